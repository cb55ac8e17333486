#include "app/study/merge.h"

#include <filesystem>
#include <optional>

#include "app/io/failure.h"
#include "app/study/files.h"
#include "app/study/folder.h"
#include "app/study/series.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

using io::refuse;

/// The design and the rows of a shard's folder.
struct LoadedShard {
  Design design;
  std::vector<Row> rows;
};

LoadedShard load_shard(const std::string& folder) {
  LoadedShard loaded;
  loaded.design = design_of_folder(folder);
  if (fs::exists(journal_path(folder)) && !fs::exists(runs_path(folder))) {
    refuse(folder + ": is not finished; run its command again first");
  }
  loaded.rows = read_runs(runs_path(folder), loaded.design);
  return loaded;
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
  std::vector<Design> shards;
  std::vector<Row> rows;
  std::vector<std::string> holder;  // which folder holds shard number i + 1
  for (const std::string& from : folders) {
    LoadedShard loaded = load_shard(from);
    const Shard shard = loaded.design.shard;
    shards.push_back(loaded.design);
    loaded.design.shard = {};
    if (!whole) {
      whole = loaded.design;
      holder.resize(static_cast<std::size_t>(shard.of));
      rows.resize(static_cast<std::size_t>(whole->runs()));
    }
    if (manifest_text(loaded.design) != manifest_text(*whole)) {
      refuse(from + ": belongs to another sweep than " + folders[0] + ": " +
             manifest_difference(manifest_text(*whole), manifest_text(loaded.design)));
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
    for (Row& row : loaded.rows) rows[static_cast<std::size_t>(row.run)] = std::move(row);
  }
  if (!whole) refuse("no shards to merge: name their folders");
  refuse_missing(holder);
  claim_folder(folder, *whole, force);
  for (std::size_t i = 0; i < folders.size(); ++i) copy_series(folders[i], shards[i], folder);
  return write_results(folder, *whole, std::move(rows));
}

}  // namespace pupflow::study
