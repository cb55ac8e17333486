#include "app/study/merge.h"

#include <filesystem>
#include <optional>

#include "app/io/failure.h"
#include "app/study/folder.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

using io::refuse;

/// A shard's folder, read.
struct Part {
  Design design;
  std::vector<Row> rows;
};

Part read_part(const std::string& folder) {
  Part part;
  part.design = design_of_folder(folder);
  if (fs::exists(journal_path(folder)) && !fs::exists(runs_path(folder))) {
    refuse(folder + ": is not finished; run its command again first");
  }
  part.rows = read_runs(runs_path(folder), part.design);
  return part;
}

/// `holder` has the folder of each shard, empty where there is none.
void refuse_missing(const std::vector<std::string>& holder) {
  constexpr int kListed = 10;
  std::string listed;
  int missing = 0;
  for (std::size_t i = 0; i < holder.size(); ++i) {
    if (!holder[i].empty()) continue;
    if (missing++ < kListed) listed += (missing == 1 ? " " : ", ") + std::to_string(i + 1);
  }
  if (missing == 0) return;
  refuse("of " + std::to_string(holder.size()) + " shards these are missing:" + listed +
         (missing > kListed ? ", ..." : "") + "; name all their folders");
}

}  // namespace

SweepResult merge_shards(const std::vector<std::string>& folders, const std::string& folder,
                         bool force) {
  std::optional<Design> whole;
  std::vector<Row> rows;
  std::vector<std::string> holder;  // which folder holds shard number i + 1
  for (const std::string& from : folders) {
    Part part = read_part(from);
    const Shard shard = part.design.shard;
    part.design.shard = {};
    if (!whole) {
      whole = part.design;
      holder.resize(static_cast<std::size_t>(shard.of));
      rows.resize(static_cast<std::size_t>(whole->runs()));
    }
    if (manifest_text(part.design) != manifest_text(*whole)) {
      refuse(from + ": belongs to another sweep than " + folders[0] + ": " +
             manifest_difference(manifest_text(*whole), manifest_text(part.design)));
    }
    if (static_cast<std::size_t>(shard.of) != holder.size()) {
      refuse(from + ": is one of " + std::to_string(shard.of) + " shards, " + folders[0] +
             " one of " + std::to_string(holder.size()));
    }
    std::string& taken = holder[static_cast<std::size_t>(shard.number - 1)];
    if (!taken.empty()) {
      refuse(from + ": is shard " + std::to_string(shard.number) + ", and so is " + taken);
    }
    taken = from;
    for (Row& row : part.rows) rows[static_cast<std::size_t>(row.run)] = std::move(row);
  }
  if (!whole) refuse("no shards to merge: name their folders");
  refuse_missing(holder);
  claim_folder(folder, *whole, force);
  return write_results(folder, *whole, std::move(rows));
}

}  // namespace pupflow::study
