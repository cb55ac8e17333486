// The time series of the runs of a sweep: a metrics CSV for each, as `pupflow run --csv` writes it.
#pragma once

#include <string>

#include "app/study/design.h"
#include "pupflow/ensemble.h"

namespace pupflow::study {

/// The file in series_folder (files.h): FOLDER/series/P-S.csv for seed number S of point number P, both counted from 1.
std::string series_path(const std::string& folder, const Design& design, std::int64_t run);

/// Whether the series of a run is there, or the design has none.
bool has_series(const std::string& folder, const Design& design, std::int64_t run);
bool has_all_series(const std::string& folder, const Design& design);

/// Writes the series of a run, whole or not at all, over one that is there. Does nothing where the
/// design has none. Throws io::Failure(bad_file).
void write_series(const std::string& folder, const Design& design, std::int64_t run,
                  const RunResult& result);

/// Copies the series of the runs of `shard` from one sweep's folder into another. Throws
/// io::Failure(bad_file), also when one is missing.
void copy_series(const std::string& from, const Design& shard, const std::string& to);

/// Removes all series, and their folder when nothing else is in it. Throws io::Failure(bad_file).
void remove_series(const std::string& folder);

}  // namespace pupflow::study
