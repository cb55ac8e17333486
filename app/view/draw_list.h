// What there is to draw of a litter, with no word of how.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "app/view/body.h"
#include "app/view/camera.h"
#include "app/view/color_scale.h"
#include "app/view/drawing.h"
#include "app/view/ellipsoid.h"
#include "app/view/light.h"
#include "app/view/skin_mesh.h"
#include "pupflow/view.h"

namespace pupflow::view {

/// Triangles of vertices.
struct Triangles {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  // three for each triangle

  void clear() {
    vertices.clear();
    indices.clear();
  }
};

/// The arena around a litter: how far its slab reaches outside the wall and below the floor
/// (pressed points sink in a little), in arena radii.
constexpr float kSlabDepth = 0.025f, kRimWidth = 0.03f;

/// The arena and the visible bodies of a litter. Its arrays are reused from frame to frame.
class DrawList {
 public:
  /// Fills the list for a look through `camera`; it must be updated when the camera turns or moves.
  /// Each point gets the color of its value of `scale.field`, its own or its pup's, under the light
  /// that falls on it. The scale is fitted to this litter where the data decides its ends. Bounds
  /// are those of all points, culled or not.
  void update(const LitterView& litter, const ColorScale& scale, const Camera& camera,
              const Drawing& drawing = {});

  std::span<const Vertex> spheres() const { return spheres_; }
  const Triangles& skin() const { return skin_; }
  const Triangles& outline() const { return outline_; }  // soft, around the skin
  std::span<const Ellipsoid> ellipsoids() const {
    return ellipsoids_;
  }                                                       // bodies too small for more
  std::span<const Ball> balls() const { return balls_; }  // outlines of the bodies
  const FloorLight& floor() const { return floor_; }      // empty without shadows
  const Drawing& drawing() const { return drawing_; }     // of the last update

  float sphere_radius() const { return sphere_radius_; }
  float arena_radius() const { return arena_radius_; }
  float wall_height() const { return wall_height_; }
  const Bounds& bounds() const { return bounds_; }    // of bodies and arena
  const ColorScale& scale() const { return scale_; }  // of the last update, fitted

 private:
  void find_bodies(const LitterView& litter);
  bool is_small(const Body& body) const;
  void add_ellipsoid(const Body& body, const Light& light);
  Rgb mean_color(const Body& body) const;
  void add_spheres(const Body& body, const Light& light);
  void add_skin(const Body& body, const Light& light);
  void add_cells(const Body& body, const SkinMesh& mesh, const std::vector<Vertex>& vertices,
                 const std::vector<float>& brightness);
  void add_outline(const Body& body, const SkinMesh& mesh, const std::vector<Vertex>& vertices);
  void find_facing(const Body& body, const SkinMesh& mesh);
  const SkinMesh& mesh_for(float pixels);  // for a radius of so many samples
  const SkinMesh& whole_mesh();
  Rgb color(const Body& body, std::size_t point) const;

  std::vector<Vertex> spheres_;
  Triangles skin_, outline_;
  std::vector<Ellipsoid> ellipsoids_;
  FloorLight floor_;
  Drawing drawing_;
  ColorScale scale_;
  float sphere_radius_ = 0, arena_radius_ = 0, wall_height_ = 0;
  Bounds bounds_;

  // Of the last update.
  Camera camera_;
  int face_points_ = 0;
  std::vector<float> xyz_;                          // of the litter
  std::vector<double> values_;                      // of the field that is shown
  std::vector<Ball> balls_;                         // radius 0 where a pup's numbers went bad
  std::map<std::pair<int, int>, SkinMesh> meshes_;  // by points on an edge, and halvings
  SkinShape shape_;
  std::vector<char> facing_, drawn_;  // of the triangles of the last skin: whether they are so
  std::vector<char> seen_;            // of its vertices: whether one of these is drawn
};

}  // namespace pupflow::view
