// Feeds files to a fuzz target: each one that is named, and all in each folder that is. Prints what is
// wrong and ends with 1 at the first input that breaks the target's invariant.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "tests/fuzz/fuzz.h"
#include "tests/support/scratch.h"

namespace {

namespace fs = std::filesystem;

void replay(const fs::path& path, int& inputs) {
  if (fs::is_directory(path)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) replay(entry, inputs);
    return;
  }
  try {
    pupflow::fuzz::one_input(pupflow::test::contents(path.string()));
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
  ++inputs;
}

}  // namespace

int main(int argc, char** argv) {
  int inputs = 0;
  try {
    for (int i = 1; i < argc; ++i) replay(argv[i], inputs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::printf("%d inputs\n", inputs);
  return inputs > 0 ? 0 : 1;  // none at all: the corpus was not found
}
