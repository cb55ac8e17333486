#include "pupflow/version.h"

#include <gtest/gtest.h>

#include <string>

namespace pupflow {
namespace {

TEST(Version, TheTextSaysTheNumbers) {
  const Version now = version();
  EXPECT_EQ(version_text(), std::to_string(now.major) + "." + std::to_string(now.minor) + "." +
                                std::to_string(now.patch));
  EXPECT_GE(now.major + now.minor + now.patch, 1);
}

}  // namespace
}  // namespace pupflow
