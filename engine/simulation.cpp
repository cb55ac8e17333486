#include "pupflow/simulation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/elementary.h"
#include "engine/health.h"
#include "engine/start.h"
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
  virtual std::size_t size() const = 0;  // coordinates of all points
  virtual void copy_positions(std::span<float> xyz) const = 0;
  virtual void copy_positions(std::span<double> xyz) const = 0;
  virtual void copy_velocities(std::span<double> xyz) const = 0;
  virtual void set_cloud(int pup, std::span<const double> positions,
                         std::span<const double> velocities) = 0;
  virtual Eigen::Vector3d centre(int pup) const = 0;
  virtual std::vector<double>& tb() = 0;
  virtual std::vector<double>& heading() = 0;
  virtual std::span<const double> exposed() const = 0;
  virtual std::span<const int> touched() const = 0;
  virtual std::span<const TouchingPair> touching() const = 0;
  virtual const Warnings& warnings() const = 0;
  virtual void set_by_hand() = 0;  // parameters or points were: warnings judge from here on
  virtual std::int64_t step() const = 0;
  virtual Clock& clock() = 0;
  virtual int pups() const = 0;
  virtual int points() const = 0;
  virtual std::uint64_t hash() const = 0;
  virtual void load(const Snapshot& snapshot) = 0;  // whose sizes fit
  virtual void set_threads(int threads) = 0;

  /// Makes the plan anew, after a change of what it is made from.
  void replan() { plan = joined(make_plan(params, observed), forced); }

  Params params;
  Plan plan, forced;
  bool observed = true;
  Status status;
  StepCounters counters;

 protected:
  explicit Model(const Params& p) : params(p) { replan(); }
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
  }

  std::unique_ptr<Model> clone() const override { return std::make_unique<LitterModel>(*this); }

  Status advance(StageListener* listener) override {
    for (const int pup : placed_) {
      const Status found = find_non_finite(state_, pup, Stage::boundary);
      if (!found.ok()) return found;
    }
    placed_.clear();
    if (!watched_) watch_.begin(params, state_);
    watched_ = true;
    const Status result =
        step_litter(params, plan, *cloud_, state_, workspace_, counters, listener);
    if (result.ok()) watch_.look(params, state_);
    return result;
  }

  void set_threads(int threads) override { workspace_.team = Team(threads); }

  std::size_t size() const override { return 3 * state_.flat(state_.pups); }
  void copy_positions(std::span<float> xyz) const override {
    copy(state_.x, state_.y, state_.z, xyz);
  }
  void copy_positions(std::span<double> xyz) const override {
    copy(state_.x, state_.y, state_.z, xyz);
  }
  void copy_velocities(std::span<double> xyz) const override {
    copy(state_.vx, state_.vy, state_.vz, xyz);
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
    set_by_hand();
  }

  Eigen::Vector3d centre(int pup) const override {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = state_.row(pup); i < state_.row(pup) + state_.points; ++i) {
      sum += Eigen::Vector3d(state_.x[i], state_.y[i], state_.z[i]);
    }
    return sum / state_.points;
  }

  std::vector<double>& tb() override { return state_.tb; }
  std::vector<double>& heading() override { return state_.heading; }
  std::span<const double> exposed() const override { return state_.exposed; }
  std::span<const int> touched() const override { return state_.touched; }
  std::span<const TouchingPair> touching() const override { return state_.touching; }
  const Warnings& warnings() const override { return watch_.warnings(); }
  void set_by_hand() override { watched_ = false; }
  std::int64_t step() const override { return state_.step; }
  Clock& clock() override { return state_.clock; }
  int pups() const override { return state_.pups; }
  int points() const override { return state_.points; }
  std::uint64_t hash() const override { return hash_state(state_); }

  void load(const Snapshot& snapshot) override {
    const std::size_t size = 3 * static_cast<std::size_t>(state_.points);
    for (int pup = 0; pup < state_.pups; ++pup) {
      set_cloud(pup, std::span(snapshot.positions).subspan(pup * size, size),
                std::span(snapshot.velocities).subspan(pup * size, size));
    }
    state_.tb = snapshot.body_temperature;
    state_.heading = snapshot.heading;
    state_.exposed = snapshot.exposed;
    state_.touched = snapshot.touched;
    state_.touching = snapshot.touching;
    state_.step = snapshot.step;
    state_.clock = snapshot.clock;
  }

 private:
  template <class Out>
  void copy(const AlignedVector<Real>& x, const AlignedVector<Real>& y,
            const AlignedVector<Real>& z, std::span<Out> xyz) const {
    std::size_t out = 0;
    for (int pup = 0; pup < state_.pups; ++pup) {
      for (std::size_t i = state_.row(pup); i < state_.row(pup) + state_.points; ++i) {
        xyz[out++] = static_cast<Out>(x[i]);
        xyz[out++] = static_cast<Out>(y[i]);
        xyz[out++] = static_cast<Out>(z[i]);
      }
    }
  }

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
  require_size(snapshot.heading.size(), n, "the snapshot's headings");
  require_size(snapshot.exposed.size(), n, "the snapshot's exposures");
  require_size(snapshot.touched.size(), all, "the snapshot's touched pups");
  for (const double tb : snapshot.body_temperature)
    require_finite(tb, "a body temperature of the snapshot");
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

void Simulation::set_params(const Params& params) {
  require_sound(params);
  if (needs_restart(model_->params, params)) {
    throw std::logic_error("these parameters define the litter and need a new simulation");
  }
  if (params.dt != model_->params.dt) model_->clock() = {steps_done(), time()};
  model_->params = params;
  model_->replan();
  model_->set_by_hand();
}

void Simulation::set_observed(bool observed) {
  model_->observed = observed;
  model_->replan();
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
  return model_->pups();
}
int Simulation::points() const {
  return model_->points();
}

void Simulation::copy_positions(std::span<float> xyz) const {
  require_size(xyz.size(), model_->size(), "the span for positions");
  model_->copy_positions(xyz);
}

void Simulation::copy_positions(std::span<double> xyz) const {
  require_size(xyz.size(), model_->size(), "the span for positions");
  model_->copy_positions(xyz);
}

void Simulation::copy_velocities(std::span<double> xyz) const {
  require_size(xyz.size(), model_->size(), "the span for velocities");
  model_->copy_velocities(xyz);
}

void Simulation::set_cloud(int pup, std::span<const double> positions,
                           std::span<const double> velocities) {
  require_pup(pup, pups());
  const std::size_t expected = 3 * static_cast<std::size_t>(points());
  require_size(positions.size(), expected, "the cloud");
  require_size(velocities.size(), expected, "the cloud's velocities");
  model_->set_cloud(pup, positions, velocities);
}

Eigen::Vector3d Simulation::centre(int pup) const {
  require_pup(pup, pups());
  return model_->centre(pup);
}

std::span<const double> Simulation::body_temperature() const {
  return model_->tb();
}
std::span<const double> Simulation::heading() const {
  return model_->heading();
}
std::span<const double> Simulation::exposed() const {
  return model_->exposed();
}

void Simulation::set_body_temperature(int pup, double value) {
  require_pup(pup, pups());
  model_->tb()[pup] = value;
}

void Simulation::set_heading(int pup, double radians) {
  require_pup(pup, pups());
  require_finite(radians, "a heading to be set");
  model_->heading()[pup] = wrap_angle(radians);
}

std::span<const int> Simulation::touched_pup() const {
  return model_->touched();
}
std::span<const TouchingPair> Simulation::touching() const {
  return model_->touching();
}
Snapshot Simulation::snapshot() const {
  Snapshot snapshot;
  snapshot.params = params();
  snapshot.positions.resize(model_->size());
  snapshot.velocities.resize(model_->size());
  copy_positions(snapshot.positions);
  copy_velocities(snapshot.velocities);
  const auto copy = [](auto from) { return std::vector(from.begin(), from.end()); };
  snapshot.body_temperature = copy(body_temperature());
  snapshot.heading = copy(heading());
  snapshot.exposed = copy(exposed());
  snapshot.touched = copy(touched_pup());
  snapshot.touching = copy(touching());
  snapshot.step = steps_done();
  snapshot.clock = model_->clock();
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
