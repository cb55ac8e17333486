// Clocks and medians. Machines are noisy: everything that is compared is measured in turns, and
// medians are reported.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow::bench {

/// The median of `values`, at least one.
double median(std::vector<double> values);

/// How long `work` takes, in microseconds.
double microseconds(const std::function<void()>& work);

/// How long the processor is busy with `work` on this thread, in microseconds. Unlike the time on
/// the wall it does not grow when others take their turns on the same processor, which matters for
/// work of many milliseconds.
double busy_microseconds(const std::function<void()>& work);

/// The same of all threads of this program.
double program_microseconds(const std::function<void()>& work);

/// Something that is measured again and again: one call measures it once and returns a time.
struct Contender {
  std::string name;
  std::function<double()> measure;
};

/// Each contender's measured times, one a round: all of them in turn, `rounds` times.
std::vector<std::vector<double>> in_turns(const std::vector<Contender>& contenders, int rounds);

/// The least of `values`, at least one: for what needs more than one core, which are all free at
/// times only.
double least(const std::vector<double>& values);

/// The median over rounds of a's time through b's time of the same round.
double ratio(const std::vector<double>& a, const std::vector<double>& b);

/// Medians of the stages of a step, in microseconds; 0 for a stage that never ran.
using StageTimes = std::array<double, kStageCount>;

/// Steps `simulation` on and times each of `steps` steps, after some that only warm the caches.
/// Returns the median in microseconds. Throws std::runtime_error on a bad status.
double step_time(Simulation& simulation, int steps);

/// The same, but the least of the times.
double least_step_time(Simulation& simulation, int steps);

/// The same, stage by stage.
StageTimes stage_times(Simulation& simulation, int steps);

/// A hash as it is printed: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace pupflow::bench
