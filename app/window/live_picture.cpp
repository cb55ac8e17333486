// Pictures of the live window, and what its films are made of.
#include <algorithm>
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

}  // namespace

/// As the arena is split now.
SeenPicture LiveWindow::new_picture(const pictures::Look& look) const {
  return {controls_.picture_size.of(controls_.seen_size), split_, look};
}

view::Camera LiveWindow::camera_of(const SeenPicture& picture) const {
  return view::framed(arena_.camera(), runner_.snapshot().view().params, picture.scene_aspect());
}

/// The picture of the litters that are shown, with their marks.
io::Image LiveWindow::paint_picture(SeenPicture& picture) {
  const LiveState& state = runner_.snapshot();
  const view::Camera camera = camera_of(picture);
  const LitterView first = state.view();
  std::vector<SeenPicture::Litter> litters;
  litters.push_back({first, &marks_.trails(), marks_of(first, camera), {}});
  if (picture.litters() > 1) {
    const LitterView second = state.second->view();
    litters.front().title = differing_values(first.params, second.params);
    litters.push_back({second, second_ ? &second_->marks.trails() : nullptr,
                       marks_of(second, camera), differing_values(second.params, first.params)});
  }
  return picture.draw(arena_.lend_renderer(), std::move(litters), camera, scale_);
}

void LiveWindow::take_picture() {
  const LiveState& state = runner_.snapshot();
  const LitterView litter = state.view();
  try {
    const std::string path = picture_path(job_.screenshot, litter.step);
    SeenPicture picture = new_picture(controls_.look);
    picture.refuse_large();
    const io::Image image = paint_picture(picture);
    io::TextEntries extra{{"picture", "live"}, {"step", std::to_string(litter.step)}};
    const auto add = [&](const io::TextEntries& more) {
      extra.insert(extra.end(), more.begin(), more.end());
    };
    add(pictures::camera_entries(camera_of(picture)));
    const PixelSize part = picture.part();
    add({{"size", std::to_string(part.width) + "x" + std::to_string(part.height)}});
    if (state.hash) add({{"hash", io::hash_text(*state.hash)}});
    if (picture.litters() > 1) {
      add({{"second", settings_text(state.second->view().params, litter.params)}});
    }
    add(picture.look_entries());
    io::write_png(path, image, io::provenance(litter.recipe, extra), false,
                  pictures::png_options(controls_.look));
    events_.screenshot(path);
    show("saved " + path + ", " + size_text(picture.size()));
  } catch (const io::Failure& failure) {
    show(failure.what());  // a full disk does not end the run
  }
}

}  // namespace pupflow::window
