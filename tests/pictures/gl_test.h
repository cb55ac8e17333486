// A fixture with a headless context, in which an OpenGL error fails the test.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "app/context/headless.h"
#include "app/gl/load.h"
#include "app/gl/renderer.h"
#include "app/view/draw_list.h"

namespace pupflow {

class GlTest : public ::testing::Test {
 protected:
  void SetUp() override { context_ = context::make_headless(report_); }
  void TearDown() override {
    EXPECT_EQ(gl::take_errors(), "");
    context_.reset();
  }

  context::ContextReport report_;
  std::unique_ptr<context::Context> context_;
};

inline view::Rgb color_at(const io::Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return {p[0], p[1], p[2]};
}

}  // namespace pupflow
