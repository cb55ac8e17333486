#include "pupflow/plan.h"

namespace pupflow {
namespace {

/// The first reason that leaves something out, or why it is in.
struct Verdict {
  bool needed;
  std::string reason;
};

struct PartRow {
  Part part;
  Stage stage;
  std::string_view name;
};

constexpr PartRow kParts[kPartCount] = {
    {Part::exposure, Stage::contact, "exposed share"},
    {Part::owners, Stage::contact, "touched pups"},
    {Part::pairs, Stage::contact, "touching pairs"},
    {Part::turn, Stage::steering, "turn"},
    {Part::direction, Stage::steering, "direction"},
    {Part::sides, Stage::steering, "felt sides"},
    {Part::mean_temperature, Stage::heat, "mean T_c"},
    {Part::rotation, Stage::shape_match, "rotation"},
    {Part::quadratic, Stage::shape_match, "quadratic terms"},
    {Part::strain, Stage::shape_match, "strain"},
    {Part::pose, Stage::shape_match, "pose"},
};

Verdict decide_boundary(const Params& p) {
  if (p.pups == 0) return {false, "there is no pup"};
  return {true, "every pup meets the floor or the wall"};
}

Verdict decide_contact(const Params& p) {
  if (p.pups < 2) return {false, "fewer than two pups: no other pup to touch"};
  return {true, "pups can touch each other"};
}

Verdict decide_turn(const Params& p) {
  if (p.pups < 2) return {false, "one pup has no contact: both its sides feel T_a"};
  if (p.sensitivity == 0) return {false, "sigma = 0: both sensors read the same, so no pup turns"};
  if (p.steering_gain == 0) return {false, "v = 0: no pup turns"};
  return {true, "contacts turn the pups"};
}

Verdict decide_steering(const Params& p, ActionKinds actions = {}) {
  if (p.pups == 0) return {false, "there is no pup"};
  if (actions.turn) return {true, "a pup is turned"};
  if (p.drive == 0) return {false, "drive = 0: the direction of travel moves nothing"};
  if (p.heading == Heading::body) return {true, "the direction of travel follows the body axis"};
  return decide_turn(p);  // a course that nothing turns stays as it is
}

Verdict decide_heat(const Params& p, ActionKinds actions = {}) {
  if (p.pups == 0) return {false, "there is no pup"};
  if (actions.heat) return {true, "a pup is heated"};
  if (p.air_conductance == 0 && p.contact_conductance == 0 && p.thermogenesis == 0)
    return {false, "k1 = k2 = g = 0: body temperatures never change"};
  return {true, "body temperatures change"};
}

Verdict decide_mean_temperature(const Params& p) {
  if (p.pups < 2) return {false, "fewer than two pups: no other pup to touch"};
  if (p.contact_conductance == 0) return {false, "k2 = 0: no heat flows between pups"};
  return {true, "heat flows between pups that touch"};
}

Verdict decide_predict(const Params& p) {
  if (p.pups == 0) return {false, "there is no pup"};
  return {true, "points move by their velocity, gravity and drive"};
}

Verdict decide_shape_match(const Params& p) {
  if (p.pups == 0) return {false, "there is no pup"};
  if (p.rigidity == 0) return {false, "alpha = 0: points are not drawn to any goal"};
  return {true, "points are drawn to their goals"};
}

Verdict decide_rotation(const Params& p) {
  if (p.deformation == 1) return {false, "beta = 1: goals are the fit alone"};
  return {true, "goals are in part the rest shape, turned"};
}

Verdict decide_quadratic(const Params& p) {
  if (p.deformation == 0) return {false, "beta = 0: goals only turn and move"};
  return {true, "goals bend with the body"};
}

/// Whether the motion or the heat of the litter needs `stage`.
Verdict decide(Stage stage, const Params& p, ActionKinds actions) {
  switch (stage) {
    case Stage::boundary:
      return decide_boundary(p);
    case Stage::contact:
      return decide_contact(p);
    case Stage::steering:
      return decide_steering(p, actions);
    case Stage::heat:
      return decide_heat(p, actions);
    case Stage::predict:
      return decide_predict(p);
    case Stage::shape_match:
      return decide_shape_match(p);
  }
  return {true, ""};
}

/// A part that records something for an observer.
Verdict decide_record(bool observed) {
  if (!observed) return {false, "only an observer reads it"};
  return {true, "read by an observer"};
}

/// Whether a step needs `stage`: for the litter, or for what an observer reads of it.
Verdict decide(Stage stage, const Params& p, PartSet observed, ActionKinds actions) {
  const Verdict verdict = decide(stage, p, actions);
  if (verdict.needed || p.pups == 0) return verdict;
  const bool records =
      (stage == Stage::steering && observed.has(Part::sides)) ||
      (stage == Stage::shape_match && (observed.has(Part::strain) || observed.has(Part::pose)));
  return records ? decide_record(true) : verdict;
}

/// A part of the contact stage, which is needed if anything reads it.
Verdict decide_readers(bool heat, bool steering, bool observer) {
  std::string readers;
  const auto add = [&](bool reads, const char* who) {
    if (reads) readers += (readers.empty() ? "" : ", ") + std::string(who);
  };
  add(heat, "heat");
  add(steering, "steering");
  add(observer, "an observer");
  if (readers.empty()) return {false, "neither heat nor steering nor an observer reads it"};
  return {true, "read by " + readers};
}

/// Whether `part` is needed in a step that has its stage.
Verdict decide(Part part, const Params& p, PartSet observed, ActionKinds actions) {
  const bool heat = decide_heat(p).needed;
  const bool turn = decide_steering(p).needed && decide_turn(p).needed;
  const bool sides = observed.has(Part::sides);
  switch (part) {
    case Part::exposure:
      return decide_readers(heat && (p.air_conductance != 0 || p.contact_conductance != 0), turn,
                            sides || observed.has(part));
    case Part::owners:
      return decide_readers(heat && decide_mean_temperature(p).needed, turn,
                            sides || observed.has(part));
    case Part::turn:
      return decide_turn(p);
    case Part::direction:
      return decide_steering(p, actions);
    case Part::mean_temperature:
      return decide_mean_temperature(p);
    case Part::rotation:
      return decide_rotation(p);
    case Part::quadratic:
      return decide_quadratic(p);
    case Part::pairs:
    case Part::sides:
    case Part::strain:
    case Part::pose:
      return decide_record(observed.has(part));
  }
  return {true, ""};
}

void add_parts(Stage stage, const Params& params, PartSet observed, ActionKinds actions,
               Plan& plan) {
  for (const PartRow& row : kParts) {
    if (row.stage == stage && decide(row.part, params, observed, actions).needed) {
      plan.add(row.part);
    }
  }
}

}  // namespace

Stage stage_of(Part part) {
  return kParts[static_cast<std::size_t>(part)].stage;
}

std::string_view part_name(Part part) {
  return kParts[static_cast<std::size_t>(part)].name;
}

Plan whole_stage(Stage stage, const Params& params, PartSet observed) {
  Plan plan;
  plan.add(stage);
  add_parts(stage, params, observed, {}, plan);
  if (stage == Stage::steering) plan.add(Part::direction);  // the reason to need the stage
  return plan;
}

Plan make_plan(const Params& params, PartSet observed, ActionKinds actions) {
  Plan plan;
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    if (!decide(stage, params, observed, actions).needed) continue;
    plan.add(stage);
    add_parts(stage, params, observed, actions, plan);
  }
  return plan;
}

Plan joined(const Plan& plan, const Plan& more) {
  Plan both;
  for (int i = 0; i < kStageCount; ++i) both.stages[i] = plan.stages[i] || more.stages[i];
  for (const PartRow& row : kParts) {
    if (both.has(row.stage) && (plan.has(row.part) || more.has(row.part))) both.add(row.part);
  }
  if (both.has(Stage::contact) &&
      (both.has(Part::turn) || both.has(Part::sides) || both.has(Part::mean_temperature))) {
    both.add(Part::exposure);
    both.add(Part::owners);
  }
  return both;
}

std::vector<Decision> explain_plan(const Params& params, PartSet observed) {
  std::vector<Decision> decisions;
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    const Verdict verdict = decide(stage, params, observed, {});
    decisions.push_back({stage, {}, verdict.needed, verdict.reason});
    if (!verdict.needed) continue;
    for (const PartRow& row : kParts) {
      if (row.stage != stage) continue;
      const Verdict part = decide(row.part, params, observed, {});
      decisions.push_back({stage, row.part, part.needed, part.reason});
    }
  }
  return decisions;
}

}  // namespace pupflow
