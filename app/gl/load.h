// The OpenGL functions of the current context.
#pragma once

#include <string>

namespace pupflow::gl {

/// Loads the functions for the context that is current now; needed once per context. Throws
/// Failure(no_context) when they cannot be loaded or the context is older than OpenGL 3.3.
void load_functions();

/// GL_RENDERER and GL_VERSION of the current context.
std::string renderer_name();
std::string version_text();

/// The OpenGL errors since the last call, e.g. "GL_INVALID_ENUM"; empty when there were none.
std::string take_errors();

}  // namespace pupflow::gl
