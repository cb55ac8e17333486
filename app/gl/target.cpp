#include "app/gl/target.h"

#include <algorithm>
#include <string>

#include "app/io/failure.h"

namespace pupflow::gl {

void Target::refuse_large(int width, int height) {
  GLint limit = 0, depth_limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &depth_limit);
  limit = std::min(limit, depth_limit);
  if (width < 1 || height < 1 || width > limit || height > limit) {
    throw io::Failure(io::ExitCode::bad_input,
                      "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                          " samples is not possible; each side must be in 1 ... " +
                          std::to_string(limit) + " (pixels times samples across a pixel)");
  }
}

void Target::resize(int width, int height) {
  if (width == width_ && height == height_) return;
  refuse_large(width, height);
  glBindTexture(GL_TEXTURE_2D, color_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  bind();
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(),
                         0);
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                            depth_.name());
  const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    io::refuse("the driver cannot draw into a framebuffer of " + std::to_string(width) + "x" +
               std::to_string(height) + " samples; fewer of them need less memory");
  }
  width_ = width;
  height_ = height;
}

void Target::bind() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
}

io::Image Target::read() const {
  io::Image image(width_, height_);
  read(image, 0, 0);
  return image;
}

void Target::read(io::Image& image, int x, int y) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, image.width);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixel(x, y));
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  // OpenGL's rows go from bottom to top.
  const auto row = 4 * static_cast<std::size_t>(width_);
  for (int i = 0; i < height_ / 2; ++i) {
    std::uint8_t* upper = image.pixel(x, y + i);
    std::swap_ranges(upper, upper + row, image.pixel(x, y + height_ - 1 - i));
  }
}

void SharedPicture::show(GLuint texture, int width, int height) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  width_ = width;
  height_ = height;
}

void SharedPicture::copy_to(GLuint framebuffer, int x, int y, const Viewport& part) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer(part.x, part.y, part.x + part.width, part.y + part.height, x, y, x + part.width,
                    y + part.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace pupflow::gl
