// Parameters as people read them.
#pragma once

#include <string>

#include "pupflow/parameters.h"

namespace pupflow::window {

/// The symbol of a parameter, or its name where it has none.
std::string label_of(const Parameter& parameter);

/// What differs between two parameter sets: "T_a 0.2 -> 0.4, N 20 -> 12" with a real arrow. At most
/// `most` of them are named.
std::string difference_text(const Params& from, const Params& to, int most = 4);

/// What `own` has where `other` has something else: "T_a = 0.2, N = 20".
std::string differing_values(const Params& own, const Params& other);

}  // namespace pupflow::window
