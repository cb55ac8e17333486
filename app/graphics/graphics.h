// What the program asks of its graphics side. That side is a module of its own (pupflow_graphics),
// loaded when a picture or a window is asked for, so that everything else runs where no GL library
// is installed.
#pragma once

#include "app/context/context.h"
#include "app/io/failure.h"
#include "app/io/module.h"
#include "app/pictures/figure1.h"
#include "app/pictures/image.h"
#include "app/pictures/render.h"
#include "app/pictures/sheet.h"
#include "app/window/live_job.h"

namespace pupflow::graphics {

/// The module's face. Every member throws io::Failure; those that draw throw it with no_context
/// when no OpenGL context can be made, saying what was tried and what to install.
class Graphics {
 public:
  virtual ~Graphics() = default;
  virtual void render(const pictures::RenderJob& job) = 0;
  virtual void sheet(const pictures::SheetJob& job) = 0;
  virtual void figure1(const pictures::Figure1Job& job) = 0;
  virtual io::Image image(const pictures::ImageJob& job, const LitterView& litter) = 0;
  virtual void live(const window::LiveJob& job) = 0;
  virtual context::ContextReport probe_headless() = 0;
  virtual context::ContextReport probe_window() = 0;
};

/// The one symbol that the module exports; the object lives as long as the module.
constexpr const char* kEntry = "pupflow_graphics_entry";
using Entry = Graphics* (*)();

/// What a module loaded for kEntry hands out. Throws Failure(no_context), with the loader's reason
/// and what to install, when it is missing or a library that it needs is.
inline Graphics& entered(const io::Module& module) {
  if (module.entry) return *reinterpret_cast<Entry>(module.entry)();
  throw io::Failure(io::ExitCode::no_context,
                    "no graphics: " + module.problem +
                        " (Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri libglew-dev "
                        "libglfw3)");
}

}  // namespace pupflow::graphics
