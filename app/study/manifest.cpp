// The manifest of a sweep, written and read.
#include <toml++/toml.h>

#include <algorithm>

#include "app/io/failure.h"
#include "app/io/provenance.h"
#include "app/io/schedule_text.h"
#include "app/io/text.h"
#include "app/io/text_stream.h"
#include "app/io/toml_problem.h"
#include "app/study/design.h"
#include "app/study/latin.h"
#include "app/study/table.h"

namespace pupflow::study {
namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw io::Failure(io::ExitCode::bad_input, where + ": is no manifest of a sweep: " + what);
}

template <class T>
T required(const toml::node_view<toml::node>& node, const char* key, const std::string& where) {
  const auto value = node[key].value_exact<T>();  // toml++ would cast any number
  if (!value) refuse(where, std::string(key) + " is missing or of another kind");
  return *value;
}

}  // namespace

namespace {

/// The lines that tell of the points.
std::string points_text(const Design& design) {
  if (design.layout == Layout::table) {
    std::vector<std::string_view> columns;
    for (const Axis& axis : design.axes) columns.push_back(axis.parameter->name);
    if (!design.given_seeds.empty()) columns.emplace_back("seed");
    return "columns = \"" + io::joined(columns, ",") + "\"\ntable = \"" + table_hash(design) +
           "\"\n";
  }
  std::vector<std::string> vary = design.spans;
  if (design.layout == Layout::grid) {
    for (const Axis& axis : design.axes) vary.push_back(axis_text(axis));
  }
  std::string text =
      "vary = [" +
      io::joined(vary, ", ", [](const std::string& axis) { return '"' + axis + '"'; }) + "]\n";
  if (design.layout == Layout::latin) text += "lhs = " + std::to_string(design.points()) + "\n";
  return text;
}

}  // namespace

std::string manifest_text(const Design& design) {
  io::TextStream text;
  text << "# What this sweep computed; 'pupflow sweep' writes it and compares with it before it "
          "goes on.\n"
       << "software = \"" << io::program_version() << "\"\n\n[sweep]\n"
       << "name = \"" << design.name << "\"\n"
       << points_text(design) << "seeds = " << design.seeds << "\n";
  if (design.seed_block != design.seeds) text << "seed_block = " << design.seed_block << "\n";
  text << "runs = " << design.runs() << "\n";
  if (design.record_every > 0) text << "record_every = " << design.record_every << "\n";
  text << "shard = \"" << design.shard.number << '/' << design.shard.of << "\"\n\n[parameters]\n";
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

namespace {

using Node = toml::node_view<toml::node>;

void read_parameters(toml::table& table, const std::string& where, Params& params) {
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
    } else if (const auto number = node.value<double>();
               number && parameter.kind != Parameter::Kind::choice) {
      if (!check_value(parameter, *number, problem)) refuse(where, problem.message);
      value = format_value(parameter, *number);
    } else if (!node) {
      missing.push_back(&parameter);
      continue;
    } else {
      refuse(where, "parameter " + name + " is of another kind");
    }
    if (!parse_value(parameter, value, params, problem)) refuse(where, problem.message);
  }
  if (const auto at = table["parameters"]["at"].value<std::string>()) {
    std::vector<std::string> problems;
    params.schedule = io::parse_schedule(*at, where, problems);
    if (!problems.empty()) refuse(where, problems.front());
  }
  io::take_as_before(missing, where, params);
}

/// Needs design.base.
void read_points(Node sweep, const std::string& where, const std::string& table, Design& design) {
  if (const auto hash = sweep["table"].value<std::string>()) {
    read_table(table, design);
    if (table_hash(design) == *hash) return;
    io::refuse(table + ": is not the table that " + where + " was made with");
  }
  std::vector<std::string> vary;
  if (const toml::array* axes = sweep["vary"].as_array()) {
    for (const toml::node& axis : *axes) vary.push_back(axis.value_or(std::string()));
  }
  if (!sweep["lhs"]) {
    for (const std::string& axis : vary) design.axes.push_back(parse_axis(axis));
    return;
  }
  const auto points = required<std::int64_t>(sweep, "lhs", where);
  if (points < 1 || points > kMostValues) refuse(where, "lhs is out of range");
  std::vector<Span> spans;
  spans.reserve(vary.size());
  for (const std::string& span : vary) spans.push_back(parse_span(span));
  spread_latin(design, spans, points);
}

/// Refuses forms of TOML that no manifest has. The parser goes as deep as tables lie in each other.
void check_lines(const std::string& text, const std::string& where) {
  constexpr const char* kName = "abcdefghijklmnopqrstuvwxyz0123456789_";
  std::int64_t number = 0;
  for (const std::string_view line : io::split(text, '\n')) {
    ++number;
    if (line.empty() || line.starts_with('#') || line == "[sweep]" || line == "[parameters]")
      continue;
    const std::size_t end = line.find_first_not_of(kName);
    if (end == 0 || end == line.npos || !line.substr(end).starts_with(" = ") ||
        line.find('{') != line.npos)
      refuse(where + ":" + std::to_string(number), "a line is neither 'name = value' nor a table");
  }
}

Design read_manifest(const std::string& text, const std::string& where, const std::string& table) {
  check_lines(text, where);
  toml::table toml;
  try {
    toml = toml::parse(text);
  } catch (const toml::parse_error& error) {
    refuse(where, io::toml_problem(error.description()));
  }
  Design design;
  const auto sweep = toml["sweep"];
  design.name = required<std::string>(sweep, "name", where);
  // It names files and stands in gnuplot's script, so no other text may come from a file.
  if (std::find(kDesignNames.begin(), kDesignNames.end(), design.name) == kDesignNames.end()) {
    refuse(where, "no sweep is called " + io::quoted(design.name) + ", only sweep and figure2 are");
  }
  design.shard = parse_shard(required<std::string>(sweep, "shard", where), where + ": shard");
  read_parameters(toml, where, design.base);
  read_points(sweep, where, table, design);
  design.seeds = required<std::int64_t>(sweep, "seeds", where);
  design.seed_block = sweep["seed_block"].value_exact<std::int64_t>().value_or(design.seeds);
  design.record_every = sweep["record_every"].value_exact<std::int64_t>().value_or(0);
  if (design.seeds < 1) refuse(where, "seeds must be at least 1");
  if (design.seed_block != design.seeds && design.seed_block != kSeedBlock)
    refuse(where, "seed_block must be " + std::to_string(kSeedBlock));
  if (design.record_every < 0) refuse(where, "record_every must be at least 0");
  check_design(design);
  return design;
}

}  // namespace

Design parse_manifest(const std::string& text, const std::string& where, const std::string& table) {
  try {
    return read_manifest(text, where, table);
  } catch (const io::Failure& wrong) {  // of its ranges and changes it is what an option says, too
    const std::string message = wrong.what();
    if (message.starts_with(where) || (!table.empty() && message.starts_with(table))) throw;
    if (!wrong.several()) throw io::Failure(wrong.code(), where + ": " + message);
    std::vector<std::string> problems;
    for (const std::string_view line : io::split(message, '\n')) {
      problems.push_back(where + ": " + std::string(line));
    }
    throw io::Failure(wrong.code(), problems);
  }
}

}  // namespace pupflow::study
