// A checkpoint. Invariant: it is refused in one sound line, or by the engine where its numbers do not
// fit its parameters; otherwise the litter comes back with the same hash from a checkpoint of its own,
// and takes a step.
#include "app/io/checkpoint.h"

#include <stdexcept>

#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

/// More numbers than this only take time.
constexpr std::int64_t kMostPoints = 100'000;

void go_on(const Snapshot& snapshot) {
  const std::int64_t points = std::int64_t{snapshot.params.pups} * points_per_pup(snapshot.params);
  if (points > kMostPoints) return;
  Simulation litter(snapshot);
  const std::string path = no_file();
  io::write_checkpoint(path, true, litter);
  const Snapshot again = read_back([&] { return io::read_checkpoint(path); });
  require(Simulation(again).hash() == litter.hash(),
          "a litter comes back changed from its checkpoint");
  const Status status = litter.step();
  if (!status.ok()) require_sound(status.message());
}

}  // namespace

void one_input(std::string_view bytes) {
  const std::string path = hdf5_file_of(bytes, "checkpoint");
  refuses([&] {
    const Snapshot snapshot = io::read_checkpoint(path);
    try {
      go_on(snapshot);
    } catch (const std::invalid_argument& unfit) {  // InvalidParams, too
      require_sound(unfit.what());
    }
  });
}

}  // namespace pupflow::fuzz
