#include "app/window/settings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/io/toml_text.h"
#include "app/io/toml_values.h"
#include "app/view/colormap.h"

namespace pupflow::window {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = 1 << 16;
constexpr std::size_t kLongestName = 4096;

/// Every setting by its key: reader and writer go through this one list.
template <class Visitor, class Of>
void each(Visitor&& visit, Of& settings) {
  visit.whole("width", settings.width, pictures::kSmallestSide, pictures::kLargestSide);
  visit.whole("height", settings.height, pictures::kSmallestSide, pictures::kLargestSide);
  visit.scale("ui_scale", settings.ui_scale);
  visit.name("theme", settings.theme, kThemeNames);
  visit.name("quality", settings.quality, view::kQualityNames);
  visit.name("draw", settings.draw, view::kDrawNames);
  visit.map("colormap", settings.colormap);
  visit.flag("panels", settings.panels);
  visit.flag("pause_minimised", settings.pause_minimised);
  visit.list("recent", settings.recent);
}

class Writer {
 public:
  void whole(const char* key, int value, int, int) { line(key, std::to_string(value)); }
  void scale(const char* key, double value) {
    if (value > 0) line(key, io::toml_number(value));
  }
  template <class Enum, std::size_t N>
  void name(const char* key, Enum value, const std::array<std::string_view, N>& names) {
    line(key, io::toml_string(names[static_cast<std::size_t>(value)]));
  }
  void map(const char* key, const std::string& value) {
    if (!value.empty()) line(key, io::toml_string(value));
  }
  void flag(const char* key, bool value) { line(key, value ? "true" : "false"); }
  void list(const char* key, const std::vector<std::string>& values) {
    line(key, "[" + io::joined(values, ", ", io::toml_string) + "]");
  }

  std::string text;

 private:
  void line(const char* key, const std::string& value) {
    text += std::string(key) + " = " + value + "\n";
  }
};

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : values_(io::toml_values(text, name)) {}

  void whole(const char* key, int& value, int low, int high) {
    take<std::int64_t>(key, std::to_string(low) + " to " + std::to_string(high),
                       [&](std::int64_t number) {
                         if (number < low || number > high) return false;
                         value = static_cast<int>(number);
                         return true;
                       });
  }
  void scale(const char* key, double& value) {
    const std::string right =
        io::number_text(kSmallestScale) + " to " + io::number_text(kLargestScale);
    const auto set = [&](auto number) {
      value = static_cast<double>(number);
      return value >= kSmallestScale && value <= kLargestScale;
    };
    take<double, std::int64_t>(key, right, set);
  }
  template <class Enum, std::size_t N>
  void name(const char* key, Enum& value, const std::array<std::string_view, N>& names) {
    take<std::string>(key, io::joined(names, " or "), [&](const std::string& word) {
      const auto found = std::ranges::find(names, word);
      if (found != names.end()) value = static_cast<Enum>(found - names.begin());
      return found != names.end();
    });
  }
  void map(const char* key, std::string& value) {
    const auto names = view::colormap_names();
    take<std::string>(key, io::joined(names, " or "), [&](const std::string& word) {
      value = word;
      return std::ranges::count(names, word) > 0;
    });
  }
  void flag(const char* key, bool& value) {
    take<bool>(key, "true or false", [&](bool given) {
      value = given;
      return true;
    });
  }
  void list(const char* key, std::vector<std::string>& values) {
    using Words = std::vector<std::string>;
    const auto is_name = [](const std::string& word) {
      return !word.empty() && word.size() <= kLongestName;
    };
    take<Words>(key, "a list of at most " + std::to_string(kMostRecent) + " names",
                [&](const Words& words) {
                  values = words;
                  return words.size() <= kMostRecent && std::ranges::all_of(words, is_name);
                });
  }

 private:
  /// Hands the value of `key`, if there is one, to `use`, which returns whether it is right.
  template <class... Types, class Use>
  void take(const char* key, const std::string& right, const Use& use) {
    const auto found = values_.find(key);
    if (found == values_.end()) return;
    const auto used = [&](const auto* value) { return value != nullptr && use(*value); };
    if ((used(std::get_if<Types>(&found->second.value)) || ...)) return;
    throw io::Failure(io::ExitCode::bad_file,
                      found->second.where + ": " + key + " must be " + right);
  }

  const std::map<std::string, io::TomlValue, std::less<>> values_;
};

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

}  // namespace

void Settings::remember(const std::string& path) {
  if (path.empty() || path.size() > kLongestName || io::printable(path) != path) return;
  std::erase(recent, path);
  recent.insert(recent.begin(), path);
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

std::string settings_path() {
  // As the XDG base directory specification says: a path that is not absolute is ignored.
  fs::path folder = variable("XDG_CONFIG_HOME");
  if (!folder.is_absolute()) {
    const fs::path home = variable("HOME");
    if (!home.is_absolute()) return {};
    folder = home / ".config";
  }
  return (folder / "pupflow" / "settings.toml").string();
}

std::string settings_text(const Settings& settings) {
  Writer writer;
  each(writer, settings);
  return writer.text;
}

Settings parse_settings(std::string_view text, const std::string& name) {
  Settings settings;
  each(Reader(text, name), settings);
  return settings;
}

Settings read_settings(const std::string& path, std::string& problem) {
  std::error_code error;
  if (path.empty() || !fs::exists(fs::symlink_status(path, error))) return {};
  try {
    if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {  // a pipe has no end
      throw io::Failure(io::ExitCode::bad_file, path + ": is no file with settings");
    }
    const std::string text = io::read_beginning(path, kLargestFile + 1);
    if (text.size() > kLargestFile) {
      throw io::Failure(io::ExitCode::bad_file, path + ": is too large for settings");
    }
    return parse_settings(text, path);
  } catch (const io::Failure& failure) {
    const std::string aside = path + ".broken";
    fs::rename(path, aside, error);
    problem = io::printable(failure.what()) +
              (error ? "; the settings are left alone" : "; it is now " + aside);
    return {};
  }
}

std::string write_settings(const std::string& path, const Settings& settings) {
  if (path.empty()) return "settings are not kept: neither XDG_CONFIG_HOME nor HOME names a folder";
  try {
    std::error_code error;
    fs::create_directories(fs::path(path).parent_path(), error);  // what fails, the file says
    io::AtomicFile file(path, true);
    file.write(settings_text(settings));
    file.commit();
    return {};
  } catch (const io::Failure& failure) {
    return "settings are not kept: " + io::printable(failure.what());
  }
}

}  // namespace pupflow::window
