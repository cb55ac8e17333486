// The tables of parameters and of fields, for axes, legends and sweeps.
#pragma once

#include <pybind11/pybind11.h>

namespace pupflow::python {

/// Adds parameters() and fields().
void add_tables(pybind11::module_& module);

}  // namespace pupflow::python
