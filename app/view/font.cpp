#include "app/view/font.h"

extern "C" {
extern const std::byte pupflow_font_begin[];
extern const std::byte pupflow_font_end[];
}

namespace pupflow::view {

std::span<const std::byte> font_file() {
  return {pupflow_font_begin, pupflow_font_end};
}

}  // namespace pupflow::view
