// Pictures in memory, and PNG files with text in them.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pupflow::io {

/// Rows from top to bottom, four bytes a pixel: red, green, blue, alpha.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  Image() = default;
  Image(int w, int h) : width(w), height(h), rgba(4 * static_cast<std::size_t>(w) * h) {}
  std::uint8_t* pixel(int x, int y) { return &rgba[4 * (static_cast<std::size_t>(y) * width + x)]; }
  const std::uint8_t* pixel(int x, int y) const {
    return &rgba[4 * (static_cast<std::size_t>(y) * width + x)];
  }
};

using TextEntries = std::vector<std::pair<std::string, std::string>>;

struct PngOptions {
  bool alpha = false;  // keep the image's; without, the PNG is opaque
  int dpi = 0;         // dots per inch that the file names; 0: none
};

/// Writes a PNG with `text` as text chunks (iTXt where a value is not ASCII), whole or not at all.
/// Throws Failure(bad_file); without `force` also when the file exists.
void write_png(const std::string& path, const Image& image, const TextEntries& text, bool force,
               const PngOptions& options = {});

/// Reads any PNG as RGBA. Throws Failure(bad_file).
Image read_png(const std::string& path);

/// The text chunks of a PNG, in file order. Throws Failure(bad_file).
TextEntries read_png_text(const std::string& path);

}  // namespace pupflow::io
