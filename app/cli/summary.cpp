#include "app/cli/summary.h"

#include <string_view>
#include <vector>

#include "app/io/celsius.h"
#include "app/io/json.h"
#include "app/io/provenance.h"
#include "app/io/table.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

std::string value_of(const Params& params, std::string_view name) {
  return format_value(*find_parameter(name), params);
}

std::string means_text(const Simulation& simulation, const Seen& seen, bool celsius) {
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
  const auto add = [&](const std::string& label, double value, const std::string& unit = "") {
    rows.push_back({"  " + label, io::formatted("%.4g", value) + (unit.empty() ? "" : " ") + unit});
  };
  const Observables m = means.means();
  for (const ObservableField& field : observables()) {
    const bool lagged = field.observable == Observable::flow && params.flow_lag != 1;
    const double value = m.*field.value;
    add(std::string(field.label) + (lagged ? ", lag " + std::to_string(params.flow_lag) : ""),
        value,
        celsius && io::is_temperature(field) ? "(" + io::celsius_text(value) + ")"
                                             : std::string(field.unit));
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

void add_celsius(CLI::App& verb, bool& celsius) {
  verb.add_flag("--celsius", celsius,
                "Temperatures in the summary in degrees, too; 0.6 is 37 \u00b0C. Files keep the "
                "model's units");
}

std::string litter_words(const Params& params, bool celsius) {
  return io::formatted("%d %s of %d points, T_a %s, seed %lld, %s precision, heading %s",
                       params.pups, params.pups == 1 ? "pup" : "pups", points_per_pup(params),
                       io::with_celsius(io::number_text(params.ambient_temperature),
                                        params.ambient_temperature, celsius)
                           .c_str(),
                       static_cast<long long>(params.seed), value_of(params, "precision").c_str(),
                       value_of(params, "heading").c_str());
}

std::string run_summary(const std::string& title, const Simulation& simulation, const Seen& seen,
                        double seconds, bool celsius) {
  const long long done = simulation.steps_done();
  std::string text = title.empty() ? "" : title + "\n";
  text += litter_words(simulation.params(), celsius) + "\n";
  text += io::formatted("%lld %s, %.6g s of model time, in %.3g s", done,
                        done == 1 ? "step" : "steps", simulation.time(), seconds);
  if (done > 0 && seconds > 0)
    text += io::formatted(": %.4g steps/s", static_cast<double>(done) / seconds);
  text += "\n" + means_text(simulation, seen, celsius);
  text += "status  " + (simulation.status().ok() ? "fine" : simulation.status().message()) + "\n";
  for (const Warning& warning : simulation.warnings())
    text += "warning " + warning.message() + "\n";
  text += "hash    " + io::hash_text(simulation.hash()) + "\n";
  return text;
}

std::string run_json(const std::string& title, const Simulation& simulation, const Seen& seen,
                     double seconds) {
  const Params& params = simulation.params();
  const RunMeans& means = seen.means;
  const Observables observed = means.means();
  io::JsonObject values;
  for (const ObservableField& field : observables()) {
    values.emplace_back(field.name, io::json_number(observed.*field.value));
  }
  values.emplace_back(run_statistics()[kExposedSd].name, io::json_number(means.exposed_sd()));
  if (seen.overlap) {
    const Overlap& overlap = *seen.overlap;
    values.emplace_back("nearest", io::json_number(overlap.nearest));
    values.emplace_back("closest", io::json_number(overlap.least));
    values.emplace_back("inside", io::json_number(overlap.inside));
    values.emplace_back("inside_exposed", io::json_number(overlap.inside_exposed));
  }
  io::JsonObject all{{"title", io::json_string(title)}};
  io::JsonObject settings;
  for (const Parameter& parameter : parameters()) {
    const std::string value = format_value(parameter, params);
    settings.emplace_back(parameter.name, parameter.kind == Parameter::Kind::choice
                                              ? io::json_string(value)
                                              : io::json_number(parameter.get(params)));
  }
  std::vector<std::string> warnings;
  for (const Warning& warning : simulation.warnings()) {
    warnings.push_back(io::json_string(warning.message()));
  }
  const Status& status = simulation.status();
  all.emplace_back("parameters", io::json_object(settings));
  all.emplace_back("steps", std::to_string(simulation.steps_done()));
  all.emplace_back("time", io::json_number(simulation.time()));
  all.emplace_back("seconds", io::json_number(seconds));
  all.emplace_back("steps_in_means", std::to_string(means.count()));
  all.emplace_back("means", io::json_object(values));
  all.emplace_back("status", io::json_string(status.ok() ? "fine" : status.message()));
  all.emplace_back("warnings", io::json_array(warnings));
  all.emplace_back("hash", io::json_string(io::hash_text(simulation.hash())));
  return io::json_file(all);
}

}  // namespace pupflow::cli
