#include "app/study/latin.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pupflow::study {
namespace {

// The standard fixes the numbers of this generator, though not those of its distributions.
using Generator = std::mt19937_64;

double uniform(Generator& generator) {
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

/// 0 ... count - 1 in random order (Fisher-Yates).
std::vector<std::int64_t> shuffled(std::int64_t count, Generator& generator) {
  std::vector<std::int64_t> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
  return order;
}

/// The value at `share` of the way through a span, 0 ... 1.
double value_at(const Span& span, double share) {
  const std::vector<double>& values = span.axis.values;
  if (!span.between) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    return values[std::min(place, values.size() - 1)];
  }
  const auto [low, high] = std::minmax(values[0], values[1]);
  if (span.axis.parameter->kind == Parameter::Kind::integer)
    return std::min(low + std::floor(share * (high - low + 1)), high);
  return std::min(low + share * (high - low), high);
}

}  // namespace

void spread_latin(Design& design, const std::vector<Span>& spans, std::int64_t points) {
  Generator generator(static_cast<std::uint64_t>(design.base.seed));
  design.layout = Layout::latin;
  design.spans.clear();
  design.axes.clear();
  for (const Span& span : spans) {
    Axis axis{span.axis.parameter, {}};
    for (const std::int64_t part : shuffled(points, generator)) {
      const double share =
          (static_cast<double>(part) + uniform(generator)) / static_cast<double>(points);
      axis.values.push_back(value_at(span, share));
    }
    design.axes.push_back(std::move(axis));
    design.spans.push_back(span_text(span));
  }
}

}  // namespace pupflow::study
