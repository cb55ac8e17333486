#include "engine/warning.h"

#include <algorithm>

namespace pupflow {
namespace {

constexpr std::array<std::string_view, kWarningKinds> kNames{
    "under the floor", "hanging in the air", "outside the wall", "gaining energy"};

}  // namespace

std::string_view warning_name(Warning::Kind kind) {
  return kNames[static_cast<std::size_t>(kind)];
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
  if (!has(warning.kind)) list_[static_cast<std::size_t>(count_++)] = warning;
}

std::string warnings_text(std::span<const Warning> warnings) {
  std::string text;
  for (const Warning& warning : warnings) text += (text.empty() ? "" : "; ") + warning.message();
  return text;
}

}  // namespace pupflow
