#include "app/window/painter.h"

#include <GL/glew.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <vector>

#include "app/window/x_errors.h"

namespace pupflow::window {
namespace {

constexpr std::size_t kMostCopies = 3;  // to the screen; each waits for the driver

// The driver notices another size of the window with a frame that is swapped. A copy of a part that
// it takes to be beyond the window's edges would end the program.
constexpr int kSwapsAfterResize = 2;

/// A function of GLX, or null; GLFW finds these by name as it does those of OpenGL.
template <class Function>
Function find(const char* name) {
  return reinterpret_cast<Function>(glfwGetProcAddress(name));
}

}  // namespace

Painter::Painter(const context::GlfwWindow& window, bool slow_gl) : window_(window) {
  if (!slow_gl || glfwExtensionSupported("GLX_MESA_copy_sub_buffer") != GLFW_TRUE) return;
  const auto display = find<void* (*)()>("glXGetCurrentDisplay");
  const auto drawable = find<unsigned long (*)()>("glXGetCurrentDrawable");
  copy_box_ = find<decltype(copy_box_)>("glXCopySubBufferMESA");
  if (display == nullptr || drawable == nullptr || copy_box_ == nullptr) {
    copy_box_ = nullptr;
    return;
  }
  display_ = display();
  drawable_ = drawable();
}

void Painter::paint(Gui& gui, std::span<const Image> images, bool new_images, view::Rgb paper) {
  ImDrawData& data = *ImGui::GetDrawData();
  const int width = static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x);
  const int height = static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y);
  const bool new_fonts = scale_ != gui.scale() || density_ != gui.density();  // in the same texture
  scale_ = gui.scale();
  density_ = gui.density();
  const std::array<float, 2> size{data.DisplaySize.x, data.DisplaySize.y};
  if (size != size_) swaps_ = kSwapsAfterResize;
  size_ = size;
  if (copy_box_ == nullptr || new_fonts || swaps_ > 0) forget();

  std::vector<PixelBox> places;
  for (const Image& image : images) places.push_back(image.place);
  const std::vector<PixelBox> boxes = repaint_.changed(data, places, new_images);
  if (boxes.empty()) return;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  clear(boxes, places, height, paper);
  for (const Image& image : images) {
    for (const PixelBox& box : boxes) {
      const PixelBox part = common(box, image.place);
      if (part.empty()) continue;
      const int left = image.left + part.left - image.place.left;
      const int bottom = image.top + part.bottom - image.place.top;
      image.picture->copy_to(0, part.left, height - part.bottom,
                             {left, image.picture->height() - bottom, part.width(), part.height()});
    }
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  cut_to(data, boxes);
  gui.draw();
  show(boxes, width, height);
}

void Painter::clear(std::span<const PixelBox> boxes, std::span<const PixelBox> images, int height,
                    view::Rgb paper) const {
  glClearColor(static_cast<float>(paper.r) / 255, static_cast<float>(paper.g) / 255,
               static_cast<float>(paper.b) / 255, 1);
  glEnable(GL_SCISSOR_TEST);
  for (const PixelBox& box : boxes) {
    const auto covers = [&](const PixelBox& image) { return image.holds(box); };
    if (std::ranges::any_of(images, covers)) continue;
    glScissor(box.left, height - box.bottom, box.width(), box.height());
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glDisable(GL_SCISSOR_TEST);
}

void Painter::show(std::span<const PixelBox> boxes, int width, int height) {
  if (copy_box_ == nullptr || swaps_ > 0) {
    swaps_ = std::max(swaps_ - 1, 0);
    glfwSwapBuffers(window_.handle());
    return;
  }
  int width_now = 0, height_now = 0;
  glfwGetFramebufferSize(window_.handle(), &width_now, &height_now);
  if (width_now != width || height_now != height) return forget();  // its event is on the way
  pass_over_errors_of_copies();
  for (const PixelBox& box : gathered(boxes, kMostCopies)) {
    copy_box_(display_, drawable_, box.left, height - box.bottom, box.width(), box.height());
  }
}

}  // namespace pupflow::window
