#include "pupflow/simulation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/elementary.h"
#include "engine/litter_model.h"
#include "pupflow/geometry.h"

namespace pupflow {

namespace {

void require_sound(const Params& params, std::int64_t from = 0) {
  std::vector<Problem> problems = check(params, from);
  if (!problems.empty()) throw InvalidParams(std::move(problems));
}

/// Makes what differs between the parameters in force and `next` part of the recipe: a change at
/// `step`, or, before the first step and all changes, a value of the start.
void add_to_recipe(const Params& in_force, const Params& next, std::int64_t step, Params& recipe) {
  const std::span<const Parameter> table = parameters();
  const bool at_start = step == 0 && recipe.schedule.next_change(-1) > 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = table[i].get(next);
    if (value == table[i].get(in_force)) continue;
    const bool of_run = table[i].effect == Parameter::Effect::run;
    of_run || at_start ? table[i].set(recipe, value) : recipe.schedule.set(step, i, value);
  }
}

void require_size(std::size_t size, std::size_t expected, const char* what) {
  if (size == expected) return;
  throw std::invalid_argument(std::string(what) + " holds " + std::to_string(size) +
                              " numbers, not " + std::to_string(expected));
}

void require_finite(double value, const char* what) {
  if (std::isfinite(value)) return;
  throw std::invalid_argument(std::string(what) + " is not a finite number");
}

void require_finite(const Action& action) {
  for (const double force : action.force) require_finite(force, "a force on a pup");
  require_finite(action.heat, "the heat of a pup");
  require_finite(action.turn.value_or(0), "the turn of a pup");
}

void require_fitting(const Snapshot& snapshot, int pups, int points) {
  const auto n = static_cast<std::size_t>(pups), all = n * static_cast<std::size_t>(points);
  require_size(snapshot.positions.size(), 3 * all, "the snapshot's positions");
  require_size(snapshot.velocities.size(), 3 * all, "the snapshot's velocities");
  require_size(snapshot.body_temperature.size(), n, "the snapshot's body temperatures");
  require_size(snapshot.felt_tb.size(), n, "the snapshot's felt body temperatures");
  require_size(snapshot.heading.size(), n, "the snapshot's headings");
  require_size(snapshot.exposed.size(), n, "the snapshot's exposures");
  require_size(snapshot.touched.size(), all, "the snapshot's touched pups");
  if (!snapshot.actions.empty()) require_size(snapshot.actions.size(), n, "the snapshot's actions");
  for (const double tb : snapshot.body_temperature)
    require_finite(tb, "a body temperature of the snapshot");
  for (const double tb : snapshot.felt_tb)
    require_finite(tb, "a felt body temperature of the snapshot");
  for (const double heading : snapshot.heading)
    require_finite(heading, "a heading of the snapshot");
  for (const double exposed : snapshot.exposed)
    require_finite(exposed, "an exposed share of the snapshot");
  for (const Action& action : snapshot.actions) require_finite(action);
  require_finite(snapshot.clock.time, "the snapshot's time");
  const auto is_pup = [pups](int pup) { return pup >= 0 && pup < pups; };
  for (const int pup : snapshot.touched) {
    if (pup != -1 && !is_pup(pup))
      throw std::invalid_argument("the snapshot's touched pups name no pup");
  }
  for (const TouchingPair& pair : snapshot.touching) {
    if (is_pup(pair.first) && is_pup(pair.second) && pair.first < pair.second) continue;
    throw std::invalid_argument("the snapshot's touching pairs name no two pups");
  }
  if (snapshot.step < 0 || static_cast<double>(snapshot.step) > kExactInteger)
    throw std::invalid_argument("the snapshot's step is not among 0 … 2^53 - 1");
  if (snapshot.clock.step < 0 || snapshot.clock.step > snapshot.step)
    throw std::invalid_argument("the snapshot's clock was not set in one of its steps");
}

void require_pup(int pup, int pups) {
  if (pup >= 0 && pup < pups) return;
  throw std::out_of_range("there is no pup " + std::to_string(pup) + " among " +
                          std::to_string(pups));
}

}  // namespace

Simulation::Simulation(const Params& params, InstructionSet set) {
  require_sound(params);
  model_ = make_litter_model(params, set);
}

Simulation::Simulation(const Snapshot& snapshot, InstructionSet set)
    : Simulation(snapshot.params, set) {
  require_fitting(snapshot, pups(), points());
  model_->load(snapshot);
}

Simulation::Simulation(const Simulation& other) : model_(other.model_->clone()) {}
Simulation::Simulation(Simulation&& other) noexcept = default;
Simulation& Simulation::operator=(const Simulation& other) {
  if (this != &other) model_ = other.model_->clone();
  return *this;
}
Simulation& Simulation::operator=(Simulation&& other) noexcept = default;
Simulation::~Simulation() = default;

const Params& Simulation::params() const {
  return model_->params;
}

const Params& Simulation::recipe() const {
  return model_->recipe;
}

void Simulation::set_params(const Params& params) {
  Params next = params;
  next.schedule = {};
  require_sound(next);
  if (needs_restart(model_->params, next)) {
    throw std::logic_error("these parameters define the litter and need a new simulation");
  }
  if (model_->next_change == Schedule::kNever) {
    // Nothing is to come that might not go with them.
    add_to_recipe(model_->params, next, steps_done(), model_->recipe);
  } else {
    Params recipe = model_->recipe;
    add_to_recipe(model_->params, next, steps_done(), recipe);
    require_sound(recipe, steps_done());
    model_->recipe = std::move(recipe);
    model_->next_change = steps_done();
  }
  model_->take(next);
  model_->replan();
}

void Simulation::set_schedule(const Schedule& schedule) {
  Params recipe = model_->recipe;
  const auto old = model_->recipe.schedule.changes();
  if (!old.empty() && old.back().step >= steps_done()) {
    recipe.schedule = {};
    for (const Change& change : old) {
      if (change.step < steps_done()) recipe.schedule.add(change);
    }
  }
  for (const Change& change : schedule.changes()) {
    if (change.step >= steps_done()) recipe.schedule.add(change);
  }
  require_sound(recipe, steps_done());
  model_->recipe = std::move(recipe);
  model_->next_change = steps_done();
}

void Simulation::set_action(int pup, const Action& action) {
  require_pup(pup, pups());
  require_finite(action);
  std::vector<Action>& imposed = model_->imposed;
  if (imposed.empty() && !action.acts()) return;
  imposed.resize(static_cast<std::size_t>(pups()));
  imposed[pup] = action;
  model_->imposed_anew = true;
  model_->edit();
}

Action Simulation::action(int pup) const {
  require_pup(pup, pups());
  return model_->imposed.empty() ? Action{} : model_->imposed[pup];
}

std::optional<std::int64_t> Simulation::edited() const {
  return model_->edited;
}

void Simulation::set_observed(PartSet parts) {
  model_->observed = parts;
  model_->replan();
  if (steps_done() == 0) model_->observe_start();
  model_->observe_poses();
}

void Simulation::force_plan(const Plan& more) {
  model_->forced = more;
  model_->replan();
}

void Simulation::set_threads(int threads) {
  if (threads < 1) {
    throw std::invalid_argument("a simulation needs at least one thread, not " +
                                std::to_string(threads));
  }
  model_->set_threads(threads);
}

const Plan& Simulation::plan() const {
  return model_->plan;
}

Status Simulation::step(StageListener* listener) {
  if (model_->status.ok()) model_->status = model_->advance(listener);
  return model_->status;
}

Status Simulation::run(std::int64_t count) {
  for (std::int64_t i = 0; i < count && step().ok(); ++i) {
  }
  return model_->status;
}

const Status& Simulation::status() const {
  return model_->status;
}
std::span<const Warning> Simulation::warnings() const {
  return model_->warnings().all();
}
std::int64_t Simulation::steps_done() const {
  return model_->step();
}
double Simulation::time() const {
  return model_->clock().at(steps_done(), params().dt);
}
int Simulation::pups() const {
  return params().pups;
}
int Simulation::points() const {
  return points_per_pup(params());
}
LitterView Simulation::view() const {
  return model_->view();
}

void Simulation::set_cloud(int pup, std::span<const double> positions,
                           std::span<const double> velocities) {
  require_pup(pup, pups());
  const std::size_t expected = 3 * static_cast<std::size_t>(points());
  require_size(positions.size(), expected, "the cloud");
  require_size(velocities.size(), expected, "the cloud's velocities");
  model_->set_cloud(pup, positions, velocities);
  model_->edit();
}

void Simulation::set_body_temperature(int pup, double value) {
  require_pup(pup, pups());
  model_->tb()[pup] = value;
  model_->edit();
}

void Simulation::set_heading(int pup, double radians) {
  require_pup(pup, pups());
  require_finite(radians, "a heading to be set");
  model_->heading()[pup] = wrap_angle(radians);
  model_->edit();
}

Snapshot Simulation::snapshot() const {
  const LitterView litter = view();
  Snapshot snapshot;
  snapshot.params = recipe();
  snapshot.in_force = params();
  const std::size_t size = std::size_t{3} * litter.pups * litter.points;
  snapshot.positions.resize(size);
  snapshot.velocities.resize(size);
  litter.positions.copy_to(snapshot.positions);
  litter.velocities.copy_to(snapshot.velocities);
  const auto copy = [](auto from) { return std::vector(from.begin(), from.end()); };
  snapshot.body_temperature = copy(litter.tb);
  snapshot.felt_tb = copy(litter.felt_tb);
  snapshot.heading = copy(litter.heading);
  snapshot.exposed = copy(litter.exposed);
  snapshot.touched = copy(litter.touched);
  snapshot.touching = copy(litter.touching);
  snapshot.actions = model_->imposed;
  snapshot.edited = edited();
  snapshot.step = litter.step;
  snapshot.clock = model_->clock();
  snapshot.recorded = litter.recorded;
  return snapshot;
}

std::int64_t Simulation::rotation_fallbacks() const {
  return model_->counters.rotation_fallbacks;
}
std::int64_t Simulation::searched_pairs() const {
  return model_->counters.searched_pairs;
}
std::uint64_t Simulation::hash() const {
  return model_->hash();
}

}  // namespace pupflow
