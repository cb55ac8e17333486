// The table of pup fields, and their formulas.
#include <array>
#include <cmath>
#include <numbers>

#include "engine/field_rows.h"
#include "engine/rotation.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

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
  for (int pup = 0; pup < litter.pups; ++pup) {
    const Eigen::Vector3d velocity = litter.velocities.mean(pup);
    const double speed = velocity.norm();  // squares may overflow
    values[pup] = std::isfinite(speed) ? speed : velocity.stableNorm();
  }
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

template <std::size_t Axis>
void fill_centre(const LitterView& litter, Values values) {
  for (std::size_t pup = 0; pup < values.size(); ++pup) {
    values[pup] = litter.pose[pup].centre[Axis];
  }
}

template <std::size_t Number>
void fill_quaternion(const LitterView& litter, Values values) {
  for (std::size_t pup = 0; pup < values.size(); ++pup) {
    values[pup] = litter.pose[pup].quaternion[Number];
  }
}

/// The files that a field goes into.
enum class Files { none, recordings, all };

constexpr LitterField of_pup(const Field& field, void (*formula)(const LitterView&, Values),
                             Files files = Files::none) {
  return {field, false, files == Files::all, files != Files::none, formula};
}

template <std::size_t Axis>
constexpr LitterField of_centre(std::string_view name) {
  return of_pup({.name = name,
                 .symbol = name,
                 .label = "centre",
                 .unit = "length",
                 .equation = "mean over points of the coordinate",
                 .doc = "Coordinate of the pup's centre; z is its height above the floor.",
                 .parts = {Part::pose}},
                fill_centre<Axis>, Files::recordings);
}

template <std::size_t Number>
constexpr LitterField of_quaternion(std::string_view name, std::string_view label) {
  return of_pup({.name = name,
                 .symbol = name,
                 .label = label,
                 .equation = "R nearest to the sum over points of (x − x_cm) qᵀ",
                 .doc = "Part of the unit quaternion that turns the pup at rest to where it is; "
                        "qw is not negative.",
                 .kind = FieldKind::signed_,
                 .low = -1,
                 .high = 1,
                 .parts = {Part::pose}},
                fill_quaternion<Number>, Files::recordings);
}

constexpr double kPi = std::numbers::pi;

// Files list the fields in this order.
constexpr std::array kPupFields{
    of_pup({.name = "tb",
            .symbol = "T_b",
            .label = "body temperature",
            .equation = "dT_b/dt = G − k_1 A (T_b − T_a) − k_2 (1 − A) (T_b − mean of touched T_c)",
            .doc = "Body temperature after the step; 0.6 is 37 deg C.",
            .low = 0,
            .high = 1},
           copy_of<&LitterView::tb>, Files::all),
    of_pup({.name = "felt_tb",
            .symbol = "T_b'",
            .label = "felt body temperature",
            .equation = "T_b before the heat stage of the step",
            .doc = "What others felt of the pup in the step.",
            .low = 0,
            .high = 1},
           copy_of<&LitterView::felt_tb>, Files::recordings),
    of_pup({.name = "exposed",
            .symbol = "A",
            .label = "exposed share",
            .equation = "points without contact / n",
            .doc = "Share of the pup's points that touch no other pup.",
            .low = 0,
            .high = 1,
            .parts = {Part::exposure}},
           copy_of<&LitterView::exposed>, Files::all),
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
           copy_of<&LitterView::heading>, Files::all),
    of_pup({.name = "turn",
            .symbol = "Δθ",
            .label = "turn",
            .unit = "rad/s",
            .equation = "atan(v (S_L − S_R) / (S_L + S_R)), S = 1 / (1 + exp(−σ T (T_p − T_b')))",
            .doc = "How fast the pup turns to the left; with heading = body the angle, in rad, "
                   "from body axis to direction of travel.",
            .kind = FieldKind::signed_,
            .low = -kPi / 2,
            .high = kPi / 2,
            .parts = {Part::sides}},
           copy_of<&LitterView::turn>, Files::recordings),
    of_pup({.name = "t_left",
            .symbol = "T_L",
            .label = "temperature felt on the left",
            .equation = "mean of T_c over the points on the left",
            .doc = "Mean temperature of the afferents on the left; T_a where there is none.",
            .low = 0,
            .high = 1,
            .parts = {Part::sides}},
           copy_of<&LitterView::t_left>, Files::recordings),
    of_pup({.name = "t_right",
            .symbol = "T_R",
            .label = "temperature felt on the right",
            .equation = "mean of T_c over the points on the right",
            .doc = "Mean temperature of the afferents on the right; T_a where there is none.",
            .low = 0,
            .high = 1,
            .parts = {Part::sides}},
           copy_of<&LitterView::t_right>, Files::recordings),
    of_pup({.name = "group",
            .label = "group",
            .equation = "component of the contact graph, numbered by its lowest pup",
            .doc = "Number of the pup's group.",
            .kind = FieldKind::categorical,
            .low = 0,
            .digits = 0,
            .parts = {Part::pairs}},
           fill_group, Files::recordings),
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
    of_centre<0>("x"),
    of_centre<1>("y"),
    of_centre<2>("z"),
    of_quaternion<0>("qx", "orientation, x"),
    of_quaternion<1>("qy", "orientation, y"),
    of_quaternion<2>("qz", "orientation, z"),
    of_quaternion<3>("qw", "orientation, w"),
};

}  // namespace

std::span<const LitterField> pup_fields() {
  return kPupFields;
}

}  // namespace pupflow
