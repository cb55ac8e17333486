// Pictures of one litter as it moves.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "pupflow/snapshot.h"

namespace pupflow::pictures {

/// `pupflow render`: frames of one scene, after the given steps (0 is the start).
struct RenderJob {
  Params params;                 // the recipe
  std::optional<Snapshot> from;  // a litter of that recipe to begin with; none: the start
  std::vector<std::int64_t> at;  // sorted, without repeats
  int threads = 1;               // that share a step
  int width = 1280, height = 960;
  view::Camera camera = view::Camera::parse(view::Camera::kUsual);
  std::optional<int> follow;  // keep this pup in the middle
  bool bar = true;            // draw the legend of the colors
  int fps = 0;                // frames a second of the film at output.path; 0: PNG files
  Look look;
  Output output;  // path may hold one %d (with width, e.g. %05d) for the step
};

/// Steps the litter once through and writes a frame at each asked step. Throws Failure: bad_input
/// and bad_file (before the first step when an output exists), no_context; bad_numbers and
/// interrupted, which keep the PNG files written so far and say how many these are. A film is there
/// whole or not at all. Without ffmpeg its frames become PNG files in the folder NAME_frames, and a
/// note says so.
void render(const RenderJob& job);

}  // namespace pupflow::pictures
