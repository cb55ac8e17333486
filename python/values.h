// Values of parameters between Python and the engine.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::python {

namespace py = pybind11;

/// The words of a str on one line: surrogates, NUL and control characters are escaped.
std::string text_of(py::handle words);

/// A path (str, bytes or os.PathLike) in bytes, as the system has it. Throws ValueError where one
/// holds NUL.
std::string path_text(py::handle path);

/// A whole number of Python or numpy. Throws TypeError where it is none, ValueError with its `name`
/// where it is not min ... max.
std::int64_t whole_number(const std::string& name, py::handle value, std::int64_t min,
                          std::int64_t max);

/// The parameter's value as a float, an int or, of a choice, a str.
py::object value_of(const Parameter& parameter, const Params& params);

/// Sets one parameter. What is wrong with the value goes to `problems`. Throws TypeError for a value
/// of the wrong type.
void take_value(const Parameter& parameter, py::handle value, Params& params,
                std::vector<std::string>& problems);

/// The parameters of a scene (None, a shipped name or a path), with those of `named` on top. Throws
/// TypeError for an unknown name or a wrong type, ValueError with every problem, OSError when the
/// scene cannot be read.
Params params_of(py::handle scene, const py::dict& named);

}  // namespace pupflow::python
