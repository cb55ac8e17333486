// What leaving out saves: a scene run as planned, beside runs of it in which what the plan leaves
// out is forced in. It shows that the results are the same, and what the work would have cost.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/io/table.h"
#include "pupflow/parameters.h"

namespace pupflow::report {

class Report;

/// How much of a litter was the same to the bit with and without a part.
enum class Agreement {
  needed,            // nothing was forced, so nothing was compared
  whole_state,       // positions, velocities, temperatures, headings
  all_but_headings,  // a forced steering turns pups that nothing drives; the rest was the same
  none               // a defect of the program
};

/// "one thread", "2 threads".
std::string threads_words(int threads);

/// As tables have it: "whole state", "all but headings", "NO", or "-" where nothing was compared.
const char* agreement_words(Agreement agreement);

/// A part of what is done for each step: a stage, a part of one, or looking at the observables.
struct Part {
  std::string name;       // as stage_name says
  bool of_stage = false;  // a part of the stage before it
  bool needed = true;
  std::string reason;  // why it is left out; empty where it is needed
  double planned = 0;  // microseconds a step as planned; exactly 0 where it is left out
  double forced = 0;   // with the part forced in; 0 where it is needed anyway
  Agreement agreement = Agreement::needed;
};

/// How long to measure.
struct MeasuredSteps {
  std::int64_t after = 300;  // steps before measuring, since contacts cost what touches
  int count = 200;           // steps to measure, in twenties; fewer where they take over 5 seconds
  int threads = 1;           // that share a step
  bool quiet = false;        // no progress
};

/// What came of it. Times are medians in microseconds.
struct Savings {
  std::int64_t first = 0, last = 0;  // the steps that were measured
  int threads = 1;
  std::vector<Part> parts;  // in the order of a step; a part of a stage after its stage
  double planned_step = 0, full_step = 0;  // a whole step as planned, and with everything forced in
  double saved = 0;                        // median difference of the two, step by step
  Agreement agreement{};                   // with everything forced in
  double clock = 0;                        // what reading the clock adds to each figure
  std::uint64_t hash = 0;                  // of the whole state after `last`, as planned
  std::uint64_t rest_hash = 0;             // of positions, velocities and temperatures alone
};

/// Runs the scene as planned for a run that nobody watches, and beside it, from the first step on
/// and in turn with it, with each left-out part forced in. Throws io::Failure:
/// bad_numbers when a run goes wrong, interrupted after Ctrl-C.
Savings measure_savings(const Params& params, const MeasuredSteps& steps);

/// Throws io::Failure(bad_numbers) where bits differ that must not.
void require_same_bits(const Savings& savings);

/// A table with a head, a row for each part, and one for the whole step.
std::vector<io::Row> savings_rows(const Savings& savings);

/// What the figures of the table are, why parts were left out, and which bits were compared: lines.
std::vector<std::string> savings_notes(const Savings& savings);

/// Puts a section on the page, with its CSV file savings.csv: five shipped scenes, what each leaves
/// out, what that saves, and that no bit changes. Throws io::Failure, bad_numbers where one does.
void savings_section(Report& report);

}  // namespace pupflow::report
