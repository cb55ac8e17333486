// Fields by the name that a user gives.
#pragma once

#include <string>
#include <string_view>

#include "pupflow/fields.h"

namespace pupflow::io {

/// The field of a pup or an afferent called `name`. Throws Failure(bad_input) when there is none,
/// with the nearest name or all names; `where` stands in front, e.g. "--color-by".
const LitterField& named_field(std::string_view name, const std::string& where);

}  // namespace pupflow::io
