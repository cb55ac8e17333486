// The Python class Litter, with the classes of its params, pup and afferent.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>

#include "pupflow/fields.h"

namespace pupflow::python {

/// Adds the classes and load(). Attributes are made from the tables.
void add_litter(pybind11::module_& module);

/// The observables by name.
pybind11::dict dict_of(const Observables& observables);

inline pybind11::str text(std::string_view words) {
  return {words.data(), words.size()};
}

}  // namespace pupflow::python
