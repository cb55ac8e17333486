#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "app/io/failure.h"
#include "app/window/picture_path.h"

namespace pupflow::window {
namespace {

TEST(PicturePath, FillsInTheStepAndOverwritesNothing) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "pupflow_picture_path_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::string pattern = (folder / "p%04d.png").string();
  const std::string first = picture_path(pattern, 12);
  EXPECT_EQ(first, (folder / "p0012.png").string());
  std::ofstream(first) << "here";
  const std::string second = picture_path(pattern, 12);
  EXPECT_EQ(second, (folder / "p0012-2.png").string());
  std::ofstream(second) << "here";
  EXPECT_EQ(picture_path(pattern, 12), (folder / "p0012-3.png").string());
  std::filesystem::remove_all(folder);
}

TEST(PicturePath, HasAUsualName) {
  EXPECT_EQ(picture_path("", 7), "pupflow-00007.png");
}

TEST(PicturePath, RefusesABadPattern) {
  EXPECT_THROW(picture_path("a%s.png", 1), io::Failure);
}

}  // namespace
}  // namespace pupflow::window
