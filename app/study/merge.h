// Joins the shards of a sweep.
#pragma once

#include <string>
#include <vector>

#include "app/study/sweep.h"

namespace pupflow::study {

/// Joins the finished shards in `folders` to a whole sweep in `folder`, with the same files
/// as a sweep that was computed at once. Throws io::Failure: bad_input when they do not belong together or
/// one is missing, given twice or not finished; bad_file; as run_sweep for `folder`. `plot_script` as in draw_plots. Memory
/// does not grow with what is missing.
SweepResult merge_shards(const std::vector<std::string>& folders, const std::string& folder,
                         bool force, const std::string& plot_script = {});

}  // namespace pupflow::study
