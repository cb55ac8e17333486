// An off-screen framebuffer: a color texture and a depth buffer.
#pragma once

#include "app/gl/object.h"
#include "app/io/png.h"

namespace pupflow::gl {

/// Part of a framebuffer in pixels, from its lower left corner.
struct Viewport {
  int x = 0, y = 0, width = 0, height = 0;
};

class Target {
 public:
  /// Throws Failure(bad_input) when the driver allows no target of this size in pixels.
  static void refuse_large(int width, int height);

  /// Makes it at least allocated at this size in pixels; the content is lost when the size changes.
  /// Throws Failure(bad_input) when the driver allows no such size.
  void resize(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  GLuint framebuffer() const { return framebuffer_.name(); }
  GLuint texture() const { return color_.name(); }

  /// Binds it for drawing.
  void bind() const;

  /// Its colors as a picture.
  io::Image read() const;

  /// The same into a larger picture, the upper left corner to (x, y).
  void read(io::Image& image, int x, int y) const;

 private:
  Framebuffer framebuffer_;
  Texture color_;
  Renderbuffer depth_;
  int width_ = 0, height_ = 0;
};

/// Reads a texture that another context draws, from one that shares its textures.
class SharedPicture {
 public:
  /// From now on that of `texture`, drawn whole, `width` x `height` pixels.
  void show(GLuint texture, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return width_ == 0; }

  /// Copies the colors of `part`, pixel by pixel, to (x, y) (lower left) of `framebuffer`, which stays
  /// bound for drawing.
  void copy_to(GLuint framebuffer, int x, int y, const Viewport& part) const;

 private:
  Framebuffer framebuffer_;
  int width_ = 0, height_ = 0;
};

}  // namespace pupflow::gl
