#define PUPFLOW_TIGHT(Real) tight_baseline_##Real
#include "bench/tight.inl"
