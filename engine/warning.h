// Impossible states of a litter whose numbers are all finite. Each is reported once, and the run
// goes on.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pupflow {

/// One impossible state: what, when it was first seen, which pup. watch.h has the criteria.
struct Warning {
  enum class Kind {
    sunk,           // a pup's centre is under the floor
    hanging,        // nothing carries a pup, and it does not fall
    outside,        // a pup's centre is outside the wall
    gaining_energy  // a pup is higher than start and drive can have brought it
  };
  Kind kind = Kind::sunk;
  std::int64_t step = 0;  // counted from 1
  int pup = -1;

  /// A few words for people, without commas, e.g. "hanging in the air from step 812 pup 3".
  std::string message() const;
};
constexpr int kWarningKinds = 4;

/// The kind as it stands in messages.
std::string_view warning_name(Warning::Kind kind);

/// The first warning of each kind, in the order of their steps.
class Warnings {
 public:
  std::span<const Warning> all() const { return {list_.data(), static_cast<std::size_t>(count_)}; }
  bool has(Warning::Kind kind) const;

  /// Keeps `warning` unless there is one of its kind.
  void add(const Warning& warning);

 private:
  std::array<Warning, kWarningKinds> list_{};
  int count_ = 0;
};

/// Their messages, joined by "; "; empty when there is none.
std::string warnings_text(std::span<const Warning> warnings);

}  // namespace pupflow
