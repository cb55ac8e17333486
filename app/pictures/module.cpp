// The graphics module: what the program loads when a picture or a window is asked for.
#include "app/context/glfw_window.h"
#include "app/context/headless.h"
#include "app/pictures/figure1.h"
#include "app/pictures/graphics.h"
#include "app/pictures/render.h"
#include "app/window/live.h"

namespace pupflow::pictures {

namespace {

class Module final : public Graphics {
 public:
  void render(const RenderJob& job) override { pictures::render(job); }
  void figure1(const Figure1Job& job) override { pictures::figure1(job); }
  void live(const LiveJob& job) override { window::run_live(job); }
  ContextReport probe_headless() override { return context::probe_headless(); }
  ContextReport probe_window() override { return context::probe_window(); }
};

}  // namespace

}  // namespace pupflow::pictures

extern "C" __attribute__((visibility("default"))) pupflow::pictures::Graphics*
pupflow_graphics_entry() {
  static pupflow::pictures::Module module;
  return &module;
}
