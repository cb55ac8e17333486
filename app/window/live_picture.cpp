// Pictures of the live window, and what its films are made of.
#include <memory>
#include <utility>

#include "app/io/failure.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/view/framing.h"
#include "app/window/live_window.h"
#include "app/window/picture_path.h"
#include "app/window/session/parameter_text.h"

namespace pupflow::window {
namespace {

/// What `litter` has else than `other`, as --set takes it.
std::string settings_text(const Params& litter, const Params& other) {
  std::vector<std::string> settings;
  for (const Parameter& parameter : parameters()) {
    if (parameter.get(litter) == parameter.get(other)) continue;
    settings.push_back(std::string(parameter.name) + '=' + format_value(parameter, litter));
  }
  return io::joined(settings, ",");
}

/// What `pupflow render` needs beside recipe and look to make the first litter's part again.
io::TextEntries text_of(const LiveState& state, const SeenPicture& picture,
                        const SeenPicture::Scene& scene) {
  const LitterView litter = state.view();
  io::TextEntries text{{"picture", "live"}, {"step", std::to_string(litter.step)}};
  const io::TextEntries camera = pictures::camera_entries(scene.camera);
  text.insert(text.end(), camera.begin(), camera.end());
  const PixelSize part = picture.part();
  text.emplace_back("size", std::to_string(part.width) + "x" + std::to_string(part.height));
  if (state.hash) text.emplace_back("hash", io::hash_text(*state.hash));
  if (picture.litters() > 1) {
    text.emplace_back("second", settings_text(state.second->view().params, litter.params));
  }
  return text;
}

}  // namespace

/// As the arena is split now.
SeenPicture LiveWindow::new_picture(const pictures::Look& look) const {
  return {controls_.picture_size.of(controls_.seen_size), split_, look};
}

/// The litters that are shown, with their marks, as that picture shows them.
SeenPicture::Scene LiveWindow::scene_for(const SeenPicture& picture) {
  const LiveState& state = runner_.snapshot();
  const LitterView first = state.view();
  const view::Camera camera = view::framed(arena_.camera(), first.params, picture.scene_aspect());
  SeenPicture::Scene scene{{}, camera, scale_};
  scene.litters.push_back({first, marks_.trails(), marks_of(first, camera), {}});
  if (picture.litters() > 1) {
    const LitterView second = state.second->view();
    scene.litters.front().title = differing_values(first.params, second.params);
    scene.litters.push_back({second, second_ ? second_->marks.trails() : view::Trails(),
                             marks_of(second, camera),
                             differing_values(second.params, first.params)});
  }
  return scene;
}

/// It is drawn and written with the arena; the window goes on meanwhile. A litter that plays has no hash
/// at hand: the next snapshot brings it.
void LiveWindow::take_picture() {
  struct Taken {
    SeenPicture picture;
    SeenPicture::Scene scene;
    io::TextEntries text;
    std::string path, problem;
  };
  const LiveState& state = runner_.snapshot();
  if (!state.hash) {
    picture_waits_ = true;
    runner_.send(Hash{});
    runner_.request();  // also while nothing is shown
    schedule_.snapshot_requested();
    return;
  }
  std::shared_ptr<Taken> taken;
  try {
    SeenPicture picture = new_picture(controls_.look);
    picture.refuse_large();
    SeenPicture::Scene scene = scene_for(picture);
    taken = std::make_shared<Taken>(Taken{std::move(picture), std::move(scene), {}, {}, {}});
  } catch (const io::Failure& failure) {
    show(failure.what());
    return;
  }
  taken->text = text_of(state, taken->picture, taken->scene);
  const auto write = [taken, pattern = job_.screenshot,
                      options = pictures::png_options(controls_.look)](gl::Renderer& renderer) {
    try {
      const LitterView& litter = taken->scene.litters.front().litter;
      taken->path = picture_path(pattern, litter.step);
      const io::Image image = taken->picture.draw(renderer, taken->scene);
      const io::TextEntries look = taken->picture.look_entries();
      taken->text.insert(taken->text.end(), look.begin(), look.end());
      io::write_png(taken->path, image, io::provenance(litter.recipe, taken->text), false, options);
    } catch (const io::Failure& failure) {
      taken->problem = failure.what();  // a full disk does not end the run
    }
  };
  arena_.start(write, [this, taken] {
    if (taken->problem.empty()) events_.screenshot(taken->path);
    show(taken->problem.empty() ? "saved " + taken->path + ", " + size_text(taken->picture.size())
                                : taken->problem);
  });
}

}  // namespace pupflow::window
