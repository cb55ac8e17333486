// What the tables of pup and afferent fields share.
#pragma once

#include <algorithm>
#include <span>

#include "pupflow/fields.h"

namespace pupflow {

using Values = std::span<double>;

/// The formula of a field that is one of the view's spans.
template <auto Member>
void copy_of(const LitterView& litter, Values values) {
  const auto& from = litter.*Member;
  std::copy(from.begin(), from.end(), values.begin());
}

}  // namespace pupflow
