// Ctrl-C: long work looks here between steps, keeps what is done and ends with code 130.
#pragma once

namespace pupflow::io {

// Visible from outside the executable, which exports its symbols: a module carries a copy of this
// code, and the dynamic linker binds the module's uses to the executable's one flag.
#pragma GCC visibility push(default)

/// From now on SIGINT, SIGTERM and SIGHUP only set the flag; a second one ends the program at once.
void watch_for_interrupt();

/// Whether one of them came.
bool interrupted();

/// Waits until `descriptor` is ready for `events` of poll(2). False when it is not, and one of the
/// signals came.
bool wait_until_ready(int descriptor, short events);

#pragma GCC visibility pop

}  // namespace pupflow::io
