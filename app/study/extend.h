// Seeds, or series, that are added to a sweep.
#pragma once

#include <optional>
#include <string>

#include "app/study/design.h"

namespace pupflow::study {

/// The design of the manifest `there` if `design` is the same sweep with more seeds, or with the
/// series of its runs (--record), or both. Only whole sweeps can be extended, not shards.
std::optional<Design> extended_by(const Design& design, const std::string& there);

/// Makes the folder of `before` ready for a design that extends it, but for the manifest: finished
/// runs go to the journal, and results that will change are removed. A figure's script stays where it
/// was edited. After an interruption both the old command and the new one go on. Throws io::Failure.
void prepare_extension(const std::string& folder, const Design& before);

}  // namespace pupflow::study
