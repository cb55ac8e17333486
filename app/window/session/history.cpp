#include "app/window/session/history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pupflow::window {
namespace {

using Sample = History::Sample;

/// Steps of a sample of a level.
std::int64_t width(std::size_t level) {
  std::int64_t steps = 1;
  while (level-- > 0) steps *= History::kMerged;
  return steps;
}

/// The place of a step among the samples of that width. Step 1 is the first of place 0.
std::int64_t place(std::int64_t step, std::int64_t width) {
  return (step - 1) / width;
}

Sample sample_of(std::int64_t step, double time, const Observables& seen,
                 const LitterView& litter) {
  Sample sample{.first = step, .last = step, .steps = 1, .time = time, .mean = seen};
  for (std::size_t k = 0; k < kObservableCount; ++k) {
    sample.low[k] = sample.high[k] = static_cast<float>(seen.*observables()[k].value);
  }
  if (!litter.tb.empty()) {
    const auto [low, high] = std::minmax_element(litter.tb.begin(), litter.tb.end());
    sample.coldest = *low;
    sample.warmest = *high;
  }
  sample.ta = litter.params.ambient_temperature;
  sample.tp = litter.params.preferred_temperature;
  return sample;
}

/// Takes `more`, which is later, into `sum`.
void join(Sample& sum, const Sample& more) {
  if (sum.steps == 0) {
    sum = more;
    return;
  }
  const double share = static_cast<double>(more.steps) / (sum.steps + more.steps);
  for (std::size_t k = 0; k < kObservableCount; ++k) {
    double& mean = sum.mean.*observables()[k].value;
    const double other = more.mean.*observables()[k].value;
    // The flow is not known at first.
    if (std::isnan(mean)) mean = other;
    if (!std::isnan(other)) mean += share * (other - mean);
    sum.low[k] = std::fmin(sum.low[k], more.low[k]);
    sum.high[k] = std::fmax(sum.high[k], more.high[k]);
  }
  sum.coldest = std::fmin(sum.coldest, more.coldest);
  sum.warmest = std::fmax(sum.warmest, more.warmest);
  sum.ta += share * (more.ta - sum.ta);
  sum.tp += share * (more.tp - sum.tp);
  sum.last = more.last;
  sum.time = more.time;
  sum.steps += more.steps;
}

}  // namespace

/// Pages of a level that may hold T_b.
std::size_t History::tb_pages(int pups) {
  return kTbBytes / (sizeof(float) * kPage * kLevels * static_cast<std::size_t>(std::max(pups, 1)));
}

/// The place of the first sample that holds a step after `step`.
std::size_t History::Level::first_after(std::int64_t step) const {
  std::size_t low = 0, high = size;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (at(middle).last > step) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

/// Makes the last page one that may be written to and has room; `pups` is 0 where T_b is not kept.
void History::Level::make_room(std::size_t pups) {
  const bool full = size == pages.size() * kPage;
  if (!full && tail.is_owner) return;
  Page page;
  if (full) {
    page.samples = std::make_shared<std::array<Sample, kPage>>();
    if (pups > 0) page.tb = std::make_shared<std::vector<float>>(kPage * pups);
    pages.push_back(page);
  } else {
    const Page& shared = pages.back();
    page.samples = std::make_shared<std::array<Sample, kPage>>(*shared.samples);
    if (shared.tb) page.tb = std::make_shared<std::vector<float>>(*shared.tb);
    pages.back() = page;
  }
  tail.is_owner = true;
}

void History::Level::push(const Sample& sample, std::span<const float> tb, int pups) {
  const std::size_t with_tb = tb_pages(pups);
  make_room(keeps_tb(pups) ? static_cast<std::size_t>(pups) : 0);
  const std::size_t row = size % kPage;
  Page& page = pages.back();
  (*page.samples)[row] = sample;
  if (page.tb) {
    const auto begin = page.tb->begin() + static_cast<std::ptrdiff_t>(row * pups);
    if (tb.empty()) {
      std::fill_n(begin, pups, std::numeric_limits<float>::quiet_NaN());
    } else {
      std::copy(tb.begin(), tb.end(), begin);
    }
  }
  ++size;
  if (pages.size() > kSamples / kPage + 1) {
    pages.erase(pages.begin());
    size -= kPage;
  }
  if (pages.size() > with_tb) pages[pages.size() - with_tb - 1].tb.reset();
}

/// Forgets the samples that hold a step after `step`.
void History::Level::cut(std::int64_t step) {
  size = first_after(step);
  pages.resize((size + kPage - 1) / kPage);
  tail.is_owner = false;  // others may know what stood behind
  open = {};
}

void History::add(std::int64_t step, double time, const Observables& seen,
                  const LitterView& litter) {
  if (litter.pups != pups_) clear();
  if (!empty() && step <= last_) return;
  pups_ = litter.pups;
  if (empty()) first_ = step;
  last_ = step;
  std::vector<float> tb;
  if (keeps_tb(pups_)) tb.assign(litter.tb.begin(), litter.tb.end());
  const Sample sample = sample_of(step, time, seen, litter);
  levels_[0].push(sample, tb, pups_);
  pass_up(1, sample, tb);
}

/// Takes a sample of the level below into the open one, which is pushed when it is complete.
void History::pass_up(std::size_t level, const Sample& sample, std::span<const float> tb) {
  for (; level < kLevels; ++level) {
    Level& here = levels_[level];
    const std::int64_t steps = width(level);
    const std::int64_t at = place(sample.last, steps);
    if (here.open.steps > 0 && place(here.open.last, steps) != at) {  // steps were left out
      const Sample rest = std::exchange(here.open, {});
      here.push(rest, {}, pups_);
      pass_up(level + 1, rest, {});
    }
    join(here.open, sample);
    if (place(here.open.last + 1, steps) == at) return;
    const Sample complete = std::exchange(here.open, {});
    here.push(complete, tb, pups_);
    return pass_up(level + 1, complete, tb);
  }
}

void History::truncate(std::int64_t step) {
  if (empty() || step >= last_) return;
  if (step < first_) {
    clear();
    return;
  }
  for (Level& level : levels_) level.cut(step);
  last_ = step;
  for (std::size_t k = 1; k < kLevels; ++k) {
    const Level& below = levels_[k - 1];
    Level& here = levels_[k];
    std::int64_t known = place(step + 1, width(k)) * width(k);  // before the open sample
    if (here.size > 0) known = std::max(known, here.at(here.size - 1).last);
    for (std::size_t i = below.first_after(known); i < below.size; ++i) {
      join(here.open, below.at(i));
    }
  }
}

History::Entry History::entry(const Level& level, std::size_t i) const {
  const Page& page = level.pages[i / kPage];
  Entry found{&(*page.samples)[i % kPage], {}};
  if (page.tb) {
    const auto pups = static_cast<std::size_t>(pups_);
    found.tb = std::span<const float>(*page.tb).subspan(i % kPage * pups, pups);
  }
  return found;
}

std::vector<History::Entry> History::between(std::int64_t first, std::int64_t last,
                                             std::int64_t most) const {
  const std::int64_t known = std::min(last, last_) - std::max(first, first_);
  std::size_t finest = 0;
  while (finest + 1 < kLevels && known / width(finest) >= most) ++finest;
  std::vector<Entry> entries;
  // From the end: this level, then coarser ones before it begins.
  for (std::size_t k = finest; k < kLevels; ++k) {
    const Level& level = levels_[k];
    const std::int64_t end = entries.empty() ? last + width(k) : entries.back().sample->first - 1;
    for (std::size_t i = level.first_after(end); i-- > 0;) {
      if (!entries.empty() && entries.back().sample->last < first) break;
      entries.push_back(entry(level, i));
    }
  }
  std::reverse(entries.begin(), entries.end());
  // The newest steps have not filled a sample of this level.
  for (std::size_t k = finest; k-- > 0;) {
    const std::int64_t end = entries.empty() ? first_ - 1 : entries.back().sample->last;
    if (end >= last) break;
    for (std::size_t i = levels_[k].first_after(end); i < levels_[k].size; ++i) {
      if (levels_[k].at(i).first <= end) continue;
      entries.push_back(entry(levels_[k], i));
      if (entries.back().sample->last > last) break;
    }
  }
  return entries;
}

}  // namespace pupflow::window
