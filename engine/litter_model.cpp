#include "engine/litter_model.h"

#include <algorithm>

#include "engine/health.h"
#include "engine/pose.h"
#include "engine/start.h"
#include "engine/steering.h"
#include "engine/watch.h"

namespace pupflow {
namespace {

template <class Real>
class ModelOf final : public LitterModel {
 public:
  ModelOf(const Params& p, InstructionSet set)
      : LitterModel(p), state_(make_state<Real>(p.pups, points_per_pup(p), set)) {
    const auto rest = cube_sphere(p.face_points, p.pup_radius);
    cloud_ = std::make_shared<const Cloud<Real>>(make_cloud<Real>(rest));
    lay_out(p, rest, state_);
    state_.recorded = observed;
    replan();
  }

  std::unique_ptr<LitterModel> clone() const override { return std::make_unique<ModelOf>(*this); }

  Status advance(StageListener* listener) override {
    for (const int pup : placed_) {
      const Status found = find_non_finite(state_, pup, Stage::boundary);
      if (!found.ok()) return found;
    }
    placed_.clear();
    if (state_.step >= next_change || imposed_anew) take_changes();
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

}  // namespace

std::unique_ptr<LitterModel> make_litter_model(const Params& params, InstructionSet set) {
  if (params.precision == Precision::float_) return std::make_unique<ModelOf<float>>(params, set);
  return std::make_unique<ModelOf<double>>(params, set);
}

}  // namespace pupflow
