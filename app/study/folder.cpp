#include "app/study/folder.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/io/text_stream.h"
#include "app/study/extend.h"
#include "app/study/files.h"
#include "app/study/series.h"
#include "app/study/table.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestManifest = std::size_t{1} << 26;

/// Everything that any sweep has beside its manifest.
std::vector<std::string> other_files(const std::string& folder, const Design& design) {
  std::vector<std::string> files = result_paths(folder, design);
  files.push_back(script_path(folder, design));
  files.push_back(journal_path(folder));
  return files;
}

void write_text(const std::string& path, const std::string& text) {
  io::AtomicFile file(path, true);
  file.write(text);
  file.commit();
}

}  // namespace

void claim_folder(const std::string& folder, const Design& design, bool force) {
  make_folder(folder);
  refuse_links(folder, design);
  const std::string text = manifest_text(design), path = manifest_path(folder);
  const bool claimed = fs::exists(path);
  const std::string there = claimed ? io::read_file(path, kLargestManifest) : "";
  if (!force) {
    if (there == text) return;
    if (const auto before = extended_by(design, there)) {
      prepare_extension(folder, *before);
      return write_text(path, text);
    }
  }
  if (claimed && !force) {
    throw io::Failure(io::ExitCode::bad_input,
                      folder + ": holds another sweep: " + manifest_difference(there, text) +
                          "; name another folder with --out, or use --force to replace it");
  }
  std::vector<std::string> in_the_way = other_files(folder, design);
  if (design.record_every > 0) in_the_way.push_back(series_folder(folder));
  if (design.layout == Layout::table) in_the_way.push_back(table_path(folder));
  for (const std::string& file : in_the_way) {
    if (fs::exists(file) && !force) {
      throw io::Failure(io::ExitCode::bad_file,
                        file +
                            ": exists already, and there is no manifest beside it; name "
                            "another folder with --out, or use --force to replace it");
    }
  }
  // Results are removed first, so a folder never has the manifest of another sweep beside them.
  for (const std::string& file : other_files(folder, design)) remove_file(file);
  if (claimed) {
    remove_file(table_path(folder));
    remove_series(folder);
    for (const std::string_view name : kDesignNames) {  // the figure of the one that was there
      Design named = design;
      named.name = name;
      for (const std::string& file : other_files(folder, named)) remove_file(file);
    }
  }
  if (design.layout == Layout::table) write_text(table_path(folder), table_text(design));
  write_text(path, text);
}

Design design_of_folder(const std::string& folder) {
  const std::string path = manifest_path(folder);
  const std::string text = io::read_file(path, kLargestManifest);
  Design design = parse_manifest(text, path, table_path(folder));
  const std::string own = manifest_text(design);
  if (text == own) return design;
  throw io::Failure(io::ExitCode::bad_input,
                    path + ": is not as this program writes it: " + manifest_difference(text, own));
}

namespace {

/// What a message shows of a line: all of it, or of a long one what stands round `at`.
std::string shown(const std::string& line, std::size_t at) {
  constexpr std::size_t kMost = 100, kBefore = 40;
  if (line.size() <= kMost) return io::quoted(line);
  const std::size_t begin = at < kMost / 2 ? 0 : at - kBefore;
  return io::quoted((begin > 0 ? "..." : "") + line.substr(begin, kMost) +
                    (begin + kMost < line.size() ? "..." : ""));
}

}  // namespace

std::string manifest_difference(const std::string& there, const std::string& now) {
  io::TextStream a(there), b(now);
  std::string line_a, line_b;
  while (true) {
    const bool more_a = static_cast<bool>(std::getline(a, line_a));
    const bool more_b = static_cast<bool>(std::getline(b, line_b));
    if (!more_a && !more_b) return "nothing";
    if (more_a && more_b && line_a == line_b) continue;
    if (!more_a) line_a.clear();
    if (!more_b) line_b.clear();
    const auto differs =
        std::mismatch(line_a.begin(), line_a.end(), line_b.begin(), line_b.end()).first;
    const auto at = static_cast<std::size_t>(differs - line_a.begin());
    return shown(line_a, at) + " there, " + shown(line_b, at) + " now";
  }
}

}  // namespace pupflow::study
