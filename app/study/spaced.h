// Evenly spaced numbers, computed from their decimal digits: the third of four values from 0.2 to 0.8
// is 0.6, not 0.6000000000000001.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace pupflow::study {

/// `count` values (at least 2) from `from` to `to`, both included. Both must be numbers as
/// parse_value reads them. A value is the double nearest to the exact one as long as that fits into a
/// fraction of integers below 2^53.
std::vector<double> spaced(std::string_view from, std::string_view to, std::int64_t count);

/// `from` and all that follows in steps of `step` (above 0) towards `to`. `to` is included where the
/// steps reach it to 1e-9 of a step. Empty when there are more than `most` values.
std::vector<double> stepped(std::string_view from, std::string_view to, std::string_view step,
                            std::int64_t most);

}  // namespace pupflow::study
