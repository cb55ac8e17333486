// Schedules as people write them: step=800,ta=0.2 on the command line, [[at]] tables in scenes, one
// line in outputs.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/io/png.h"
#include "pupflow/schedule.h"

namespace pupflow::io {

/// Something wrong with one entry of a change.
struct ChangeProblem {
  std::size_t entry;  // its place among the entries
  std::string message;
};

/// The change with these entries: step and until as whole numbers; then parameters that may change
/// in the next step, or pup with force=[x,y,z], heat, turn. What is wrong is added to `problems`.
/// What depends on the litter is left to check().
Change read_change(const TextEntries& entries, std::vector<ChangeProblem>& problems);

/// Adds the change in "step=800,ta=0.2" to `schedule`; what is wrong with it goes to `problems`
/// instead, each told to come from `where`.
void add_change(std::string_view text, const std::string& where, Schedule& schedule,
                std::vector<std::string>& problems);

/// A change, or all of them joined by "; ", in the form that is read back to the same.
std::string change_text(const Change& change);
std::string schedule_text(const Schedule& schedule);

/// Reads what schedule_text wrote; problems as in add_change.
Schedule parse_schedule(std::string_view text, const std::string& where,
                        std::vector<std::string>& problems);

}  // namespace pupflow::io
