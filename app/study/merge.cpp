#include "app/study/merge.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/study/files.h"
#include "app/study/folder.h"
#include "app/study/lock.h"
#include "app/study/series.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

using io::refuse;

/// A shard's folder and its design.
struct Part {
  std::string folder;
  Design design;
};

using Parts = std::map<std::int64_t, Part>;  // by the number of the shard

Part open_part(const std::string& folder) {
  Part part{folder, design_of_folder(folder)};
  if (fs::exists(journal_path(folder)) && !fs::exists(runs_path(folder)))
    refuse(folder + ": is not finished; run its command again first");
  return part;
}

Design whole_of(Design shard) {
  shard.shard = {};
  return shard;
}

/// Adds a shard of the same sweep as those that are there.
void add_part(Part part, Parts& parts) {
  if (!parts.empty()) {
    const Part& first = parts.begin()->second;
    const std::string text = manifest_text(whole_of(part.design)),
                      others = manifest_text(whole_of(first.design));
    if (text != others) {
      refuse(part.folder + ": belongs to another sweep than " + first.folder + ": " +
             manifest_difference(others, text));
    }
    if (part.design.shard.of != first.design.shard.of) {
      refuse(part.folder + ": is one of " + std::to_string(part.design.shard.of) + " shards, " +
             first.folder + " one of " + std::to_string(first.design.shard.of));
    }
  }
  const std::int64_t number = part.design.shard.number;
  const auto [taken, added] = parts.try_emplace(number, std::move(part));
  if (!added) {
    refuse(part.folder + ": is shard " + std::to_string(number) + ", and so is " +
           taken->second.folder);
  }
}

void refuse_missing(const Parts& parts) {
  constexpr std::size_t kListed = 10;
  const std::int64_t all = parts.begin()->second.design.shard.of;
  const std::int64_t missing = all - std::ssize(parts);
  if (missing == 0) return;
  std::vector<std::string> listed;
  for (std::int64_t i = 1; i <= all && listed.size() < kListed; ++i)
    if (!parts.contains(i)) listed.push_back(std::to_string(i));
  refuse(std::to_string(missing) + " of " + std::to_string(all) + " shards " +
         (missing == 1 ? "is" : "are") + " missing: " + io::joined(listed, ", ") +
         (missing > std::ssize(listed) ? ", ..." : "") + "; name all their folders");
}

/// The rows of all shards, in the order of the whole sweep. Each shard's come in order.
std::vector<Row> read_rows(const Parts& parts) {
  std::vector<Row> rows;
  for (const auto& [number, part] : parts) {
    for (Row& row : read_runs(runs_path(part.folder), part.design)) rows.push_back(std::move(row));
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.run < b.run; });
  return rows;
}

}  // namespace

SweepResult merge_shards(const std::vector<std::string>& folders, const std::string& folder,
                         bool force, const std::string& plot_script) {
  Parts parts;
  for (const std::string& from : folders) add_part(open_part(from), parts);
  if (parts.empty()) refuse("no shards to merge: name their folders");
  refuse_missing(parts);
  std::vector<Row> rows = read_rows(parts);
  const Design whole = whole_of(parts.begin()->second.design);
  const FolderLock lock(folder);
  claim_folder(folder, whole, force);
  remove_leftovers(folder, whole);
  for (const auto& [number, part] : parts) copy_series(part.folder, part.design, folder);
  return write_results(folder, whole, std::move(rows), plot_script);
}

}  // namespace pupflow::study
