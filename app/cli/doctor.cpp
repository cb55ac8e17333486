// pupflow doctor: what is here, what is missing, and how to get it.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/cli/graphics_module.h"
#include "app/cli/module.h"
#include "app/cli/optional_parts.h"
#include "app/cli/verb.h"
#include "app/io/failure.h"
#include "app/io/json.h"
#include "app/io/machine.h"
#include "app/io/table.h"
#include "pupflow/version.h"

namespace pupflow::cli {
namespace {

struct DoctorOptions {
  Common common;
  bool json = false;
};

bool is_here(const OptionalPart& part) {
  return std::any_of(part.places.begin(), part.places.end(), [&part](const char* place) {
    if (part.kind == "run") return !io::program_path(place).empty();
    std::error_code unreadable;  // as good as not there
    return std::filesystem::exists(program_folder() / place, unreadable);
  });
}

/// A row for each part, and what to install for those that are not here.
void add_optional_parts(std::vector<io::Row>& rows, std::vector<std::string>& advice) {
  for (const OptionalPart& part : kOptionalParts) {
    const bool here = is_here(part), built = part.kind == "built";
    const std::string thing = built ? "module" : part.thing;
    rows.push_back({part.name, here ? thing + " found" : "no " + thing});
    if (here) continue;
    advice.push_back(std::string(part.purpose) + " need " + part.thing + ": apt install " +
                     part.packages + (built ? ", build again" : ""));
  }
}

std::vector<io::Row> build_rows() {
  return {{"version", std::string(version_text())},
          {"compiler", io::compiler_words()},
          {"processor", io::cpu_name()},
          {"kernels", io::kernel_words()},
          {"threads", std::to_string(std::thread::hardware_concurrency())}};
}

/// The rows for one kind of context: what was chosen and every attempt.
void add_context(std::vector<io::Row>& rows, const std::string& what,
                 const context::ContextReport& report) {
  rows.push_back({what, report.works ? "works: " + report.chosen : "does not work"});
  if (report.works) {
    rows.push_back({"", "renderer " + report.renderer});
    rows.push_back({"", "OpenGL " + report.version});
  }
  for (const std::string& attempt : report.tried) rows.push_back({"", "tried " + attempt});
}

std::string as_text(const std::vector<io::Row>& rows, const std::vector<std::string>& advice) {
  std::string text = io::aligned(rows);
  text += advice.empty() ? "Nothing is missing.\n" : "Missing:\n";
  for (const std::string& line : advice) text += "  " + line + "\n";
  return text;
}

/// A row without a name goes on with the one above it.
std::string as_json(const std::vector<io::Row>& rows, const std::vector<std::string>& advice) {
  std::vector<std::pair<std::string, std::vector<std::string>>> values;
  for (const io::Row& row : rows) {
    if (!row[0].empty()) values.push_back({row[0], {}});
    values.back().second.push_back(io::json_string(row[1]));
  }
  io::JsonObject object;
  for (const auto& [name, lines] : values) {
    object.emplace_back(name, lines.size() == 1 ? lines[0] : io::json_array(lines));
  }
  std::vector<std::string> missing;
  for (const std::string& line : advice) missing.push_back(io::json_string(line));
  object.emplace_back("missing", io::json_array(missing));
  return io::json_file(object);
}

void work(const DoctorOptions& options) {
  io::set_up(options.common.settings);  // checked like everywhere
  std::vector<io::Row> rows = build_rows();
  std::vector<std::string> advice;
  add_optional_parts(rows, advice);
  try {
    graphics::Graphics& graphics = load_graphics();
    rows.push_back({"graphics", "module loaded"});
    const context::ContextReport headless = graphics.probe_headless();
    const context::ContextReport window = graphics.probe_window();
    add_context(rows, "pictures", headless);
    add_context(rows, "window", window);
    if (!headless.works) {
      advice.emplace_back("pictures need EGL and a driver: apt install libegl1 libgl1-mesa-dri");
    }
    if (!window.works) {
      advice.emplace_back(
          "the window needs a display (DISPLAY or WAYLAND_DISPLAY); pictures do not");
    }
  } catch (const io::Failure& failure) {
    if (failure.code() != io::ExitCode::no_context) throw;
    rows.push_back({"graphics", "not available"});
    advice.emplace_back(failure.what());
  }
  deliver(options.common, options.json ? as_json(rows, advice) : as_text(rows, advice));
}

}  // namespace

Verb add_doctor(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "doctor", "Report versions, processor and graphics; tell what is missing and how to get it");
  const auto options = std::make_shared<DoctorOptions>();
  CommonHelp help;
  help.scene = false;
  help.settings = "checked, but the report does not depend on it";
  help.threads = "No effect here; every verb takes it";
  help.out = "Write the report to a file instead of standard output";
  help.quiet = "No effect here; the report is all that is printed";
  add_common(*app, options->common, help);
  add_json(*app, options->json);
  app->footer("Exit code 0 whenever it could report, also when something is missing.");
  return {app,
          [options] { work(*options); },
          {{"doctor", "What works here, and what to install for the rest"},
           {"doctor --json", "The same for a program"}}};
}

}  // namespace pupflow::cli
