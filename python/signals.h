// Ctrl-C in long calls without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>

namespace pupflow::python {

/// Lets Python handle signals, twenty times a second.
class SignalWatch {
 public:
  /// Called between steps, without the GIL. Throws what a handler throws, such as KeyboardInterrupt.
  void look() {
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(50);
    const pybind11::gil_scoped_acquire python;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_ = Clock::now() + std::chrono::milliseconds(50);
};

}  // namespace pupflow::python
