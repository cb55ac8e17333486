#include "app/pictures/render.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>

#include "app/io/atomic_file.h"
#include "app/io/background.h"
#include "app/io/failure.h"
#include "app/io/frame_path.h"
#include "app/io/interrupt.h"
#include "app/io/movie.h"
#include "app/io/note.h"
#include "app/io/progress.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
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
  if (job.fps != 0) {
    io::check_movie(job.output.path, job.fps, job.width, job.height);
    if (job.look.transparent) io::refuse("--transparent: a film has no transparent paper");
    return;
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
  if (job.fps != 0) return io::refuse_existing(job.output.path, job.output.force);
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

/// Where the pictures were taken from, and what they show.
io::TextEntries view_entries(const RenderJob& job, const view::Camera& camera,
                             const io::TextEntries& look) {
  io::TextEntries entries = camera_entries(camera);
  entries.emplace_back("size", std::to_string(job.width) + "x" + std::to_string(job.height));
  entries.emplace_back("bar", job.bar ? "true" : "false");
  entries.insert(entries.end(), look.begin(), look.end());
  return entries;
}

/// What a film carries: known before its first frame.
io::TextEntries movie_text(const RenderJob& job, const view::Camera& camera) {
  io::TextEntries extra{{"picture", "movie"},
                        {"fps", std::to_string(job.fps)},
                        {"frames", std::to_string(job.at.size())},
                        {"first_step", std::to_string(job.at.front())},
                        {"last_step", std::to_string(job.at.back())}};
  if (job.follow) extra.emplace_back("follow", std::to_string(*job.follow));
  io::TextEntries look = look_entries(job.look, job.look.scale.fitted({}));
  for (auto& [name, value] : look) {
    if (name == "scale" && job.look.scale.ends != view::Ends::typed) {
      value = view::name_of(job.look.scale.ends);
    }
  }
  const io::TextEntries seen = view_entries(job, camera, look);
  extra.insert(extra.end(), seen.begin(), seen.end());
  return io::provenance(job.params, extra);
}

/// Writes frames one after the other on a thread of its own, while the next one is made.
class Writer {
 public:
  Writer(const RenderJob& job, const view::Camera& camera) : job_(job) {
    if (job.fps == 0) return;
    movie_.emplace(job.output.path, io::MovieFile::Options{.width = job.width,
                                                           .height = job.height,
                                                           .fps = job.fps,
                                                           .text = movie_text(job, camera),
                                                           .force = job.output.force});
  }

  /// Throws what writing the frame before threw.
  void write(const Simulation& litter, io::Image image, const view::Camera& camera,
             const io::TextEntries& look) {
    finish();
    frame_ = std::move(image);
    if (movie_) {
      pending_ = thread_.run([this] { movie_->add(frame_); });
      return;
    }
    const std::int64_t step = litter.steps_done();
    io::TextEntries extra{{"picture", "render"}};
    io::add_state(litter, extra);
    const io::TextEntries seen = view_entries(job_, camera, look);
    extra.insert(extra.end(), seen.begin(), seen.end());
    pending_ = thread_.run([this, step, extra] {
      io::write_png(io::frame_path(job_.output.path, step), frame_,
                    io::provenance(job_.params, extra), job_.output.force, png_options(job_.look));
    });
  }

  /// Once, last.
  void close() {
    finish();
    if (movie_) movie_->finish();
  }

  void finish() {
    if (!pending_) return;
    thread_.wait(*pending_);
    pending_.reset();
    ++written_;
  }

  /// How far it came, for a message.
  std::string summary() {
    if (movie_) return "no film was written";
    finish();
    return std::to_string(written_) + " of " + std::to_string(job_.at.size()) +
           " frames were written";
  }

 private:
  const RenderJob& job_;
  io::Image frame_;
  std::optional<io::MovieFile> movie_;
  std::optional<io::Background::Ticket> pending_;
  std::size_t written_ = 0;
  io::Background thread_;  // last: it uses the others
};

/// Does `work`; a Failure that it throws also says what `writer` has written.
auto telling(Writer& writer, auto work) {
  try {
    return work();
  } catch (const io::Failure& failure) {
    throw io::Failure(failure.code(), failure.what() + ("; " + writer.summary()));
  }
}

/// The litter to begin with. What its colors show is recorded from the first frame on.
Simulation first_litter(const RenderJob& job) {
  if (!job.from) return observed_litter(job.params, job.look.parts());
  Simulation simulation(*job.from);
  simulation.set_observed(job.look.parts());
  return simulation;
}

/// Steps the litter on a thread of its own, while the frame before is drawn.
class Stepper {
 public:
  explicit Stepper(const RenderJob& job)
      : job_(job),
        litter_(first_litter(job)),
        trails_(job.look.overlays.has("trails") ? job.look.trail : 0),
        progress_("render", job.at.back(), job.output.quiet) {
    litter_.set_threads(job.threads);
    watch();
    begin();
  }
  ~Stepper() { ended_ = true; }
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  /// A litter, and where its pups were until then.
  struct Moment {
    Simulation litter;
    view::Trails trails;
  };

  /// At the next of the job's steps. Throws Failure: bad_numbers, interrupted; it says what `writer`
  /// has written.
  Moment next(Writer& writer) {
    telling(writer, [&] { thread_.wait_for_all(); });
    Moment moment{litter_, trails_};
    begin();
    return moment;
  }

 private:
  void begin() {
    if (frame_ == job_.at.size()) return;
    const std::int64_t step = job_.at[frame_++];
    thread_.run([this, step] { advance(step); });
  }

  void advance(std::int64_t step) {
    while (litter_.steps_done() < step && !ended_) {
      if (io::interrupted()) {
        throw io::Failure(io::ExitCode::interrupted,
                          "interrupted after step " + std::to_string(litter_.steps_done()));
      }
      const Status status = litter_.step();
      if (!status.ok()) throw io::Failure(io::ExitCode::bad_numbers, status.message());
      watch();
      progress_.update(litter_.steps_done());
    }
  }

  void watch() {
    if (trails_.seconds() > 0) trails_.add(litter_.view());
  }

  const RenderJob& job_;
  Simulation litter_;
  view::Trails trails_;
  io::Progress progress_;
  std::size_t frame_ = 0;  // of the next one to begin
  std::atomic<bool> ended_ = false;
  io::Background thread_;  // last: it uses the others
};

/// The film's frames as PNG files in the folder NAME_frames, numbered by their steps, so that the
/// order of their names is theirs.
RenderJob frames_instead(const RenderJob& job) {
  RenderJob frames = job;
  frames.fps = 0;
  const std::filesystem::path path(job.output.path);
  const std::string folder = (path.parent_path() / (path.stem().string() + "_frames")).string();
  const std::size_t digits = std::clamp<std::size_t>(std::to_string(job.at.back()).size(), 5, 9);
  frames.output.path = folder + "/%0" + std::to_string(digits) + "d.png";
  io::note(io::no_ffmpeg_text(folder));
  return frames;
}

}  // namespace

void render(const RenderJob& job) {
  check_job(job);
  if (job.fps != 0 && !io::has_ffmpeg()) {
    io::refuse_existing(job.output.path, job.output.force);
    return render(frames_instead(job));
  }
  Picture picture(job.width, job.height, job.bar, job.look);
  view::Camera camera = view::framed(job.camera, job.params, picture.scene_aspect());
  const Headless headless(job.look);
  picture.refuse_large();
  check_outputs(job);
  Writer writer(job, camera);
  Stepper stepper(job);
  for (std::size_t i = 0; i < job.at.size(); ++i) {
    const auto [litter, trails] = stepper.next(writer);
    picture.remember(trails);
    if (job.follow) camera.look_at(litter.view().positions.mean(*job.follow));
    io::Image frame =
        telling(writer, [&] { return picture.draw(*headless.renderer, litter.view(), camera); });
    writer.write(litter, std::move(frame), camera, picture.look_entries());
  }
  writer.close();
}

}  // namespace pupflow::pictures
