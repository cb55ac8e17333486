// Errors of the X server that end no program.
#pragma once

namespace pupflow::window {

/// Call it before pixels are copied to a window. When the window becomes smaller while it is
/// painted, the server gets a box that it no longer holds; it answers with an error, for which Xlib
/// would end the program. Such an error is passed over: the new size is painted next. Every other
/// error goes to whoever handled it before.
void pass_over_errors_of_copies();

}  // namespace pupflow::window
