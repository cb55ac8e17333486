// Inputs made from others by chance, where libFuzzer has nothing to learn from: the libraries that
// read HDF5 files are not compiled with its counters.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pupflow::fuzz {

/// One of `seeds`, which are not none, with one to eight changes: bits, numbers, pieces left out,
/// doubled or taken from another seed. The same seeds and number give the same bytes. It is at most
/// twice as long as the longest seed.
std::string mutated(const std::vector<std::string>& seeds, std::uint64_t number);

}  // namespace pupflow::fuzz
