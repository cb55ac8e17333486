// Work in the child of an EXPECT_EXIT that ends as the program would.
#pragma once

#include <csignal>
#include <cstdlib>
#include <iostream>

#include "app/io/failure.h"
#include "app/io/interrupt.h"

namespace pupflow::test {

/// Does `work` and ends as the program does: the failure's message, its exit code. 0 where nothing
/// failed.
template <class Work>
[[noreturn]] void run_as_program(Work work) {
  try {
    work();
  } catch (const io::Failure& failure) {
    std::cerr << failure.what() << std::endl;
    std::_Exit(static_cast<int>(failure.code()));
  }
  std::_Exit(0);
}

/// The same in a process that is interrupted.
template <class Work>
[[noreturn]] void end_interrupted(Work work) {
  io::watch_for_interrupt();
  std::raise(SIGINT);
  run_as_program(work);
}

}  // namespace pupflow::test
