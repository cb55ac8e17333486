#define PUPFLOW_TIGHT(Real) tight_avx512_##Real
#include "bench/tight.inl"
