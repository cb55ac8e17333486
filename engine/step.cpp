#include "engine/step.h"

#include <algorithm>
#include <array>
#include <span>

#include "engine/boundary.h"
#include "engine/health.h"
#include "engine/heat.h"
#include "engine/pose.h"
#include "engine/refinement.h"
#include "engine/shape_match.h"
#include "engine/steering.h"

namespace pupflow {
namespace {

/// The planned stages in the order of the integrator.
class Sequence {
 public:
  Sequence(const Plan& plan, Integrator integrator) {
    const bool predict_first = integrator == Integrator::predictive;
    for (const Stage stage : {Stage::boundary, Stage::contact, Stage::steering, Stage::heat,
                              predict_first ? Stage::predict : Stage::shape_match,
                              predict_first ? Stage::shape_match : Stage::predict}) {
      if (plan.has(stage)) stages_[count_++] = stage;
    }
  }
  std::span<const Stage> stages() const { return {stages_.data(), count_}; }

  /// The last stage that moves points.
  Stage last_motion() const { return stages_[count_ - 1]; }

 private:
  std::array<Stage, kStageCount> stages_{};
  std::size_t count_ = 0;
};

/// One step under way.
template <class Real>
struct Step {
  using Found = typename Workspace<Real>::Found;

  const Params& params;
  const Plan& plan;
  const Cloud<Real>& cloud;
  State<Real>& state;
  Workspace<Real>& workspace;
  const Sequence& sequence;
  StepBody body;

  /// Any stage but shape matching, which takes several pups at a time.
  Status stage_of_pup(Stage stage, int pup, int worker) const {
    switch (stage) {
      case Stage::boundary:
        apply_boundaries(params, state, pup);
        return {};
      case Stage::contact:
        return workspace.contacts.apply(params, body.contact_share, state, pup, worker);
      case Stage::steering:
        return steer(params,
                     {plan.has(Part::turn), plan.has(Part::direction), plan.has(Part::sides)},
                     cloud, state, pup);
      case Stage::heat:
        return heat(params, plan.has(Part::mean_temperature), state, pup, state.felt_tb[pup]);
      case Stage::predict:
        predict(params, state, pup);
        return check_if_last(stage, pup);
      case Stage::shape_match:
        break;
    }
    return {};
  }

  Status check_if_last(Stage stage, int pup) const {
    return stage == sequence.last_motion() ? check_motion(params, state, pup, stage) : Status{};
  }

  /// Stages number `begin` ... `end` - 1 of the sequence: all of them for some pups, then for the
  /// next, while their points are at hand.
  void run(std::size_t begin, std::size_t end, StepCounters& counters) const {
    if (sequence.stages()[begin] == Stage::contact) {
      const ContactRecords records{plan.has(Part::exposure), plan.has(Part::owners),
                                   plan.has(Part::pairs)};
      workspace.contacts.find(params, records, state, workspace.team);
      counters.searched_pairs += workspace.contacts.searched_pairs();
    }
    const int workers = useful_workers(workspace.team, state.pups);
    workspace.team.run(workers, [&](int worker) {
      Found& found = workspace.found[worker];
      const Share share = share_of(state.pups, worker, workers);
      for (int pup = share.begin; pup < share.end; pup += kMatchedTogether) {
        run_some(begin, end, pup, std::min(pup + kMatchedTogether, share.end), worker, found);
      }
    });
  }

  /// Whether shape matching has all that poses take; otherwise they are fitted after the step.
  bool poses_from_match() const {
    return plan.has(Part::pose) && plan.has(Part::rotation) && !body.damps() &&
           params.integrator == Integrator::predictive;
  }

  /// Those stages for the pups first ... last - 1.
  void run_some(std::size_t begin, std::size_t end, int first, int last, int worker,
                Found& found) const {
    const auto matches = [&](std::size_t place) {
      return sequence.stages()[place] == Stage::shape_match;
    };
    for (std::size_t place = begin, next; place < end; place = next) {
      next = place + 1;
      if (matches(place)) {
        const MatchParts parts{plan.has(Part::quadratic), plan.has(Part::rotation),
                               plan.has(Part::strain), poses_from_match()};
        found.counters.rotation_fallbacks +=
            match_shapes(params, body, parts, cloud, state, first, last);
        for (int pup = first; pup < last; ++pup) {
          keep_earliest(found, check_if_last(Stage::shape_match, pup), place);
        }
        continue;
      }
      while (next < end && !matches(next)) ++next;
      for (int pup = first; pup < last; ++pup) {
        for (std::size_t i = place; i < next; ++i) {
          keep_earliest(found, stage_of_pup(sequence.stages()[i], pup, worker), i);
        }
      }
    }
    const bool done = end == sequence.stages().size();
    if (done && plan.has(Part::pose) && !poses_from_match()) {
      record_poses(cloud, state, first, last);
    }
  }

  static void keep_earliest(Found& found, const Status& status, std::size_t place) {
    if (status.ok() || (!found.status.ok() && found.place <= place)) return;
    found.status = status;
    found.place = place;
  }

  /// What all workers found.
  Status gather(StepCounters& counters) const {
    Found all;
    for (const Found& found : workspace.found) {
      keep_earliest(all, found.status, found.place);
      counters.rotation_fallbacks += found.counters.rotation_fallbacks;
    }
    return all.status;
  }
};

}  // namespace

template <class Real>
Status step_litter(const Params& params, const Plan& plan, const Cloud<Real>& cloud,
                   State<Real>& state, Workspace<Real>& workspace, StepCounters& counters,
                   StageListener* listener) {
  const Sequence sequence(plan, params.integrator);
  const std::span<const Stage> stages = sequence.stages();
  const Step<Real> step{params, plan, cloud, state, workspace, sequence, step_body(params)};
  workspace.found.assign(workspace.team.size(), {});
  make_room(state, plan.parts);
  // Contacts need all pups behind the boundary stage. What follows them looks at nothing of other
  // pups that a later stage changes, so a pup can be taken through it in one go; a listener wants
  // to see the stages one by one.
  const bool apart = listener != nullptr;
  for (std::size_t begin = 0; begin < stages.size();) {
    const bool alone = apart || stages[begin] == Stage::boundary;
    const std::size_t end = alone ? begin + 1 : stages.size();
    if (apart) listener->stage_begins(stages[begin]);
    step.run(begin, end, counters);
    if (apart) listener->stage_ends(stages[begin]);
    begin = end;
  }
  if (plan.has(Stage::heat)) {
    state.tb.swap(state.felt_tb);  // the heat stage wrote the new temperatures there
  } else {
    state.felt_tb = state.tb;
  }
  const Status status = step.gather(counters);
  if (status.ok()) ++state.step;
  return status;
}

#define PUPFLOW_INSTANTIATE(Real)                                                                 \
  template Status step_litter<Real>(const Params&, const Plan&, const Cloud<Real>&, State<Real>&, \
                                    Workspace<Real>&, StepCounters&, StageListener*);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
