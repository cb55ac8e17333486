#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/study/design.h"
#include "tests/app/failing.h"
#include "tests/study/small_design.h"

namespace pupflow::study {
namespace {

using io::ExitCode;
using pupflow::test::failure_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

Design odd_design() {
  Design design = test::small_design({"ta=0:1:24", "heading=body,course", "pups=2,5"}, 7);
  design.name = "figure2";
  design.base.seed = (std::int64_t{1} << 53) - 1;
  design.base.thermogenesis = 0.1 + 0.2;
  design.base.precision = Precision::float_;
  design.shard = {3, 8};
  return design;
}

TEST(Manifest, ReadsBackToTheSameDesign) {
  const Design design = odd_design();
  const Design back = parse_manifest(manifest_text(design), "here");
  EXPECT_EQ(back.name, design.name);
  EXPECT_EQ(back.base, design.base);
  EXPECT_EQ(back.seeds, design.seeds);
  EXPECT_EQ(back.shard, design.shard);
  ASSERT_EQ(back.axes.size(), design.axes.size());
  for (std::size_t a = 0; a < design.axes.size(); ++a) {
    EXPECT_EQ(back.axes[a].parameter, design.axes[a].parameter);
    EXPECT_EQ(back.axes[a].values, design.axes[a].values);
  }
  EXPECT_EQ(manifest_text(back), manifest_text(design));
}

TEST(Manifest, TellsAllDesignsApart) {
  const std::string text = manifest_text(odd_design());
  const auto differs = [&](auto change) {
    Design design = odd_design();
    change(design);
    return manifest_text(design) != text;
  };
  EXPECT_TRUE(differs([](Design& d) { d.seeds = 8; }));
  EXPECT_TRUE(differs([](Design& d) { d.shard = {4, 8}; }));
  EXPECT_TRUE(differs([](Design& d) { d.axes.pop_back(); }));
  EXPECT_TRUE(differs([](Design& d) { std::swap(d.axes[0], d.axes[1]); }));
  EXPECT_TRUE(differs([](Design& d) { d.axes[0].values[3] += 1e-15; }));
  for (const Parameter& parameter : parameters()) {
    EXPECT_TRUE(differs([&](Design& d) {
      const double value = parameter.get(d.base);
      const bool last = parameter.kind == Parameter::Kind::choice &&
                        value + 1 == static_cast<double>(parameter.choices.size());
      parameter.set(d.base, last || parameter.name == "seed" ? value - 1 : value + 1);
    })) << parameter.name;
  }
}

class WrongManifest : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(WrongManifest, IsRefusedByName) {
  std::string text = manifest_text(odd_design());
  const std::string before = GetParam().first;
  const std::size_t at = text.find(before);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, before.size(), GetParam().second);
  failure_of(ExitCode::bad_input, [&] { parse_manifest(text, "some/manifest.toml"); });
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongManifest,
    ::testing::Values(std::pair{"[sweep]", "[sweep"}, std::pair{"seeds = 7", "seeds = 0"},
                      std::pair{"seeds = 7", "seeds = \"7\""}, std::pair{"seeds = 7\n", ""},
                      std::pair{"shard = \"3/8\"", "shard = \"9/8\""},
                      std::pair{"beta = 0.5", "beta = 5"}, std::pair{"beta = 0.5", "betta = 0.5"},
                      std::pair{"beta = 0.5", "beta = true"}, std::pair{"pups=2,5", "pups=2,5.5"},
                      std::pair{"pups=2,5", "ta=2,5"}));

TEST(Manifest, NamesTheFileInErrors) {
  EXPECT_THAT(failure_of(ExitCode::bad_input, [] { parse_manifest("x", "some/manifest.toml"); }),
              AllOf(HasSubstr("some/manifest.toml"), HasSubstr("no manifest of a sweep")));
}

}  // namespace
}  // namespace pupflow::study
