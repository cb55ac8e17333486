#include "app/report/error/litter.h"

#include <algorithm>
#include <cmath>

#include "app/report/error/paired.h"
#include "app/report/statistics.h"

namespace pupflow::report {
namespace {

constexpr Observable kShown[] = {Observable::huddling, Observable::mean_tb, Observable::flow};
constexpr double kTemperatures[] = {0.2, 0.48, 0.8};  // cold, transition, warm

/// How large a change is, in units of its interval.
enum class Size { none, perhaps, clear };

Size size_of(const Compared& row) {
  double furthest = 0;  // in intervals; above 2 it is not due to chance
  for (const Estimate& change : row.differences) {
    if (change.beyond_chance())
      furthest = std::max(furthest, std::abs(change.mean) / change.interval);
  }
  return furthest > 2 ? Size::clear : furthest > 1 ? Size::perhaps : Size::none;
}

/// Which changes have an effect on a mean, as far as these runs show.
std::string verdict(const Paired& paired) {
  std::string lists[3];
  for (const Compared& row : paired.rows) {
    if (row.change.group.empty() || !std::isfinite(row.differences[0].interval)) continue;
    std::string& list = lists[static_cast<int>(size_of(row))];
    const bool named =
        row.change.label.find(' ') != std::string::npos;  // the label is clear without its group
    list += (list.empty() ? "" : "; ") + (named ? "" : row.change.group + " ") + row.change.label;
  }
  const auto words = [](const std::string& list) { return list.empty() ? "nothing" : list; };
  return "**What this means.** At least one mean changes by more than twice its interval with: " +
         words(lists[2]) +
         ". By more than its interval, as one mean in twenty does by chance: " + words(lists[1]) +
         ". By less than its interval: " + words(lists[0]) + ".";
}

/// The time with twice the step.
std::string time_words(const Paired& paired) {
  const Compared& base = paired.rows.front();
  for (const Compared& row : paired.rows) {
    if (row.change.params.dt != 2 * base.change.params.dt) continue;
    return "Twice the step takes " + rounded(row.seconds / base.seconds, 2) +
           " times the processor time for the same model seconds.";
  }
  return "";
}

}  // namespace

void litter_section(Report& report) {
  const bool quick = report.options().quick;
  report.heading("7. The litter: what each choice changes");
  report.text(
      "The litter is chaotic, so the error of a single run at a point in time has no meaning "
      "(section "
      "8 shows how fast two runs diverge). Means over seeds are compared. Every row below has the "
      "same " +
      std::to_string(quick ? 4 : 40) + " seeds. " + how_to_read() +
      " `pupflow report error SCENE` makes such a table of any scene.");
  std::vector<std::string> shown;
  for (const Observable one : kShown) shown.push_back(statistic_name(one));
  for (const double ta : kTemperatures) {
    Params base;
    base.ambient_temperature = ta;
    if (quick) base.steps = 400, base.discard = 200;
    const std::string name = "litter-" + rounded(ta);
    const Paired paired =
        compare({name, changes_of(base, quick ? 2 : 4), quick ? 4 : 40, shown}, report.options());
    report.subheading("T_a = " + rounded(ta));
    show(report, name,
         "Size of each change against processor seconds at T_a = " + rounded(ta) +
             ", with its 95 % interval",
         paired);
    report.text(verdict(paired) + " " + time_words(paired));
  }
}

}  // namespace pupflow::report
