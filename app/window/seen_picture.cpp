#include "app/window/seen_picture.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/view/canvas.h"

namespace pupflow::window {
namespace {

constexpr view::Rgb kPaper{255, 255, 255}, kLine{208, 213, 219}, kInk{40, 40, 40};

/// Runs of text with what follows a '_' as subscripts.
view::TextLine line_of(std::string_view text) {
  view::TextLine line;
  while (!text.empty()) {
    const std::size_t mark = std::min(text.find('_'), text.size());
    if (mark > 0) line.push_back({std::string(text.substr(0, mark))});
    if (mark == text.size()) break;
    text.remove_prefix(mark + 1);
    const auto end = std::find_if_not(text.begin(), text.end(),
                                      [](unsigned char c) { return std::isalnum(c) != 0; });
    const auto length = static_cast<std::size_t>(end - text.begin());
    if (length > 0) {
      line.push_back({std::string(text.substr(0, length)), view::TextRun::Style::subscript});
    }
    text.remove_prefix(length);
  }
  return line;
}

int scene_width(const pictures::Picture& picture, int height) {
  return static_cast<int>(std::lround(picture.scene_aspect() * height));
}

}  // namespace

/// Both parts have a legend, so that their scenes are alike; that of the left one is cut off.
SeenPicture::SeenPicture(PixelSize size, Split split, const pictures::Look& look)
    : size_(size), part_(size), split_(split) {
  const auto make = [&] {
    return std::make_unique<pictures::Picture>(part_.width, part_.height, true, look);
  };
  if (split == Split::above) part_.height = std::max(size.height / 2, pictures::kSmallestSide);
  if (split == Split::beside) {
    // The legend's width depends a little on the part's.
    constexpr int kRounds = 4;
    int legend = 0;
    for (int round = 0; round < kRounds; ++round) {
      part_.width = std::max((size.width + legend) / 2, pictures::kSmallestSide);
      legend = part_.width - scene_width(*make(), part_.height);
    }
  }
  parts_.push_back(make());
  if (split != Split::none) parts_.push_back(make());
}

io::Image SeenPicture::draw(gl::Renderer& renderer, const Scene& scene) {
  std::vector<io::Image> images;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    pictures::Picture& part = *parts_[i];
    const Litter& shown = scene.litters.at(i);
    part.set_scale(scene.scale);
    part.mark(shown.marks);
    part.remember(shown.trails);
    images.push_back(part.draw(renderer, shown.litter, scene.camera));
  }
  if (split_ == Split::none) return std::move(images.front());
  io::Image all(size_.width, size_.height);
  view::fill(all, {0, 0, size_.width, size_.height}, kPaper);
  const int width = scene_width(*parts_.front(), part_.height);
  const bool beside = split_ == Split::beside;
  const int x = beside ? size_.width - part_.width : 0;
  const int y = beside ? 0 : size_.height - part_.height;
  view::blit(all, images.front(), 0, 0);
  view::blit(all, images.back(), x, y);  // over the first one's legend
  const int thick = std::max(1, size_.height / 900);
  view::fill(all,
             beside ? view::Box{x, 0, thick, size_.height} : view::Box{0, y, size_.width, thick},
             kLine);
  view::TextPainter text;
  const double size = parts_.front()->text_size();
  const auto title = [&](int left, int top, const std::string& words) {
    text.draw(all, left + width / 2.0, top + 1.7 * size, line_of(words), size, kInk,
              view::Align::centre);
  };
  title(0, 0, scene.litters.front().title);
  title(x, y, scene.litters.back().title);
  return all;
}

}  // namespace pupflow::window
