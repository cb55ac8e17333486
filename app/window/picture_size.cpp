#include "app/window/picture_size.h"

#include <algorithm>
#include <array>

#include "app/io/text.h"
#include "app/pictures/look.h"

namespace pupflow::window {
namespace {

constexpr std::array kOffered{OfferedSize{"seen", "As seen", {}},
                              OfferedSize{"twice", "Twice as large", {.times = 2}},
                              OfferedSize{"4k", "4K", {.pixels = {3840, 2160}}}};

bool fits(int side) {
  return side >= pictures::kSmallestSide && side <= pictures::kLargestSide;
}

}  // namespace

PixelSize PictureSize::of(PixelSize seen) const {
  if (pixels.width > 0) return pixels;
  const auto side = [&](int length) {
    return std::clamp(times * length, pictures::kSmallestSide, pictures::kLargestSide);
  };
  return {side(seen.width), side(seen.height)};
}

std::span<const OfferedSize> offered_sizes() {
  return kOffered;
}

std::variant<PixelSize, std::string> read_size(std::string_view text) {
  constexpr std::string_view kTimes = "\u00d7";
  std::string plain(text);
  if (const std::size_t sign = plain.find(kTimes); sign != plain.npos) {
    plain.replace(sign, kTimes.size(), "x");
  }
  std::erase(plain, ' ');
  const auto sides = io::split(plain, 'x');
  if (sides.size() == 2) {
    const auto width = io::read_number<int>(sides[0]), height = io::read_number<int>(sides[1]);
    if (width && height && fits(*width) && fits(*height)) return PixelSize{*width, *height};
  }
  return "takes WIDTHxHEIGHT, each " + std::to_string(pictures::kSmallestSide) + " \u2026 " +
         std::to_string(pictures::kLargestSide);
}

std::string size_text(PixelSize size) {
  return std::to_string(size.width) + " \u00d7 " + std::to_string(size.height);
}

}  // namespace pupflow::window
