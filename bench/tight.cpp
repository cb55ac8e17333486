#include "bench/tight.h"

#include <type_traits>

namespace pupflow::bench {

#define PUPFLOW_DECLARE(set)                            \
  extern const TightKernels<float> tight_##set##_float; \
  extern const TightKernels<double> tight_##set##_double;
PUPFLOW_DECLARE(baseline)
#if defined(PUPFLOW_X86_KERNELS)
PUPFLOW_DECLARE(avx2)
PUPFLOW_DECLARE(avx512)
#endif
#undef PUPFLOW_DECLARE

namespace {

template <class Real>
const TightKernels<Real>* pick(const TightKernels<float>& narrow,
                               const TightKernels<double>& wide) {
  if constexpr (std::is_same_v<Real, float>) {
    static_cast<void>(wide);
    return &narrow;
  } else {
    static_cast<void>(narrow);
    return &wide;
  }
}

}  // namespace

template <class Real>
const TightKernels<Real>* tight_kernels(InstructionSet set) {
#if defined(PUPFLOW_X86_KERNELS)
  if (set != InstructionSet::baseline && !__builtin_cpu_supports("fma")) return nullptr;
  if (set == InstructionSet::avx2) return pick<Real>(tight_avx2_float, tight_avx2_double);
  if (set == InstructionSet::avx512) return pick<Real>(tight_avx512_float, tight_avx512_double);
#endif
  static_cast<void>(set);
  return pick<Real>(tight_baseline_float, tight_baseline_double);
}

template const TightKernels<float>* tight_kernels<float>(InstructionSet);
template const TightKernels<double>* tight_kernels<double>(InstructionSet);

}  // namespace pupflow::bench
