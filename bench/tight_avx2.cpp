#define PUPFLOW_TIGHT(Real) tight_avx2_##Real
#include "bench/tight.inl"
