// A scene. Invariant: every problem is one line that begins with its place; parameters that are sound
// come back the same from what outputs say of them.
#include "app/io/provenance.h"
#include "app/io/scene_file.h"
#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {

void one_input(std::string_view bytes) {
  std::vector<std::string> problems;
  const io::Scene scene = io::parse_scene(bytes, "scene.toml", problems);
  for (const std::string& problem : problems) {
    require_sound(problem);
    require(problem.starts_with("scene.toml:"), "a problem has no place: " + problem);
  }
  if (!problems.empty()) return;
  for (const Problem& problem : check(scene.params)) {
    require_sound(problem.message);
    return;
  }
  const io::TextEntries entries = io::provenance(scene.params);
  require(read_back([&] { return io::params_from(entries, "again"); }) == scene.params,
          "the parameters of a scene come back changed");
}

}  // namespace pupflow::fuzz
