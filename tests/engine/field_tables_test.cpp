// What holds for all rows of the tables: names, values that are not known, sizes, copies.
#include <gmock/gmock.h>

#include <set>

#include "pupflow/fields.h"
#include "pupflow/observer.h"
#include "pupflow/simulation.h"

namespace pupflow {
namespace {

using ::testing::Each;
using ::testing::IsNan;
using ::testing::Not;

std::vector<const LitterField*> all_fields() {
  std::vector<const LitterField*> fields;
  for (const LitterField& field : pup_fields()) fields.push_back(&field);
  for (const LitterField& field : afferent_fields()) fields.push_back(&field);
  return fields;
}

Simulation litter(int pups, Precision precision = Precision::double_) {
  Params p;
  p.pups = pups;
  p.face_points = 3;
  p.precision = precision;
  return Simulation(p);
}

TEST(FieldTables, NamesAreUniqueAndRowsAreComplete) {
  std::set<std::string_view> names;
  const auto look_at = [&](const Field& field) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_FALSE(field.label.empty()) << field.name;
    EXPECT_TRUE(field.doc.ends_with('.')) << field.name;
    EXPECT_FALSE(field.low >= field.high) << field.name;  // either may be NaN
    EXPECT_TRUE(field.categories.empty() || field.kind == FieldKind::categorical) << field.name;
  };
  for (const LitterField* field : all_fields()) {
    look_at(*field);
    EXPECT_EQ(find_field(field->name), field);
  }
  EXPECT_EQ(find_field("nothing"), nullptr);
  names.clear();  // huddling is of a pup and of a litter
  for (const Field& field : run_statistics()) look_at(field);
}

TEST(FieldTables, KindsHaveNames) {
  EXPECT_EQ(kind_name(FieldKind::continuous), "continuous");
  EXPECT_EQ(kind_name(FieldKind::signed_), "signed");
  EXPECT_EQ(kind_name(FieldKind::categorical), "categorical");
  EXPECT_EQ(kind_name(FieldKind::angle), "angle");
}

TEST(FieldsOfNobody, AreEmpty) {
  const Simulation s = litter(0);
  for (const LitterField* field : all_fields()) EXPECT_TRUE(field->values(s).empty());
}

TEST(UnknownFields, AreNaN) {
  Params p;
  p.pups = 3;
  p.face_points = 3;
  p.drive = p.air_conductance = p.contact_conductance = 0;  // nothing reads contacts
  Simulation s(p);
  s.set_observed({});
  ASSERT_TRUE(s.run(2).ok());
  for (const LitterField* field : all_fields()) {
    EXPECT_EQ(is_known(*field, s), field->parts.empty()) << field->name;
    if (field->parts.empty()) {
      EXPECT_THAT(field->values(s), Each(Not(IsNan()))) << field->name;
    } else {
      EXPECT_THAT(field->values(s), Each(IsNan())) << field->name;
    }
  }
}

TEST(UnknownFields, ComeAndGoWithTheObserver) {
  Simulation s = litter(3);
  for (const LitterField* field : all_fields()) {
    s.set_observed(field->parts);
    s.step();
    EXPECT_TRUE(is_known(*field, s)) << field->name;
    s.set_observed({});
    s.step();
    EXPECT_EQ(is_known(*field, s), s.plan().parts.includes(field->parts)) << field->name;
  }
}

TEST(UnknownFields, ASpeedNeedsVelocities) {
  const Simulation s = litter(2);
  LitterCopy copy;
  copy.take(s, false);
  EXPECT_THAT(find_field("speed")->values(copy.view()), Each(IsNan()));
  copy.take(s, true);
  EXPECT_THAT(find_field("speed")->values(copy.view()), Each(0));
}

TEST(LitterCopies, ShowWhatTheLitterDoes) {
  Simulation s = litter(4, Precision::float_);  // a copy keeps points as float
  s.set_observed(PartSet::all());
  s.run(300);
  LitterCopy copy;
  copy.take(s, true);
  for (const LitterField* field : all_fields()) {
    EXPECT_EQ(field->values(copy.view()), field->values(s)) << field->name;
  }
}

TEST(FieldFill, RefusesAWrongSize) {
  const Simulation s = litter(2);
  for (const LitterField* field : all_fields()) {
    const std::size_t size = field->of_afferents ? 2 * 54 : 2;
    std::vector<double> fits(size), less(size - 1), more(size + 1);
    EXPECT_NO_THROW(field->fill(s, fits));
    EXPECT_THROW(field->fill(s, less), std::invalid_argument) << field->name;
    EXPECT_THROW(field->fill(s, more), std::invalid_argument) << field->name;
  }
}

}  // namespace
}  // namespace pupflow
