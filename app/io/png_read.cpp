#include <png.h>

#include <csetjmp>
#include <cstring>
#include <string_view>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/png.h"
#include "app/io/png_memory.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;
constexpr std::size_t kLargestPicture = std::size_t{1} << 31;  // bytes of its pixels

Failure no_png(const std::string& path, const std::string& reason) {
  return {ExitCode::bad_file, path + ": cannot read PNG: " + reason};
}

/// What is wrong with the sizes of the chunks in `bytes`, which libpng would take memory for; empty
/// where nothing is.
std::string wrong_chunk(std::string_view bytes) {
  constexpr std::size_t kLongestText = std::size_t{1} << 24;
  constexpr std::size_t kSignature = 8, kAround = 12;  // length, type and checksum of a chunk
  for (std::size_t at = kSignature; at < bytes.size();) {
    const std::string_view rest = bytes.substr(at);
    if (rest.size() < kAround) return "it ends too early";
    std::size_t length = 0;
    for (const char byte : rest.substr(0, 4))
      length = length << 8 | static_cast<unsigned char>(byte);
    if (length > rest.size() - kAround) return "it ends too early";
    const std::string_view type = rest.substr(4, 4);
    if (type == "IEND") break;
    if (type != "IDAT" && length > kLongestText) {
      return "a " + printable(type) + " chunk has " + std::to_string(length) +
             " bytes, more than " + std::to_string(kLongestText);
    }
    at += kAround + length;
  }
  return {};
}

/// The bytes of a file whose chunks have possible sizes.
std::string checked_bytes(const std::string& path) {
  std::string bytes = read_file(path, kLargestFile);
  if (const std::string wrong = wrong_chunk(bytes); !wrong.empty()) throw no_png(path, wrong);
  return bytes;
}

/// What the callbacks of libpng reach: the file's bytes and what went wrong.
struct Source {
  std::string bytes;
  std::size_t position = 0;
  std::string error;
};

void note_error(png_structp png, png_const_charp message) {
  static_cast<Source*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void accept_warning(png_structp, png_const_charp) {}  // what libpng can put right is no concern

void take(png_structp png, png_bytep data, std::size_t size) {
  Source& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (source.bytes.size() - source.position < size) png_error(png, "it ends too early");
  std::memcpy(data, source.bytes.data() + source.position, size);
  source.position += size;
}

/// False after an error, told in `source`. libpng leaves by longjmp, so nothing with a destructor
/// may live in this frame.
bool read_chunks(png_structp png, png_infop info, png_infop end, Source& source) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_read_fn(png, &source, take);
  png_read_info(png, info);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  // libpng finds what follows the pixels only by way of them.
  for (png_uint_32 row = 0; row < png_get_image_height(png, info); ++row) {
    if (interrupted()) png_error(png, "interrupted");
    for (int pass = 0; pass < passes; ++pass) png_read_row(png, nullptr, nullptr);
  }
  png_read_end(png, end);
  return true;
}

void append_text(png_structp png, png_infop info, TextEntries& entries) {
  png_textp chunks = nullptr;
  int count = 0;
  png_get_text(png, info, &chunks, &count);
  for (int i = 0; i < count; ++i) {
    entries.emplace_back(chunks[i].key, chunks[i].text ? chunks[i].text : "");
  }
}

}  // namespace

Image read_png(const std::string& path) {
  return read_png(checked_bytes(path), path);
}

Image read_png(std::string_view bytes, const std::string& name) {
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) {
    throw no_png(name, png.message);
  }
  png.format = PNG_FORMAT_RGBA;
  if (std::uint64_t{4} * png.width * png.height > kLargestPicture) {
    png_image_free(&png);
    throw no_png(name, "it has " + std::to_string(png.width) + " x " + std::to_string(png.height) +
                           " pixels, more than memory is taken for");
  }
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (!png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr)) {
    throw no_png(name, png.message);
  }
  return image;
}

TextEntries read_png_text(const std::string& path) {
  Source source;
  source.bytes = checked_bytes(path);
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, note_error, accept_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  png_infop end = info ? png_create_info_struct(png) : nullptr;
  TextEntries entries;
  const bool done = end && read_chunks(png, info, end, source);
  if (done) {
    append_text(png, info, entries);
    append_text(png, end, entries);
  }
  png_destroy_read_struct(&png, &info, &end);
  if (!done && interrupted())
    throw Failure(ExitCode::interrupted, "interrupted while reading " + path);
  if (!done) throw no_png(path, source.error);
  return entries;
}

}  // namespace pupflow::io
