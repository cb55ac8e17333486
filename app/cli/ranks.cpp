#include "app/cli/ranks.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "app/cli/module.h"
#include "app/io/failure.h"
#include "app/io/read_file.h"

namespace pupflow::cli {
namespace {

struct Launcher {
  const char *rank, *size;
};

// A job step of Slurm has its size in SLURM_STEP_NUM_TASKS whether or not it is an MPI job; one
// that is has a rank of PMI or PMIx too.
constexpr Launcher kLaunchers[] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                   {"PMI_RANK", "PMI_SIZE"},
                                   {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}};

std::optional<int> number_in(const char* variable) {
  const char* text = std::getenv(variable);
  if (!text) return std::nullopt;
  const std::string_view view(text);
  int number = 0;
  const auto [stop, error] = std::from_chars(view.data(), view.data() + view.size(), number);
  if (error != std::errc{} || stop != view.data() + view.size() || number < 0) return std::nullopt;
  return number;
}

struct Place {
  int rank = 0, size = 1;
};

Place place_among_ranks() {
  for (const Launcher& launcher : kLaunchers) {
    const std::optional<int> rank = number_in(launcher.rank), size = number_in(launcher.size);
    if (rank && size && *size > 1) return {*rank, *size};
  }
  return {};
}

/// The words that this process was started with.
std::string command_line() {
  std::string words = io::read_file("/proc/self/cmdline", std::size_t{1} << 22);
  while (words.ends_with('\0')) words.pop_back();
  std::replace(words.begin(), words.end(), '\0', ' ');
  return words;
}

std::chrono::milliseconds lost_after(std::chrono::milliseconds otherwise) {
  constexpr const char* kVariable = "PUPFLOW_LOST_AFTER";
  if (!std::getenv(kVariable)) return otherwise;
  const std::optional<int> seconds = number_in(kVariable);
  if (seconds && *seconds >= 1) return std::chrono::seconds(*seconds);
  throw io::Failure(io::ExitCode::bad_input,
                    std::string(kVariable) + ": must be a whole number of seconds, at least 1");
}

}  // namespace

mpi::Membership launched() {
  mpi::Membership self;
  const Place place = place_among_ranks();
  if (place.size < 2) return self;
  self.rank = place.rank;
  self.size = place.size;
  self.lost_after = lost_after(self.lost_after);
  self.job = command_line();
  return self;
}

bool leaves_speaking(int argc, char** argv) {
  const std::string_view verb = argc > 1 ? argv[1] : "";
  return (verb == "sweep" || verb == "figure2") && place_among_ranks().rank > 0;
}

mpi::Ranks& load_ranks(const mpi::Membership& self) {
  const Module module = load_module("libpupflow_mpi.so", mpi::kRanksEntry);
  if (!module.entry) {
    throw io::Failure(
        io::ExitCode::bad_input,
        "started as one of " + std::to_string(self.size) + " ranks, but " +
            (module.missing ? "this pupflow was built without MPI: build it with -DPUPFLOW_MPI=ON"
                            : "its MPI module cannot be loaded: " + module.problem) +
            ", or give each process a share with --shard");
  }
  return *reinterpret_cast<mpi::RanksEntry>(module.entry)();
}

}  // namespace pupflow::cli
