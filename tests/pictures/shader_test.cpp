#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "app/gl/program.h"
#include "app/io/failure.h"
#include "pupflow/simulation.h"
#include "tests/pictures/gl_test.h"
#include "tests/support/scratch.h"

namespace pupflow::gl {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kFiles[] = {
    "spheres.vert", "spheres.frag", "sphere_edges.frag", "ellipsoids.vert", "ellipsoids.frag",
    "skin.vert",    "skin.frag",    "plane.vert",        "plane.frag",      "wall.vert",
    "wall.frag",    "rim.vert",     "rim.frag",          "resolve.vert",    "resolve.frag"};

class ShaderTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    for (const char* file : kFiles) write(file, std::string(embedded_shader(file)));
  }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_.path(file)) << text;
  }
  std::string directory() const { return folder_.path(""); }

  /// What a renderer with these shaders fails with.
  io::Failure failure() const {
    try {
      Renderer renderer(directory());
    } catch (const io::Failure& failure) {
      return failure;
    }
    ADD_FAILURE() << "the shaders were taken";
    return {io::ExitCode::done, ""};
  }

  test::Scratch folder_;
};

TEST_F(ShaderTest, AreReadFromAFolderInstead) {
  std::string text(embedded_shader("plane.frag"));
  const std::string output = "fragment = vec4(color, cover);";
  ASSERT_NE(text.find(output), std::string::npos);
  text.replace(text.find(output), output.size(), "fragment = vec4(0.0, 1.0, 0.0, cover);");
  write("plane.frag", text);
  Params params;
  params.pups = 0;
  view::Camera camera = view::Camera::parse("top");
  camera.frame(2, 1, 1);
  view::DrawList list;
  list.update(Simulation(params), view::ColorScale("viridis", 0, 1), camera);
  Renderer embedded, changed(directory());
  for (Renderer* renderer : {&embedded, &changed}) renderer->upload(list);
  EXPECT_EQ(color_at(embedded.picture(camera, 64, 64, 1), 36, 36), Palette{}.floor);
  EXPECT_EQ(color_at(changed.picture(camera, 64, 64, 1), 36, 36), (view::Rgb{0, 255, 0}));
}

TEST_F(ShaderTest, AnErrorNamesFileAndLine) {
  write("spheres.frag", "#version 330 core\nvoid main() {\n  nonsense;\n}\n");
  const io::Failure what = failure();
  EXPECT_EQ(what.code(), io::ExitCode::bad_input);
  EXPECT_THAT(what.what(), AllOf(HasSubstr(folder_.path("")), HasSubstr("spheres.frag"),
                                 HasSubstr("nonsense"), HasSubstr("3")));
  EXPECT_EQ(std::string(what.what()).find('\n'), std::string::npos);
}

TEST_F(ShaderTest, StagesThatDoNotFitAreNamed) {
  write("wall.frag",
        "#version 330 core\nin float eye_place;\nout vec4 fragment;\n"
        "void main() { fragment = vec4(eye_place); }\n");
  const io::Failure what = failure();
  EXPECT_EQ(what.code(), io::ExitCode::bad_input);
  EXPECT_THAT(what.what(),
              AllOf(HasSubstr("wall.vert"), HasSubstr("wall.frag"), HasSubstr("eye_place")));
}

TEST_F(ShaderTest, AMissingFileIsNamed) {
  std::filesystem::remove(folder_.path("resolve.vert"));
  const io::Failure what = failure();
  EXPECT_EQ(what.code(), io::ExitCode::bad_file);
  EXPECT_THAT(what.what(), HasSubstr("resolve.vert"));
}

}  // namespace
}  // namespace pupflow::gl
