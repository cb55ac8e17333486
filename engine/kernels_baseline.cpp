// The kernels for one instruction set; its compiler flags stand in CMakeLists.txt.
#define PUPFLOW_KERNELS(Real) k_baseline_##Real
#include "engine/kernels.inl"
