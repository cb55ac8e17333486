// The manifest of a sweep, written and read.
#include <toml++/toml.h>
#include <sstream>

#include "app/io/failure.h"
#include "app/io/provenance.h"
#include "app/io/schedule_text.h"
#include "app/io/text.h"
#include "app/study/design.h"

namespace pupflow::study {
namespace {

std::string axis_text(const Axis& axis) {
  std::string text(axis.parameter->name);
  for (std::size_t i = 0; i < axis.values.size(); ++i) {
    text += (i == 0 ? "=" : ",") + format_value(*axis.parameter, axis.values[i]);
  }
  return text;
}

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw io::Failure(io::ExitCode::bad_input, where + ": is no manifest of a sweep: " + what);
}

template <class T>
T required(const toml::node_view<toml::node>& node, const char* key, const std::string& where) {
  const auto value = node[key].value<T>();
  if (!value) refuse(where, std::string(key) + " is missing or of another kind");
  return *value;
}

}  // namespace

std::string manifest_text(const Design& design) {
  std::ostringstream text;
  text << "# What this sweep computed; 'pupflow sweep' writes it and compares with it before it "
          "goes on.\n"
       << "software = \"" << io::program_version() << "\"\n\n[sweep]\n"
       << "name = \"" << design.name << "\"\nvary = [";
  for (std::size_t a = 0; a < design.axes.size(); ++a) {
    text << (a == 0 ? "" : ", ") << '"' << axis_text(design.axes[a]) << '"';
  }
  text << "]\nseeds = " << design.seeds << "\nruns = " << design.runs() << "\nshard = \""
       << design.shard.number << '/' << design.shard.of << "\"\n\n[parameters]\n";
  for (const Parameter& parameter : parameters()) {
    const bool choice = parameter.kind == Parameter::Kind::choice;
    const char* quote = choice ? "\"" : "";
    text << parameter.name << " = " << quote << format_value(parameter, design.base) << quote
         << '\n';
  }
  const Schedule& schedule = design.base.schedule;
  if (!schedule.empty()) text << "at = \"" << io::schedule_text(schedule) << "\"\n";
  return text.str();
}

Design parse_manifest(const std::string& text, const std::string& where) {
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error& error) {
    refuse(where, std::string(error.description()));
  }
  Design design;
  const auto sweep = table["sweep"];
  design.name = required<std::string>(sweep, "name", where);
  design.seeds = required<std::int64_t>(sweep, "seeds", where);
  design.shard = parse_shard(required<std::string>(sweep, "shard", where));
  if (const toml::array* vary = sweep["vary"].as_array()) {
    for (const toml::node& axis : *vary)
      design.axes.push_back(parse_axis(axis.value_or(std::string())));
  }
  if (const toml::table* given = table["parameters"].as_table()) {
    for (const auto& [key, value] : *given) {
      if (find_parameter(key.str()) || key.str() == "at") continue;
      refuse(where, "this version has no parameter " + io::quoted(key.str()));
    }
  }
  std::vector<const Parameter*> missing;
  for (const Parameter& parameter : parameters()) {
    const std::string name(parameter.name);
    const auto node = table["parameters"][name];
    Problem problem;
    std::string value;
    if (const auto word = node.value_exact<std::string>()) {
      value = *word;
    } else if (const auto number = node.value<double>()) {
      value = format_value(parameter, *number);
    } else if (!node) {
      missing.push_back(&parameter);
      continue;
    } else {
      refuse(where, "parameter " + name + " is of another kind");
    }
    if (!parse_value(parameter, value, design.base, problem)) refuse(where, problem.message);
  }
  if (const auto at = table["parameters"]["at"].value<std::string>()) {
    std::vector<std::string> problems;
    design.base.schedule = io::parse_schedule(*at, where, problems);
    if (!problems.empty()) refuse(where, problems.front());
  }
  io::take_as_before(missing, where, design.base);
  if (design.seeds < 1) refuse(where, "seeds must be at least 1");
  check_design(design);
  return design;
}

}  // namespace pupflow::study
