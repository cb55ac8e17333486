#include "app/window/scene_desk.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <utility>
#include <vector>

#include "app/io/atomic_file.h"
#include "app/io/checkpoint.h"
#include "app/io/command_text.h"
#include "app/io/failure.h"
#include "app/io/file_kind.h"
#include "app/io/params_of_file.h"
#include "app/io/scene_file.h"
#include "app/io/scene_text.h"
#include "app/io/text.h"
#include "pupflow/simulation.h"

namespace pupflow::window {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".toml";

bool is_shipped(const std::string& name) {
  return std::ranges::count(io::shipped_scenes(), name, &io::ShippedScene::name) > 0;
}

std::string whole(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return error ? path : absolute.lexically_normal().string();
}

void take_scene(const std::string& source, Opened& opened) {
  std::vector<std::string> problems;
  const io::Scene scene = io::load_scene(source, problems);
  if (!problems.empty()) io::refuse(io::joined(problems, "; "));
  opened.is_scene = true;
  opened.params = scene.params;
  opened.description = scene.description;
  if (!scene.title.empty()) opened.title = io::printable(scene.title);
}

/// A checkpoint brings its litter, a recording only its recipe.
void take_hdf5(const std::string& path, Opened& opened) {
  const io::TextEntries entries = io::read_hdf5_text(path);
  const bool checkpoint =
      std::ranges::count(entries, std::pair<std::string, std::string>("kind", "checkpoint")) > 0;
  if (!checkpoint) {
    opened.params = io::params_of_file(path);
    return;
  }
  opened.from = io::read_checkpoint(path);
  opened.params = opened.from->params;
}

void take_file(const std::string& path, Opened& opened) {
  // A pipe may have the window wait for ever. What cannot be found, reading says.
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw io::Failure(io::ExitCode::bad_file, path + ": is no file that can be opened");
  }
  if (path.ends_with(kEnding)) return take_scene(path, opened);
  if (io::file_kind(path) == io::FileKind::hdf5) return take_hdf5(path, opened);
  opened.params = io::params_of_file(path);
}

/// Throws where no litter can be made of it.
void try_out(const Opened& opened) {
  try {
    if (opened.from) {
      const Simulation unused(*opened.from);
    } else {
      const Simulation unused(opened.params);
    }
  } catch (const std::bad_alloc&) {
    io::refuse(opened.title + ": not enough memory for its litter");
  } catch (const std::logic_error& error) {  // InvalidParams too
    std::string message = error.what();
    std::ranges::replace(message, '\n', ';');
    io::refuse(opened.title + ": " + message);
  }
}

}  // namespace

Opened read_scene(const std::string& source) {
  Opened opened;
  if (is_shipped(source)) {
    opened.source = opened.title = source;
    take_scene(source, opened);
    return opened;
  }
  opened.source = whole(source);
  opened.title = io::printable(fs::path(source).stem().string());
  try {
    take_file(opened.source, opened);
  } catch (const io::Failure& failure) {
    std::string message = failure.what();
    std::ranges::replace(message, '\n', ';');
    throw io::Failure(failure.code(), message);
  }
  try_out(opened);
  return opened;
}

SceneDesk::SceneDesk(const Begun& begun)
    : source_(begun.source), kept_(begun.recipe), set_by_hand_(begun.set_by_hand) {
  if (source_.empty() || source_ == "-") return;
  title_ = io::printable(fs::path(source_).stem().string());
  const bool shipped = is_shipped(source_);
  if (!shipped) source_ = whole(source_);
  if (!shipped && !source_.ends_with(kEnding)) return;
  Opened scene;
  scene.title = title_;
  take_scene(source_, scene);
  title_ = scene.title;
  description_ = scene.description;
  is_scene_ = true;
  base_ = scene.params;
}

void SceneDesk::take(const Opened& opened) {
  source_ = opened.source;
  title_ = opened.title;
  description_ = opened.description;
  is_scene_ = opened.is_scene;
  base_ = kept_ = opened.params;
  set_by_hand_ = opened.from ? opened.from->edited : std::nullopt;
}

std::string SceneDesk::file_name() const {
  const std::string stem = source_.empty() ? title() : fs::path(source_).stem().string();
  return io::printable(stem) + std::string(kEnding);
}

std::string SceneDesk::path() const {
  return is_scene_ && source_.ends_with(kEnding) ? source_ : std::string();
}

std::string SceneDesk::save(std::string path, const Params& recipe, std::int64_t step) {
  if (!path.ends_with(kEnding)) path += kEnding;
  path = whole(path);
  io::Scene scene{title_, description_, recipe};
  if (path != this->path()) {
    scene.title = io::printable(fs::path(path).stem().string());
    scene.description = "Saved in the live window after step " + std::to_string(step) + ".";
  }
  io::AtomicFile file(path, true);
  file.write(io::scene_text(scene));
  file.commit();
  source_ = path;
  title_ = scene.title;
  description_ = scene.description;
  is_scene_ = true;
  base_ = kept_ = recipe;
  return path;
}

std::string SceneDesk::command(const Params& recipe, std::int64_t steps) const {
  return is_scene_ ? io::command_text(source_, base_, recipe, steps)
                   : io::command_text("", Params{}, recipe, steps);
}

}  // namespace pupflow::window
