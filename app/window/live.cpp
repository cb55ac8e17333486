#include "app/window/live.h"

#include "app/io/failure.h"
#include "app/window/live_window.h"

namespace pupflow::window {

void run_live(const LiveJob& job) {
  try {
    LiveWindow(job).run();
  } catch (const io::Failure& failure) {
    if (failure.code() != io::ExitCode::no_context) throw;
    throw io::Failure(failure.code(), std::string(failure.what()) +
                                          "; `pupflow render` makes pictures without a display");
  }
}

}  // namespace pupflow::window
