// The time that a plan saves: a scene run as planned, and the same with the parts forced in that the
// plan leaves out. The results have the same bits.
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
  needed,            // not forced in, so not compared
  whole_state,       // positions, velocities, temperatures, headings
  all_but_headings,  // a forced steering turns pups without drive; the rest is the same
  none               // a defect of the program
};

/// "one thread", "2 threads".
std::string threads_words(int threads);

/// For tables: "whole state", "all but headings", "NO", or "-" for needed.
const char* agreement_words(Agreement agreement);

/// The time of a stage, of a part of one, or of the observables, in each step.
struct PartCost {
  std::string name;       // stage_name, part_name, or of the observables
  bool of_stage = false;  // a part of the stage before it
  bool needed = true;
  std::string reason;  // why it is left out; empty where it is needed
  double planned = 0;  // microseconds a step as planned; exactly 0 where it is left out
  double forced = 0;   // with the part forced in; 0 where it is needed anyway
  Agreement agreement = Agreement::needed;
};

/// How long to measure.
struct MeasuredSteps {
  std::int64_t after =
      300;             // steps before measuring, since the time of contacts depends on what touches
  int count = 200;     // steps to measure, a multiple of 20; fewer where they take over 5 seconds
  int threads = 1;     // that share a step
  bool quiet = false;  // no progress
};

/// The result. Times are medians in microseconds.
struct Savings {
  std::int64_t first = 0, last = 0;  // the steps that were measured
  int threads = 1;
  std::vector<PartCost> parts;  // in the order of a step; a part of a stage after its stage
  double planned_step = 0, full_step = 0;  // a whole step as planned, and with everything forced in
  double saved = 0;                        // median difference of the two, step by step
  Agreement agreement{};                   // with everything forced in
  double clock = 0;                        // the time of reading the clock, which is in each time
  std::uint64_t hash = 0;                  // of the whole state after `last`, as planned
  std::uint64_t rest_hash = 0;             // of positions, velocities and temperatures alone
};

/// Runs the scene as planned for a run that is not observed and, in turn with it, with each left-out
/// part forced in from the first step on. Throws io::Failure: bad_numbers after a bad status,
/// interrupted after Ctrl-C.
Savings measure_savings(const Params& params, const MeasuredSteps& steps);

/// Throws io::Failure(bad_numbers) if a forced part has changed the result.
void require_same_bits(const Savings& savings);

/// A table with a head, a row for each part, and one for the whole step.
std::vector<io::Row> savings_rows(const Savings& savings);

/// Paragraphs: what the times mean, why parts are left out, and which bits were compared.
std::vector<std::string> savings_notes(const Savings& savings);

/// Adds a section, with savings.csv: for each of five shipped scenes the parts that it leaves out and
/// the time that this saves. Throws io::Failure, bad_numbers if a bit changes.
void savings_section(Report& report);

}  // namespace pupflow::report
