// numpy arrays over memory of C++.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

namespace pupflow::python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

/// An array over `memory`, which lives as long as the array. Its size is that of `shape`.
template <class Number>
py::array array_over(std::shared_ptr<std::vector<Number>> memory, const Shape& shape) {
  Number* const data = memory->data();
  using Owner = std::shared_ptr<std::vector<Number>>;
  const py::capsule owner(new Owner(std::move(memory)),
                          [](void* held) { delete static_cast<Owner*>(held); });
  return py::array_t<Number>(shape, data, owner);
}

/// The same, read-only.
template <class Number>
py::array read_only_array(std::shared_ptr<std::vector<Number>> memory, const Shape& shape) {
  py::array array = array_over(std::move(memory), shape);
  // What setflags(write=False) does, in a tenth of the time.
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

}  // namespace pupflow::python
