// The program: finds the verb, parses its options, and turns every failure into one line on
// standard error and an exit code.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/cli/launcher.h"
#include "app/cli/manual.h"
#include "app/cli/refusals.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "pupflow/parameters.h"

namespace pupflow::cli {
namespace {

using io::ExitCode;
using io::Failure;

void add_verbs(CLI::App& program, std::vector<Verb>& verbs) {
  verbs = {
      add_live(program),    add_run(program),     add_render(program),     add_figure1(program),
      add_figure2(program), add_sweep(program),   add_merge(program),      add_compare(program),
      add_verify(program),  add_info(program),    add_export(program),     add_scenes(program),
      add_params(program),  add_fields(program),  add_explain(program),    add_report(program),
      add_doctor(program),  add_version(program), add_help(program, verbs)};
}

/// The page of the verb on the command line, or that of the program.
Page page_asked_for(const CLI::App& program, const std::vector<Verb>& verbs) {
  const auto chosen =
      std::find_if(verbs.begin(), verbs.end(), [](const Verb& verb) { return verb.app->parsed(); });
  return chosen == verbs.end() ? page_of(program, verbs) : page_of(*chosen);
}

void parse_and_work(int argc, char** argv) {
  CLI::App program("Self-organising huddles of soft, warm bodies (Wilson 2017).", "pupflow");
  program.set_version_flag("-V,--version", io::program_version(), "Print the version and exit");
  program.set_help_flag("-h,--help", "Print this help and exit");
  std::vector<Verb> verbs;
  add_verbs(program, verbs);
  program.footer("'pupflow VERB --help' tells what each verb takes.");  // verbs would inherit it
  const std::span<const char* const> words(argv + 1, argv + std::max(argc, 1));
  refuse_unknown_verb(verbs, words);
  program.allow_extras();
  program.require_subcommand(0, 1);  // what follows a verb is no verb: 'help run'
  for (const Verb& verb : verbs) {
    verb.app->allow_extras();
    take_extra_arguments(*verb.app);
    for (CLI::Option* option : verb.app->get_options()) {
      if (option->get_expected_max() == 0) option->disable_flag_override();  // --force=no
    }
  }

  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    io::print(help_text(page_asked_for(program, verbs)));
    return;
  } catch (const CLI::CallForVersion& version) {
    io::print(std::string(version.what()) + "\n");
    return;
  } catch (const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    if (chosen.empty()) throw bad_command_line(error, program, "pupflow", words);
    throw bad_command_line(error, *chosen[0], "pupflow " + chosen[0]->get_name(), words);
  }
  for (const Verb& verb : verbs) {
    if (!verb.app->parsed()) continue;
    const std::string command = "pupflow " + verb.app->get_name();
    refuse_taken_options(*verb.app, command);
    refuse_extras(*verb.app, command);
    refuse_extras(program, "pupflow");
    verb.work();
    return;
  }
  refuse_extras(program, "pupflow");
}

constexpr const char* kNoMemory =
    "there is not enough memory for this; fewer pups, face_points or pixels need less";
constexpr const char* kNoThreads =
    "the system gives this program no more threads; --threads 1 needs the fewest";

/// One line for each line of `message`, as far as anybody would read them.
void print_error(std::string_view message) {
  constexpr std::size_t kMostLines = 20;
  const std::vector<std::string_view> lines = io::split(message, '\n');
  const std::size_t shown = lines.size() > kMostLines + 1 ? kMostLines : lines.size();
  for (std::size_t i = 0; i < shown; ++i) {
    if (!lines[i].empty()) std::fprintf(stderr, "pupflow: %s\n", io::printable(lines[i]).c_str());
  }
  if (shown < lines.size())
    std::fprintf(stderr, "pupflow: and %zu lines like these\n", lines.size() - shown);
}

/// The exit code of what `work` throws, which `report` is told of.
template <class Work, class Report>
ExitCode code_of(Work work, Report report) {
  const auto told = [&](const char* message, ExitCode code) {
    report(message, code);
    return code;
  };
  try {
    work();
    return ExitCode::done;
  } catch (const Failure& failure) {
    return told(failure.lines().c_str(), failure.code());
  } catch (const InvalidParams& invalid) {
    return told(invalid.what(), ExitCode::bad_input);
  } catch (const std::bad_alloc&) {
    return told(kNoMemory, ExitCode::bad_input);
  } catch (const std::length_error&) {  // more than any memory holds
    return told(kNoMemory, ExitCode::bad_input);
  } catch (const std::system_error& error) {
    const bool of_threads = error.code() == std::errc::resource_unavailable_try_again;
    return of_threads ? told(kNoThreads, ExitCode::bad_input)
                      : told(io::printable(error.what()).c_str(), ExitCode::bad_file);
  } catch (const std::exception& error) {
    const std::string message = std::string("internal error: ") + error.what();
    return told(io::printable(message).c_str(), ExitCode::difference);
  }
}

/// libhdf5 calls exit(-1) where a call of it gets no memory; no end of this program's own has that
/// status.
void take_end_by_library(int status, void*) {
  if ((status & 0xff) != 0xff) return;
  std::fprintf(stderr, "pupflow: %s\n", kNoMemory);
  _exit(static_cast<int>(ExitCode::bad_input));
}

std::terminate_handler terminate_otherwise = nullptr;
std::atomic<bool> memory_ended = false;

void take_end_of_memory() {
  memory_ended = true;
  throw std::bad_alloc();
}

/// Ends the program without memory where std::bad_alloc leaves a function that is noexcept: CLI11 has
/// such functions that copy strings (get_option_no_throw, _find_subcommand), libstdc++ one that opens
/// a folder. What is thrown there is not always there to be asked for.
[[noreturn]] void take_terminate() {
  if (memory_ended) {
    std::fprintf(stderr, "pupflow: %s\n", kNoMemory);
    _exit(static_cast<int>(ExitCode::bad_input));
  }
  terminate_otherwise();
  std::abort();
}

/// Opens those of standard input, output and error that are closed: a file that is opened later would
/// otherwise get its number, and then what is printed. What is written to a closed output still fails.
void open_standard_streams() {
  for (int stream = 0; stream <= 2;) {
    if (fcntl(stream, F_GETFD) >= 0) {
      ++stream;
    } else if (open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) < 0) {
      return;
    }
  }
}

int guarded_main(int argc, char** argv) {
  open_standard_streams();
  // This program locks its files itself, in another way, which HDF5's own locks would not go with.
  setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
  // A closed pipe shows as a failed write, which is reported; dying of the signal would leave
  // temporary files.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // likewise a file that reaches its size limit
  on_exit(take_end_by_library, nullptr);
  std::set_new_handler(take_end_of_memory);
  terminate_otherwise = std::set_terminate(take_terminate);
  io::watch_for_interrupt();
  const bool silent = is_silent_rank(argc, argv);
  const auto report = [&](const char* message, ExitCode code) {
    if (!silent) print_error(message);
    leave_job(argc, argv, message, code);
  };
  try {
    return static_cast<int>(code_of([&] { parse_and_work(argc, argv); }, report));
  } catch (const std::bad_alloc&) {  // no memory even to report; this takes none
    std::fprintf(stderr, "pupflow: %s\n", kNoMemory);
    return static_cast<int>(ExitCode::bad_input);
  }
}

}  // namespace
}  // namespace pupflow::cli

int main(int argc, char** argv) {
  return pupflow::cli::guarded_main(argc, argv);
}
