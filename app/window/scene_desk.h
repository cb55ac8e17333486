// Which scene the window shows, where it came from, and saving it.
#pragma once

#include <optional>
#include <string>

#include "pupflow/snapshot.h"

namespace pupflow::window {

/// A litter to show.
struct Opened {
  std::string source;            // a shipped scene's name or a whole path; empty: neither
  std::string title;             // for people
  bool is_scene = false;         // `pupflow run SOURCE` runs it
  std::string description;       // of a scene
  Params params;                 // the recipe
  std::optional<Snapshot> from;  // a litter of that recipe to begin with; none: a new one
};

/// Reads a shipped scene, a scene file, a checkpoint, or any other file of this program that carries
/// a recipe. Throws Failure, in one line, also where the recipe or the litter is unsound.
Opened read_scene(const std::string& source);

/// What the command line brought: `source` as typed (empty: neither scene nor file), and the litter
/// that it made of it and of its options.
struct Begun {
  std::string source;
  Params recipe;
  std::optional<std::int64_t> set_by_hand;  // Snapshot::edited
};

/// Keeps track of what is saved. Not a thread, not a window.
class SceneDesk {
 public:
  explicit SceneDesk(const Begun& begun);

  /// Another one is shown from now on.
  void take(const Opened& opened);

  /// Whether a run of `recipe` holds more than was opened or saved.
  bool changed(const Params& recipe) const { return recipe != kept_; }

  /// The scene's name, for people, and one for the file that it may be saved to.
  std::string title() const { return title_.empty() ? "untitled" : title_; }
  const std::string& description() const { return description_; }
  std::string file_name() const;

  /// The file that it can be saved to again; empty: none yet.
  std::string path() const;

  /// Writes `recipe` as a scene to `path`, to which ".toml" is added if it is missing; replaces what
  /// is there. Returns the whole path. Throws Failure.
  std::string save(std::string path, const Params& recipe, std::int64_t step);

  /// The command that repeats the first `steps` steps of a run of `recipe`.
  std::string command(const Params& recipe, std::int64_t steps) const;

  /// The step after which pups of the checkpoint were set by hand, which no recipe tells.
  std::optional<std::int64_t> set_by_hand() const { return set_by_hand_; }

 private:
  std::string source_, title_, description_;  // as in Opened
  bool is_scene_ = false;
  Params base_;  // what `pupflow run SOURCE` begins with
  Params kept_;  // the recipe that was opened or saved
  std::optional<std::int64_t> set_by_hand_;
};

}  // namespace pupflow::window
