// The graphics module: what the program loads when a picture or a window is asked for.
#include "app/context/glfw_window.h"
#include "app/context/headless.h"
#include "app/graphics/graphics.h"
#include "app/window/live.h"

namespace pupflow::graphics {

namespace {

class Module final : public Graphics {
 public:
  void render(const pictures::RenderJob& job) override { pictures::render(job); }
  void sheet(const pictures::SheetJob& job) override { pictures::sheet(job); }
  void figure1(const pictures::Figure1Job& job) override { pictures::figure1(job); }
  io::Image image(const pictures::ImageJob& job, const LitterView& litter) override {
    return pictures::image(job, litter);
  }
  void live(const window::LiveJob& job) override { window::run_live(job); }
  context::ContextReport probe_headless() override { return context::probe_headless(); }
  context::ContextReport probe_window() override { return context::probe_window(); }
};

}  // namespace

}  // namespace pupflow::graphics

extern "C" __attribute__((visibility("default"))) pupflow::graphics::Graphics*
pupflow_graphics_entry() {
  static pupflow::graphics::Module module;
  return &module;
}
