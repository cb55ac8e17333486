// Reads the #include lines of the source tree: which of them run against the arrows, and whether
// they go in a circle.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace pupflow::arrows {

/// Files by their path relative to the root of the source tree, with '/', and their content.
using Sources = std::map<std::string, std::string>;

/// All .h and .cpp files below the folders `tops` of `root`. Throws std::runtime_error when a file
/// cannot be read.
Sources read_sources(const std::filesystem::path& root, const std::vector<std::string>& tops);

/// One #include line that may not be.
struct Violation {
  std::string file;
  int line;  // counted from 1
  std::string header;
  std::string reason;
};

/// The violations in `text`, the content of `file`.
std::vector<Violation> scan_text(const std::string& file, const std::string& text);

/// Who includes whom.
using Graph = std::map<std::string, std::set<std::string>>;

/// A unit is a header and the source file of the same name.
enum class Node { unit, folder };

/// The includes among `sources`, between different units or folders.
Graph include_graph(const Sources& sources, Node node);

/// A closed walk through the graph, first node repeated at the end; empty if there is none.
std::vector<std::string> find_cycle(const Graph& graph);

}  // namespace pupflow::arrows
