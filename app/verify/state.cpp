// Files that show one state: pictures by its hash, checkpoints by every number.
#include <algorithm>
#include <bit>
#include <cmath>

#include "app/io/checkpoint.h"
#include "app/io/failure.h"
#include "app/io/progress.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/verify/kinds.h"

namespace pupflow::verify {
namespace {

std::int64_t step_of(const io::TextEntries& entries, const std::string& path) {
  const std::string* text = find_entry(entries, "step");
  const auto step = text ? io::read_number<std::int64_t>(*text) : std::nullopt;
  if (!step || *step < 0) io::refuse(path + ": does not say which step it shows");
  return *step;
}

const std::string& hash_in(const io::TextEntries& entries, const std::string& path) {
  const std::string* hash = find_entry(entries, "hash");
  if (!hash) io::refuse(path + ": carries no hash of the state it shows, so nothing to compare");
  return *hash;
}

Simulation repeated(const io::TextEntries& entries, std::int64_t step, const std::string& path,
                    const Options& options) {
  Simulation litter = litter_of(entries, path, options);
  io::Progress progress("verify", step, options.quiet);
  advance(litter, step, [&] { progress.update(litter.steps_done()); });
  return litter;
}

/// figure1: a litter for each panel.
Verdict verify_figure1(const io::TextEntries& entries, const std::string& path,
                       const Options& options) {
  const std::string* panels = find_entry(entries, "panels_ta");
  if (!panels) io::refuse(path + ": does not say the ambient temperatures of its panels");
  const auto temperatures = io::split(*panels, ',');
  const auto hashes = io::split(hash_in(entries, path), ',');
  if (temperatures.size() != hashes.size()) {
    io::refuse(path + ": has not one hash for each of its panels");
  }
  for (std::size_t i = 0; i < hashes.size(); ++i) {
    io::TextEntries panel = entries;
    for (auto& [name, value] : panel) {
      if (name == "ta") value = temperatures[i];
    }
    const std::int64_t steps = io::params_from(panel, path).steps;
    const Simulation litter = repeated(panel, steps, path, options);
    const Verdict verdict =
        compare_hash(litter, std::string(hashes[i]), "T_a " + std::string(temperatures[i]) + ", ");
    if (!verdict.same) return verdict;
  }
  return {true, std::to_string(hashes.size()) + " litters"};
}

/// The first number in which two arrays of a snapshot differ, for a pup of `each` numbers.
std::optional<std::string> compare(const std::string& name, std::span<const double> file,
                                   std::span<const double> run, std::size_t each) {
  for (std::size_t i = 0; i < std::min(file.size(), run.size()); ++i) {
    if (std::bit_cast<std::uint64_t>(file[i]) == std::bit_cast<std::uint64_t>(run[i])) continue;
    return difference("pup " + std::to_string(i / each), name, io::number_text(file[i]),
                      io::number_text(run[i]));
  }
  return std::nullopt;
}

}  // namespace

Verdict verify_picture(const std::string& path, const Options& options) {
  const io::TextEntries entries = io::read_png_text(path);
  const std::string* picture = find_entry(entries, "picture");
  if (!picture) {
    io::refuse(path +
               ": is no picture of a litter; a sweep's figure is drawn from its runs.csv, "
               "which can be verified");
  }
  if (*picture == "figure1") return verify_figure1(entries, path, options);
  const std::string& hash = hash_in(entries, path);
  return compare_hash(repeated(entries, step_of(entries, path), path, options), hash);
}

Verdict verify_checkpoint(const std::string& path, const Options& options) {
  const io::TextEntries entries = io::read_hdf5_text(path);
  const Snapshot file = io::read_checkpoint(path);
  const Simulation litter = repeated(entries, file.step, path, options);
  const Snapshot run = litter.snapshot();
  const std::string where = "step " + std::to_string(file.step) + ", ";
  const auto points = static_cast<std::size_t>(litter.points());
  const struct {
    const char* name;
    std::span<const double> file, run;
    std::size_t each;
  } arrays[] = {{"tb", file.body_temperature, run.body_temperature, 1},
                {"heading", file.heading, run.heading, 1},
                {"position", file.positions, run.positions, 3 * points},
                {"velocity", file.velocities, run.velocities, 3 * points}};
  for (const auto& array : arrays) {
    if (const auto other = compare(array.name, array.file, array.run, array.each)) {
      return {false, where + *other};
    }
  }
  return compare_hash(litter, hash_in(entries, path));
}

}  // namespace pupflow::verify
