// Draws a list of bodies and its arena with OpenGL 3.3 core. Knows neither window nor EGL: a
// context must be current whenever a function here runs, the destructors included.
#pragma once

#include <functional>
#include <string>

#include "app/gl/object.h"
#include "app/gl/program.h"
#include "app/gl/target.h"
#include "app/io/png.h"
#include "app/view/camera.h"
#include "app/view/draw_list.h"

namespace pupflow::gl {

/// Edge of what is drawn at once into a picture, and of the samples that are drawn at once.
constexpr int kLargestPart = 2048;

/// Of the grid on the floor, arena units.
constexpr float kGridSpacing = 0.5f;

/// Colors of what is no pup.
struct Palette {
  view::Rgb background{255, 255, 255};
  bool transparent = false;        // no background: colors are premultiplied with their alpha
  view::Rgb floor{232, 234, 237};  // where nothing shades it
  view::Rgb slab{206, 210, 215};   // around the floor and below it
  view::Rgb glass{110, 130, 150}, rim{120, 127, 136};
};

class Renderer {
 public:
  /// Compiles the embedded shaders, or those in `shader_dir` when it is not empty. Throws
  /// Failure(bad_file) when a shader file cannot be read and Failure(bad_input) with file name and
  /// driver's log when it does not compile.
  explicit Renderer(const std::string& shader_dir = {});

  /// Takes over what to draw; needed only when the list has changed.
  void upload(const view::DrawList& list);

  /// Draws the uploaded list into `viewport` of the framebuffer that is bound for drawing, with
  /// `supersample` x `supersample` samples a pixel (1: none). The camera's aspect is the
  /// viewport's. Leaves that framebuffer bound, depth test and blending off. Throws
  /// Failure(bad_input) when the samples need a larger texture than the driver allows.
  void draw(const view::Camera& camera, const Viewport& viewport, int supersample,
            const Palette& palette = {});

  /// The same into the upper left of `image`, which holds `width` x `height` pixels at least. Calls
  /// `between_parts`, which may throw, between the parts that it is drawn in.
  void draw(const view::Camera& camera, io::Image& image, int width, int height, int supersample,
            const Palette& palette = {}, const std::function<void()>& between_parts = {});

  /// The same into a picture of its own.
  io::Image picture(const view::Camera& camera, int width, int height, int supersample,
                    const Palette& palette = {}, const std::function<void()>& between_parts = {}) {
    io::Image image(width, height);
    draw(camera, image, width, height, supersample, palette, between_parts);
    return image;
  }

 private:
  /// Vertices on their way to the driver.
  struct Mesh {
    VertexArray array;
    Buffer vertices, indices;
    GLsizei count = 0;  // of indices
    Mesh();
    void upload(const view::Triangles& triangles);
    void draw() const;
  };

  void draw_scene(const view::CameraMatrices& matrices, bool from_below, const Viewport& viewport,
                  const Palette& palette);
  struct Frame;
  Frame frame_of(const view::Camera& camera, int width, int height, int supersample,
                 const Palette& palette);
  void draw_part(const Frame& frame, const Viewport& part, int x, int y,
                 const std::function<void()>& before = {});  // to x, y
  void resolve(const Viewport& viewport, int samples);
  void draw_spheres(const view::CameraMatrices& matrices, int rows);
  void draw_ellipsoids(const view::CameraMatrices& matrices, int rows);
  void draw_floor(const view::CameraMatrices& matrices, bool from_below, const Palette& palette);
  void draw_soft_edges(const view::CameraMatrices& matrices);
  void draw_wall(const view::CameraMatrices& matrices, float radius, float bottom, float top,
                 view::Rgb color, bool glass);
  /// A line that is the foot of a side of height `side` fades where less than a pixel of it is seen;
  /// 0: it never does.
  void draw_rim(const view::CameraMatrices& matrices, const Viewport& viewport, float radius,
                float height, float opacity, view::Rgb color, float side);

  Program spheres_program_, sphere_edges_program_, ellipsoids_program_, skin_program_,
      plane_program_, wall_program_, rim_program_, resolve_program_;
  VertexArray spheres_array_, ellipsoids_array_, empty_array_;
  Buffer spheres_buffer_, ellipsoids_buffer_;
  Mesh skin_, outline_;
  Texture light_;
  Target samples_, picture_;
  GLsizei count_ = 0;  // of spheres
  GLsizei ellipsoids_count_ = 0;
  bool lit_ = false, soft_ = false;
  float sphere_radius_ = 0, arena_radius_ = 0, wall_height_ = 0;
  float line_scale_ = 1;  // samples that a line of one pixel is wide
  view::Bounds bounds_;
};

}  // namespace pupflow::gl
