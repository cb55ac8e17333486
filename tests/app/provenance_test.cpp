#include "app/io/provenance.h"
#include "app/io/params_of_file.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "app/io/csv.h"
#include "failing.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using test::failure_of;
using testing::HasSubstr;

/// A sound set in which every parameter differs from its default; reals need all their digits.
Params unusual_params() {
  Params params;
  for (const Parameter& p : parameters()) {
    const double old = p.get(params);
    double value = old + 1;
    if (p.kind == Parameter::Kind::choice) value = old == 0 ? 1 : 0;
    if (p.kind == Parameter::Kind::real)
      value = std::min(p.max, std::nextafter(old * 1.1 + 0.1, 9));
    p.set(params, value);
    EXPECT_NE(p.get(params), old) << p.name;
  }
  params.seed = 9007199254740991;
  params.dt = std::nextafter(0.0075, 9);  // refinement = consistent is for steps below 0.01
  EXPECT_TRUE(check(params).empty());
  return params;
}

TEST(Provenance, ParametersReadBackFromEntries) {
  const Params params = unusual_params();
  EXPECT_EQ(params_from(provenance(params), "here"), params);
}

TEST(Provenance, ParametersReadBackFromPng) {
  const test::Scratch scratch;
  const Params params = unusual_params();
  write_png(scratch.path("a.png"), Image(8, 8),
            provenance(params, {{"picture", "render"}, {"step", "12"}}), false);
  EXPECT_EQ(params_of_file(scratch.path("a.png")), params);
  EXPECT_EQ(read_png_text(scratch.path("a.png")).back().second, "12");
}

TEST(Provenance, ParametersReadBackFromBothCsvFiles) {
  const test::Scratch scratch;
  const Params params = unusual_params();
  MetricsCsv(scratch.path("m.csv"), false, Simulation(params)).file().commit();
  PupsCsv(scratch.path("p.csv"), false, Simulation(params)).file().commit();
  EXPECT_EQ(params_of_file(scratch.path("m.csv")), params);
  EXPECT_EQ(params_of_file(scratch.path("p.csv")), params);
}

TEST(Provenance, NamesTheVersion) {
  const TextEntries entries = provenance(Params{});
  EXPECT_EQ(entries.front().first, "Software");
  EXPECT_THAT(entries.front().second, testing::MatchesRegex("pupflow [0-9.]+"));
}

TEST(Provenance, AFileWithoutAParameterMeansWhatItsVersionDid) {
  Params params;
  params.contact = ContactRule::mean;
  params.deformation = 0.25;
  TextEntries entries = provenance(params);
  std::erase_if(entries, [](const auto& e) { return e.first == "contact" || e.first == "beta"; });
  testing::internal::CaptureStderr();
  const Params taken = params_from(entries, "old.csv");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "pupflow: note: old.csv was written by an older version; taking beta = 0.5, contact = "
            "sum\n");
  EXPECT_EQ(taken.contact, ContactRule::sum);  // what ran before there was a choice
  EXPECT_EQ(taken.deformation, 0.5);           // the default
}

TEST(Provenance, AParameterOfANewerVersionIsRefusedByName) {
  const std::pair<std::string, std::string> newer("viscosity", "0.5");
  const auto refusal = [](const TextEntries& entries) {
    return failure_of(ExitCode::bad_input, [&] { params_from(entries, "new.png"); });
  };
  TextEntries entries = provenance(Params{}, {{"picture", "render"}, {"step", "12"}});
  const auto first = entries.begin() + 1;
  const auto behind = std::find_if(first, entries.end(),
                                   [](const auto& entry) { return entry.first == "picture"; });
  for (const auto& place : {first, behind}) {
    TextEntries with = entries;
    with.insert(with.begin() + (place - entries.begin()), newer);
    EXPECT_EQ(refusal(with), "new.png: this version has no parameter 'viscosity'");
  }
  entries.push_back(newer);  // behind "picture" it tells of the picture
  EXPECT_EQ(params_from(entries, "new.png"), Params{});
}

TEST(Provenance, NothingElseIsWrittenWhereParametersStand) {
  EXPECT_THROW(provenance(Params{}, {{"step", "12"}}), std::logic_error);
}

TEST(Provenance, RefusesWhatIsNotOursOrWrong) {
  TextEntries entries = provenance(Params{});
  std::erase_if(entries, [](const auto& e) { return e.first == "Software"; });
  EXPECT_THAT(failure_of(ExitCode::bad_input, [&] { params_from(entries, "other.csv"); }),
              HasSubstr("other.csv: does not say that pupflow wrote it"));
  entries = provenance(Params{});
  std::erase_if(entries, [](const auto& e) { return e.first == "beta"; });
  entries.emplace_back("beta", "much");
  EXPECT_THAT(failure_of(ExitCode::bad_input, [&] { params_from(entries, "old.csv"); }),
              HasSubstr("old.csv: beta = 'much'"));
}

TEST(Provenance, RefusesAFileOfAnotherKind) {
  const test::Scratch scratch;
  const std::string path = scratch.file("a.csv", "a,b\n1,2\n");
  EXPECT_THAT(failure_of(ExitCode::bad_input, [&] { params_of_file(path); }), HasSubstr(path));
}

}  // namespace
}  // namespace pupflow::io
