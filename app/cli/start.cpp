#include "app/cli/start.h"

#include <stdexcept>

#include "app/io/checkpoint.h"
#include "app/io/failure.h"
#include "app/io/schedule_text.h"

namespace pupflow::cli {
namespace {

/// Changes of the command line that lie before the checkpoint would have no effect.
void refuse_past_changes(const io::Settings& settings, const std::string& from, std::int64_t step) {
  for (const std::string& text : settings.at) {
    Schedule schedule;
    std::vector<std::string> reported;  // by set_up
    io::add_change(text, "--at", schedule, reported);
    for (const Change& change : schedule.changes()) {
      if (change.step >= step) continue;
      io::refuse("--at " + text + ": " + from + " is at step " + std::to_string(step) +
                 "; a change must begin there or later");
    }
  }
}

/// Takes what was typed for the steps that follow.
void take(const io::Settings& settings, Simulation& simulation) {
  Params before = simulation.params();
  before.schedule = simulation.recipe().schedule;
  const Params typed = io::set_up(settings, before).params;
  Params next = typed;
  // The parameters of another output are those of its start.
  if (!settings.like.empty()) apply_schedule(typed, simulation.steps_done(), next);
  simulation.set_schedule(typed.schedule);
  simulation.set_params(next);
}

}  // namespace

void add_from(CLI::App& verb, std::string& from) {
  verb.add_option("--from", from, "Go on from a checkpoint, bit for bit, up to step --steps")
      ->option_text("FILE")
      ->check(not_empty);
}

Start start_of(const io::Settings& settings, const std::string& from) {
  if (from.empty()) {
    const io::Setup setup = io::set_up(settings);
    return {setup.params, {}, setup.title};
  }
  if (!settings.scene.empty()) {
    io::refuse("--from brings its own parameters; change them with --set, not with a scene");
  }
  const Snapshot read = io::read_checkpoint(from);
  refuse_past_changes(settings, from, read.step);
  try {
    Simulation simulation(read);
    take(settings, simulation);
    if (simulation.steps_done() > simulation.recipe().steps) {
      io::refuse("--from " + from + ": is at step " + std::to_string(simulation.steps_done()) +
                 ", and the run ends at step " + std::to_string(simulation.recipe().steps) +
                 "; --steps must be at least the former");
    }
    return {simulation.recipe(), simulation.snapshot(), {}};
  } catch (const InvalidParams&) {
    throw;
  } catch (const std::logic_error& error) {
    // Parameters that define the litter, or numbers that do not fit.
    io::refuse(from + ": " + error.what());
  }
}

Simulation litter_of(const Start& start) {
  return start.from ? Simulation(*start.from) : Simulation(start.recipe);
}

}  // namespace pupflow::cli
