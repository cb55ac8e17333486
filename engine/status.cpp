#include "pupflow/status.h"

#include <algorithm>
#include <cassert>

namespace pupflow {
namespace {

constexpr std::array<std::string_view, kWarningKinds> kWarningNames{
    "under the floor", "hanging in the air", "outside the wall", "gaining energy"};

}  // namespace

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

std::string_view warning_name(Warning::Kind kind) {
  return kWarningNames[static_cast<std::size_t>(kind)];
}

std::string Warning::message() const {
  return std::string(warning_name(kind)) + " from step " + std::to_string(step) + " pup " +
         std::to_string(pup);
}

bool Warnings::has(Warning::Kind kind) const {
  const auto seen = all();
  return std::any_of(seen.begin(), seen.end(),
                     [kind](const Warning& warning) { return warning.kind == kind; });
}

void Warnings::add(const Warning& warning) {
  assert(static_cast<int>(warning.kind) >= 0 && static_cast<int>(warning.kind) < kWarningKinds);
  if (!has(warning.kind)) list_[static_cast<std::size_t>(count_++)] = warning;
}

std::string warnings_text(std::span<const Warning> warnings) {
  std::string text;
  for (const Warning& warning : warnings) text += (text.empty() ? "" : "; ") + warning.message();
  return text;
}

}  // namespace pupflow
