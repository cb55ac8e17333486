// The table of afferent fields, and their formulas.
#include <array>

#include "engine/field_rows.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

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

constexpr bool kInRecordings = true;

constexpr LitterField of_afferent(const Field& field, void (*formula)(const LitterView&, Values),
                                  bool in_recordings = false) {
  return {field, true, false, in_recordings, formula};
}

constexpr std::array<std::string_view, 2> kSides{"right", "left"};

constexpr std::array kAfferentFields{
    of_afferent({.name = "temperature",
                 .symbol = "T_c",
                 .label = "afferent temperature",
                 .equation = "T_b' of the touched pup, or T_a",
                 .doc = "What the afferent feels: felt_tb of the pup that it touches, T_a where it "
                        "touches no pup.",
                 .low = 0,
                 .high = 1,
                 .parts = {Part::owners, Part::pairs}},
                fill_temperature, kInRecordings),
    of_afferent({.name = "touched",
                 .label = "touched pup",
                 .doc = "The pup whose point is the nearest touching one; -1 where there is none.",
                 .kind = FieldKind::categorical,
                 .low = -1,
                 .digits = 0,
                 .parts = {Part::owners, Part::pairs}},
                copy_of<&LitterView::touched>, kInRecordings),
    of_afferent(
        {.name = "side",
         .label = "side",
         .equation = "1 where cos φ (y − y_cm) − sin φ (x − x_cm) > 0, else 0",
         .doc =
             "Side that the afferent was on when the pup steered: 1 left, 0 right. φ is θ before "
             "the turn; with heading = body it is the body axis, and the tail is on the right.",
         .kind = FieldKind::categorical,
         .low = 0,
         .high = 1,
         .categories = kSides,
         .digits = 0,
         .parts = {Part::sides}},
        copy_of<&LitterView::left>, kInRecordings),
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

std::span<const LitterField> afferent_fields() {
  return kAfferentFields;
}

}  // namespace pupflow
