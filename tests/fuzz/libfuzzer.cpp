// Where libFuzzer comes in.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // What the program notes on standard error would fill it. libFuzzer and the sanitizers keep their own.
  if (std::FILE* const nowhere = std::fopen("/dev/null", "w")) stderr = nowhere;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    pupflow::fuzz::one_input({reinterpret_cast<const char*>(data), size});
  } catch (const std::exception& error) {
    ::dprintf(2, "%s\n", error.what());
    std::abort();
  }
  return 0;
}
