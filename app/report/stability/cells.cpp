#include "app/report/stability/cells.h"

#include <algorithm>

#include "app/io/interrupt.h"
#include "app/report/share_out.h"

namespace pupflow::report {

Verdict Cell::verdict() const {
  std::vector<Verdict> all;
  for (const Trial& trial : trials) all.push_back(trial.verdict);
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

int Cell::agreeing() const {
  const Verdict called = verdict();
  return static_cast<int>(std::count_if(trials.begin(), trials.end(), [called](const Trial& trial) {
    return trial.verdict == called;
  }));
}

std::optional<Verdict> Cell::other() const {
  std::optional<Verdict> worst;
  const Verdict called = verdict();
  for (const Trial& trial : trials) {
    if (trial.verdict != called && (!worst || trial.verdict > *worst)) worst = trial.verdict;
  }
  return worst;
}

double Cell::mean(double Trial::*measure) const {
  double sum = 0;
  int count = 0;
  for (const Trial& trial : trials) {
    if (!trial.status.ok()) continue;
    sum += trial.*measure;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

const Trial* Cell::lost() const {
  const auto found = std::find_if(trials.begin(), trials.end(),
                                  [](const Trial& trial) { return !trial.status.ok(); });
  return found == trials.end() ? nullptr : &*found;
}

MapResult compute_map(const StabilityMap& map, const Options& options) {
  const std::size_t columns = map.x.values.size(), rows = map.y.values.size();
  MapResult result(map.methods.size(),
                   std::vector<std::vector<Cell>>(rows, std::vector<Cell>(columns)));
  struct Run {
    Trial* trial;
    Params params;
  };
  std::vector<Run> runs;
  for (std::size_t m = 0; m < map.methods.size(); ++m) {
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        Cell& cell = result[m][j][i];
        const auto params = [&](int seed) {
          return cell_params(map, map.methods[m], map.x.values[i], map.y.values[j], seed);
        };
        const std::vector<Problem> problems = check(params(1));
        if (!problems.empty()) {
          cell.refused = problems[0].message;
          continue;
        }
        cell.trials.resize(static_cast<std::size_t>(map.seeds));
        for (int seed = 1; seed <= map.seeds; ++seed) {
          runs.push_back({&cell.trials[static_cast<std::size_t>(seed - 1)], params(seed)});
        }
      }
    }
  }
  share_out("map " + map.title, static_cast<std::int64_t>(runs.size()), options,
            [&](std::int64_t task) {
              const Run& run = runs[static_cast<std::size_t>(task)];
              const auto trial = map.classify(run.params, io::interrupted);
              if (trial) *run.trial = *trial;
            });
  return result;
}

}  // namespace pupflow::report
