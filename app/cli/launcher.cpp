#include "app/cli/launcher.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "app/cli/module.h"
#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

/// The environment variables that hold a process's rank and the number of ranks.
struct Launcher {
  const char *rank, *size;
};

// Slurm sets SLURM_STEP_NUM_TASKS for every job step; only a step that is an MPI job has a rank of
// PMI or PMIx too.
constexpr Launcher kLaunchers[] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                   {"PMI_RANK", "PMI_SIZE"},
                                   {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}};

std::optional<int> number_in(const char* variable) {
  const char* text = std::getenv(variable);
  if (!text) return std::nullopt;
  const std::optional<int> number = io::read_number<int>(text);
  return number && *number >= 0 ? number : std::nullopt;
}

/// Rank and size only.
mpi::RankInfo rank_from_environment() {
  mpi::RankInfo self;
  for (const Launcher& launcher : kLaunchers) {
    const std::optional<int> rank = number_in(launcher.rank), size = number_in(launcher.size);
    if (!rank || !size || *size < 2) continue;
    self.rank = *rank;
    self.size = *size;
    break;
  }
  return self;
}

/// The command line of this process, with spaces between its arguments.
std::string command_line() {
  std::string words = io::read_file("/proc/self/cmdline", std::size_t{1} << 22);
  while (words.ends_with('\0')) words.pop_back();
  std::replace(words.begin(), words.end(), '\0', ' ');
  return words;
}

constexpr const char* kLostAfter = "PUPFLOW_LOST_AFTER";

std::chrono::seconds lost_after(std::chrono::seconds default_value) {
  const char* text = std::getenv(kLostAfter);
  if (!text) return default_value;
  const std::optional<int> seconds = number_in(kLostAfter);
  if (seconds && *seconds >= 1) return std::chrono::seconds(*seconds);
  io::refuse(std::string(kLostAfter) + ": must be a whole number of seconds, at least 1, not " +
             io::quoted(text));
}

}  // namespace

mpi::RankInfo launched_rank() {
  mpi::RankInfo self = rank_from_environment();
  if (self.size < 2) return self;
  self.lost_after = lost_after(self.lost_after);
  self.command = command_line();
  return self;
}

namespace {

bool joined = false;  // whether this rank has begun to talk to the others

bool computes_runs(int argc, char** argv) {
  const std::string_view verb = argc > 1 ? argv[1] : "";
  return verb == "sweep" || verb == "figure2";
}

}  // namespace

bool is_silent_rank(int argc, char** argv) {
  return computes_runs(argc, argv) && rank_from_environment().rank > 0;
}

void leave_job(int argc, char** argv, const std::string& why, io::ExitCode code) noexcept {
  if (joined || !computes_runs(argc, argv)) return;
  try {
    mpi::RankInfo self = rank_from_environment();
    if (self.size < 2) return;
    if (number_in(kLostAfter).value_or(0) > 0) self.lost_after = lost_after({});
    load_mpi(self).refuse_work(self, why, static_cast<int>(code));
  } catch (const std::exception&) {
    // There is nobody to tell, or rank 0 hears why others cannot take part either.
  }
}

mpi::Interface& load_mpi(const mpi::RankInfo& self) {
  joined = true;
  const io::Module module = load_module(io::kMpiModule, mpi::kEntry);
  if (!module.entry) {
    io::refuse("started as one of " + std::to_string(self.size) + " ranks, but " +
               (module.missing
                    ? "this pupflow was built without MPI: build it with -DPUPFLOW_MPI=ON"
                    : "its MPI module cannot be loaded: " + module.problem) +
               ", or give each process a share with --shard");
  }
  return *reinterpret_cast<mpi::Entry>(module.entry)();
}

}  // namespace pupflow::cli
