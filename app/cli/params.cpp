// pupflow params: every parameter, for people (text), docs (markdown) and programs (json).
#include <algorithm>
#include <cctype>
#include <memory>

#include "app/cli/verb.h"
#include "app/io/json.h"
#include "app/io/table.h"
#include "pupflow/parameters.h"

namespace pupflow::cli {
namespace {

struct ParamsOptions {
  Common common;
  std::string format;
};

std::string_view effect_word(Parameter::Effect effect) {
  switch (effect) {
    case Parameter::Effect::next_step:
      return "next step";
    case Parameter::Effect::restart:
      return "restart";
    case Parameter::Effect::run:
      return "run";
  }
  return {};
}

std::string_view kind_word(Parameter::Kind kind) {
  switch (kind) {
    case Parameter::Kind::real:
      return "real";
    case Parameter::Kind::integer:
      return "integer";
    case Parameter::Kind::choice:
      return "choice";
  }
  return {};
}

std::string default_text(const Parameter& parameter) {
  return format_value(parameter, parameter.default_value());
}

/// `values` gets a column of its own where a scene or an option was given.
std::string text_table(const Params& values, bool with_values) {
  std::vector<io::Row> rows{{"name", "symbol", "default", "range", "unit", "title", "source"}};
  if (with_values) rows[0].insert(rows[0].begin() + 3, "here");
  for (const Parameter& p : parameters()) {
    io::Row row{std::string(p.name), std::string(p.symbol), default_text(p),      range_text(p),
                std::string(p.unit), std::string(p.title),  std::string(p.source)};
    if (with_values) row.insert(row.begin() + 3, format_value(p, values));
    rows.push_back(row);
  }
  return io::aligned(rows);
}

/// Groups in the order in which the table first names them.
std::vector<std::string_view> groups() {
  std::vector<std::string_view> names;
  for (const Parameter& p : parameters()) {
    if (std::find(names.begin(), names.end(), p.group) == names.end()) names.push_back(p.group);
  }
  return names;
}

std::string markdown(const Params& values, bool with_values) {
  std::string text =
      "# Parameters\n\n"
      "Written by `pupflow params --format markdown`.\n\n"
      "A parameter is set by its name: in a scene file (`ta = 0.2`) or with `--set ta=0.2`. A "
      "change "
      "in the live window acts on the next step, needs a restart of the litter, or concerns only "
      "how long a run is and what its means cover (run).\n";
  for (const std::string_view group : groups()) {
    std::string heading(group);
    heading[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(heading[0])));
    text += "\n## " + heading + "\n\n";
    std::vector<io::Row> rows{
        {"name", "symbol", "default", "range", "unit", "acts", "meaning", "source"}};
    if (with_values) rows[0].insert(rows[0].begin() + 3, "here");
    for (const Parameter& p : parameters()) {
      if (p.group != group) continue;
      io::Row row{"`" + std::string(p.name) + "`",
                  std::string(p.symbol),
                  default_text(p),
                  range_text(p),
                  std::string(p.unit),
                  std::string(effect_word(p.effect)),
                  std::string(p.doc),
                  std::string(p.source)};
      if (with_values) row.insert(row.begin() + 3, format_value(p, values));
      rows.push_back(row);
    }
    text += io::markdown_table(rows);
  }
  return text;
}

std::string json_value(const Parameter& p, double value) {
  return p.kind == Parameter::Kind::choice ? io::json_string(format_value(p, value))
                                           : io::json_number(value);
}

std::string json(const Params& values) {
  std::vector<io::JsonObject> rows;
  for (const Parameter& p : parameters()) {
    io::JsonObject row{{"name", io::json_string(p.name)},
                       {"symbol", io::json_string(p.symbol)},
                       {"title", io::json_string(p.title)},
                       {"unit", io::json_string(p.unit)},
                       {"group", io::json_string(p.group)},
                       {"source", io::json_string(p.source)},
                       {"doc", io::json_string(p.doc)},
                       {"kind", io::json_string(kind_word(p.kind))},
                       {"effect", io::json_string(effect_word(p.effect))},
                       {"default", json_value(p, p.default_value())},
                       {"value", json_value(p, p.get(values))}};
    if (p.kind == Parameter::Kind::choice) {
      row.emplace_back("choices", io::json_strings(p.choices));
    } else {
      row.emplace_back("min", io::json_number(p.min));
      row.emplace_back("min_open", io::json_bool(p.min_open));
      row.emplace_back("max", io::json_number(p.max));
    }
    rows.push_back(row);
  }
  return io::json_objects(rows);
}

void work(const ParamsOptions& options) {
  const Params values = io::set_up(options.common.settings).params;
  const bool with_values = !options.common.settings.empty();
  deliver(options.common, options.format == "json"       ? json(values)
                          : options.format == "markdown" ? markdown(values, with_values)
                                                         : text_table(values, with_values));
}

}  // namespace

Verb add_params(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "params", "List every parameter: name, symbol, default, range, unit, source");
  const auto options = std::make_shared<ParamsOptions>();
  CommonHelp help;
  help.settings = "adds a column with the values that it comes to";
  help.threads = "No effect here; every verb takes it";
  help.out = "Write the list to a file instead of standard output";
  help.quiet = "No effect here; the list is all that is printed";
  add_common(*app, options->common, help);
  add_format(*app, options->format);
  return {app,
          [options] { work(*options); },
          {{"params", "Every parameter"},
           {"params cold", "The values of a scene beside the defaults"}}};
}

}  // namespace pupflow::cli
