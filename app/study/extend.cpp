#include "app/study/extend.h"

#include <filesystem>

#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/study/files.h"
#include "app/study/journal.h"
#include "app/study/plot_script.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestScript = std::size_t{1} << 30;

/// The number in the line "name = number" of a manifest; 0 where there is none.
std::int64_t number_in(const std::string& manifest, const std::string& name) {
  const std::string key = "\n" + name + " = ";
  const std::size_t at = manifest.find(key);
  if (at == std::string::npos) return 0;
  const std::size_t begin = at + key.size(), end = manifest.find('\n', begin);
  const std::string_view text = std::string_view(manifest).substr(begin, end - begin);
  return io::read_number<std::int64_t>(text).value_or(0);
}

}  // namespace

std::optional<Design> extended_by(const Design& design, const std::string& there) {
  if (!design.shard.whole()) return std::nullopt;
  Design before = design;
  before.seeds = number_in(there, "seeds");
  before.record_every = number_in(there, "record_every");
  const bool same_series = before.record_every == design.record_every || before.record_every == 0;
  if (before.seeds < 1 || before.seeds > design.seeds || !same_series ||
      manifest_text(before) != there)
    return std::nullopt;
  return before;
}

void prepare_extension(const std::string& folder, const Design& before) {
  if (fs::exists(runs_path(folder))) {
    const std::vector<Row> rows = read_runs(runs_path(folder), before);
    Journal journal(journal_path(folder), before);
    for (const Row& row : rows) journal.add(row);
    const std::string script = script_path(folder, before);
    if (fs::exists(script) &&
        io::read_file(script, kLargestScript) == plot_script(before, summarise(before, rows)))
      remove_file(script);
  }
  for (const std::string& result : result_paths(folder, before)) remove_file(result);
}

}  // namespace pupflow::study
