// What goes wrong, as Python exceptions with the sentences of the program.
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

#include "pupflow/status.h"

namespace pupflow::python {

/// A step ended with a bad status. In Python pupflow.BadNumbers.
class BadNumbers : public std::runtime_error {
 public:
  explicit BadNumbers(const Status& status)
      : std::runtime_error(status.message()), status_(status) {}
  const Status& status() const { return status_; }

 private:
  Status status_;
};

/// Throws BadNumbers unless the status is fine.
inline void require_fine(const Status& status) {
  if (!status.ok()) throw BadNumbers(status);
}

/// Adds pupflow.BadNumbers, and the ways from C++ exceptions to Python's.
void add_errors(pybind11::module_& module);

/// Throws AttributeError: `object` has no such attribute. Names the nearest that it has.
[[noreturn]] void refuse_attribute(pybind11::handle object, const pybind11::str& attribute);

/// Makes instances of the class `type` refuse unknown attributes so, whether read or set. Those of a
/// subclass in Python may have attributes of their own.
void refuse_unknown_attributes(pybind11::object type);

}  // namespace pupflow::python
