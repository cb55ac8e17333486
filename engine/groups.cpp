// Groups of pups that touch.
#include <algorithm>
#include <numeric>

#include "pupflow/fields.h"

namespace pupflow {
namespace {

/// Root of `pup` in a union-find forest; halves the path on the way.
int find_root(std::vector<int>& parent, int pup) {
  while (parent[pup] != pup) pup = parent[pup] = parent[parent[pup]];
  return pup;
}

}  // namespace

std::vector<int> group_labels(int pups, std::span<const TouchingPair> touching) {
  std::vector<int> parent(pups);
  std::iota(parent.begin(), parent.end(), 0);
  for (const TouchingPair& pair : touching) {
    const int a = find_root(parent, pair.first), b = find_root(parent, pair.second);
    parent[std::max(a, b)] = std::min(a, b);  // so a root is its group's lowest pup
  }
  std::vector<int> label(pups);
  int next = 0;
  for (int pup = 0; pup < pups; ++pup) {
    const int root = find_root(parent, pup);
    label[pup] = root == pup ? next++ : label[root];
  }
  return label;
}

std::vector<int> group_sizes(std::span<const int> labels) {
  std::vector<int> sizes;
  for (const int label : labels) {
    if (static_cast<std::size_t>(label) >= sizes.size()) sizes.resize(std::size_t{1} + label, 0);
    ++sizes[label];
  }
  return sizes;
}

}  // namespace pupflow
