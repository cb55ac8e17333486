/// @file
/// What changes during a run: parameters, at a step or over some steps, and what is done to single
/// pups. With it a parameter set is the whole recipe of a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace pupflow {

/// What is done to a pup beside what it does by itself.
struct Action {
  std::array<double, 3> force{};  ///< length/s^2; acceleration, added to gravity and drive
  double heat = 0;                ///< normalised/s; added to G
  std::optional<double> turn;  ///< rad/s, in place of its own delta theta; with heading = body rad

  /// Whether it changes anything.
  bool acts() const { return *this != Action{}; }

  /// Both at once: forces and heats add up, the turn of `other` counts if it has one.
  Action& operator+=(const Action& other);

  friend bool operator==(const Action&, const Action&) = default;
};

/// One entry of a schedule. It sets parameters, or acts on one pup.
struct Change {
  /// A value for a parameter.
  struct Setting {
    std::size_t parameter;  ///< its place in parameters(); must be of Effect::next_step
    double value;           ///< as Parameter::set takes it
    friend bool operator==(const Setting&, const Setting&) = default;
  };

  std::int64_t step = 0;  ///< steps done when it begins: step + 1 is the first to use it
  std::optional<std::int64_t> until;  ///< steps done when it has ended
  std::vector<Setting> settings;  ///< without `until` at once, with it linear from the value that
                                  ///< holds at `step`; only Kind::real
  std::optional<int> pup;         ///< whom `action` acts on, up to `until` or the end of the run
  Action action;                  ///< what is done to that pup

  friend bool operator==(const Change&, const Change&) = default;
};

/// All changes of a run, sorted by their steps. Where several set a parameter, the one that began
/// last counts, and of those that begin together the one that was added last. Actions on one pup
/// are added up in that order.
class Schedule {
 public:
  /// No further change.
  static constexpr std::int64_t kNever = INT64_MAX;

  /// In their order. Valid until one is added.
  std::span<const Change> changes() const { return changes_; }

  /// Whether nothing changes.
  bool empty() const { return changes_.empty(); }

  /// Adds a change behind those that begin at the same step. Nothing is checked: `check` does so for
  /// the parameters that hold the schedule.
  void add(Change change);

  /// Adds a change at once of one parameter. A value set before at the same step is replaced.
  void set(std::int64_t step, std::size_t parameter, double value);

  /// What is done to each of `pups` pups in the step after `steps`; empty where nothing is. The
  /// schedule must be sound for these pups.
  std::vector<Action> actions(std::int64_t steps, int pups) const;

  /// The least number of steps done, above `steps`, at which something may be different; kNever
  /// when nothing changes any more.
  std::int64_t next_change(std::int64_t steps) const;

  friend bool operator==(const Schedule&, const Schedule&) = default;

 private:
  std::vector<Change> changes_;
};

}  // namespace pupflow
#pragma GCC visibility pop
