// What the program asks of its graphics side. That side is a module of its own (pupflow_graphics),
// loaded when a picture or a window is asked for, so that everything else runs where no GL library
// is installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/context/report.h"
#include "pupflow/parameters.h"

namespace pupflow::pictures {

/// Options that every picture and window shares.
struct Look {
  std::string colormap = "viridis";  // viridis, inferno, cividis, jet
  double scale_min = 0.0;            // body temperature at the ends of the colour scale
  double scale_max = 1.0;
  std::string shader_dir;  // read shaders from here instead of the embedded ones
  int supersample = 2;     // n x n samples per pixel
  bool verbose = false;    // print which context and renderer were chosen
};

struct Output {
  std::string path;
  bool force = false;  // overwrite
  bool quiet = false;
};

/// `pupflow render`: frames of one scene, after the given steps (0 is the start).
struct RenderJob {
  Params params;
  std::vector<std::int64_t> at;  // sorted, without repeats
  int threads = 1;               // that share a step
  int width = 1280, height = 960;
  std::string camera = "orbit:30,35";  // top | side | orbit:azimuth,elevation[,distance]
  bool bar = true;                     // draw the colour bar
  Look look;
  Output output;  // path may hold one %d (with width, e.g. %05d) for the step
};

/// `pupflow figure1`: the paper's Figure 1.
struct Figure1Job {
  Params params;                             // everything but ta
  std::vector<double> ta = {0.2, 0.5, 0.8};  // one panel each
  int panel = 560;                           // edge of a panel, pixels
  int threads = 0;                           // that step the litters; 0: as many as help
  Look look;
  Output output;
};

/// `pupflow live`: the window.
struct LiveJob {
  Params params;
  Look look;
  int width = 1400, height = 900;
  int threads = 1;           // that share a step
  double ui_scale = 0;       // 0: the display's
  bool paused = false;       // start paused
  std::string screenshot;    // pattern for screenshots, with %d for the step
  bool test_events = false;  // print widget rectangles and value changes, for window tests
  double exit_after = 0;     // close by itself after so many seconds; 0: never
};

using context::ContextReport;  // for `pupflow doctor`

/// The module's face. Every member throws io::Failure; those that draw throw it with no_context
/// when no OpenGL context can be made, saying what was tried and what to install.
class Graphics {
 public:
  virtual ~Graphics() = default;
  virtual void render(const RenderJob& job) = 0;
  virtual void figure1(const Figure1Job& job) = 0;
  virtual void live(const LiveJob& job) = 0;
  virtual ContextReport probe_headless() = 0;
  virtual ContextReport probe_window() = 0;
};

/// The one symbol that the module exports; the object lives as long as the module.
constexpr const char* kGraphicsEntry = "pupflow_graphics_entry";
using GraphicsEntry = Graphics* (*)();

}  // namespace pupflow::pictures
