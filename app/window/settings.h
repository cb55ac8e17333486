// What the window remembers of its user from one time to the next.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/view/drawing.h"
#include "app/window/live_job.h"
#include "app/window/theme_choice.h"

namespace pupflow::window {

/// The recent files that are remembered.
constexpr std::size_t kMostRecent = 10;

struct Settings {
  int width = kUsualWidth, height = kUsualHeight;  // of the window
  double ui_scale = 0;                             // 0: the display's
  Theme theme = Theme::light;
  view::Quality quality = view::Quality::normal;
  view::Draw draw = view::Draw::skin;
  std::string colormap;             // empty: that of the field's kind
  bool panels = true;               // open
  bool pause_minimised = false;     // a minimised window takes no steps
  std::vector<std::string> recent;  // whole paths, the last one first

  friend bool operator==(const Settings&, const Settings&) = default;

  /// Puts `path` in front of the recent ones, if text can name it.
  void remember(const std::string& path);
};

/// $XDG_CONFIG_HOME/pupflow/settings.toml, by default ~/.config/pupflow/settings.toml; empty where
/// there is neither.
std::string settings_path();

/// The settings as a TOML file.
std::string settings_text(const Settings& settings);

/// Reads what settings_text wrote. Unknown keys are ignored; those that are missing keep their
/// defaults. Throws Failure(bad_file), "NAME:line:column: ...", for anything else.
Settings parse_settings(std::string_view text, const std::string& name);

/// The settings of a file; the defaults where there is none. A file that cannot be used is renamed
/// to PATH.broken, which `problem` then says in one line.
Settings read_settings(const std::string& path, std::string& problem);

/// Writes them to `path`, whole or not at all, and makes its folder. Says in one line why it could
/// not; empty: it could.
std::string write_settings(const std::string& path, const Settings& settings);

}  // namespace pupflow::window
