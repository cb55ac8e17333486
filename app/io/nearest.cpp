#include "app/io/nearest.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "app/io/text.h"

namespace pupflow::io {
namespace {

/// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (optimal
/// string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> two_above, above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({above[j] + (a[i] == b[j] ? 0 : 1), above[j + 1] + 1, row[j] + 1});
      const bool swapped = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (swapped) row[j + 1] = std::min(row[j + 1], two_above[j - 1] + 1);
    }
    two_above = above;
    std::swap(above, row);
  }
  return above[b.size()];
}

std::size_t common_prefix(std::string_view a, std::string_view b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t length = 0;
  while (length < shorter && a[length] == b[length]) ++length;
  return length;
}

}  // namespace

std::string nearest(std::string_view name, std::span<const std::string_view> candidates) {
  constexpr std::size_t kLongest = 64;  // nothing that long is a slip of the pen
  std::string_view best;
  if (name.size() > kLongest) return {};
  std::size_t best_distance = std::max<std::size_t>(name.size() / 3, 1);
  std::size_t best_prefix = 0;
  for (const std::string_view candidate : candidates) {
    // At least as many letters must be put in, or taken out.
    if (std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size()) >
        best_distance)
      continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance > best_distance || distance >= candidate.size()) continue;
    // Of two equally near, the one that begins alike: slips at the beginning are rare.
    const std::size_t prefix = common_prefix(name, candidate);
    if (!best.empty() && distance == best_distance && prefix <= best_prefix) continue;
    best = candidate;
    best_distance = distance;
    best_prefix = prefix;
  }
  return std::string(best);
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
  const std::string found = nearest(name, candidates);
  return found.empty() ? std::string() : "; did you mean " + io::quoted(found) + "?";
}

}  // namespace pupflow::io
