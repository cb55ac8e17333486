// Parameters and their changes as people read them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::window {

/// A parameter that was changed: its place in parameters(), its values before and after.
struct Edited {
  std::size_t parameter;
  double from, to;
};

/// The symbol of a parameter, or its name where it has none.
std::string label_of(const Parameter& parameter);

/// A symbol, if there is one, and then what it stands for.
std::string titled(std::string_view symbol, std::string_view title);

/// "T_a 0.4 → 0.2, g 10 → 3". At most `most` of the changes are named.
std::string text_of(const std::vector<Edited>& values, std::size_t most = 3);

/// The same for all that differs between two parameter sets.
std::string difference_text(const Params& from, const Params& to, std::size_t most = 4);

/// What `own` has where `other` has something else: "T_a = 0.2, N = 20".
std::string differing_values(const Params& own, const Params& other);

}  // namespace pupflow::window
