#include "app/gl/program.h"

#include <map>
#include <stdexcept>

#include "app/io/failure.h"
#include "app/io/read_file.h"

// The embedded files: name, and the symbol that CMake gives it.
#define PUPFLOW_SHADERS(X)                  \
  X("spheres.vert", spheres_vert)           \
  X("spheres.frag", spheres_frag)           \
  X("sphere_edges.frag", sphere_edges_frag) \
  X("ellipsoids.vert", ellipsoids_vert)     \
  X("ellipsoids.frag", ellipsoids_frag)     \
  X("skin.vert", skin_vert)                 \
  X("skin.frag", skin_frag)                 \
  X("plane.vert", plane_vert)               \
  X("plane.frag", plane_frag)               \
  X("wall.vert", wall_vert)                 \
  X("wall.frag", wall_frag)                 \
  X("rim.vert", rim_vert)                   \
  X("rim.frag", rim_frag)                   \
  X("resolve.vert", resolve_vert)           \
  X("resolve.frag", resolve_frag)

#define PUPFLOW_DECLARE(file, symbol)                      \
  extern "C" const char pupflow_shader_##symbol##_begin[]; \
  extern "C" const char pupflow_shader_##symbol##_end[];
PUPFLOW_SHADERS(PUPFLOW_DECLARE)
#undef PUPFLOW_DECLARE

namespace pupflow::gl {

namespace {

struct Source {
  std::string name, text;
};

Source source_of(const std::string& shader_dir, const std::string& file) {
  if (shader_dir.empty()) return {file, std::string(embedded_shader(file))};
  const std::string path = shader_dir + "/" + file;
  constexpr std::size_t kLargestShader = std::size_t{1} << 20;
  return {path, io::read_file(path, kLargestShader)};
}

/// A driver's log in one line.
template <class GetLog>
std::string log_line(GLuint name, GetLog get_log, GLint length) {
  std::string log(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  get_log(name, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  while (!log.empty() && (log.back() == '\n' || log.back() == ' ')) log.pop_back();
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log[i] == '\n') log.replace(i, 1, "; ");
  }
  return log;
}

/// Owns one shader until its program is linked.
class Shader {
 public:
  Shader(GLenum stage, const Source& source) : name_(glCreateShader(stage)) {
    const char* text = source.text.data();
    const auto length = static_cast<GLint>(source.text.size());
    glShaderSource(name_, 1, &text, &length);
    glCompileShader(name_);
    GLint fine = 0;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &fine);
    if (fine == GL_TRUE) return;
    GLint log_length = 0;
    glGetShaderiv(name_, GL_INFO_LOG_LENGTH, &log_length);
    const std::string log = log_line(name_, glGetShaderInfoLog, log_length);
    glDeleteShader(name_);
    throw io::Failure(io::ExitCode::bad_input, source.name + " does not compile: " + log);
  }
  ~Shader() { glDeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

/// The name of a new program of these two stages.
GLuint link(const Source& vertex, const Source& fragment) {
  const Shader vertex_shader(GL_VERTEX_SHADER, vertex);
  const Shader fragment_shader(GL_FRAGMENT_SHADER, fragment);
  const GLuint name = glCreateProgram();
  glAttachShader(name, vertex_shader.name());
  glAttachShader(name, fragment_shader.name());
  glLinkProgram(name);
  GLint fine = 0;
  glGetProgramiv(name, GL_LINK_STATUS, &fine);
  if (fine == GL_TRUE) return name;
  GLint log_length = 0;
  glGetProgramiv(name, GL_INFO_LOG_LENGTH, &log_length);
  const std::string log = log_line(name, glGetProgramInfoLog, log_length);
  glDeleteProgram(name);
  throw io::Failure(io::ExitCode::bad_input,
                    vertex.name + " and " + fragment.name + " do not link: " + log);
}

}  // namespace

std::string_view embedded_shader(std::string_view file) {
#define PUPFLOW_ENTRY(name, symbol) \
  {name, {pupflow_shader_##symbol##_begin, pupflow_shader_##symbol##_end}},
  static const std::map<std::string_view, std::string_view> shaders{PUPFLOW_SHADERS(PUPFLOW_ENTRY)};
#undef PUPFLOW_ENTRY
  return shaders.at(file);
}

Program::Program(const std::string& shader_dir, const std::string& vertex,
                 const std::string& fragment)
    : name_(link(source_of(shader_dir, vertex), source_of(shader_dir, fragment))) {}

Program::~Program() {
  if (name_ != 0) glDeleteProgram(name_);
}

GLint Program::uniform(const char* uniform_name) const {
  return glGetUniformLocation(name_, uniform_name);
}

}  // namespace pupflow::gl
