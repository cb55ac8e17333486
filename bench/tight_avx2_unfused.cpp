#define PUPFLOW_TIGHT(Real) tight_avx2_unfused_##Real
#include "bench/tight.inl"
