#include "app/window/history_csv.h"

#include <filesystem>
#include <limits>
#include <vector>

#include "app/io/atomic_file.h"
#include "app/io/csv.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/window/picture_path.h"

namespace pupflow::window {
namespace {

/// Columns after those of the metrics CSV.
struct Column {
  const char* name;
  double (*value)(const History::Sample&);
};

constexpr Column kColumns[] = {
    {"lowest_tb", [](const History::Sample& s) { return s.coldest; }},
    {"highest_tb", [](const History::Sample& s) { return s.warmest; }},
    {"ta", [](const History::Sample& s) { return s.ta; }},
    {"tp", [](const History::Sample& s) { return s.tp; }},
    {"steps", [](const History::Sample& s) { return static_cast<double>(s.steps); }},
};

}  // namespace

std::string history_csv(const LitterState& state, StepRange steps) {
  std::string text;
  for (const auto& [name, value] : io::provenance(state.view().recipe, {{"command", "live"}})) {
    text += "# " + name + " = " + value + '\n';
  }
  std::vector<std::string> cells = io::metrics_columns();
  for (const Column& column : kColumns) cells.emplace_back(column.name);
  text += io::joined(cells, ",") + '\n';
  constexpr std::int64_t kFinest = std::numeric_limits<std::int64_t>::max();
  for (const History::Entry& entry : state.history.between(steps.first, steps.last, kFinest)) {
    const History::Sample& sample = *entry.sample;
    if (sample.last < steps.first || sample.first > steps.last) continue;
    cells = io::metrics_cells(sample.last, sample.time, sample.mean);
    for (const Column& column : kColumns) cells.push_back(io::number_text(column.value(sample)));
    text += io::joined(cells, ",") + '\n';
  }
  return text;
}

std::string save_history_csv(const std::string& pattern, const LitterState& state,
                             StepRange steps) {
  std::filesystem::path name(pattern.empty() ? "pupflow-%05d" : pattern);
  name.replace_extension(".csv");
  const std::string path = picture_path(name.string(), state.view().step);
  io::AtomicFile file(path, false);
  file.write(history_csv(state, steps));
  file.commit();
  return path;
}

}  // namespace pupflow::window
