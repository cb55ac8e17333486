#include "app/pictures/render.h"

#include <filesystem>
#include <optional>

#include "app/io/atomic_file.h"
#include "app/io/background.h"
#include "app/io/failure.h"
#include "app/io/frame_path.h"
#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "app/io/provenance.h"
#include "app/pictures/picture.h"
#include "app/view/framing.h"

namespace pupflow::pictures {

namespace {

void check_job(const RenderJob& job) {
  if (job.at.empty() || job.at.front() < 0) {
    throw io::Failure(io::ExitCode::bad_input, "render needs steps from 0 upwards");
  }
  if (job.from && job.at.front() < job.from->step) {
    io::refuse("no frame after step " + std::to_string(job.at.front()) +
               ": the checkpoint is at step " + std::to_string(job.from->step));
  }
  if (job.follow && (*job.follow < 0 || *job.follow >= job.params.pups)) {
    io::refuse("there is no pup " + std::to_string(*job.follow) + " to follow; the litter has " +
               std::to_string(job.params.pups) + ", numbered from 0");
  }
  if (job.at.size() > 1 && !io::has_number(job.output.path)) {
    throw io::Failure(io::ExitCode::bad_input,
                      job.output.path +
                          ": several frames need a place for the step in the file "
                          "name, e.g. %05d.png");
  }
}

/// Refuses before any work what could not be written after it. Numbered frames may go to a folder
/// that is still to be made.
void check_outputs(const RenderJob& job) {
  std::filesystem::path made;
  for (const std::int64_t step : job.at) {
    const std::string path = io::frame_path(job.output.path, step);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (io::has_number(job.output.path) && folder != made)
      std::filesystem::create_directories(folder, error);
    made = folder;
    if (error) {
      throw io::Failure(io::ExitCode::bad_file,
                        folder.string() + ": cannot make the folder: " + error.message());
    }
    io::refuse_existing(path, job.output.force);
  }
}

/// Writes frames one after the other on a thread of its own, while the next one is made.
class Writer {
 public:
  explicit Writer(const RenderJob& job) : job_(job) {}

  /// Throws what writing the frame before threw.
  void write(const Simulation& litter, io::Image image, const view::Camera& camera,
             const io::TextEntries& look) {
    finish();
    const std::int64_t step = litter.steps_done();
    io::TextEntries extra{{"picture", "render"}};
    io::add_state(litter, extra);
    const io::TextEntries seen = camera_entries(camera);
    extra.insert(extra.end(), seen.begin(), seen.end());
    extra.emplace_back("size", std::to_string(image.width) + "x" + std::to_string(image.height));
    extra.emplace_back("bar", job_.bar ? "true" : "false");
    extra.insert(extra.end(), look.begin(), look.end());
    frame_ = std::move(image);
    pending_ = thread_.run([this, step, extra] {
      io::write_png(io::frame_path(job_.output.path, step), frame_,
                    io::provenance(job_.params, extra), job_.output.force, png_options(job_.look));
    });
  }

  void finish() {
    if (!pending_) return;
    thread_.wait(*pending_);
    pending_.reset();
    ++written_;
  }

  /// How far it came, for a message.
  std::string summary() {
    finish();
    return std::to_string(written_) + " of " + std::to_string(job_.at.size()) +
           " frames were written";
  }

 private:
  const RenderJob& job_;
  io::Image frame_;
  std::optional<io::Background::Ticket> pending_;
  std::size_t written_ = 0;
  io::Background thread_;  // last: it uses the others
};

/// The litter to begin with. What its colors show is recorded from the first frame on.
Simulation first_litter(const RenderJob& job) {
  if (!job.from) return observed_litter(job.params, job.look.parts());
  Simulation simulation(*job.from);
  simulation.set_observed(job.look.parts());
  return simulation;
}

void advance(Simulation& simulation, std::int64_t step, Picture& picture, io::Progress& progress,
             Writer& writer) {
  while (simulation.steps_done() < step) {
    if (io::interrupted()) {
      throw io::Failure(io::ExitCode::interrupted, "interrupted after step " +
                                                       std::to_string(simulation.steps_done()) +
                                                       "; " + writer.summary());
    }
    const Status status = simulation.step();
    if (!status.ok()) {
      throw io::Failure(io::ExitCode::bad_numbers, status.message() + "; " + writer.summary());
    }
    picture.watch(simulation.view());
    progress.update(simulation.steps_done());
  }
}

}  // namespace

void render(const RenderJob& job) {
  check_job(job);
  Simulation simulation = first_litter(job);
  simulation.set_threads(job.threads);
  Picture picture(job.width, job.height, job.bar, job.look);
  view::Camera camera = view::framed(job.camera, job.params, picture.scene_aspect());
  const Headless headless(job.look);
  picture.refuse_large();
  check_outputs(job);
  Writer writer(job);
  io::Progress progress("render", job.at.back(), job.output.quiet);
  for (const std::int64_t step : job.at) {
    advance(simulation, step, picture, progress, writer);
    if (job.follow) camera.look_at(simulation.view().positions.mean(*job.follow));
    io::Image frame = picture.draw(*headless.renderer, simulation.view(), camera);
    writer.write(simulation, std::move(frame), camera, picture.look_entries());
  }
  writer.finish();
}

}  // namespace pupflow::pictures
