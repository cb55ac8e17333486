#include "app/window/picture_path.h"

#include <filesystem>

#include "app/io/frame_path.h"

namespace pupflow::window {
namespace {

constexpr const char* kPattern = "pupflow-%05d.png";

}  // namespace

std::string picture_path(const std::string& pattern, std::int64_t step) {
  const std::string first = io::frame_path(pattern.empty() ? kPattern : pattern, step);
  const std::filesystem::path path(first);
  std::string candidate = first;
  for (int number = 2; std::filesystem::exists(candidate); ++number) {
    candidate = (path.parent_path() / path.stem()).string() + '-' + std::to_string(number) +
                path.extension().string();
  }
  return candidate;
}

}  // namespace pupflow::window
