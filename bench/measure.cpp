#include "bench/measure.h"
#include "pupflow/simulation.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <stdexcept>

namespace pupflow::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWarmUpSteps = 20;

double microseconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::micro>(end - begin).count();
}

/// Microseconds of processor time that this clock has counted.
double processor_time(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

void require(const Status& status) {
  if (!status.ok()) throw std::runtime_error(status.message());
}

std::vector<double> step_times(Simulation& simulation, int steps) {
  require(simulation.run(kWarmUpSteps));
  std::vector<double> times;
  for (int i = 0; i < steps; ++i) {
    const Clock::time_point begin = Clock::now();
    const Status status = simulation.step();
    times.push_back(microseconds_between(begin, Clock::now()));
    require(status);
  }
  return times;
}

class StageClock : public StageListener {
 public:
  void stage_begins(Stage) override { begin_ = Clock::now(); }
  void stage_ends(Stage stage) override {
    times_[static_cast<std::size_t>(stage)].push_back(microseconds_between(begin_, Clock::now()));
  }
  StageTimes medians() const {
    StageTimes result{};
    for (std::size_t stage = 0; stage < result.size(); ++stage) {
      if (!times_[stage].empty()) result[stage] = median(times_[stage]);
    }
    return result;
  }

 private:
  Clock::time_point begin_;
  std::array<std::vector<double>, kStageCount> times_;
};

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double least(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

double microseconds(const std::function<void()>& work) {
  const Clock::time_point begin = Clock::now();
  work();
  return microseconds_between(begin, Clock::now());
}

double busy_microseconds(const std::function<void()>& work) {
  const double begin = processor_time(CLOCK_THREAD_CPUTIME_ID);
  work();
  return processor_time(CLOCK_THREAD_CPUTIME_ID) - begin;
}

double program_microseconds(const std::function<void()>& work) {
  const double begin = processor_time(CLOCK_PROCESS_CPUTIME_ID);
  work();
  return processor_time(CLOCK_PROCESS_CPUTIME_ID) - begin;
}

std::vector<std::vector<double>> in_turns(const std::vector<Contender>& contenders, int rounds) {
  std::vector<std::vector<double>> times(contenders.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      times[i].push_back(contenders[i].measure());
    }
  }
  return times;
}

double ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return median(std::move(ratios));
}

double step_time(Simulation& simulation, int steps) {
  return median(step_times(simulation, steps));
}

double least_step_time(Simulation& simulation, int steps) {
  return least(step_times(simulation, steps));
}

StageTimes stage_times(Simulation& simulation, int steps) {
  require(simulation.run(kWarmUpSteps));
  StageClock clock;
  for (int i = 0; i < steps; ++i) require(simulation.step(&clock));
  return clock.medians();
}

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace pupflow::bench
