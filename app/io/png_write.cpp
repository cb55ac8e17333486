#include <png.h>

#include <csetjmp>
#include <stdexcept>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/png.h"

namespace pupflow::io {
namespace {

bool is_ascii(const std::string& text) {
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0x80) != 0) return false;
  }
  return true;
}

/// libpng's view of `text`; the pointers are valid as long as `text` is.
std::vector<png_text> text_chunks(TextEntries& text) {
  std::vector<png_text> chunks(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto& [key, value] = text[i];
    png_text& chunk = chunks[i];
    chunk = {};
    chunk.key = key.data();
    chunk.text = value.data();
    if (is_ascii(value)) {
      chunk.compression = PNG_TEXT_COMPRESSION_NONE;
      chunk.text_length = value.size();
    } else {
      chunk.compression = PNG_ITXT_COMPRESSION_NONE;
      chunk.itxt_length = value.size();
    }
  }
  return chunks;
}

/// Row `y` of an image without its alpha.
void take_rgb(const Image& image, int y, std::vector<std::uint8_t>& rgb) {
  const std::uint8_t* rgba = image.pixel(0, y);
  for (std::size_t i = 0; i < static_cast<std::size_t>(image.width); ++i) {
    for (std::size_t c = 0; c < 3; ++c) rgb[3 * i + c] = rgba[4 * i + c];
  }
}

/// What the callbacks of libpng reach: where the bytes go and what went wrong.
struct Sink {
  std::string bytes;
  std::string error;
};

void append(png_structp png, png_bytep data, std::size_t size) {
  static_cast<Sink*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<char*>(data), size);
}

void flush(png_structp) {}

void note_error(png_structp png, png_const_charp message) {
  static_cast<Sink*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void note_warning(png_structp png, png_const_charp message) {
  note_error(png, message);  // about our own data: as bad as an error
}

/// False after an error, told in `sink`. libpng leaves by longjmp, so nothing with a destructor may
/// live in this frame.
bool encode(png_structp png, png_infop info, Sink& sink, const Image& image,
            std::vector<std::uint8_t>& rgb, std::vector<png_text>& chunks,
            const PngOptions& options) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &sink, append, flush);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  // A third of the time of libpng's defaults at a sixth more bytes.
  png_set_compression_level(png, 1);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8,
               options.alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (options.dpi > 0) {
    const auto per_metre = static_cast<png_uint_32>(options.dpi / 0.0254 + 0.5);
    png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
  }
  if (!chunks.empty()) png_set_text(png, info, chunks.data(), static_cast<int>(chunks.size()));
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) {
    if (!options.alpha) take_rgb(image, y, rgb);
    png_write_row(png, options.alpha ? image.pixel(0, y) : rgb.data());
  }
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

void write_png(const std::string& path, const Image& image, const TextEntries& text, bool force,
               const PngOptions& options) {
  if (image.width <= 0 || image.height <= 0) {
    throw std::invalid_argument("write_png: the image is empty");
  }
  AtomicFile file(path, force);
  std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(image.width));
  TextEntries own_text = text;  // libpng asks for text that it might write to
  std::vector<png_text> chunks = text_chunks(own_text);
  Sink sink;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, note_error, note_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool done = info && encode(png, info, sink, image, rgb, chunks, options);
  png_destroy_write_struct(&png, &info);
  if (!done) throw Failure(ExitCode::bad_file, path + ": cannot write PNG: " + sink.error);
  file.write(sink.bytes);
  file.commit();
}

}  // namespace pupflow::io
