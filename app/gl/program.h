// A compiled and linked pair of shaders.
#pragma once

#include <GL/glew.h>

#include <string>
#include <string_view>
#include <utility>

namespace pupflow::gl {

/// The source embedded under `file`, e.g. "spheres.vert". Throws std::out_of_range for another.
std::string_view embedded_shader(std::string_view file);

/// A linked program. Deleted with its owner, in the context that it was made in.
class Program {
 public:
  /// Compiles and links `vertex` and `fragment`: embedded files, or files in `shader_dir` when that
  /// is not empty. Throws Failure(bad_file) when one cannot be read, Failure(bad_input) with its
  /// name and the driver's log when it does not compile or the two do not link.
  Program(const std::string& shader_dir, const std::string& vertex, const std::string& fragment);
  ~Program();
  Program(Program&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Program& operator=(Program&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }

  GLuint name() const { return name_; }

  /// The place of a uniform; -1 when the shaders do not use it, which glUniform* ignores.
  GLint uniform(const char* uniform_name) const;

 private:
  GLuint name_ = 0;
};

}  // namespace pupflow::gl
