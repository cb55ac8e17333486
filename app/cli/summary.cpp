#include "app/cli/summary.h"

#include <string_view>
#include <vector>

#include "app/io/provenance.h"
#include "app/io/table.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

std::string value_of(const Params& params, std::string_view name) {
  return format_value(*find_parameter(name), params);
}

std::string means_text(const Simulation& simulation, const Seen& seen) {
  const RunMeans& means = seen.means;
  const Params& params = simulation.params();
  const long long discard = params.discard, done = simulation.steps_done();
  if (done == 0) return "no means: no step was taken\n";
  if (means.count() == 0) {
    return io::formatted(
        "no means: the run ended at step %lld, and discard = %lld leaves out steps 1 to %lld\n",
        done, discard, discard);
  }
  const long long first = done - means.count() + 1;  // after --from later than discard + 1
  std::vector<io::Row> rows;
  // In full precision, to compare with a sweep's row of the same parameters and seed.
  const auto add = [&](const std::string& label, double value, std::string_view unit = "") {
    rows.push_back(
        {"  " + label, io::number_text(value) + (unit.empty() ? "" : " ") + std::string(unit)});
  };
  const Observables m = means.means();
  for (const ObservableField& field : observables()) {
    const bool lagged = field.observable == Observable::flow && params.flow_lag != 1;
    add(std::string(field.label) + (lagged ? ", lag " + std::to_string(params.flow_lag) : ""),
        m.*field.value, field.unit);
  }
  add(std::string(run_statistics()[kExposedSd].label), means.exposed_sd());
  const std::string title = io::formatted("means over steps %lld to %lld\n", first, done);
  if (!seen.overlap) return title + io::aligned(rows);
  const Overlap& o = *seen.overlap;
  const std::string text =
      title + io::aligned(rows) +
      io::formatted("overlap of bodies, every %dth of these steps\n", kOverlapEvery);
  rows.clear();
  add("nearest centres apart", o.nearest);
  add("closest ever", o.least);
  add("points inside another", o.inside);
  add("exposed share of those", o.inside_exposed);
  return text + io::aligned(rows);
}

}  // namespace

std::string litter_words(const Params& params) {
  return io::formatted("%d %s of %d points, T_a %s, seed %lld, %s precision, heading %s",
                       params.pups, params.pups == 1 ? "pup" : "pups", points_per_pup(params),
                       io::number_text(params.ambient_temperature).c_str(),
                       static_cast<long long>(params.seed), value_of(params, "precision").c_str(),
                       value_of(params, "heading").c_str());
}

std::string run_summary(const std::string& title, const Simulation& simulation, const Seen& seen,
                        double seconds) {
  const long long done = simulation.steps_done();
  std::string text = title.empty() ? "" : title + "\n";
  text += litter_words(simulation.params()) + "\n";
  text += io::formatted("%lld %s, %.6g s of model time, in %.3g s", done,
                        done == 1 ? "step" : "steps", simulation.time(), seconds);
  if (done > 0 && seconds > 0)
    text += io::formatted(": %.4g steps/s", static_cast<double>(done) / seconds);
  text += "\n" + means_text(simulation, seen);
  text += "status  " + (simulation.status().ok() ? "fine" : simulation.status().message()) + "\n";
  for (const Warning& warning : simulation.warnings())
    text += "warning " + warning.message() + "\n";
  text += "hash    " + io::hash_text(simulation.hash()) + "\n";
  return text;
}

}  // namespace pupflow::cli
