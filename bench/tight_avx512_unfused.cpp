#define PUPFLOW_TIGHT(Real) tight_avx512_unfused_##Real
#include "bench/tight.inl"
