#include "app/view/text.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cmath>
#include <cstdint>
#include <functional>
#include <new>
#include <string_view>

#include "app/io/failure.h"
#include "app/view/canvas.h"
#include "app/view/font.h"

namespace pupflow::view {

namespace {

constexpr double kSubscriptSize = 0.72, kSubscriptDrop = 0.2;  // of the em
constexpr double kSlant = 0.21;                                // 12 degrees, for italics

/// The font is part of the program, so what fails here is an allocation, which FreeType does not
/// always say.
void require(FT_Error error, const char* what) {
  if (error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
  if (error == 0) return;
  throw io::Failure(io::ExitCode::no_context,
                    std::string("FreeType cannot ") + what + "; there may not be enough memory");
}

/// Takes one character off the front of `text`; U+FFFD for bytes that are no UTF-8.
char32_t next_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  char32_t code = length == 1 ? first : first & (0x7F >> length);
  if ((first & 0xC0) == 0x80 || first >= 0xF8 || length > text.size()) {
    text.remove_prefix(1);
    return U'\uFFFD';
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) {
      text.remove_prefix(i);
      return U'\uFFFD';
    }
    code = code << 6 | (byte(i) & 0x3F);
  }
  text.remove_prefix(length);
  return code;
}

}  // namespace

struct TextPainter::FreeType {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  FreeType() {
    require(FT_Init_FreeType(&library), "start");
    const auto file = font_file();
    require(FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(file.data()),
                               static_cast<FT_Long>(file.size()), 0, &face),
            "read the embedded font");
  }
  ~FreeType() { FT_Done_FreeType(library); }
  FreeType(const FreeType&) = delete;
  FreeType& operator=(const FreeType&) = delete;

  /// Sets `line` from x = 0 and gives each pixel of its glyphs to `pixel` with its coverage, y
  /// downwards from the baseline. Glyphs stand at whole pixels plus the fraction of `start`.
  /// Returns the width.
  double set(const TextLine& line, double size, double start,
             const std::function<void(int, int, double)>& pixel) {
    double pen = start;
    for (const TextRun& run : line) {
      const bool lowered = run.style == TextRun::Style::subscript;
      const double em = lowered ? kSubscriptSize * size : size;
      require(FT_Set_Char_Size(face, 0, std::lround(64 * em), 72, 72), "scale the font");
      FT_Matrix slant{0x10000,
                      run.style == TextRun::Style::italic ? std::lround(kSlant * 0x10000) : 0, 0,
                      0x10000};
      FT_UInt previous = 0;
      for (std::string_view rest = run.text; !rest.empty();) {
        const FT_UInt glyph = FT_Get_Char_Index(face, next_character(rest));
        FT_Vector kerning{0, 0};
        FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNFITTED, &kerning);
        pen += static_cast<double>(kerning.x) / 64;
        require(FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING), "load a glyph");
        const FT_GlyphSlot slot = face->glyph;
        const double advance = static_cast<double>(slot->linearHoriAdvance) / 65536;
        if (pixel) {
          FT_Outline_Transform(&slot->outline, &slant);
          FT_Outline_Translate(&slot->outline, std::lround(64 * (pen - std::floor(pen))),
                               lowered ? -std::lround(64 * kSubscriptDrop * size) : 0);
          require(FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL), "draw a glyph");
          const FT_Bitmap& bitmap = slot->bitmap;
          for (unsigned y = 0; y < bitmap.rows; ++y) {
            for (unsigned x = 0; x < bitmap.width; ++x) {
              const auto cover = bitmap.buffer[y * static_cast<unsigned>(bitmap.pitch) + x];
              if (cover == 0) continue;
              pixel(static_cast<int>(std::floor(pen)) + slot->bitmap_left + static_cast<int>(x),
                    static_cast<int>(y) - slot->bitmap_top, cover / 255.0);
            }
          }
        }
        pen += advance;
        previous = glyph;
      }
    }
    return pen - start;
  }
};

TextLine symbol(const std::string& letter, const std::string& subscript) {
  return {{letter, TextRun::Style::italic}, {subscript, TextRun::Style::subscript}};
}

TextLine symbol(std::string_view written) {
  const std::size_t mark = written.find('_');
  if (mark == std::string_view::npos) return {{std::string(written), TextRun::Style::italic}};
  return symbol(std::string(written.substr(0, mark)), std::string(written.substr(mark + 1)));
}

TextLine operator+(TextLine a, const TextLine& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TextLine operator+(TextLine a, const std::string& upright) {
  a.push_back({upright, TextRun::Style::upright});
  return a;
}

TextPainter::TextPainter() : freetype_(std::make_unique<FreeType>()) {}
TextPainter::~TextPainter() = default;

double TextPainter::width(const TextLine& line, double size) {
  return freetype_->set(line, size, 0, nullptr);
}

void TextPainter::draw(io::Image& image, double x, double y, const TextLine& line, double size,
                       Rgb color, Align align) {
  const double share = align == Align::left ? 0 : align == Align::centre ? 0.5 : 1;
  const double start = share == 0 ? x : x - share * width(line, size);
  const int baseline = static_cast<int>(std::lround(y));
  freetype_->set(line, size, start, [&](int px, int py, double cover) {
    blend(image, px, baseline + py, color, cover);
  });
}

void TextPainter::draw_upwards(io::Image& image, double x, double y, const TextLine& line,
                               double size, Rgb color) {
  const int column = static_cast<int>(std::lround(x));
  const int middle = static_cast<int>(std::lround(y));
  freetype_->set(line, size, -width(line, size) / 2, [&](int px, int py, double cover) {
    blend(image, column + py, middle - px, color, cover);
  });
}

}  // namespace pupflow::view
