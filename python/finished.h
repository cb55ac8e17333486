// Objects of Python whose __init__() has not finished: pybind11 gives out memory without a value.
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

namespace pupflow::python {

/// The caster of the class `Held` that throws RuntimeError for an object without a value.
template <class Held>
class FinishedCaster : public pybind11::detail::type_caster_base<Held> {
  using Base = pybind11::detail::type_caster_base<Held>;

 public:
  bool load(pybind11::handle source, bool convert) {
    const auto* const type = this->typeinfo;
    if (source && type != nullptr && PyObject_TypeCheck(source.ptr(), type->type) != 0) {
      auto* const object = reinterpret_cast<pybind11::detail::instance*>(source.ptr());
      if (!object->get_value_and_holder(type).holder_constructed()) refuse(type->type->tp_name);
    }
    return Base::load(source, convert);
  }

 private:
  [[noreturn]] static void refuse(const std::string& type) {
    throw std::runtime_error(type.substr(type.rfind('.') + 1) + ".__init__() has not finished");
  }
};

}  // namespace pupflow::python
