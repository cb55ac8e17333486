#include "tests/arrows/include_scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace pupflow::arrows {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string listed(const std::vector<Violation>& violations) {
  std::ostringstream out;
  for (const Violation& v : violations) {
    out << v.file << ":" << v.line << ": " << v.header << ": " << v.reason << "\n";
  }
  return out.str();
}

TEST(Arrows, NoIncludeOfTheSourceTreeRunsBack) {
  const Sources sources = read_sources(PUPFLOW_SOURCE_DIR, {"engine", "app", "python", "bench"});
  EXPECT_THAT(sources, SizeIs(::testing::Gt(50u))) << "the scan did not see the source tree";
  std::vector<Violation> violations;
  for (const auto& [file, text] : sources) {
    const std::vector<Violation> in_file = scan_text(file, text);
    violations.insert(violations.end(), in_file.begin(), in_file.end());
  }
  EXPECT_EQ(listed(violations), "");
}

TEST(Cycles, NoUnitOfTheSourceTreeIncludesItselfThroughOthers) {
  const Graph graph =
      include_graph(read_sources(PUPFLOW_SOURCE_DIR, {"engine", "app"}), Node::unit);
  EXPECT_THAT(graph, SizeIs(::testing::Gt(50u)));
  EXPECT_THAT(find_cycle(graph), IsEmpty());
}

TEST(Cycles, NoFolderOfTheProgramIncludesItselfThroughOthers) {
  const Graph graph = include_graph(read_sources(PUPFLOW_SOURCE_DIR, {"app"}), Node::folder);
  EXPECT_THAT(graph, SizeIs(::testing::Ge(10u)));
  EXPECT_THAT(find_cycle(graph), IsEmpty());
}

TEST(Cycles, AreFoundThroughSourceFilesAndPublicHeaders) {
  const Sources sources{
      {"engine/include/pupflow/fields.h", ""},
      {"engine/fields.cpp", "#include \"pupflow/fields.h\"\n#include \"engine/rotation.h\"\n"},
      {"engine/rotation.h", "#include \"engine/fit.h\"\n"},
      {"engine/fit.h", ""},
      {"engine/fit.cpp", "#include \"engine/fit.h\"\n#include <pupflow/fields.h>\n"}};
  EXPECT_THAT(find_cycle(include_graph(sources, Node::unit)),
              ElementsAre("engine/fields", "engine/rotation", "engine/fit", "engine/fields"));
  Sources straight = sources;
  straight["engine/fit.cpp"] = "#include \"engine/fit.h\"\n";
  EXPECT_THAT(find_cycle(include_graph(straight, Node::unit)), IsEmpty());
}

TEST(Cycles, AreFoundBetweenFoldersThatShareNoUnit) {
  const Sources sources{{"app/pictures/look.h", ""},
                        {"app/pictures/module.cpp", "#include \"app/window/live.h\"\n"},
                        {"app/window/live.h", "#include \"app/pictures/look.h\"\n"}};
  EXPECT_THAT(find_cycle(include_graph(sources, Node::unit)), IsEmpty());
  EXPECT_THAT(find_cycle(include_graph(sources, Node::folder)),
              ElementsAre("app/pictures", "app/window", "app/pictures"));
}

struct Case {
  const char* file;
  const char* line;
};

class Forbidden : public ::testing::TestWithParam<Case> {};
class Allowed : public ::testing::TestWithParam<Case> {};

TEST_P(Forbidden, IncludeIsFound) {
  const std::string text = std::string("#pragma once\n\n") + GetParam().line + "\n";
  const std::vector<Violation> violations = scan_text(GetParam().file, text);
  ASSERT_THAT(violations, SizeIs(1));
  EXPECT_EQ(violations[0].file, GetParam().file);
  EXPECT_EQ(violations[0].line, 3);
  EXPECT_THAT(GetParam().line, HasSubstr(violations[0].header));
}

TEST_P(Allowed, IncludePasses) {
  const std::vector<Violation> violations = scan_text(GetParam().file, GetParam().line);
  EXPECT_EQ(listed(violations), "");
}

constexpr Case kForbidden[] = {
    {"engine/include/pupflow/simulation.h", "#include \"engine/state.h\""},
    {"app/window/session.cpp", "#include \"engine/state.h\""},
    {"engine/heat.cpp", "#include \"app/io/failure.h\""},
    {"engine/heat.cpp", "#include <GL/glew.h>"},
    {"engine/heat.cpp", "#include <sys/stat.h>"},
    {"engine/heat.cpp", "#include \"heat.h\""},
    {"app/io/csv.cpp", "#include \"app/view/camera.h\""},
    {"app/view/camera.cpp", "  #  include <GL/gl.h>"},
    {"app/view/camera.cpp", "#include \"app/gl/renderer.h\""},
    {"app/gl/renderer.cpp", "#include <GLFW/glfw3.h>"},
    {"app/gl/renderer.cpp", "#include \"app/context/context.h\""},
    {"app/context/headless.cpp", "#include \"app/window/session/session.h\""},
    {"app/window/session.cpp", "#include \"app/cli/verb.h\""},
    {"app/pictures/render.cpp", "#include \"app/window/live.h\""},
    {"app/pictures/render.cpp", "#include \"app/cli/run.h\""},
    {"app/pictures/render.cpp", "#include <EGL/egl.h>"},
    {"app/cli/render.cpp", "#include \"app/gl/renderer.h\""},
    {"app/cli/render.cpp", "#include \"app/pictures/render.h\""},
    {"app/cli/run.cpp", "#include <imgui.h>"},
    {"app/study/sweep.cpp", "#include \"app/view/camera.h\""},
    {"app/study/sweep.cpp", "#include <mpi.h>"},
    {"app/mpi/leader.cpp", "#include \"app/study/sweep.h\""},
    {"app/cli/sweep.cpp", "#include \"app/mpi/leader.h\""},
    {"app/cli/explain.cpp", "#include \"bench/measure.h\""},
    {"app/study/sweep.cpp", "#include <armadillo>"},
    {"app/export/npy.cpp", "#include \"app/study/sweep.h\""},
    {"app/cli/export.cpp", "#include <hdf5.h>"},
    {"python/image.cpp", "#include \"app/pictures/picture.h\""},
    {"app/io/csv.cpp", "#include <pybind11/pybind11.h>"},
};

constexpr Case kAllowed[] = {
    {"engine/include/pupflow/simulation.h", "#include \"pupflow/view.h\""},
    {"engine/heat.cpp", "#include \"pupflow/parameters.h\""},
    {"app/window/session.cpp", "#include \"pupflow/view.h\""},
    {"app/report/error/rotations.cpp", "#include \"engine/rotation.h\""},
    {"engine/heat.cpp", "#include \"engine/heat.h\""},
    {"engine/heat.cpp", "#include <cmath>"},
    {"engine/heat.cpp", "#include <Eigen/Core>"},
    {"engine/heat.cpp", "// #include \"app/io/failure.h\""},
    {"app/io/png.cpp", "#include <png.h>"},
    {"app/cli/render.cpp", "#include \"app/graphics/graphics.h\""},
    {"app/cli/module.cpp", "#include <dlfcn.h>"},
    {"app/mpi/mailbox.cpp", "#include <mpi.h>"},
    {"app/cli/launcher.cpp", "#include \"app/mpi/interface.h\""},
    {"app/graphics/module.cpp", "#include \"app/window/live.h\""},
    {"app/window/window.cpp", "#include \"imgui_impl_glfw.h\""},
    {"app/context/headless.cpp", "#include <EGL/egl.h>"},
    {"python/image.cpp", "#include \"app/graphics/graphics.h\""},
    {"bench/sitting.cpp", "#include \"app/gl/renderer.h\""},
};

std::string name_of(const ::testing::TestParamInfo<Case>& info) {
  return "Case" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(Arrows, Forbidden, ::testing::ValuesIn(kForbidden), name_of);
INSTANTIATE_TEST_SUITE_P(Arrows, Allowed, ::testing::ValuesIn(kAllowed), name_of);

TEST(Arrows, FileOfAnUnknownFolderIsFound) {
  EXPECT_THAT(scan_text("app/nowhere/new.cpp", "#include <cmath>\n"), SizeIs(1));
}

}  // namespace
}  // namespace pupflow::arrows
