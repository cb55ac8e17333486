// Joins the shards of a sweep.
#pragma once

#include <string>
#include <vector>

#include "app/study/sweep.h"

namespace pupflow::study {

/// Joins the finished shards in `folders` to a whole sweep in `folder`, with the same files
/// as a sweep that was computed at once. Throws io::Failure: bad_input when they do not belong together or
/// one is missing, given twice or not finished; bad_file; as claim_folder for `folder`.
SweepResult merge_shards(const std::vector<std::string>& folders, const std::string& folder,
                         bool force);

}  // namespace pupflow::study
