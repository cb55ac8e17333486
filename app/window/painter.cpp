#include "app/window/painter.h"

#include <GL/glew.h>

#include <algorithm>
#include <vector>

namespace pupflow::window {

bool Painter::paint(Gui& gui, std::span<const Image> images, bool new_images, view::Rgb paper) {
  ImDrawData& data = *ImGui::GetDrawData();
  const int width = static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x);
  const int height = static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y);
  if (width < 1 || height < 1) return false;
  if (scale_ != gui.scale() || density_ != gui.density()) forget();  // another typeface, same name
  scale_ = gui.scale();
  density_ = gui.density();

  std::vector<PixelBox> places;
  for (const Image& image : images) places.push_back(image.place);
  const std::vector<PixelBox> boxes = repaint_.changed(data, places, new_images);
  if (boxes.empty()) return false;
  store_.resize(width, height);
  store_.bind();
  glClearColor(static_cast<float>(paper.r) / 255, static_cast<float>(paper.g) / 255,
               static_cast<float>(paper.b) / 255, 1);
  glEnable(GL_SCISSOR_TEST);
  for (const PixelBox& box : boxes) {
    const auto holds = [&](const PixelBox& place) { return place.holds(box); };
    if (std::ranges::any_of(places, holds)) continue;
    glScissor(box.left, box.top, box.width(), box.height());
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glDisable(GL_SCISSOR_TEST);
  for (const Image& image : images) {
    for (const PixelBox& box : boxes) {
      const PixelBox part = common(box, image.place);
      if (part.empty()) continue;
      image.store->copy_to(
          store_.framebuffer(), part.left, part.top,
          {part.left - image.place.left, part.top - image.place.top, part.width(), part.height()});
    }
  }
  glViewport(0, 0, width, height);
  cut_to(data, boxes);
  turn_upside_down(data);
  gui.draw();
  copy_.show(store_);
  return true;
}

}  // namespace pupflow::window
