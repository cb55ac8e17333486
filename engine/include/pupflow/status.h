/// @file
/// What a step reports: a status, fine or where the numbers went wrong; and warnings of impossible
/// states of a litter whose numbers are all finite. Each kind of warning is reported once, and the
/// run goes on.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace pupflow {

/// The stages of a step, in the order in which they run. Only with integrator = explicit
/// shape_match runs before predict. A step leaves out the stages that its scene does not need
/// (plan.h).
enum class Stage {
  boundary,    ///< floor and wall
  contact,     ///< points of different pups that touch
  steering,    ///< headings, from the temperatures that points feel
  heat,        ///< body temperatures
  predict,     ///< motion under gravity and drive
  shape_match  ///< pull of the points towards their goals
};
/// How many there are.
constexpr int kStageCount = 6;

/// The stage's name as `explain`, errors and benchmarks print it.
std::string_view stage_name(Stage stage);

/// Told when a stage of a step begins and ends; the engine itself owns no clock.
class StageListener {
 public:
  virtual ~StageListener() = default;
  virtual void stage_begins(Stage stage) = 0;  ///< called on the thread that steps
  virtual void stage_ends(Stage stage) = 0;    ///< called on the same thread
};

/// Outcome of a step. A step never repairs anything. After a bad status the state stays as the step
/// left it, for inspection, and the simulation takes no more steps.
struct Status {
  /// How a step ended.
  enum class Kind {
    fine,        ///< with finite numbers
    non_finite,  ///< a number became infinite or NaN
    diverged,    ///< finite but far too large: a point is further than 100 pup radii from its pup's
                 ///< centre, or forward Euler drives a body temperature away from equilibrium
    escaped      ///< a pup is more than 100 pup radii beyond the wall
  };
  Kind kind = Kind::fine;         ///< how the step ended
  Stage stage = Stage::boundary;  ///< the first stage whose result was bad
  std::int64_t step = 0;          ///< the step in which it happened, counted from 1
  int pup = -1;                   ///< whose number it was
  int point = -1;                 ///< -1 where the quantity belongs to the whole pup

  /// Whether it is fine.
  bool ok() const { return kind == Kind::fine; }

  /// One line for people, e.g. "non-finite number at step 12, stage heat, pup 3".
  std::string message() const;
};

/// The kind as it stands in a message.
std::string_view kind_name(Status::Kind kind);

/// One impossible state: its kind, the step in which it was first seen, and the pup. engine/watch.h
/// has the criteria.
struct Warning {
  /// What was seen.
  enum class Kind {
    sunk,           ///< a pup's centre is under the floor
    hanging,        ///< a pup has no support and does not fall
    outside,        ///< a pup's centre is outside the wall
    gaining_energy  ///< a pup is higher than its energy at the start and the drive allow
  };
  Kind kind = Kind::sunk;  ///< what was seen
  std::int64_t step = 0;   ///< counted from 1
  int pup = -1;            ///< of which pup

  /// A few words for people, without commas, e.g. "hanging in the air from step 812 pup 3".
  std::string message() const;
};
/// How many kinds there are.
constexpr int kWarningKinds = 4;

/// The kind as it stands in messages.
std::string_view warning_name(Warning::Kind kind);

/// The first warning of each kind, in the order of their steps.
class Warnings {
 public:
  /// By step. Valid until one is added.
  std::span<const Warning> all() const { return {list_.data(), static_cast<std::size_t>(count_)}; }

  /// Whether there is one of this kind.
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
#pragma GCC visibility pop
