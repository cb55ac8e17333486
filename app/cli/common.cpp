#include <algorithm>
#include <thread>

#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/nearest.h"

namespace pupflow::cli {
namespace {

/// One argument each time that the option is given, so that a SCENE may follow it.
CLI::Option* one_at_a_time(CLI::Option* option) {
  return option->allow_extra_args(false)->take_all();
}

}  // namespace

std::string not_empty(const std::string& text) {
  return text.empty() ? "must not be empty" : "";
}

std::function<std::string(const std::string&)> one_of(const std::vector<std::string_view>& words) {
  return [words](const std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return "";
    const std::string meant = io::did_you_mean(text, words);
    return io::quoted(text) + " is none of " + io::joined(words, ", ") + meant;
  };
}

void refuse_idle(const CLI::App& verb, const std::string& option, bool acts,
                 const std::string& without) {
  if (!acts && verb.count(option) > 0) io::refuse(option + ": has no effect without " + without);
}

void add_common(CLI::App& verb, Common& common, const CommonHelp& help) {
  io::Settings& settings = common.settings;
  const std::string remark = help.settings.empty() ? "" : "; " + help.settings;
  if (help.scene) {
    verb.add_option("SCENE", settings.scene,
                    "A scene file (TOML), or the name of a shipped scene such as cold")
        ->option_text(" ")
        ->check(not_empty);
  }
  one_at_a_time(verb.add_option("--set", settings.sets,
                                "Set any parameter of 'pupflow params'; repeatable" + remark))
      ->option_text("NAME=VALUE");
  const std::string frames = help.at.empty() ? "" : "; or " + help.at;
  one_at_a_time(verb.add_option("--at", settings.at,
                                "Change parameters after a step, e.g. step=800,ta=0.2 (with "
                                "until=N linearly), or act on a pup, e.g. "
                                "step=1200,until=1260,pup=3,force=[2,0,0]; repeatable" +
                                    frames))
      ->option_text(help.at.empty() ? "CHANGE" : "CHANGE|STEPS");
  verb.add_option("--like", settings.like,
                  "Take all parameters and changes from a file that this program wrote" + remark)
      ->option_text("FILE")
      ->check(not_empty);
  verb.add_option("--row", settings.row,
                  "With --like runs.csv: the run of this row; 1 is the first")
      ->option_text("N")
      ->check(between(std::int64_t{1}, kUnbounded));
  verb.add_option("--seed", settings.seed, "Short for --set seed=N")->option_text("N");
  verb.add_option("--steps", settings.steps, "Short for --set steps=N")->option_text("N");
  verb.add_option("--precision", settings.precision, "Short for --set precision=...")
      ->option_text("float|double");
  verb.add_option("--threads", common.threads, help.threads)
      ->option_text("N")
      ->check(between(1, 1024));
  verb.add_option(help.out_names, common.out, help.out)->option_text("FILE")->check(not_empty);
  verb.add_flag("--force", common.force, "Replace output files that exist");
  verb.add_flag("-q,--quiet", common.quiet, help.quiet);
}

void add_flow_lag(CLI::App& verb, Common& common) {
  verb.add_option("--flow-lag", common.settings.flow_lag,
                  "Short for --set flow_lag=N: pup flow is |A(t) - A(t - N dt)| / (N dt) (default "
                  "1)")
      ->option_text("N");
}

void add_json(CLI::App& verb, bool& json) {
  verb.add_flag("--json", json, "Print JSON, with every digit, instead of text for people");
}

void add_format(CLI::App& verb, std::string& format) {
  format = "text";
  verb.add_option("--format", format, "How to write the list (default text)")
      ->option_text("text|markdown|json")
      ->check(one_of({"text", "markdown", "json"}));
}

int thread_count(const Common& common) {
  if (common.threads > 0) return common.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void deliver(const Common& common, const std::string& text) {
  if (common.out.empty()) {
    io::print(text);
    return;
  }
  io::AtomicFile file(common.out, common.force);
  file.write(text);
  file.commit();
}

}  // namespace pupflow::cli
