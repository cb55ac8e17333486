// pupflow help, version, scenes: what the program says of itself.
#include <algorithm>
#include <memory>

#include "app/cli/manual.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/json.h"
#include "app/io/nearest.h"
#include "app/io/provenance.h"
#include "app/io/scene_file.h"
#include "app/io/table.h"

namespace pupflow::cli {
namespace {

std::vector<std::string_view> form_names() {
  std::vector<std::string_view> names;
  for (const ManualForm& form : manual_forms()) names.push_back(form.name);
  return names;
}

std::string form_help() {
  std::string text;
  for (const ManualForm& form : manual_forms()) {
    text += (text.empty() ? "" : "; ") + std::string(form.name) + ": " + std::string(form.doc);
  }
  return text + " (default text)";
}

struct HelpOptions {
  std::string verb, format = "text";
};

void print_help(const HelpOptions& options, const std::vector<Page>& pages) {
  const auto form = std::find_if(manual_forms().begin(), manual_forms().end(),
                                 [&](const ManualForm& row) { return row.name == options.format; });
  if (form->all != nullptr) {
    if (!options.verb.empty()) {
      io::refuse("--format " + options.format + " is of all verbs: leave out '" + options.verb +
                 "'");
    }
    io::print(form->all(pages));
    return;
  }
  const std::string name = options.verb.empty() ? "pupflow" : "pupflow " + options.verb;
  const auto page =
      std::find_if(pages.begin(), pages.end(), [&](const Page& one) { return one.name == name; });
  if (page == pages.end()) {
    std::vector<std::string_view> verbs;
    for (const Page::Entry& verb : pages.front().verbs) verbs.push_back(verb.names);
    const std::string meant = io::did_you_mean(options.verb, verbs);
    io::refuse("no verb " + io::quoted(options.verb) +
               (meant.empty() ? "; verbs: " + io::joined(verbs, ", ") : meant));
  }
  io::print(form->one(*page));
}

struct ScenesOptions {
  Common common;
  std::string name, format;
};

/// The file of one scene, to change and keep.
std::string scene_text(const std::string& name) {
  std::vector<std::string_view> names;
  for (const io::ShippedScene& scene : io::shipped_scenes()) {
    if (scene.name == name) return std::string(scene.text);
    names.push_back(scene.name);
  }
  const std::string meant = io::did_you_mean(name, names);
  io::refuse("no scene " + io::quoted(name) +
             (meant.empty() ? "; shipped: " + io::joined(names, ", ") : meant));
}

std::string list_of_scenes(const std::string& format) {
  std::vector<io::Row> rows;
  std::vector<io::JsonObject> objects;
  std::string markdown = "| scene | title | |\n|---|---|---|\n";
  for (const io::ShippedScene& shipped : io::shipped_scenes()) {
    std::vector<std::string> problems;
    const io::Scene scene = io::parse_scene(shipped.text, std::string(shipped.name), problems);
    const std::string name(shipped.name);
    rows.push_back({name, scene.title + ". " + scene.description});
    markdown += "| `" + name + "` | " + scene.title + " | " + scene.description + " |\n";
    objects.push_back({{"name", io::json_string(name)},
                       {"title", io::json_string(scene.title)},
                       {"description", io::json_string(scene.description)}});
  }
  if (format == "json") return io::json_objects(objects);
  return format == "markdown" ? markdown : io::aligned(rows);
}

void work(const CLI::App& verb, const ScenesOptions& options) {
  refuse_idle(verb, "--format", options.name.empty(), "the list; a scene's file is TOML");
  io::set_up(options.common.settings);  // checked like everywhere
  deliver(options.common,
          options.name.empty() ? list_of_scenes(options.format) : scene_text(options.name));
}

}  // namespace

Verb add_help(CLI::App& program, const std::vector<Verb>& verbs) {
  CLI::App* app = program.add_subcommand(
      "help", "Print the manual: of a verb, of the program, for man or for a shell");
  const auto options = std::make_shared<HelpOptions>();
  app->add_option("VERB", options->verb, "The verb (default: the program)")
      ->option_text(" ")
      ->check(not_empty);
  app->add_option("--format", options->format, form_help())
      ->option_text(io::joined(form_names(), "|"))
      ->check(one_of(form_names()));
  return {app,
          [options, &program, &verbs] {
            std::vector<Page> pages{page_of(program, verbs)};
            for (const Verb& verb : verbs) pages.push_back(page_of(verb));
            print_help(*options, pages);
          },
          {{"help run", "What 'pupflow run --help' prints"},
           {"help --format bash", "The completion for bash, to be sourced by it"}}};
}

Verb add_version(CLI::App& program) {
  CLI::App* app = program.add_subcommand("version", "Print the version");
  return {app,
          [] { io::print(io::program_version() + "\n"); },
          {{"version", "The version, as every output carries it"},
           {"doctor", "The version with compiler, processor and graphics"}}};
}

Verb add_scenes(CLI::App& program) {
  CLI::App* app = program.add_subcommand("scenes", "List the shipped scenes, or print one");
  const auto options = std::make_shared<ScenesOptions>();
  app->add_option("NAME", options->name, "The scene whose file is printed (default: list all)")
      ->option_text(" ")
      ->check(not_empty);
  CommonHelp help;
  help.scene = false;
  help.settings = "checked, but the list does not depend on it";
  help.threads = "No effect here; every verb takes it";
  help.out = "Write to a file instead of standard output";
  help.quiet = "No effect here; the list is all that is printed";
  add_common(*app, options->common, help);
  add_format(*app, options->format);
  return {
      app,
      [options, app] { work(*app, *options); },
      {{"scenes", "A line for each scene"},
       {"scenes critical --out mine.toml", "A copy to change; 'pupflow run mine.toml' runs it"}}};
}

}  // namespace pupflow::cli
