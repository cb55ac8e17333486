// The engine: sound parameters, a schedule and a disturbed litter, 50 steps. Invariant: after each step
// every position, temperature and heading is finite, or the status says in one line that and where one
// is not, and no further step changes anything. Each instruction set gives the same bits, and so does a
// run that goes on from a snapshot: an input's first byte says which of these is compared. Builds with
// assertions check what must hold between stages (engine/invariants.h), too.
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/io/text.h"
#include "pupflow/fields.h"
#include "pupflow/simulation.h"
#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

constexpr int kSteps = 50;

/// Larger litters become usual ones: small, since their number tells more than their size.
constexpr int kMostPups = 4, kUsualPups = 2, kMostFacePoints = 3, kUsualFacePoints = 2;

/// A value for a row of the table: its default, one of its slider, an end of its range, or any.
double value_for(const Parameter& row, Source& source) {
  const std::uint8_t mode = source.byte();
  const bool whole = row.kind != Parameter::Kind::real;
  double value = row.default_value();
  if (mode % 4 == 1) value = row.slider_min + source.share() * (row.slider_max - row.slider_min);
  if (mode % 4 == 2) value = mode < 128 ? row.min : row.max;
  if (mode % 4 == 3) value = source.number();
  if (row.kind == Parameter::Kind::choice) value = mode % static_cast<int>(row.choices.size());
  if (whole) value = std::round(value);
  Problem ignored;
  return check_value(row, value, ignored) ? value : row.default_value();
}

Change change_from(Source& source, int pups) {
  Change change;
  change.step = source.byte() % kSteps;
  const std::uint8_t mode = source.byte();
  if (mode & 1) change.until = change.step + 1 + source.byte() % kSteps;
  if (mode & 2 && pups > 0) {
    change.pup = source.byte() % pups;
    for (double& along : change.action.force) along = 20 * source.share() - 10;
    change.action.heat = source.share() - 0.5;
    if (mode & 4) change.action.turn = 10 * source.share() - 5;
    return change;
  }
  const std::size_t place = source.byte() % parameters().size();
  change.settings.push_back({place, value_for(parameters()[place], source)});
  return change;
}

Params params_from(Source& source) {
  Params params;
  for (const Parameter& row : parameters()) row.set(params, value_for(row, source));
  if (params.pups > kMostPups) params.pups = kUsualPups;
  if (params.face_points > kMostFacePoints) params.face_points = kUsualFacePoints;
  for (int changes = source.byte() % 4; changes > 0; --changes) {
    params.schedule.add(change_from(source, params.pups));
  }
  if (!check(params).empty()) params.schedule = {};
  return params;
}

/// Moves, stretches or breaks pups, and sets their temperatures and headings.
void disturb(Simulation& litter, Source& source) {
  for (int pup = 0; pup < litter.pups() && !source.empty(); ++pup) {
    const std::uint8_t mode = source.byte();
    if (mode & 1) {
      std::vector<double> positions(3 * static_cast<std::size_t>(litter.points()));
      std::vector<double> velocities(positions.size());
      litter.view().positions.copy_pup_to(pup, positions);
      const double factor = mode & 2 ? source.number() : 4 * source.share() - 2;
      const double shift = 4 * source.share() - 2;
      for (std::size_t i = 0; i < positions.size(); ++i) {
        positions[i] = factor * positions[i] + (i % 3 == mode / 64 ? shift : 0);
        velocities[i] = mode & 4 ? source.number() : 0;
      }
      litter.set_cloud(pup, positions, velocities);
    }
    if (mode & 8) litter.set_body_temperature(pup, mode & 16 ? source.number() : source.share());
    if (mode & 32) litter.set_heading(pup, 7 * source.share() - 3.5);
  }
}

/// Velocities are left out: a step finds one that is not finite by where it leads in the next.
bool all_finite(const LitterView& litter) {
  const auto finite = [](double value) { return std::isfinite(value); };
  for (int pup = 0; pup < litter.pups; ++pup) {
    for (int point = 0; point < litter.points; ++point) {
      if (!litter.positions(pup, point).allFinite()) return false;
    }
  }
  return std::all_of(litter.tb.begin(), litter.tb.end(), finite) &&
         std::all_of(litter.heading.begin(), litter.heading.end(), finite);
}

/// Takes a step; false after a bad status.
bool step(Simulation& litter) {
  const Status status = litter.step();
  if (status.ok()) {
    require(all_finite(litter), "a number is not finite, and the status is fine");
    return true;
  }
  require_sound(status.message());
  const std::uint64_t hash = litter.hash();
  require(litter.step().message() == status.message() && litter.hash() == hash,
          "a step after a bad status changed something");
  return false;
}

/// All fields of all that steps can record.
void look(Simulation& litter) {
  for (const auto table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) field.values(litter);
  }
}

/// What steps come to: the litter's hash, or the step that went wrong. Bits of NaN have no meaning, and
/// what is first found in a step depends on what is observed.
std::string outcome(const Simulation& litter) {
  const Status& status = litter.status();
  return status.ok() ? io::hash_text(litter.hash()) : "bad at " + std::to_string(status.step);
}
std::string outcome_after(Simulation litter, std::int64_t steps) {
  litter.run(steps);
  return outcome(litter);
}

/// Whether a litter may be made from it.
bool fits(const Snapshot& snapshot) {
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::all_of(snapshot.body_temperature.begin(), snapshot.body_temperature.end(), finite);
}

/// 50 steps, observed, and whether a snapshot on the way goes on to the same end.
void step_and_look(Simulation& litter, int pause, bool go_on) {
  litter.set_observed(PartSet::all());
  std::optional<Simulation> other;
  for (int taken = 0; taken < kSteps && step(litter); ++taken) {
    if (go_on && taken == pause) other.emplace(litter.snapshot());
  }
  look(litter);
  require(!other || outcome_after(*other, kSteps - pause - 1) == outcome(litter),
          "a run that goes on from a snapshot ends otherwise");
}

}  // namespace

void one_input(std::string_view bytes) {
  Source source(bytes);
  const std::uint8_t first = source.byte();
  const std::size_t compared =
      first / kSteps;  // 0: everything, 1: a snapshot, 2 ...: an instruction set
  const Params params = params_from(source);
  if (!check(params).empty()) return;
  Simulation litter(params);
  disturb(litter, source);
  const Snapshot start = litter.snapshot();
  step_and_look(litter, first % kSteps, compared <= 1);
  if (!fits(start)) return;
  const auto sets = supported_instruction_sets();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (compared != 0 && compared != i + 2) continue;
    require(outcome_after(Simulation(start, sets[i]), kSteps) == outcome(litter),
            "an instruction set gives other bits");
  }
}

}  // namespace pupflow::fuzz
