// What all kinds of files share: the litter of a recipe, stepped.
#include <algorithm>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/verify/kinds.h"

namespace pupflow::verify {

const std::string* find_entry(const io::TextEntries& entries, const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return entry.first == name; });
  return found == entries.end() ? nullptr : &found->second;
}

std::int64_t begun(const io::TextEntries& entries) {
  const std::string* step = find_entry(entries, "begun");
  return step ? io::read_number<std::int64_t>(*step).value_or(0) : 0;
}

Simulation litter_of(const io::TextEntries& entries, const std::string& path,
                     const Options& options) {
  if (const std::string* step = find_entry(entries, "edited")) {
    io::refuse(path + ": pups were set by hand after step " + *step +
               ", which its parameters and changes do not tell; such a run cannot be repeated");
  }
  const Params recipe = io::params_from(entries, path);
  const std::vector<Problem> problems = check(recipe);
  if (!problems.empty()) io::refuse(path + ": " + problems.front().message);
  Simulation litter(recipe);
  litter.set_threads(options.threads);
  return litter;
}

void advance(Simulation& litter, std::int64_t step, const std::function<void()>& each) {
  while (litter.steps_done() < step && litter.step().ok()) {
    if (io::interrupted()) {
      throw io::Failure(io::ExitCode::interrupted,
                        "interrupted after step " + std::to_string(litter.steps_done()));
    }
    if (each) each();
  }
}

Verdict compare_hash(const Simulation& litter, const std::string& hash, const std::string& whose) {
  const std::string run = io::hash_text(litter.hash());
  const std::string where = whose + "step " + std::to_string(litter.steps_done());
  if (!litter.status().ok()) return {false, where + ": " + litter.status().message()};
  if (run != hash) return {false, difference(where, "the hash of the state", hash, run)};
  return {true, where + ", hash " + hash};
}

std::string difference(const std::string& where, const std::string& what, const std::string& file,
                       const std::string& run) {
  return where + ": " + what + " is " + file + " in the file, " + run + " in the run";
}

}  // namespace pupflow::verify
