#include "engine/plan.h"

namespace pupflow {
namespace {

/// One decision: the first reason that leaves a stage out, or why it is in.
struct Decision {
  bool needed;
  const char* reason;
};

bool has_heat(const Params& p) {
  return p.k1 != 0 || p.k2 != 0 || p.g != 0;
}

Decision decide_boundary(const Params& p) {
  if (p.pups == 0) return {false, "there is no pup"};
  return {true, "every pup meets the floor or the wall"};
}

Decision decide_contact(const Params& p) {
  if (p.pups < 2) return {false, "fewer than two pups: nobody to touch"};
  return {true, "pups can touch each other"};
}

Decision decide_steering(const Params& p) {
  if (p.pups == 0) return {false, "there is no pup"};
  if (p.drive == 0) return {false, "drive = 0: the direction of travel moves nothing"};
  if (p.heading == Heading::body) return {true, "the direction of travel follows the body axis"};
  if (p.pups < 2)
    return {false, "one pup touches nobody, so both its sides feel T_a and it keeps its course"};
  if (p.sigma == 0) return {false, "sigma = 0: both sensors read the same, so nobody turns"};
  if (p.v == 0) return {false, "v = 0: nobody turns"};
  return {true, "contacts turn the pups"};
}

Decision decide_heat(const Params& p) {
  if (p.pups == 0) return {false, "there is no pup"};
  if (!has_heat(p)) return {false, "k1 = k2 = g = 0: body temperatures never change"};
  return {true, "body temperatures change"};
}

Decision decide_predict(const Params& p) {
  if (p.pups == 0) return {false, "there is no pup"};
  return {true, "points move by their velocity, gravity and drive"};
}

Decision decide_shape_match(const Params& p) {
  if (p.pups == 0) return {false, "there is no pup"};
  if (p.alpha == 0) return {false, "alpha = 0: points are not drawn to any goal"};
  if (p.beta == 0) return {true, "rotation only: beta = 0 needs no quadratic terms"};
  return {true, "rotation and quadratic terms"};
}

Decision decide(Stage stage, const Params& params) {
  switch (stage) {
    case Stage::boundary:
      return decide_boundary(params);
    case Stage::contact:
      return decide_contact(params);
    case Stage::steering:
      return decide_steering(params);
    case Stage::heat:
      return decide_heat(params);
    case Stage::predict:
      return decide_predict(params);
    case Stage::shape_match:
      return decide_shape_match(params);
  }
  return {true, ""};
}

}  // namespace

Plan make_plan(const Params& params, bool observed) {
  Plan plan;
  for (int i = 0; i < kStageCount; ++i)
    plan.needed[i] = decide(static_cast<Stage>(i), params).needed;
  plan.quadratic = plan.has(Stage::shape_match) && params.beta > 0;
  const bool heat_feels = plan.has(Stage::heat) && (params.k1 != 0 || params.k2 != 0);
  plan.afferents =
      plan.has(Stage::contact) && (observed || heat_feels || plan.has(Stage::steering));
  return plan;
}

Plan joined(const Plan& plan, const Plan& more) {
  Plan both;
  for (int i = 0; i < kStageCount; ++i) both.needed[i] = plan.needed[i] || more.needed[i];
  both.quadratic = both.has(Stage::shape_match) && (plan.quadratic || more.quadratic);
  both.afferents =
      both.has(Stage::contact) && (plan.afferents || more.afferents || both.has(Stage::steering));
  return both;
}

std::vector<PlannedStage> explain_plan(const Params& params, bool observed) {
  std::vector<PlannedStage> stages;
  const Plan plan = make_plan(params, observed);
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    const Decision decision = decide(stage, params);
    std::string reason = decision.reason;
    if (stage == Stage::contact && decision.needed && !plan.afferents) {
      reason += "; who touches whom is not recorded: no heat, steering or observer asks for it";
    }
    stages.push_back({stage, decision.needed, reason});
  }
  return stages;
}

}  // namespace pupflow
