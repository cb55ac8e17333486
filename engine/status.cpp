#include "engine/status.h"

namespace pupflow {

std::string_view stage_name(Stage stage) {
  switch (stage) {
    case Stage::boundary:
      return "boundary";
    case Stage::contact:
      return "contact";
    case Stage::steering:
      return "steering";
    case Stage::heat:
      return "heat";
    case Stage::predict:
      return "predict";
    case Stage::shape_match:
      return "shape_match";
  }
  return "unknown";
}

std::string_view kind_name(Status::Kind kind) {
  switch (kind) {
    case Status::Kind::fine:
      return "fine";
    case Status::Kind::non_finite:
      return "non-finite number";
    case Status::Kind::diverged:
      return "diverged";
    case Status::Kind::escaped:
      return "escaped from the arena";
  }
  return "unknown";
}

std::string Status::message() const {
  std::string text(kind_name(kind));
  if (ok()) return text;
  text += " at step " + std::to_string(step) + ", stage " + std::string(stage_name(stage)) +
          ", pup " + std::to_string(pup);
  if (point >= 0) text += ", point " + std::to_string(point);
  return text;
}

}  // namespace pupflow
