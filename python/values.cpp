#include "python/values.h"

#include <limits>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/scene_file.h"
#include "app/io/text.h"

namespace pupflow::python {
namespace {

[[noreturn]] void refuse_type(const Parameter& parameter, const char* wanted, py::handle value) {
  throw py::type_error(std::string(parameter.name) + " must be " + wanted + ", not " +
                       Py_TYPE(value.ptr())->tp_name);
}

bool is_negative(py::handle value) {
  const int negative = PyObject_RichCompareBool(value.ptr(), py::int_(0).ptr(), Py_LT);
  if (negative < 0) throw py::error_already_set();
  return negative != 0;
}

/// Any number of Python or numpy. An int beyond all doubles is infinite here.
double number_of(const Parameter& parameter, py::handle value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number != -1 || PyErr_Occurred() == nullptr) return number;
  const bool huge = PyErr_ExceptionMatches(PyExc_OverflowError) != 0;
  if (!huge && PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
  PyErr_Clear();
  if (!huge) refuse_type(parameter, "a number", value);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return is_negative(value) ? -kInfinity : kInfinity;
}

const Parameter& parameter_called(const std::string& name) {
  if (const Parameter* parameter = find_parameter(name)) return *parameter;
  std::vector<std::string_view> names;
  for (const Parameter& parameter : parameters()) names.push_back(parameter.name);
  const std::string meant = io::did_you_mean(name, names);
  throw py::type_error("unknown parameter " + io::quoted(name) +
                       (meant.empty() ? "; must be one of " + io::joined(names, ", ") : meant));
}

}  // namespace

std::string text_of(py::handle words) {
  return io::printable(words.attr("encode")("utf-8", "backslashreplace").cast<std::string>());
}

std::string path_text(py::handle path) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(path.ptr(), &bytes) == 0) throw py::error_already_set();
  return py::reinterpret_steal<py::bytes>(bytes);
}

std::int64_t whole_number(const std::string& name, py::handle value, std::int64_t min,
                          std::int64_t max) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index) {
    if (PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
    PyErr_Clear();
    throw py::type_error(name + " must be a whole number, not " + Py_TYPE(value.ptr())->tp_name);
  }
  int beyond = 0;
  const std::int64_t number = PyLong_AsLongLongAndOverflow(index.ptr(), &beyond);
  if (beyond == 0 && number >= min && number <= max) return number;
  throw py::value_error(name + " must be a whole number from " + std::to_string(min) + " to " +
                        std::to_string(max));
}

py::object value_of(const Parameter& parameter, const Params& params) {
  switch (parameter.kind) {
    case Parameter::Kind::real:
      return py::float_(parameter.get(params));
    case Parameter::Kind::integer:
      return py::int_(static_cast<std::int64_t>(parameter.get(params)));
    case Parameter::Kind::choice:
      break;
  }
  return py::str(format_value(parameter, params));
}

void take_value(const Parameter& parameter, py::handle value, Params& params,
                std::vector<std::string>& problems) {
  Problem problem;
  if (parameter.kind == Parameter::Kind::choice) {
    if (!py::isinstance<py::str>(value)) refuse_type(parameter, "a str", value);
    const std::string text = text_of(value);
    if (parse_value(parameter, text, params, problem)) return;
    problem.message += io::did_you_mean(text, parameter.choices);
  } else {
    const double number = number_of(parameter, value);
    if (check_value(parameter, number, problem)) return parameter.set(params, number);
  }
  problems.push_back(problem.message);
}

Params params_of(py::handle scene, const py::dict& named) {
  std::vector<std::string> problems;
  Params params;
  if (!scene.is_none()) {
    params = io::load_scene(path_text(scene), problems).params;
  }
  for (const auto& [name, value] : named) {
    const std::string known = text_of(name);
    take_value(parameter_called(known), value, params, problems);
  }
  for (const Problem& problem : check(params)) problems.push_back(problem.message);
  io::refuse_all(problems);
  return params;
}

}  // namespace pupflow::python
