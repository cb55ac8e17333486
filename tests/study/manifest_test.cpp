#include <gmock/gmock.h>

#include "app/study/latin.h"
#include "app/study/table.h"
#include "pupflow/ensemble.h"
#include "tests/app/failing.h"
#include "tests/study/small_design.h"
#include "tests/support/scratch.h"

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

Design read_back(const Design& design, const std::string& table = "") {
  return parse_manifest(manifest_text(design), "here", table);
}

TEST(Manifest, OfALatinHypercubeHoldsItsRanges) {
  Design design = test::small_design({}, 3);
  design.base.seed = 5;
  spread_latin(design, {parse_span("ta=0:1"), parse_span("heading=course,body")}, 20);
  EXPECT_THAT(manifest_text(design),
              HasSubstr("vary = [\"ta=0:1\", \"heading=course,body\"]\nlhs = 20\nseeds = 3\n"));
  const Design back = read_back(design);
  EXPECT_EQ(manifest_text(back), manifest_text(design));
  EXPECT_EQ(back.axes[0].values, design.axes[0].values);
  EXPECT_EQ(back.axes[1].values, design.axes[1].values);
}

TEST(Manifest, OfATableHoldsItsHash) {
  const pupflow::test::Scratch scratch;
  Design design = test::small_design({}, 3);
  parse_table("ta,seed\n0.5,1\n0.5,2\n", "here", design);
  const std::string path = scratch.file("design.csv", table_text(design));
  EXPECT_THAT(manifest_text(design),
              HasSubstr("columns = \"ta,seed\"\ntable = \"" + table_hash(design)));
  const Design back = read_back(design, path);
  EXPECT_EQ(manifest_text(back), manifest_text(design));
  EXPECT_EQ(back.given_seeds, design.given_seeds);
  scratch.file("design.csv", "ta,seed\n0.5,1\n0.5,3\n");
  EXPECT_THAT(failure_of(ExitCode::bad_input, [&] { read_back(design, path); }),
              AllOf(HasSubstr(path), HasSubstr("is not the table")));
  failure_of(ExitCode::bad_file, [&] { read_back(design, scratch.path("none.csv")); });
}

TEST(Manifest, OfAnOlderVersionNumbersItsSeedsInOrder) {
  Design design = test::small_design({"ta=0,1"}, 3);
  EXPECT_EQ(read_back(design).seed_of(3), run_seed(1, 10));
  std::string text = manifest_text(design);
  const std::string block = "seed_block = 10\n";
  text.erase(text.find(block), block.size());
  EXPECT_EQ(parse_manifest(text, "here").seed_of(3), run_seed(1, 3));
  design.seeds = 10;  // the same in both
  EXPECT_THAT(manifest_text(design), ::testing::Not(HasSubstr("seed_block")));
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
  EXPECT_TRUE(differs([](Design& d) { d.seed_block = 7; }));
  EXPECT_TRUE(differs([](Design& d) { d.record_every = 1; }));
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
  EXPECT_THAT(failure_of(ExitCode::bad_input, [&] { parse_manifest(text, "some/manifest.toml"); }),
              testing::HasSubstr("some/manifest.toml"));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongManifest,
    ::testing::Values(
        std::pair{"[sweep]", "[sweep"}, std::pair{"seeds = 7", "seeds = 0"},
        std::pair{"seeds = 7", "seeds = \"7\""}, std::pair{"seeds = 7\n", ""},
        std::pair{"seed_block = 10", "seed_block = 0"},
        std::pair{"seed_block = 10", "seed_block = 9223372036854775807"},
        std::pair{"seed_block = 10", "seed_block = 3"},
        std::pair{"seeds = 7", "seeds = 9223372036854775807"},
        std::pair{"seeds = 7", "seeds = 1e300"}, std::pair{"seeds = 7", "seeds = -7"},
        std::pair{"runs = ", "lhs = 9223372036854775807\nruns = "},
        std::pair{"shard = \"3/8\"", "shard = \"3/9223372036854775808\""},
        std::pair{"shard = \"3/8\"", "shard = \"-3/8\""}, std::pair{"ta=0,", "ta=nan,"},
        std::pair{"ta=0,", "ta=0:1:1000000000,"}, std::pair{"heading=body", "heading=1"},
        std::pair{"heading=body", "heading=\\u0000"}, std::pair{"beta = 0.5", "beta = nan"},
        std::pair{"beta = 0.5", "beta = [0.5]"}, std::pair{"beta = 0.5", "beta.x = 0.5"},
        std::pair{"beta = 0.5", "beta = {x = 0.5}"},
        std::pair{"beta = 0.5", "x = [[[[[[[[{a.b = 1}]]]]]]]]"},
        std::pair{"beta = 0.5", "at = \"step=-1,ta=0\""},
        std::pair{"beta = 0.5", "at = \"step=5,pup=99999999999,heat=1\""},
        std::pair{"name = \"figure2\"", "name = \"\""},
        std::pair{"name = \"figure2\"", "name = \"figure2\\u0000\""},
        std::pair{"name = \"figure2\"", "name = [\"figure2\"]"},
        std::pair{"runs = ", "lhs = 0\nruns = "},
        std::pair{"runs = ", "record_every = -1\nruns = "},
        std::pair{"shard = \"3/8\"", "shard = \"9/8\""}, std::pair{"beta = 0.5", "beta = 5"},
        std::pair{"beta = 0.5", "betta = 0.5"}, std::pair{"beta = 0.5", "beta = true"},
        std::pair{"pups=2,5", "pups=2,5.5"}, std::pair{"pups=2,5", "ta=2,5"},
        std::pair{"heat = \"exact\"", "heat = 1000000"}, std::pair{"heat = \"exact\"", "heat = 1"},
        std::pair{"pups = 3", "pups = 1e300"},
        std::pair{"name = \"figure2\"", "name = \"../figure2\""},
        std::pair{"name = \"figure2\"", "name = \"x'; else system('touch PWNED'); y = '\""}));

TEST(Manifest, TakesNoNumberThatIsNone) {
  const std::string text = manifest_text(odd_design());
  for (const Parameter& parameter : parameters()) {
    const std::size_t at = text.find("\n" + std::string(parameter.name) + " = ") + 1;
    const std::size_t end = text.find('\n', at);
    for (const char* value : {"1000000", "-1", "1e300", "-1e300", "0.5", "9223372036854775807",
                              "nan", "inf", "true", "\"\"", "\"1000000\"", "[]", "1979-05-27"}) {
      std::string changed = text;
      changed.replace(at, end - at, std::string(parameter.name) + " = " + value);
      try {
        const Design design = parse_manifest(changed, "here");
        // What is read can be written, and that reads back to the same.
        const std::string again = manifest_text(design);
        EXPECT_EQ(manifest_text(parse_manifest(again, "here")), again);
      } catch (const io::Failure& failure) {
        EXPECT_EQ(failure.code(), ExitCode::bad_input) << failure.what();
      }
    }
  }
}

TEST(Manifest, MayNotGoDeep) {
  std::string key = "a";
  for (int i = 0; i < 40'000; ++i) key += ".a";
  const std::string text = manifest_text(odd_design());
  for (const std::string& line :
       {key + " = 1", "[" + key + "]", "x = {" + key + " = 1}", "[[" + key + "]]",
        "x = " + std::string(40'000, '['), "x = [" + std::string(40'000, '{')})
    failure_of(ExitCode::bad_input, [&] { parse_manifest(text + line + "\n", "here"); });
}

TEST(Manifest, NamesTheFileInErrors) {
  EXPECT_THAT(failure_of(ExitCode::bad_input, [] { parse_manifest("x", "some/manifest.toml"); }),
              AllOf(HasSubstr("some/manifest.toml"), HasSubstr("no manifest of a sweep")));
}

}  // namespace
}  // namespace pupflow::study
