// Long calls without the GIL (Python's global lock), and Ctrl-C in them.
#pragma once

#include <cxxabi.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <chrono>

namespace pupflow::python {

/// Lets other threads of Python run, from here to the end of the scope. Between, Python handles
/// signals in look().
class WithoutGil {
 public:
  WithoutGil() : state_(PyEval_SaveThread()) {}
  ~WithoutGil() {
    if (state_ != nullptr) take();
  }
  WithoutGil(const WithoutGil&) = delete;
  WithoutGil& operator=(const WithoutGil&) = delete;

  /// Called between steps; does something at most twenty times a second. Throws what the handler of
  /// a signal throws, such as KeyboardInterrupt; this thread has the GIL then.
  void look() {
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + kPause;
    take();
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    state_ = PyEval_SaveThread();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr auto kPause = std::chrono::milliseconds(50);

  /// When the interpreter has ended, Python before 3.14 ends the thread that asks for the GIL, by
  /// an unwinding that must not meet a destructor. The thread waits for the end of the process
  /// instead, as from Python 3.14 on.
  void take() {
    PyThreadState* const state = state_;
    state_ = nullptr;
    try {
      PyEval_RestoreThread(state);
    } catch (abi::__forced_unwind&) {
      for (;;) ::pause();
    }
  }

  PyThreadState* state_;
  Clock::time_point next_ = Clock::now() + kPause;
};

}  // namespace pupflow::python
