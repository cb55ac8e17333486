// The themes by name, for options and settings.
#pragma once

#include <array>
#include <string_view>

namespace pupflow::window {

enum class Theme { light, dark };
constexpr std::array<std::string_view, 2> kThemeNames{"light", "dark"};

}  // namespace pupflow::window
