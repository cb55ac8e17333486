// Latin hypercubes: points that fill the space of several parameters with few runs.
#pragma once

#include "app/study/design.h"

namespace pupflow::study {

/// Gives the design `points` points (at least 1) in the spans. The range of each parameter is cut into
/// as many equal parts as there are points, and each part has one of them, at a random place (McKay,
/// Beckman & Conover 1979). Parameters are independent of each other. Whole numbers and listed values
/// come as equally often as the count allows. The same base seed gives the same points on any machine.
void spread_latin(Design& design, const std::vector<Span>& spans, std::int64_t points);

}  // namespace pupflow::study
