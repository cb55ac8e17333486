#include "python/errors.h"

#include <string_view>
#include <vector>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"
#include "python/docstrings.h"
#include "python/values.h"

namespace pupflow::python {

namespace py = pybind11;

namespace {

PyObject* bad_numbers_type = nullptr;

PyObject* type_of(io::ExitCode code) {
  switch (code) {
    case io::ExitCode::bad_numbers:
      return PyExc_ArithmeticError;
    case io::ExitCode::bad_file:
      return PyExc_OSError;
    case io::ExitCode::no_context:
      return PyExc_RuntimeError;
    case io::ExitCode::interrupted:
      return PyExc_KeyboardInterrupt;
    case io::ExitCode::done:
    case io::ExitCode::difference:
    case io::ExitCode::bad_input:
      break;
  }
  return PyExc_ValueError;
}

/// Messages may hold bytes of a path that are not UTF-8.
py::object message_of(const std::exception& error) {
  return py::bytes(error.what()).attr("decode")("utf-8", "backslashreplace");
}

void raise(const BadNumbers& bad) {
  const Status& status = bad.status();
  const py::object error = py::handle(bad_numbers_type)(message_of(bad));
  error.attr("kind") = std::string(kind_name(status.kind));
  error.attr("stage") = std::string(stage_name(status.stage));
  error.attr("step") = status.step;
  error.attr("pup") = status.pup;
  error.attr("point") = status.point;
  PyErr_SetObject(bad_numbers_type, error.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const BadNumbers& bad) {
    raise(bad);
  } catch (const io::Failure& failure) {
    PyErr_SetObject(type_of(failure.code()), message_of(failure).ptr());
  }
}

void set_attribute(const py::object& self, const py::str& name, const py::object& value) {
  if (PyObject_GenericSetAttr(self.ptr(), name.ptr(), value.ptr()) != 0)
    throw py::error_already_set();
}

}  // namespace

void add_errors(py::module_& module) {
  bad_numbers_type = PyErr_NewExceptionWithDoc("pupflow.BadNumbers", kBadNumbersDoc,
                                               PyExc_ArithmeticError, nullptr);
  module.add_object("BadNumbers", bad_numbers_type);
  py::register_exception_translator(translate);
}

void refuse_attribute(py::handle object, const py::str& attribute) {
  const std::string name = text_of(attribute);
  std::vector<std::string> known;
  for (const py::handle item : py::module_::import("builtins").attr("dir")(py::type::of(object))) {
    known.push_back(text_of(item));
  }
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string type = py::type::of(object).attr("__name__").cast<std::string>();
  throw py::attribute_error(type + " has no attribute " + io::quoted(name) +
                            io::did_you_mean(name, names));
}

void refuse_unknown_attributes(py::object type) {
  type.attr("__getattr__") =
      py::cpp_function([](const py::object& self,
                          const py::str& name) -> py::object { refuse_attribute(self, name); },
                       py::is_method(type));
  const auto set = [type = py::handle(type)](const py::object& self, const py::str& name,
                                             const py::object& value) {
    if (py::type::of(self).is(type) && !py::hasattr(type, name)) refuse_attribute(self, name);
    set_attribute(self, name, value);
  };
  type.attr("__setattr__") = py::cpp_function(set, py::is_method(type));
}

}  // namespace pupflow::python
