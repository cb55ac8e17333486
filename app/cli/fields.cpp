// pupflow fields: every quantity that comes out, for people (text), docs (markdown) and programs
// (json).
#include "pupflow/fields.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "app/cli/verb.h"
#include "app/io/json.h"
#include "app/io/table.h"
#include "app/io/text.h"
#include "pupflow/observer.h"

namespace pupflow::cli {
namespace {

struct FieldsOptions {
  Common common;
  std::string format;
};

/// Fields of one owner.
struct Section {
  std::string_view of;     // whose the quantities are
  std::string_view title;  // heading of the page
  std::string_view about;
  std::vector<const Field*> fields;
};

template <class Table>
std::vector<const Field*> pointers(const Table& table) {
  std::vector<const Field*> fields;
  for (const Field& field : table) fields.push_back(&field);
  return fields;
}

std::vector<Section> sections() {
  return {
      {"litter", "Of the litter", "One value after a step.", pointers(observables())},
      {"run", "Of a run",
       "One value for all steps after `discard`. A run has the means of the litter's quantities, "
       "too.",
       pointers(run_statistics().subspan(kObservableCount))},
      {"pup", "Of a pup", "One value for each pup after a step.", pointers(pup_fields())},
      {"afferent", "Of an afferent", "One value for each point of each pup after a step.",
       pointers(afferent_fields())}};
}

/// What a step must record for `field`, in the words of `pupflow explain`.
std::vector<std::string_view> recorded_for(const Field& field) {
  std::vector<std::string_view> names;
  for (int i = 0; i < kPartCount; ++i) {
    const auto part = static_cast<Part>(i);
    if (field.parts.has(part)) names.push_back(part_name(part));
  }
  return names;
}

/// An end of a range; angles as parts of pi.
std::string limit_text(const Field& field, double value) {
  if (std::isnan(value)) return "data";
  const bool angle = field.unit.starts_with("rad");
  const double size = std::abs(value);
  const std::string text = angle && size == std::numbers::pi       ? "π"
                           : angle && size == std::numbers::pi / 2 ? "π/2"
                                                                   : io::number_text(size);
  return (value < 0 ? "−" : "") + text;
}

std::string range_text(const Field& field) {
  return limit_text(field, field.low) + " … " + limit_text(field, field.high);
}

/// The kind, with what the numbers of a categorical field stand for.
std::string kind_text(const Field& field) {
  std::string text(kind_name(field.kind));
  if (field.categories.empty()) return text;
  int number = 0;
  const auto numbered = [&](std::string_view name) {
    return std::to_string(number++) + " " + std::string(name);
  };
  return text + ": " + io::joined(field.categories, ", ", numbered);
}

std::string text_table() {
  std::vector<io::Row> rows{{"name", "of", "symbol", "unit", "range", "kind", "needs", "label"}};
  for (const Section& section : sections()) {
    for (const Field* f : section.fields) {
      rows.push_back({std::string(f->name), std::string(section.of), std::string(f->symbol),
                      std::string(f->unit), range_text(*f), std::string(kind_name(f->kind)),
                      io::joined(recorded_for(*f), ", "), std::string(f->label)});
    }
  }
  return io::aligned(rows);
}

std::string markdown() {
  std::string text =
      "# Fields\n\n"
      "Written by `pupflow fields --format markdown`.\n\n"
      "These are the quantities that come out. CSV files have columns of these names, recordings "
      "data "
      "sets. *Range* is what a quantity is drawn with; *data* stands for an end that is taken from "
      "the data. *Needs* names the parts of a step that compute it. A step leaves them out where "
      "neither the model nor an observer reads them (`pupflow explain` says which), and what the "
      "last "
      "step did not compute is NaN.\n";
  for (const Section& section : sections()) {
    text += "\n## " + std::string(section.title) + "\n\n" + std::string(section.about) + "\n\n";
    std::vector<io::Row> rows{
        {"name", "symbol", "unit", "range", "kind", "needs", "equation", "meaning"}};
    for (const Field* f : section.fields) {
      rows.push_back(
          {"`" + std::string(f->name) + "`", std::string(f->symbol), std::string(f->unit),
           range_text(*f), kind_text(*f), io::joined(recorded_for(*f), ", "),
           f->equation.empty() ? "" : "`" + std::string(f->equation) + "`", std::string(f->doc)});
    }
    text += io::markdown_table(rows);
  }
  return text;
}

std::string json() {
  std::vector<io::JsonObject> rows;
  for (const Section& section : sections()) {
    for (const Field* f : section.fields) {
      const bool is_signed = f->kind == FieldKind::signed_;
      rows.push_back({{"name", io::json_string(f->name)},
                      {"of", io::json_string(section.of)},
                      {"symbol", io::json_string(f->symbol)},
                      {"label", io::json_string(f->label)},
                      {"unit", io::json_string(f->unit)},
                      {"kind", io::json_string(kind_name(f->kind))},
                      {"low", io::json_number(f->low)},
                      {"high", io::json_number(f->high)},
                      {"centre", is_signed ? io::json_number(f->centre) : "null"},
                      {"categories", io::json_strings(f->categories)},
                      {"digits", std::to_string(f->digits)},
                      {"needs", io::json_strings(recorded_for(*f))},
                      {"equation", io::json_string(f->equation)},
                      {"doc", io::json_string(f->doc)}});
    }
  }
  return io::json_objects(rows);
}

void work(const FieldsOptions& options) {
  io::set_up(options.common.settings);  // refuses wrong settings, as every verb does
  deliver(options.common, options.format == "json"       ? json()
                          : options.format == "markdown" ? markdown()
                                                         : text_table());
}

}  // namespace

Verb add_fields(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "fields", "List every quantity that comes out: name, symbol, unit, range, kind, equation");
  const auto options = std::make_shared<FieldsOptions>();
  CommonHelp help;
  help.scene = false;
  help.settings = "does nothing here";
  help.threads = "No effect here; every verb takes it";
  help.out = "Write the list to a file instead of standard output";
  help.quiet = "No effect here; the list is all that is printed";
  add_common(*app, options->common, help);
  add_format(*app, options->format);
  return {app,
          [options] { work(*options); },
          {{"fields", "Every quantity that comes out"},
           {"fields --format json", "The same for a program"}}};
}

}  // namespace pupflow::cli
