// Docstrings, made from the rows of the tables.
#pragma once

#include <string>

#include "pupflow/fields.h"
#include "pupflow/parameters.h"

namespace pupflow::python {

/// Of an attribute that is a parameter.
std::string words(const Parameter& parameter);

/// Of an attribute that is a field, or a key that is an observable. `shape` stands first, e.g.
/// "(pups,)".
std::string words(const Field& field, const std::string& shape);

}  // namespace pupflow::python
