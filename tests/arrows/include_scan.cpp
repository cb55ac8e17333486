#include "tests/arrows/include_scan.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace pupflow::arrows {
namespace {

/// A folder, and the other folders or headers that it may include.
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
    {"app/export", {kPublic, "app/io"}},
    {"app/study", {kPublic, "app/io"}},
    {"app/verify", {kPublic, "app/io", "app/study"}},
    {"app/report", {kPublic, "engine", "app/io", "app/study"}},
    {"app/mpi", {kPublic, "app/io", "app/study/executor.h"}},
    {"app/view", {kPublic, "app/io"}},
    {"app/gl", {kPublic, "app/io", "app/view"}},
    {"app/context", {"app/io", "app/gl/load.h"}},
    {"app/pictures", {kPublic, "app/io", "app/view", "app/gl", "app/context"}},
    {"app/window", {kPublic, "app/io", "app/view", "app/gl", "app/context", "app/pictures"}},
    {"app/graphics", {"app/io", "app/context", "app/pictures", "app/window"}},
    {"app/cli",
     {kPublic, "app/io", "app/export", "app/study", "app/verify", "app/report", "app/view",
      "app/mpi/interface.h", "app/graphics/graphics.h", "app/pictures/look.h"}},
    {"python", {kPublic, "app/io", "app/view", "app/graphics/graphics.h", "app/pictures/image.h"}},
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
    {"hdf5", {"app/io"}},
    {"isa-l.h", {"app/io"}},
    {"png.h", {"app/io"}},
    {"ft2build.h", {"app/view"}},
    {"toml++/", {"app/io", "app/study"}},
    {"CLI/", {"app/cli"}},
    {"mpi.h", {"app/mpi"}},
    {"sstream", {"app/io"}},  // app/io/text_stream.h has one that says when memory ends
    {"zlib.h", {"app/export"}},
    {"pybind11/", {"python"}},
    {"Python.h", {"python"}},
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
  const bool of_system = header == "immintrin.h" || header == "unistd.h";  // unistd.h: getpid
  if (standard || !layer.folder.starts_with("engine") || of_system) return {};
  return "the engine includes the C++ standard library, intrinsics, unistd.h and Eigen, nothing "
         "else";
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

/// Calls `use(line number, header, quoted)` for each #include line.
template <class Use>
void for_each_include(const std::string& text, const Use& use) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, include)) use(number, match[2].str(), match[1] == "\"");
  }
}

/// The header and source file of one name are one unit; public headers belong to the engine.
std::string unit_of(const std::string& file) {
  const std::string public_folder = std::string(kPublic) + "/";
  const std::string unit = file.substr(0, file.rfind('.'));
  return unit.starts_with(public_folder) ? "engine/" + unit.substr(public_folder.size()) : unit;
}

/// The folder of a file in app/, with all folders within it.
std::string folder_of(const std::string& file) {
  return file.substr(0, file.find('/', file.find('/') + 1));
}

}  // namespace

std::vector<Violation> scan_text(const std::string& file, const std::string& text) {
  const Layer* layer = layer_of(file);
  if (layer == nullptr) return {{file, 1, "", "the folder has no row in the table of layers"}};

  std::vector<Violation> found;
  for_each_include(text, [&](int line, const std::string& header, bool quoted) {
    std::string reason = include_problem(*layer, header, quoted);
    if (!reason.empty()) found.push_back({file, line, header, std::move(reason)});
  });
  return found;
}

Graph include_graph(const Sources& sources, Node node) {
  const auto node_of = node == Node::unit ? unit_of : folder_of;
  Graph graph;
  for (const auto& [file, text] : sources) {
    auto& targets = graph[node_of(file)];
    for_each_include(text, [&](int, const std::string& header, bool) {
      const std::string place = place_of(header);
      if (sources.count(place) > 0 && node_of(place) != node_of(file)) {
        targets.insert(node_of(place));
      }
    });
  }
  return graph;
}

std::vector<std::string> find_cycle(const Graph& graph) {
  std::set<std::string> finished;
  std::vector<std::string> path;
  const std::function<bool(const std::string&)> closes = [&](const std::string& node) {
    const auto before = std::find(path.begin(), path.end(), node);
    if (before != path.end()) {
      path.erase(path.begin(), before);
      path.push_back(node);
      return true;
    }
    if (!finished.insert(node).second) return false;
    path.push_back(node);
    if (const auto entry = graph.find(node); entry != graph.end()) {
      for (const std::string& next : entry->second) {
        if (closes(next)) return true;
      }
    }
    path.pop_back();
    return false;
  };
  for (const auto& entry : graph) {
    if (closes(entry.first)) return path;
  }
  return {};
}

Sources read_sources(const std::filesystem::path& root, const std::vector<std::string>& tops) {
  Sources sources;
  for (const std::string& top : tops) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      sources[entry.path().lexically_relative(root).generic_string()] = read_file(entry.path());
    }
  }
  return sources;
}

}  // namespace pupflow::arrows
