// Owners of OpenGL objects: made in the current context, deleted with their owner.
#pragma once

#include <GL/glew.h>

#include <utility>

namespace pupflow::gl {

/// Owns one OpenGL name; moves, never copies. `Kind` says how names are made and deleted.
template <class Kind>
class Object {
 public:
  Object() { Kind::make(&name_); }
  ~Object() {
    if (name_ != 0) Kind::remove(&name_);
  }
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct BufferKind {
  static void make(GLuint* name) { glGenBuffers(1, name); }
  static void remove(const GLuint* name) { glDeleteBuffers(1, name); }
};
struct VertexArrayKind {
  static void make(GLuint* name) { glGenVertexArrays(1, name); }
  static void remove(const GLuint* name) { glDeleteVertexArrays(1, name); }
};
struct TextureKind {
  static void make(GLuint* name) { glGenTextures(1, name); }
  static void remove(const GLuint* name) { glDeleteTextures(1, name); }
};
struct RenderbufferKind {
  static void make(GLuint* name) { glGenRenderbuffers(1, name); }
  static void remove(const GLuint* name) { glDeleteRenderbuffers(1, name); }
};
struct FramebufferKind {
  static void make(GLuint* name) { glGenFramebuffers(1, name); }
  static void remove(const GLuint* name) { glDeleteFramebuffers(1, name); }
};

using Buffer = Object<BufferKind>;
using VertexArray = Object<VertexArrayKind>;
using Texture = Object<TextureKind>;
using Renderbuffer = Object<RenderbufferKind>;
using Framebuffer = Object<FramebufferKind>;

}  // namespace pupflow::gl
