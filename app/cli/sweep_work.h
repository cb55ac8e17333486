// What the verbs that compute or join sweeps share: options, computation, summary.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/verb.h"
#include "app/study/sweep.h"

namespace pupflow::cli {

struct SweepOptions {
  Common common;  // its `out` is the folder
  std::vector<std::string> vary;
  std::string design;               // the file of a table; empty for none
  std::optional<std::int64_t> lhs;  // points of a latin hypercube
  std::optional<std::int64_t> seeds;
  bool record = false;
  std::int64_t every = 1;
  std::string shard = "1/1";
  std::string plot_script;  // empty: the one in the folder
  bool celsius = false;
};

/// Declares --plot-script.
void add_plot_script(CLI::App& app, std::string& script);

/// Throws io::Failure(bad_file) where `script` is neither empty nor a file.
void check_plot_script(const std::string& script);

/// Declares all options but those that choose the points. `folder` is the default of --out.
void add_sweep_options(CLI::App& app, SweepOptions& options, const std::string& folder);

/// Computes the missing runs of the sweep, on all ranks of the job, and reports on rank 0. `name`
/// is the name of its picture and of its default folder. Throws io::Failure: bad_numbers if runs
/// failed.
void run_sweep_verb(const CLI::App& verb, const SweepOptions& options, const std::string& name);

/// How the summary of a sweep is printed.
struct SummaryStyle {
  bool quiet = false;    // not at all
  bool celsius = false;  // T_a in degrees, too
};

/// Prints the summary of a finished sweep. Throws io::Failure(bad_numbers) if runs failed.
void report_sweep(const study::Design& design, const study::SweepResult& result,
                  const std::string& folder, SummaryStyle style);

}  // namespace pupflow::cli
