// From where the arena is looked at. World: z up, the floor at z = 0, the arena's centre at the
// origin.
#pragma once

#include <Eigen/Core>
#include <string>

namespace pupflow::view {

/// A box around everything that is drawn, in world units.
struct Bounds {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
};

/// What the shaders need of a camera.
struct CameraMatrices {
  Eigen::Matrix4f eye_from_world;  // eye space: x right, y up, looking along -z
  Eigen::Matrix4f clip_from_eye;   // OpenGL clip space
  bool perspective = true;
};

/// A camera that looks at `target` from azimuth and elevation. Plain value; angles in radians.
class Camera {
 public:
  enum class Projection { perspective, orthographic };

  /// top (orthographic, x to the right and y up), side (orthographic, x to the right and z up) or
  /// orbit:azimuth,elevation[,distance[,view]] (perspective; degrees, counter-clockwise from the x
  /// axis and up from the floor; distance from the arena's centre in arena units; view: the angle
  /// from the bottom of the picture to its top, 30 degrees unless it is given). Without a distance
  /// the arena fills the picture. Throws Failure(bad_input) for anything else.
  static Camera parse(const std::string& spec);

  /// From `eye` along the floor in the direction `azimuth`, to a target `distance` away, which it
  /// keeps; `view`: the angle from bottom to top. Angles in radians.
  static Camera along(const Eigen::Vector3d& eye, double azimuth, double distance, double view);

  /// Where pictures and the window look from unless told otherwise.
  static constexpr const char* kUsual = "orbit:30,35";

  /// How the camera is written: as it was typed, or once it was turned or moved by hand as
  /// orbit:azimuth,elevation,distance, with the view where it is not the usual one. A camera
  /// without perspective keeps what was typed.
  std::string spec() const;

  /// Whether it was turned or moved since it was parsed (orbit, pan, zoom).
  bool moved() const { return moved_; }

  /// Whether its target was given (look_at).
  bool targeted() const { return targeted_; }

  /// Looks at `target` from now on, which framing leaves where it is; the distance stays.
  void look_at(const Eigen::Vector3d& target);

  /// Moves along the line of sight, and sideways, until an arena of this radius, with something
  /// `height` tall on it, fills a picture of that aspect (width / height). Keeps the angles. Does
  /// nothing when the specification gave a distance, and once the camera was moved by hand.
  void frame(double arena_radius, double height, double aspect);

  /// Turns around the target, by radians; the elevation stays within +-90 degrees. A camera without
  /// perspective gets one, with its target as near as possible to the arena's centre.
  void orbit(double d_azimuth, double d_elevation);

  /// Moves eye and target so that the scene shifts by these shares of the picture's height,
  /// positive to the right and up.
  void pan(double right, double up);

  /// Divides the distance by `factor` (> 1: closer); stays within 0.05 ... 10^6 arena units.
  void zoom(double factor);

  /// The same towards a place of the picture, `right` and `up` of its middle in shares of its
  /// height: what lies there, as far away as the target, stays there.
  void zoom_at(double factor, double right, double up);

  Projection projection() const { return projection_; }
  double azimuth() const { return azimuth_; }
  double elevation() const { return elevation_; }
  double distance() const { return distance_; }
  const Eigen::Vector3d& target() const { return target_; }

  /// Unit vectors: to the picture's right, its top, and from the target to the eye.
  Eigen::Vector3d right() const;
  Eigen::Vector3d up() const;
  Eigen::Vector3d backward() const;

  Eigen::Vector3d eye() const { return target_ + distance_ * backward(); }

  /// Half of the picture's height where the target is, in world units; for both projections.
  double half_height() const;

  /// The matrices for a picture of that aspect, with clip planes just around `bounds`.
  CameraMatrices matrices(double aspect, const Bounds& bounds) const;

  friend bool operator==(const Camera&, const Camera&) = default;

 private:
  static constexpr double kTanHalfView = 0.2679491924311227;  // of 15 degrees

  Projection projection_ = Projection::perspective;
  double azimuth_ = 0, elevation_ = 0;
  double distance_ = 10;
  double tan_half_view_ = kTanHalfView;
  bool fixed_distance_ = false, moved_ = false, targeted_ = false;
  std::string typed_;
  Eigen::Vector3d target_ = Eigen::Vector3d::Zero();
};

}  // namespace pupflow::view
