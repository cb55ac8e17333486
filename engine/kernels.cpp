#include "engine/kernels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <type_traits>

namespace pupflow {

#define PUPFLOW_DECLARE(set)                   \
  extern const Kernels<float> k_##set##_float; \
  extern const Kernels<double> k_##set##_double;
PUPFLOW_DECLARE(baseline)
#if defined(PUPFLOW_X86_KERNELS)
PUPFLOW_DECLARE(avx2)
PUPFLOW_DECLARE(avx512)
#endif
#undef PUPFLOW_DECLARE

namespace {

struct Supported {
  std::array<InstructionSet, 3> sets{InstructionSet::baseline};
  std::size_t count = 1;
};

Supported find_supported() {
  Supported supported;
#if defined(PUPFLOW_X86_KERNELS)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    supported.sets[supported.count++] = InstructionSet::avx2;
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
    supported.sets[supported.count++] = InstructionSet::avx512;
  }
#endif
  return supported;
}

/// The table for the precision Real.
template <class Real>
const Kernels<Real>& pick(const Kernels<float>& for_float, const Kernels<double>& for_double) {
  if constexpr (std::is_same_v<Real, float>) {
    static_cast<void>(for_double);
    return for_float;
  } else {
    static_cast<void>(for_float);
    return for_double;
  }
}

}  // namespace

std::string_view instruction_set_name(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return "baseline";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
  }
  return "unknown";
}

std::span<const InstructionSet> supported_instruction_sets() {
  static const Supported supported = find_supported();
  return {supported.sets.data(), supported.count};
}

template <class Real>
const Kernels<Real>& kernels_for(InstructionSet set) {
  assert(std::ranges::count(supported_instruction_sets(), set) == 1);
#if defined(PUPFLOW_X86_KERNELS)
  if (set == InstructionSet::avx2) return pick<Real>(k_avx2_float, k_avx2_double);
  if (set == InstructionSet::avx512) return pick<Real>(k_avx512_float, k_avx512_double);
#endif
  static_cast<void>(set);
  return pick<Real>(k_baseline_float, k_baseline_double);
}

template const Kernels<float>& kernels_for<float>(InstructionSet);
template const Kernels<double>& kernels_for<double>(InstructionSet);

}  // namespace pupflow
