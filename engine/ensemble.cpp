#include "pupflow/ensemble.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "engine/rng.h"
#include "pupflow/simulation.h"

namespace pupflow {

std::optional<RunResult> run_to_end(const Params& params, const std::function<bool()>& stop,
                                    std::int64_t series_every) {
  Simulation simulation(params);
  RunMeans means(params.discard);
  std::vector<Sample> series;
  // Flow compares with the state flow_lag steps before, so the observer begins that many steps
  // before what is wanted.
  const std::int64_t first =
      series_every > 0 ? 0 : std::max<std::int64_t>(params.discard - params.flow_lag, 0);
  simulation.set_observed({});
  std::optional<Observer> observer;
  while (simulation.steps_done() < params.steps) {
    if (stop()) return std::nullopt;
    if (simulation.steps_done() == first) observer.emplace(simulation);
    if (simulation.steps_done() == std::max<std::int64_t>(first - 1, 0))
      simulation.set_observed(kContactRecords);
    if (!simulation.step().ok()) break;
    const std::int64_t step = simulation.steps_done();
    const bool in_means = step > params.discard,
               in_series = series_every > 0 && step % series_every == 0;
    if (in_means || in_series) {
      const Observables& seen = observer->observe(simulation);
      if (in_means) means.add(simulation, seen);
      if (in_series) series.push_back({step, simulation.time(), seen});
    } else if (observer) {
      observer->pass(simulation);
    }
  }
  RunResult result{simulation.status(),     means.means(),     means.exposed_sd(), {},
                   simulation.steps_done(), simulation.hash(), std::move(series)};
  for (const Warning& warning : simulation.warnings()) result.warnings.add(warning);
  return result;
}

void for_each_index(std::int64_t count, int threads,
                    const std::function<void(std::int64_t)>& body) {
  std::atomic<std::int64_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;  // written by the thread that sets `failed`
  const auto work = [&] {
    try {
      for (std::int64_t i = next++; i < count && !failed; i = next++) body(i);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
    }
  };
  std::vector<std::jthread> helpers;
  const auto wanted = std::clamp<std::int64_t>(count, 1, std::max(threads, 1));
  helpers.reserve(static_cast<std::size_t>(wanted));
  try {
    for (std::int64_t i = 1; i < wanted; ++i) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // no more of them to be had: fewer do the work
  }
  work();
  helpers.clear();  // joins
  if (failure) std::rethrow_exception(failure);
}

void run_ensemble(std::int64_t count, int threads,
                  const std::function<Params(std::int64_t)>& params_of,
                  const std::function<void(std::int64_t, const RunResult&)>& deliver,
                  const std::function<bool()>& stop, std::int64_t series_every) {
  std::atomic<bool> failed{false};
  std::mutex mutex;  // guards deliver
  const auto stop_all = [&] { return failed || stop(); };
  for_each_index(count, threads, [&](std::int64_t i) {
    try {
      if (stop_all()) return;
      const std::optional<RunResult> result = run_to_end(params_of(i), stop_all, series_every);
      const std::lock_guard lock(mutex);
      if (result && !failed) deliver(i, *result);
    } catch (...) {
      failed = true;  // the other runs end at their next step
      throw;
    }
  });
}

std::int64_t run_seed(std::int64_t base_seed, std::int64_t run) {
  // Multiplication by an odd factor is a bijection modulo 2^31, so no two runs of a sweep have the
  // same seed. 31 bits are short to type, and other programs accept them as a seed.
  constexpr std::uint64_t kSeedMask = (std::uint64_t{1} << 31) - 1, kOdd = 0x9e3779b97f4a7c15u;
  const std::uint64_t start = mix_bits(static_cast<std::uint64_t>(base_seed));
  return static_cast<std::int64_t>((start + static_cast<std::uint64_t>(run) * kOdd) & kSeedMask);
}

}  // namespace pupflow
