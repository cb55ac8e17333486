#include "app/window/live.h"

#include "app/io/failure.h"
#include "app/io/note.h"
#include "app/window/live_window.h"
#include "app/window/settings.h"

namespace pupflow::window {
namespace {

/// Takes from `settings` what `job` was not given.
void take(const Settings& settings, LiveJob& job) {
  const LiveJob::Given& given = job.given;
  if (!given.size) {
    job.width = settings.width;
    job.height = settings.height;
  }
  if (!given.ui_scale) job.ui_scale = settings.ui_scale;
  if (!given.quality) job.look.quality = settings.quality;
  if (!given.draw) job.look.draw = settings.draw;
  const bool free = !given.colormap && job.look.scale.field->kind == FieldKind::continuous;
  if (free && !settings.colormap.empty()) job.look.scale.set_map(settings.colormap);
}

}  // namespace

void run_live(const LiveJob& job) {
  std::string problem;
  const Settings settings = read_settings(settings_path(), problem);
  if (!problem.empty()) io::note(problem);
  LiveJob wanted = job;
  take(settings, wanted);
  try {
    LiveWindow(wanted, settings).run();
  } catch (const io::Failure& failure) {
    if (failure.code() != io::ExitCode::no_context) throw;
    throw io::Failure(failure.code(), std::string(failure.what()) +
                                          "; `pupflow render` makes pictures without a display");
  }
}

}  // namespace pupflow::window
