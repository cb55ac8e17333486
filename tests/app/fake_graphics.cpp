// A graphics module without graphics, put beside a copy of the executable: it prints the job that
// it is given. The command line is tested with it where there is no OpenGL.
#include <chrono>
#include <cstdio>
#include <thread>

#include "app/graphics/graphics.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"

namespace pupflow::graphics {
namespace {

using context::ContextReport;
using pictures::Figure1Job;
using pictures::Look;
using pictures::Output;
using pictures::RenderJob;
using pictures::SheetJob;
using window::LiveJob;

void print_look(const Look& look, const Output& output) {
  std::printf(
      "%s by %s %g..%g n=%d verbose=%d shaders='%s' out=%s force=%d quiet=%d\n"
      "draw=%s quality=%s overlay=%s trail=%g caption=%d transparent=%d dpi=%d%s\n",
      std::string(look.scale.field->name).c_str(), std::string(look.scale.map_name).c_str(),
      look.scale.min, look.scale.max, look.samples(), look.verbose, look.shader_dir.c_str(),
      output.path.c_str(), output.force, output.quiet, std::string(name_of(look.draw)).c_str(),
      std::string(name_of(look.quality)).c_str(), look.overlays.names().c_str(), look.trail,
      look.caption, look.transparent, look.dpi, look.celsius ? " celsius" : "");
}

class FakeGraphics : public Graphics {
 public:
  void render(const RenderJob& job) override {
    std::printf("render seed=%lld at", static_cast<long long>(job.params.seed));
    for (const std::int64_t step : job.at) std::printf(" %lld", static_cast<long long>(step));
    std::printf("\n%dx%d camera=%s bar=%d", job.width, job.height, job.camera.spec().c_str(),
                job.bar);
    const Eigen::Vector3d& target = job.camera.target();
    if (job.camera.targeted()) std::printf(" target=%g,%g,%g", target.x(), target.y(), target.z());
    if (job.follow) std::printf(" follow=%d", *job.follow);
    if (job.fps != 0) std::printf(" fps=%d", job.fps);
    std::printf("\n");
    print_look(job.look, job.output);
  }

  void sheet(const SheetJob& job) override {
    std::printf("sheet seed=%lld steps=%lld panel=%d threads=%d camera=%s bar=%d",
                static_cast<long long>(job.params.seed), static_cast<long long>(job.params.steps),
                job.panel, job.threads, job.camera.spec().c_str(), job.bar);
    for (const pictures::Axis& axis : job.axes) {
      std::printf(" %s", axis.parameter.c_str());
      for (const double value : axis.values) std::printf(" %g", value);
    }
    std::printf("\n");
    print_look(job.look, job.output);
  }

  void figure1(const Figure1Job& job) override {
    std::printf("figure1 seed=%lld panel=%d threads=%d ta", static_cast<long long>(job.params.seed),
                job.panel, job.threads);
    for (const double ta : job.ta) std::printf(" %g", ta);
    std::printf("\n");
    print_look(job.look, job.output);
  }

  io::Image image(const pictures::ImageJob& job, const LitterView&) override {
    return {job.width, job.height};
  }

  /// Waits for Ctrl-C when --exit-after is 1, else fails as a module without a display does.
  void live(const LiveJob& job) override {
    std::printf("live %dx%d ui=%g paused=%d shots=%s events=%d\n", job.width, job.height,
                job.ui_scale, job.paused, job.screenshot.c_str(), job.test_events);
    std::fflush(stdout);
    if (job.exit_after != 1) throw io::Failure(io::ExitCode::no_context, "no display was found");
    std::fclose(std::fopen("ready", "w"));
    while (!io::interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    throw io::Failure(io::ExitCode::interrupted, "the module saw it");
  }

  ContextReport probe_headless() override {
    return {true, "EGL fake", "renderer of paper", "3.3", {"first: no", "second: yes"}};
  }
  ContextReport probe_window() override { return {false, "", "", "", {"GLFW: no DISPLAY"}}; }
};

}  // namespace
}  // namespace pupflow::graphics

extern "C" __attribute__((visibility("default"))) pupflow::graphics::Graphics*
pupflow_graphics_entry() {
  static pupflow::graphics::FakeGraphics graphics;
  return &graphics;
}
