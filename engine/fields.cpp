// The tables of pup and afferent fields, and their formulas.
#include "pupflow/fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "engine/rotation.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

using Values = std::span<double>;

/// A field that is one of the view's spans.
template <auto Member>
void copy(const LitterView& litter, Values values) {
  const auto& from = litter.*Member;
  std::copy(from.begin(), from.end(), values.begin());
}

void fill_huddling(const LitterView& litter, Values values) {
  for (std::size_t pup = 0; pup < values.size(); ++pup) values[pup] = 1 - litter.exposed[pup];
}

void fill_group(const LitterView& litter, Values values) {
  const std::vector<int> labels = group_labels(litter.pups, litter.touching);
  std::copy(labels.begin(), labels.end(), values.begin());
}

void fill_group_size(const LitterView& litter, Values values) {
  const std::vector<int> labels = group_labels(litter.pups, litter.touching);
  const std::vector<int> sizes = group_sizes(labels);
  for (std::size_t pup = 0; pup < values.size(); ++pup) values[pup] = sizes[labels[pup]];
}

void fill_neighbours(const LitterView& litter, Values values) {
  std::fill(values.begin(), values.end(), 0);
  for (const TouchingPair& pair : litter.touching) {
    ++values[pair.first];
    ++values[pair.second];
  }
}

void fill_height(const LitterView& litter, Values values) {
  for (int pup = 0; pup < litter.pups; ++pup) values[pup] = litter.positions.mean(pup).z();
}

void fill_speed(const LitterView& litter, Values values) {
  for (int pup = 0; pup < litter.pups; ++pup) values[pup] = litter.velocities.mean(pup).norm();
}

void fill_deformation(const LitterView& litter, Values values) {
  const double radius = litter.params.pup_radius;
  const std::vector<Eigen::Vector3d> rest = cube_sphere(litter.params.face_points, radius);
  for (int pup = 0; pup < litter.pups; ++pup) {
    const Eigen::Vector3d centre = litter.positions.mean(pup);
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (int i = 0; i < litter.points; ++i) {
      moment += (litter.positions(pup, i) - centre) * rest[i].transpose();
    }
    const Eigen::Matrix3d rotation = nearest_rotation(moment).matrix;
    double squares = 0;
    for (int i = 0; i < litter.points; ++i) {
      squares += (litter.positions(pup, i) - centre - rotation * rest[i]).squaredNorm();
    }
    values[pup] = std::sqrt(squares / litter.points) / radius;
  }
}

void fill_temperature(const LitterView& litter, Values values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int pup = litter.touched[i];
    values[i] = pup < 0 ? litter.params.ambient_temperature : litter.felt_tb[pup];
  }
}

void fill_strain(const LitterView& litter, Values values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<double>(litter.strain[i]) / litter.params.pup_radius;
  }
}

template <int Axis>
void fill_normal(const LitterView& litter, Values values) {
  const std::vector<Eigen::Vector3d> rest = cube_sphere(litter.params.face_points, 1);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = rest[i % rest.size()][Axis];
}

using Formula = void (*)(const LitterView&, Values);
constexpr bool kInFiles = true;

constexpr LitterField of_pup(const Field& field, Formula formula, bool in_files = false) {
  return {field, false, in_files, formula};
}

constexpr LitterField of_afferent(const Field& field, Formula formula) {
  return {field, true, false, formula};
}

constexpr double kPi = std::numbers::pi;
constexpr std::array<std::string_view, 2> kSides{"right", "left"};

// Files list the fields in this order.
constexpr std::array kPupFields{
    of_pup({.name = "tb",
            .symbol = "T_b",
            .label = "body temperature",
            .doc = "Body temperature after the step; 0.6 is 37 deg C.",
            .low = 0,
            .high = 1},
           copy<&LitterView::tb>, kInFiles),
    of_pup({.name = "felt_tb",
            .symbol = "T_b'",
            .label = "felt body temperature",
            .equation = "T_b before the heat stage of the step",
            .doc = "What others felt of the pup in the step.",
            .low = 0,
            .high = 1},
           copy<&LitterView::felt_tb>),
    of_pup({.name = "exposed",
            .symbol = "A",
            .label = "exposed share",
            .equation = "points without contact / n",
            .doc = "Share of the pup's points that touch no other pup.",
            .low = 0,
            .high = 1,
            .parts = {Part::exposure}},
           copy<&LitterView::exposed>, kInFiles),
    of_pup({.name = "huddling",
            .symbol = "1 − A",
            .label = "touching share",
            .equation = "1 − A",
            .doc = "Share of the pup's points that touch another pup.",
            .low = 0,
            .high = 1,
            .parts = {Part::exposure}},
           fill_huddling),
    of_pup({.name = "heading",
            .symbol = "θ",
            .label = "direction of travel",
            .unit = "rad",
            .doc = "Direction in which the pup drives, counter-clockwise from the x axis.",
            .kind = FieldKind::angle,
            .low = -kPi,
            .high = kPi},
           copy<&LitterView::heading>, kInFiles),
    of_pup({.name = "turn",
            .symbol = "Δθ",
            .label = "turn",
            .unit = "rad/s",
            .equation = "Δθ = atan(v (S_L − S_R) / (S_L + S_R))",
            .doc = "How fast the pup turns to the left; with heading = body the angle, in rad, "
                   "from body axis to direction of travel.",
            .kind = FieldKind::signed_,
            .low = -kPi / 2,
            .high = kPi / 2,
            .parts = {Part::sides}},
           copy<&LitterView::turn>),
    of_pup({.name = "t_left",
            .symbol = "T_L",
            .label = "temperature felt on the left",
            .equation = "mean of T_c over the points on the left",
            .doc = "Mean temperature of the afferents on the left of the heading.",
            .low = 0,
            .high = 1,
            .parts = {Part::sides}},
           copy<&LitterView::t_left>),
    of_pup({.name = "t_right",
            .symbol = "T_R",
            .label = "temperature felt on the right",
            .equation = "mean of T_c over the points on the right",
            .doc = "Mean temperature of the afferents on the right of the heading.",
            .low = 0,
            .high = 1,
            .parts = {Part::sides}},
           copy<&LitterView::t_right>),
    of_pup({.name = "group",
            .label = "group",
            .equation = "component of the contact graph, numbered by its lowest pup",
            .doc = "Number of the pup's group.",
            .kind = FieldKind::categorical,
            .low = 0,
            .digits = 0,
            .parts = {Part::pairs}},
           fill_group),
    of_pup({.name = "group_size",
            .label = "pups in the group",
            .unit = "pups",
            .doc = "Pups in the pup's group, itself included.",
            .low = 1,
            .digits = 0,
            .parts = {Part::pairs}},
           fill_group_size),
    of_pup({.name = "neighbours",
            .label = "pups touched",
            .unit = "pups",
            .doc = "Other pups that the pup touches.",
            .low = 0,
            .digits = 0,
            .parts = {Part::pairs}},
           fill_neighbours),
    of_pup({.name = "height",
            .symbol = "z",
            .label = "height",
            .unit = "length",
            .equation = "mean over points of z",
            .doc = "Height of the pup's centre above the floor.",
            .low = 0},
           fill_height),
    of_pup({.name = "speed",
            .symbol = "|v|",
            .label = "speed",
            .unit = "length/s",
            .equation = "|mean over points of v|",
            .doc = "Speed of the pup's centre.",
            .low = 0,
            .velocities = true},
           fill_speed),
    of_pup({.name = "deformation",
            .label = "deformation",
            .equation = "sqrt(mean over points of |x − x_cm − R q|²) / r_pup",
            .doc = "Root mean square distance of the points from the undeformed pup q at its best "
                   "rotation R, in pup radii.",
            .low = 0},
           fill_deformation),
};

constexpr std::array kAfferentFields{
    of_afferent({.name = "temperature",
                 .symbol = "T_c",
                 .label = "afferent temperature",
                 .equation = "T_b' of the touched pup, or T_a",
                 .doc = "What the afferent feels: felt_tb of the pup that it touches, T_a where it "
                        "touches nobody.",
                 .low = 0,
                 .high = 1,
                 .parts = {Part::owners, Part::pairs}},
                fill_temperature),
    of_afferent({.name = "touched",
                 .label = "touched pup",
                 .doc = "The pup whose point is the nearest touching one; -1 where there is none.",
                 .kind = FieldKind::categorical,
                 .low = -1,
                 .digits = 0,
                 .parts = {Part::owners, Part::pairs}},
                copy<&LitterView::touched>),
    of_afferent(
        {.name = "side",
         .label = "side",
         .equation = "1 where cos θ (y − y_cm) − sin θ (x − x_cm) > 0, else 0",
         .doc = "Side of the heading that the afferent was on in the step: 1 left, 0 right.",
         .kind = FieldKind::categorical,
         .low = 0,
         .high = 1,
         .categories = kSides,
         .digits = 0,
         .parts = {Part::sides}},
        copy<&LitterView::left>),
    of_afferent(
        {.name = "strain",
         .label = "strain",
         .equation = "|g − x*| / r_pup",
         .doc = "Distance of the point from its goal before it is pulled there, in pup radii.",
         .low = 0,
         .parts = {Part::strain}},
        fill_strain),
    of_afferent({.name = "normal_x",
                 .symbol = "q_x",
                 .label = "normal at rest, x",
                 .doc = "Outward direction of the point on the pup at rest, x in body axes.",
                 .kind = FieldKind::signed_,
                 .low = -1,
                 .high = 1},
                fill_normal<0>),
    of_afferent({.name = "normal_y",
                 .symbol = "q_y",
                 .label = "normal at rest, y",
                 .doc = "Outward direction of the point on the pup at rest, y in body axes.",
                 .kind = FieldKind::signed_,
                 .low = -1,
                 .high = 1},
                fill_normal<1>),
    of_afferent({.name = "normal_z",
                 .symbol = "q_z",
                 .label = "normal at rest, z",
                 .doc = "Outward direction of the point on the pup at rest, z in body axes.",
                 .kind = FieldKind::signed_,
                 .low = -1,
                 .high = 1},
                fill_normal<2>),
};

}  // namespace

std::string_view kind_name(FieldKind kind) {
  switch (kind) {
    case FieldKind::continuous:
      return "continuous";
    case FieldKind::signed_:
      return "signed";
    case FieldKind::categorical:
      return "categorical";
    case FieldKind::angle:
      return "angle";
  }
  return "unknown";
}

bool is_known(const Field& field, const LitterView& litter) {
  return litter.recorded.includes(field.parts) &&
         !(field.velocities && litter.velocities.empty() && litter.pups > 0);
}

void LitterField::fill(const LitterView& litter, std::span<double> values) const {
  const std::size_t wanted =
      static_cast<std::size_t>(litter.pups) * (of_afferents ? litter.points : 1);
  if (values.size() != wanted) {
    throw std::invalid_argument("the span for " + std::string(name) + " holds " +
                                std::to_string(values.size()) + " numbers, not " +
                                std::to_string(wanted));
  }
  if (is_known(*this, litter)) {
    formula(litter, values);
  } else {
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
  }
}

std::vector<double> LitterField::values(const LitterView& litter) const {
  std::vector<double> values(static_cast<std::size_t>(litter.pups) *
                             (of_afferents ? litter.points : 1));
  fill(litter, values);
  return values;
}

std::span<const LitterField> pup_fields() {
  return kPupFields;
}

std::span<const LitterField> afferent_fields() {
  return kAfferentFields;
}

const LitterField* find_field(std::string_view name) {
  for (const std::span<const LitterField> table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      if (field.name == name) return &field;
    }
  }
  return nullptr;
}

PartSet parts_in_files() {
  PartSet parts;
  for (const std::span<const LitterField> table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      if (field.in_files) parts = parts | field.parts;
    }
  }
  return parts;
}

}  // namespace pupflow
