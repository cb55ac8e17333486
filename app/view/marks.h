// Drawing primitives over a scene: what overlays are made of. They know where they are in the
// arena, not how they are drawn. Painters of pictures and window each paint a list of them.
#pragma once

#include <Eigen/Core>
#include <span>
#include <variant>
#include <vector>

#include "app/view/camera.h"
#include "app/view/light.h"
#include "app/view/rgb.h"
#include "app/view/text.h"

namespace pupflow::view {

struct Ink {
  Rgb color;
  double opacity = 1;
};

// Widths and sizes are pixels of a picture 960 pixels high; painters scale them with the height.

struct Segment {
  Eigen::Vector3d from, to;
  double width;
  Ink ink;
};
struct Polyline {
  std::vector<Eigen::Vector3d> points;
  double width;
  Ink ink;
  bool fades = false;  // towards its beginning
};
struct Arrow {  // its head is at `to`
  Eigen::Vector3d from, to;
  double width;
  Ink ink;
};
struct Label {  // its middle is at `at`, on a halo of paper
  Eigen::Vector3d at;
  TextLine text;
  double size;
  Ink ink;
};
struct Polygon {  // on the floor: bodies hide it
  std::vector<Eigen::Vector3d> corners;
  double width;  // of its outline
  Ink outline, inside;
};
using Mark = std::variant<Segment, Polyline, Arrow, Label, Polygon>;

/// A line of a legend: a small mark, and what it means.
struct LegendEntry {
  enum class Sign { line, arrow, area, label };
  Sign sign;
  Ink ink;
  TextLine text;
};

struct Marks {
  std::vector<Mark> marks;  // in the order in which they are painted
  std::vector<LegendEntry> legend;

  void clear() {
    marks.clear();
    legend.clear();
  }
};

/// Where places of the arena are in a picture.
class Projection {
 public:
  /// `bodies` hide what is behind them; they must outlive the projection.
  Projection(const Camera& camera, const Bounds& bounds, int width, int height,
             std::span<const Ball> bodies = {});

  /// Pixels from the upper left corner; false for a place behind the eye.
  bool place(const Eigen::Vector3d& world, Eigen::Vector2d& pixels) const;

  /// Whether a body is between the place and the eye.
  bool hidden(const Eigen::Vector3d& world) const;

 private:
  Camera camera_;
  std::span<const Ball> bodies_;
  Eigen::Matrix4d clip_from_world_;
  double width_, height_;
};

}  // namespace pupflow::view
