#include "app/window/settings.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/io/toml_depth.h"
#include "app/io/toml_text.h"
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

/// Where the file is wrong, and what would be right.
[[noreturn]] void refuse_file(const std::string& name, const toml::source_region& where,
                              const std::string& message) {
  throw io::Failure(io::ExitCode::bad_file, name + ":" + std::to_string(where.begin.line) + ":" +
                                                std::to_string(where.begin.column) + ": " +
                                                message);
}

class Reader {
 public:
  Reader(const toml::table& table, const std::string& name) : table_(table), name_(name) {}

  void whole(const char* key, int& value, int low, int high) {
    take<std::int64_t>(key, std::to_string(low) + " to " + std::to_string(high),
                       [&](std::int64_t number) {
                         if (number < low || number > high) return false;
                         value = static_cast<int>(number);
                         return true;
                       });
  }
  void scale(const char* key, double& value) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    const std::optional<double> number = node->value<double>();
    if (!number || !(*number >= kSmallestScale) || *number > kLargestScale) {
      wrong(key, *node, io::number_text(kSmallestScale) + " to " + io::number_text(kLargestScale));
    }
    value = *number;
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
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    const toml::array* items = node->as_array();
    if (items == nullptr || items->size() > kMostRecent) {
      wrong(key, *node, "a list of at most " + std::to_string(kMostRecent) + " names");
    }
    for (const toml::node& item : *items) {
      const auto word = item.value_exact<std::string>();
      if (!word || word->empty() || word->size() > kLongestName)
        wrong(key, item, "a list of names");
      values.push_back(*word);
    }
  }

 private:
  template <class Type, class Use>
  void take(const char* key, const std::string& right, const Use& use) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    const std::optional<Type> value = node->value_exact<Type>();
    if (!value || !use(*value)) wrong(key, *node, right);
  }

  [[noreturn]] void wrong(const char* key, const toml::node& node, const std::string& right) {
    refuse_file(name_, node.source(), std::string(key) + " must be " + right);
  }

  const toml::table& table_;
  const std::string& name_;
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
  if (const std::string deep = io::too_deep(text); !deep.empty()) {
    throw io::Failure(io::ExitCode::bad_file, name + ":" + deep);
  }
  Settings settings;
  try {
    const toml::table table = toml::parse(text, name);
    each(Reader(table, name), settings);
  } catch (const toml::parse_error& error) {
    refuse_file(name, error.source(), std::string(error.description()));
  }
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
