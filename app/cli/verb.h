// The program's verbs. Each has one file, which declares its options and returns what to do once
// they are parsed.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

#include "app/io/settings.h"
#include "app/io/text.h"

namespace pupflow::cli {

/// A command that help shows, without "pupflow ", and what it does.
struct Example {
  std::string command, does;
};

/// A verb: its command line, its work, which throws io::Failure, and examples for its help.
struct Verb {
  CLI::App* app;
  std::function<void()> work;
  std::vector<Example> examples;
};

Verb add_run(CLI::App& program);
Verb add_render(CLI::App& program);
Verb add_figure1(CLI::App& program);
Verb add_live(CLI::App& program);
Verb add_figure2(CLI::App& program);
Verb add_sweep(CLI::App& program);
Verb add_merge(CLI::App& program);
Verb add_compare(CLI::App& program);
Verb add_verify(CLI::App& program);
Verb add_params(CLI::App& program);
Verb add_fields(CLI::App& program);
Verb add_explain(CLI::App& program);
Verb add_info(CLI::App& program);
Verb add_export(CLI::App& program);
Verb add_report(CLI::App& program);
Verb add_doctor(CLI::App& program);
Verb add_scenes(CLI::App& program);
Verb add_version(CLI::App& program);
/// `verbs` is read when the verb works: all verbs, also this one.
Verb add_help(CLI::App& program, const std::vector<Verb>& verbs);

/// The options that every verb takes.
struct Common {
  io::Settings settings;
  int threads = 0;  // 0: not given
  std::string out;
  bool force = false;
  bool quiet = false;
};

/// What the common options mean for one verb, for its help.
struct CommonHelp {
  bool scene = true;                   // takes a SCENE
  std::string settings;                // a remark on --set and its shortcuts; may be empty
  std::string threads, out, quiet;     // the whole help text of each
  std::string at;                      // what else --at takes, for its help; may be empty
  std::string out_names = "-o,--out";  // with a verb's own word for it, e.g. "-o,--csv,--out"
};

/// A check for options that name something: refuses an empty text, as an unset shell variable
/// gives.
std::string not_empty(const std::string& text);

/// A check for options that are one of some words.
std::function<std::string(const std::string&)> one_of(const std::vector<std::string_view>& words);

/// The largest count or step: that of the whole numbers that a double holds.
constexpr std::int64_t kUnbounded = std::int64_t{1} << 53;

/// A check for options that are a number: refuses all but `least` ... `most`; whole numbers where
/// these are. An empty text and nan are no numbers.
template <class Number>
auto between(Number least, Number most) {
  return [least, most](const std::string& text) -> std::string {
    const auto number = io::read_number<Number>(text);
    if (number && *number >= least && *number <= most) return "";
    const auto shown = [](Number limit) {
      if constexpr (std::is_floating_point_v<Number>) return io::number_text(limit);
      return limit == kUnbounded ? "2^53" : std::to_string(limit);
    };
    return io::quoted(text) + " must be a " + (std::is_integral_v<Number> ? "whole " : "") +
           "number from " + shown(least) + " to " + shown(most);
  };
}

/// Refuses an option that was typed and has no effect, since what it acts on was not asked for:
/// "--trail: has no effect without --overlay trails". Throws Failure(bad_input).
void refuse_idle(const CLI::App& verb, const std::string& option, bool acts,
                 const std::string& without);

/// Declares the common options.
void add_common(CLI::App& verb, Common& common, const CommonHelp& help);

/// Declares --flow-lag, for verbs that report pup flow.
void add_flow_lag(CLI::App& verb, Common& common);

/// Declares --json, for verbs that report to people.
void add_json(CLI::App& verb, bool& json);

/// Declares --format text|markdown|json, for verbs that print a table; text where it is not given.
void add_format(CLI::App& verb, std::string& format);

/// The threads asked for, or one for each core.
int thread_count(const Common& common);

/// Text to standard output, or to the file of --out. Throws Failure(bad_file).
void deliver(const Common& common, const std::string& text);

}  // namespace pupflow::cli
