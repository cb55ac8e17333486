// A recording, as info, verify and export read it. Invariant: it is refused in one sound line, or its
// last frame of every field can be read.
#include "app/io/about.h"
#include "app/io/recorded_run.h"
#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

/// More numbers than this only take time.
constexpr std::uint64_t kMost = 1'000'000;

void read(const std::string& path) {
  const io::RecordedRun run(path);
  for (const io::SetInfo& field : run.fields()) {
    std::uint64_t size = 1;
    for (std::size_t i = 1; i < field.shape.size(); ++i) size *= field.shape[i];
    if (run.frames() == 0 || size > kMost) continue;
    std::vector<double> values(size);
    refuses([&] {
      run.read(field, run.frames() - 1, 1, std::nullopt, io::NumberType::f8, values.data());
    });
  }
  run.sheet();
}

}  // namespace

void one_input(std::string_view bytes) {
  const std::string path = hdf5_file_of(bytes, "recording");
  refuses([&] { read(path); });
  refuses([&] { io::about_file(path); });
}

}  // namespace pupflow::fuzz
