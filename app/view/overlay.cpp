#include "app/view/overlay.h"

#include <algorithm>
#include <array>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"

namespace pupflow::view {

namespace {

constexpr std::array kOverlays{
    Overlay{"groups", "outline and size of each group", {Part::pairs}, draw_groups},
    Overlay{"trails", "where the pups were", {}, draw_trails},
    Overlay{"contacts",
            "lines between touching pups, as wide as they touch",
            {Part::owners, Part::pairs},
            draw_contacts},
    Overlay{"forces", "drive, and the push of contacts", {Part::owners, Part::pairs}, draw_forces},
    Overlay{"headings", "directions of travel", {}, draw_headings},
    Overlay{"ids", "numbers of the pups", {}, draw_ids}};

}  // namespace

std::span<const Overlay> overlays() {
  return kOverlays;
}

OverlaySet OverlaySet::parse(std::string_view names) {
  OverlaySet set;
  if (names.empty()) return set;
  for (const std::string_view name : io::split(names, ',')) {
    const auto found = std::ranges::find(kOverlays, name, &Overlay::name);
    if (found == kOverlays.end()) {
      std::array<std::string_view, kOverlays.size()> known{};
      std::ranges::transform(kOverlays, known.begin(), &Overlay::name);
      std::string hint = io::did_you_mean(name, known);
      if (hint.empty()) {
        hint =
            "; there are " + io::joined(known, ", ", [](auto each) { return std::string(each); });
      }
      io::refuse("unknown overlay " + io::quoted(name) + hint);
    }
    set.bits_ |= std::uint32_t{1} << (found - kOverlays.begin());
  }
  return set;
}

std::string OverlaySet::names() const {
  std::string names;
  for (const Overlay& overlay : kOverlays) {
    if (has(overlay.name)) names += (names.empty() ? "" : ",") + std::string(overlay.name);
  }
  return names;
}

bool OverlaySet::has(std::string_view name) const {
  const auto found = std::ranges::find(kOverlays, name, &Overlay::name);
  return found != kOverlays.end() && (bits_ >> (found - kOverlays.begin()) & 1) != 0;
}

void OverlaySet::set(std::string_view name, bool on) {
  const auto bit = std::uint32_t{1}
                   << (std::ranges::find(kOverlays, name, &Overlay::name) - kOverlays.begin());
  bits_ = on ? bits_ | bit : bits_ & ~bit;
}

PartSet OverlaySet::parts() const {
  PartSet parts;
  for (const Overlay& overlay : kOverlays) {
    if (has(overlay.name)) parts = parts | overlay.parts;
  }
  return parts;
}

void OverlaySet::draw(const OverlayScene& scene, Marks& marks) const {
  for (const Overlay& overlay : kOverlays) {
    if (has(overlay.name) && scene.litter.pups > 0) overlay.draw(scene, marks);
  }
}

void Trails::add(const LitterView& litter) {
  const auto pups = static_cast<std::size_t>(litter.pups);
  if (!moments_.empty() &&
      (moments_.back().centres.size() != pups || moments_.back().time > litter.time)) {
    moments_.clear();
  }
  if (!moments_.empty() && moments_.back().time == litter.time) return;
  Moment moment{litter.time, {}};
  for (int pup = 0; pup < litter.pups; ++pup) {
    moment.centres.push_back(litter.positions.mean(pup).cast<float>());
  }
  moments_.push_back(std::move(moment));
  while (moments_.front().time < litter.time - seconds_ - 1e-9) moments_.pop_front();
}

std::vector<Eigen::Vector3d> Trails::of(std::size_t pup) const {
  std::vector<Eigen::Vector3d> places;
  for (const Moment& moment : moments_) places.push_back(moment.centres[pup].cast<double>());
  return places;
}

}  // namespace pupflow::view
