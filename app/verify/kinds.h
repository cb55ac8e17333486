// The kinds of files that can be verified, and what they share.
#pragma once

#include <functional>
#include <string>

#include "app/io/png.h"
#include "app/verify/verdict.h"
#include "pupflow/simulation.h"

namespace pupflow::verify {

Verdict verify_metrics(const std::string& path, const Options& options);
Verdict verify_pups(const std::string& path, const Options& options);
Verdict verify_runs(const std::string& path, const Options& options);
Verdict verify_picture(const std::string& path, const Options& options);
Verdict verify_checkpoint(const std::string& path, const Options& options);
Verdict verify_recording(const std::string& path, const Options& options);

/// The entry called `name`, or nullptr.
const std::string* find_entry(const io::TextEntries& entries, const std::string& name);

/// The step after which the run behind a file began to be observed: that of its checkpoint, or 0.
std::int64_t begun(const io::TextEntries& entries);

/// The litter of these entries at t = 0. Throws io::Failure(bad_input) when they say that pups were
/// set by hand, which no recipe tells.
Simulation litter_of(const io::TextEntries& entries, const std::string& path,
                     const Options& options);

/// Takes steps up to `step`, or to the first bad status; calls `each` after every step. Throws
/// io::Failure(interrupted).
void advance(Simulation& litter, std::int64_t step, const std::function<void()>& each = {});

/// Whether the litter's state has this hash. `whose` precedes the step in the words of the verdict.
Verdict compare_hash(const Simulation& litter, const std::string& hash,
                     const std::string& whose = "");

/// "step 12: tb of pup 3 is 0.5 in the file, 0.6 in the run".
std::string difference(const std::string& where, const std::string& what, const std::string& file,
                       const std::string& run);

}  // namespace pupflow::verify
