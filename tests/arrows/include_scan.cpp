#include "tests/arrows/include_scan.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace pupflow::arrows {
namespace {

/// A folder or a single file, and the other folders or headers that it may include. A file's own
/// row counts before its folder's.
struct Layer {
  std::string_view folder;
  std::vector<std::string_view> may_include;
};

/// The headers of a library, and the only folders whose files may include them.
struct Library {
  std::string_view prefix;
  std::vector<std::string_view> open_to;
};

constexpr std::string_view kPublic = "engine/include/pupflow";

// The arrows: each folder includes only what stands above it. Of the engine that is its public
// headers; reports and benchmarks measure its parts, so they see those, too.
const std::vector<Layer> kLayers = {
    {kPublic, {}},
    {"engine", {kPublic}},
    {"app/io", {kPublic}},
    {"app/study", {kPublic, "app/io"}},
    {"app/report", {kPublic, "engine", "app/io", "app/study"}},
    {"app/mpi", {kPublic, "app/io", "app/study/executor.h"}},
    {"app/view", {kPublic, "app/io"}},
    {"app/gl", {kPublic, "app/io", "app/view"}},
    {"app/context", {"app/io", "app/gl/load.h"}},
    {"app/pictures", {kPublic, "app/io", "app/view", "app/gl", "app/context"}},
    {"app/window", {kPublic, "app/io", "app/view", "app/gl", "app/context", "app/pictures"}},
    {"app/pictures/module.cpp", {"app/io", "app/context", "app/pictures", "app/window"}},
    {"app/cli",
     {kPublic, "app/io", "app/study", "app/report", "app/view", "app/mpi/interface.h",
      "app/pictures/graphics.h"}},
    {"bench", {kPublic, "engine", "app/io", "app/view", "app/gl", "app/context", "app/pictures"}},
};

// Graphics libraries stay on the graphics side; the rest stays where it is wrapped.
const std::vector<Library> kLibraries = {
    {"Eigen/",
     {kPublic, "engine", "app/study", "app/report", "app/view", "app/gl", "app/window",
      "app/pictures", "app/cli", "bench"}},
    {"armadillo", {"bench"}},
    {"benchmark/", {"bench"}},
    {"GL/", {"app/gl", "app/context", "app/window"}},
    {"EGL/", {"app/context"}},
    {"GLFW/", {"app/context", "app/window"}},
    {"imgui", {"app/window"}},
    {"png.h", {"app/io"}},
    {"ft2build.h", {"app/view"}},
    {"toml++/", {"app/io", "app/study"}},
    {"CLI/", {"app/cli"}},
    {"mpi.h", {"app/mpi"}},
};

bool starts_with_any(std::string_view text, const std::vector<std::string_view>& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](std::string_view prefix) { return text.starts_with(prefix); });
}

/// Where a header lies that an #include line names; public headers are named pupflow/NAME.
std::string place_of(std::string_view header) {
  const bool is_public = header.starts_with("pupflow/");
  return (is_public ? "engine/include/" : "") + std::string(header);
}

const Layer* layer_of(std::string_view file) {
  for (const Layer& layer : kLayers) {
    if (file == layer.folder) return &layer;
  }
  for (const Layer& layer : kLayers) {
    if (file.starts_with(std::string(layer.folder) + "/")) return &layer;
  }
  return nullptr;
}

/// Why `layer` may not include the project's own `header`; empty when it may.
std::string own_header_problem(const Layer& layer, std::string_view header) {
  const Layer* target = layer_of(place_of(header));
  if (target == nullptr) return "headers are named from the root, as engine/... or app/FOLDER/...";
  if (target == &layer || starts_with_any(place_of(header), layer.may_include)) return {};
  return std::string(layer.folder) + " may not include " + std::string(target->folder);
}

/// The same for a header of a library or of the system.
std::string other_header_problem(const Layer& layer, std::string_view header) {
  for (const Library& library : kLibraries) {
    if (!header.starts_with(library.prefix)) continue;
    if (std::count(library.open_to.begin(), library.open_to.end(), layer.folder) > 0) return {};
    return std::string(library.prefix) + " is closed to " + std::string(layer.folder);
  }
  const bool standard = header.find_first_of("./") == std::string_view::npos;
  if (standard || !layer.folder.starts_with("engine") || header == "immintrin.h") return {};
  return "the engine includes the C++ standard library, intrinsics and Eigen, nothing else";
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string include_problem(const Layer& layer, std::string_view header, bool quoted) {
  const bool of_library =
      std::any_of(kLibraries.begin(), kLibraries.end(),
                  [&](const Library& library) { return header.starts_with(library.prefix); });
  const bool own = layer_of(place_of(header)) != nullptr || (quoted && !of_library);
  return own ? own_header_problem(layer, header) : other_header_problem(layer, header);
}

}  // namespace

std::vector<Violation> scan_text(const std::string& file, const std::string& text) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  const Layer* layer = layer_of(file);
  if (layer == nullptr) return {{file, 1, "", "the folder has no row in the table of layers"}};

  std::vector<Violation> found;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_search(line, match, include)) continue;
    const std::string header = match[2];
    std::string reason = include_problem(*layer, header, match[1] == "\"");
    if (!reason.empty()) found.push_back({file, number, header, std::move(reason)});
  }
  return found;
}

std::vector<Violation> scan_tree(const std::filesystem::path& root, int& files) {
  files = 0;
  std::vector<Violation> found;
  for (const char* top : {"engine", "app", "bench"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      ++files;
      const std::string name = entry.path().lexically_relative(root).generic_string();
      const std::vector<Violation> in_file = scan_text(name, read_file(entry.path()));
      found.insert(found.end(), in_file.begin(), in_file.end());
    }
  }
  return found;
}

}  // namespace pupflow::arrows
