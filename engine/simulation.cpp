#include "pupflow/simulation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/elementary.h"
#include "engine/health.h"
#include "engine/pose.h"
#include "engine/start.h"
#include "engine/steering.h"
#include "engine/step.h"
#include "engine/watch.h"
#include "pupflow/geometry.h"

namespace pupflow {

/// What the face needs of a litter, whatever its precision.
class Simulation::Model {
 public:
  virtual ~Model() = default;
  virtual std::unique_ptr<Model> clone() const = 0;
  virtual Status advance(StageListener* listener) = 0;
  virtual LitterView view() const = 0;
  virtual void observe_start() = 0;  // records what is observed, before the first step
  virtual void observe_poses() = 0;  // records them where they are observed
  virtual void set_cloud(int pup, std::span<const double> positions,
                         std::span<const double> velocities) = 0;
  virtual std::vector<double>& tb() = 0;
  virtual std::vector<double>& heading() = 0;
  virtual const Warnings& warnings() const = 0;
  virtual void judge_anew() = 0;  // parameters or pups were set: warnings judge from here on
  virtual std::vector<Action>& actions() = 0;  // of the next step; empty: none
  virtual std::int64_t step() const = 0;
  virtual Clock& clock() = 0;
  virtual std::uint64_t hash() const = 0;
  virtual void load(const Snapshot& snapshot) = 0;  // whose sizes fit
  virtual void set_threads(int threads) = 0;

  /// Makes the plan anew, after a change of what it is made from.
  void replan() {
    kinds = {};
    for (const Action& action : actions()) {
      kinds.force |= action.force != std::array<double, 3>{};
      kinds.heat |= action.heat != 0;
      kinds.turn |= action.turn.has_value();
    }
    plan = joined(make_plan(params, observed, kinds), forced);
  }

  /// Parameters for the next step.
  void take(const Params& next) {
    if (next.dt != params.dt) clock() = {step(), clock().at(step(), params.dt)};
    const bool other_motion =
        next.dt != params.dt || next.gravity != params.gravity || next.drive != params.drive;
    params = next;
    if (other_motion) judge_anew();
  }

  /// What the schedule and the caller want of the next step. To be called when `next_change` is
  /// reached.
  void take_changes() {
    Params next = params;
    apply_schedule(recipe, step(), next);
    if (next != params) take(next);
    actions() = recipe.schedule.actions(step(), params.pups);
    if (!imposed.empty()) {
      actions().resize(imposed.size());
      for (std::size_t pup = 0; pup < imposed.size(); ++pup) actions()[pup] += imposed[pup];
    }
    next_change = recipe.schedule.next_change(step());
    replan();
  }

  void edit() {
    if (!edited) edited = step();
  }

  Params params, recipe;
  ActionKinds kinds;             // of the actions in the next step
  std::int64_t next_change = 0;  // the number of steps done at which take_changes is due
  std::vector<Action> imposed;   // by set_action, one per pup; empty: none
  std::optional<std::int64_t> edited;
  Plan plan, forced;
  PartSet observed = kContactRecords;
  Status status;
  StepCounters counters;

 protected:
  explicit Model(const Params& p) : params(p), recipe(p) { params.schedule = {}; }
  Model(const Model&) = default;
};

template <class Real>
class Simulation::LitterModel final : public Simulation::Model {
 public:
  LitterModel(const Params& p, InstructionSet set)
      : Model(p), state_(make_state<Real>(p.pups, points_per_pup(p), set)) {
    const auto rest = cube_sphere(p.face_points, p.pup_radius);
    cloud_ = std::make_shared<const Cloud<Real>>(make_cloud<Real>(rest));
    lay_out(p, rest, state_);
    state_.recorded = observed;
    replan();
  }

  std::unique_ptr<Model> clone() const override { return std::make_unique<LitterModel>(*this); }

  Status advance(StageListener* listener) override {
    for (const int pup : placed_) {
      const Status found = find_non_finite(state_, pup, Stage::boundary);
      if (!found.ok()) return found;
    }
    placed_.clear();
    if (state_.step >= next_change) take_changes();
    // A pup that somebody pushes may go where no pup can go by itself.
    if (!watched_ && !kinds.force) watch_.begin(params, state_);
    watched_ = !kinds.force;
    const Status result =
        step_litter(params, plan, *cloud_, state_, workspace_, counters, listener);
    state_.recorded = plan.parts | observed;
    if (result.ok() && watched_) watch_.look(params, state_);
    return result;
  }

  void set_threads(int threads) override { workspace_.team = Team(threads); }

  LitterView view() const override {
    const auto vectors = [&](const auto& x, const auto& y, const auto& z) {
      return PointVectors(x.data(), y.data(), z.data(), state_.pups, state_.points, state_.stride);
    };
    return {.params = params,
            .recipe = recipe,
            .pups = state_.pups,
            .points = state_.points,
            .positions = vectors(state_.x, state_.y, state_.z),
            .velocities = vectors(state_.vx, state_.vy, state_.vz),
            .tb = state_.tb,
            .felt_tb = state_.felt_tb,
            .heading = state_.heading,
            .exposed = state_.exposed,
            .t_left = state_.t_left,
            .t_right = state_.t_right,
            .turn = state_.turn,
            .pose = state_.pose,
            .touched = state_.touched,
            .left = state_.left,
            .strain = state_.strain,
            .touching = state_.touching,
            .step = state_.step,
            .time = state_.clock.at(state_.step, params.dt),
            .recorded = state_.recorded};
  }

  void observe_start() override {
    make_room(state_, observed);
    for (int pup = 0; pup < state_.pups && observed.has(Part::sides); ++pup) {
      steer(params, {.turn = false, .direction = false, .sides = true}, *cloud_, state_, pup);
    }
    state_.recorded = state_.recorded | observed;
  }

  void observe_poses() override {
    if (!observed.has(Part::pose)) return;
    make_room(state_, {Part::pose});
    record_poses(*cloud_, state_, 0, state_.pups);
    state_.recorded.add(Part::pose);
  }

  void set_cloud(int pup, std::span<const double> positions,
                 std::span<const double> velocities) override {
    AlignedVector<Real>* position[3] = {&state_.x, &state_.y, &state_.z};
    AlignedVector<Real>* velocity[3] = {&state_.vx, &state_.vy, &state_.vz};
    for (int i = 0; i < state_.stride; ++i) {
      const std::size_t from = 3 * static_cast<std::size_t>(std::min(i, state_.points - 1));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        (*position[axis])[state_.row(pup) + i] = static_cast<Real>(positions[from + axis]);
        (*velocity[axis])[state_.row(pup) + i] = static_cast<Real>(velocities[from + axis]);
      }
    }
    update_bounds(state_, pup);
    placed_.push_back(pup);
    judge_anew();
  }

  std::vector<double>& tb() override { return state_.tb; }
  std::vector<double>& heading() override { return state_.heading; }
  const Warnings& warnings() const override { return watch_.warnings(); }
  void judge_anew() override { watched_ = false; }
  std::vector<Action>& actions() override { return state_.actions; }
  std::int64_t step() const override { return state_.step; }
  Clock& clock() override { return state_.clock; }
  std::uint64_t hash() const override { return hash_state(state_); }

  void load(const Snapshot& snapshot) override {
    const std::size_t size = 3 * static_cast<std::size_t>(state_.points);
    for (int pup = 0; pup < state_.pups; ++pup) {
      set_cloud(pup, std::span(snapshot.positions).subspan(pup * size, size),
                std::span(snapshot.velocities).subspan(pup * size, size));
    }
    state_.tb = snapshot.body_temperature;
    state_.felt_tb = snapshot.felt_tb;
    state_.heading = snapshot.heading;
    state_.exposed = snapshot.exposed;
    state_.touched = snapshot.touched;
    state_.touching = snapshot.touching;
    state_.recorded = snapshot.recorded;
    state_.step = snapshot.step;
    state_.clock = snapshot.clock;
    params = params_of_step(snapshot.params, snapshot.step);
    params.schedule = {};
    imposed = snapshot.actions;
    edited = snapshot.edited;
    replan();
  }

 private:
  std::shared_ptr<const Cloud<Real>> cloud_;  // never changes, so copies share it
  State<Real> state_;
  Workspace<Real> workspace_;
  Watch<Real> watch_;
  bool watched_ = false;
  std::vector<int> placed_;  // pups set by hand since the last step, whose numbers nobody has seen
};

namespace {

void require_sound(const Params& params) {
  std::vector<Problem> problems = check(params);
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
  const auto is_pup = [pups](int pup) { return pup >= 0 && pup < pups; };
  for (const int pup : snapshot.touched) {
    if (pup != -1 && !is_pup(pup))
      throw std::invalid_argument("the snapshot's touched pups name no pup");
  }
  for (const TouchingPair& pair : snapshot.touching) {
    if (is_pup(pair.first) && is_pup(pair.second) && pair.first < pair.second) continue;
    throw std::invalid_argument("the snapshot's touching pairs name no two pups");
  }
  if (snapshot.step < 0) throw std::invalid_argument("the snapshot's step is negative");
}

void require_pup(int pup, int pups) {
  if (pup >= 0 && pup < pups) return;
  throw std::out_of_range("there is no pup " + std::to_string(pup) + " among " +
                          std::to_string(pups));
}

}  // namespace

Simulation::Simulation(const Params& params, InstructionSet set) {
  require_sound(params);
  if (params.precision == Precision::float_) {
    model_ = std::make_unique<LitterModel<float>>(params, set);
  } else {
    model_ = std::make_unique<LitterModel<double>>(params, set);
  }
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
    require_sound(recipe);
    model_->recipe = std::move(recipe);
    model_->next_change = steps_done();
  }
  model_->take(next);
  model_->replan();
}

void Simulation::set_schedule(const Schedule& schedule) {
  Params recipe = model_->recipe;
  recipe.schedule = {};
  for (const Change& change : model_->recipe.schedule.changes()) {
    if (change.step < steps_done()) recipe.schedule.add(change);
  }
  for (const Change& change : schedule.changes()) {
    if (change.step >= steps_done()) recipe.schedule.add(change);
  }
  require_sound(recipe);
  model_->recipe = std::move(recipe);
  model_->next_change = steps_done();
}

void Simulation::set_action(int pup, const Action& action) {
  require_pup(pup, pups());
  for (const double force : action.force) require_finite(force, "a force on a pup");
  require_finite(action.heat, "the heat of a pup");
  require_finite(action.turn.value_or(0), "the turn of a pup");
  std::vector<Action>& imposed = model_->imposed;
  if (imposed.empty() && !action.acts()) return;
  imposed.resize(static_cast<std::size_t>(pups()));
  imposed[pup] = action;
  model_->next_change = steps_done();
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
