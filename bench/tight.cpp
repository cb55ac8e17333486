#include "bench/tight.h"

#include <type_traits>

namespace pupflow::bench {

#define PUPFLOW_DECLARE(set)                            \
  extern const TightKernels<float> tight_##set##_float; \
  extern const TightKernels<double> tight_##set##_double;
PUPFLOW_DECLARE(baseline)
#if defined(PUPFLOW_X86_KERNELS)
PUPFLOW_DECLARE(avx2_unfused)
PUPFLOW_DECLARE(avx2)
PUPFLOW_DECLARE(avx512_unfused)
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
std::vector<TightVariant<Real>> tight_variants() {
  std::vector<TightVariant<Real>> variants{
      {"baseline", pick<Real>(tight_baseline_float, tight_baseline_double)}};
#if defined(PUPFLOW_X86_KERNELS)
  const bool fused = __builtin_cpu_supports("fma") != 0;
  const auto add = [&](std::string_view name, const TightKernels<Real>* kernels) {
    variants.push_back({name, kernels});
  };
  if (__builtin_cpu_supports("avx2")) {
    add("avx2, not fused", pick<Real>(tight_avx2_unfused_float, tight_avx2_unfused_double));
    if (fused) add("avx2", pick<Real>(tight_avx2_float, tight_avx2_double));
  }
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
    add("avx512, not fused", pick<Real>(tight_avx512_unfused_float, tight_avx512_unfused_double));
    if (fused) add("avx512", pick<Real>(tight_avx512_float, tight_avx512_double));
  }
#endif
  return variants;
}

template std::vector<TightVariant<float>> tight_variants<float>();
template std::vector<TightVariant<double>> tight_variants<double>();

}  // namespace pupflow::bench
