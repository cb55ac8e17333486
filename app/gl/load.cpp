#include "app/gl/load.h"

#include <GL/glew.h>

#include "app/io/failure.h"

namespace pupflow::gl {

namespace {

std::string text_of(GLenum what) {
  const GLubyte* text = glGetString(what);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

const char* error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "unknown OpenGL error";
  }
}

}  // namespace

void load_functions() {
  const GLenum outcome = glewInit();
  // A GLEW built for GLX says this in every EGL context, after it has loaded everything.
  if (outcome != GLEW_OK && outcome != GLEW_ERROR_NO_GLX_DISPLAY) {
    throw io::Failure(io::ExitCode::no_context,
                      std::string("GLEW cannot load OpenGL's functions: ") +
                          reinterpret_cast<const char*>(glewGetErrorString(outcome)));
  }
  if (!GLEW_VERSION_3_3) {
    throw io::Failure(io::ExitCode::no_context,
                      "OpenGL 3.3 is needed, the driver has " + version_text());
  }
}

std::string renderer_name() {
  return text_of(GL_RENDERER);
}

std::string version_text() {
  return text_of(GL_VERSION);
}

std::string take_errors() {
  std::string errors;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    if (!errors.empty()) errors += ", ";
    errors += error_name(error);
  }
  return errors;
}

}  // namespace pupflow::gl
