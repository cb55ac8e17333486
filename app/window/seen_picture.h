// A picture of what the arena shows: one litter, or two that are compared.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/pictures/picture.h"
#include "app/window/picture_size.h"

namespace pupflow::window {

/// How litters share an area.
enum class Split { none, beside, above };

/// Pictures of one size, each of one litter or of two, which then have the same camera and colors.
class SeenPicture {
 public:
  struct Litter {
    LitterView litter;
    view::Trails trails;  // where its pups were
    view::Marks marks;    // painted beneath the overlays
    std::string title;    // what it differs by; subscripts stand behind a '_'
  };
  struct Scene {
    std::vector<Litter> litters;  // as many as the picture shows
    view::Camera camera;
    view::ColorScale scale;  // fitted
  };

  /// Throws as pictures::Picture does.
  SeenPicture(PixelSize size, Split split, const pictures::Look& look);

  /// Of all, and of a part with its legend: what `pupflow render` needs for the first litter.
  PixelSize size() const { return size_; }
  PixelSize part() const { return part_; }

  /// Litters that it shows.
  std::size_t litters() const { return parts_.size(); }

  /// Width over height of the part of the picture in which a litter stands.
  double scene_aspect() const { return parts_.front()->scene_aspect(); }

  /// Throws where driver or memory allow no such picture. A context must be current.
  void refuse_large() const { parts_.front()->refuse_large(); }

  /// Throws as Picture::draw.
  io::Image draw(gl::Renderer& renderer, const Scene& scene);

  /// What a file carries of the last picture, see Picture.
  io::TextEntries look_entries() const { return parts_.front()->look_entries(); }

 private:
  PixelSize size_, part_;
  Split split_;
  std::vector<std::unique_ptr<pictures::Picture>> parts_;
};

}  // namespace pupflow::window
