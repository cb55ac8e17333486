#include "app/io/params_of_file.h"

#include <algorithm>

#include "app/io/checkpoint.h"
#include "app/io/command_text.h"
#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/file_kind.h"
#include "app/io/movie.h"
#include "app/io/png.h"
#include "app/io/provenance.h"

namespace pupflow::io {

namespace {

/// Sets the parameters that are columns of row number `row`.
void take_row(const std::string& path, std::int64_t row, Params& params) {
  CsvReader file(path);
  const auto& columns = file.columns();
  if (std::find(columns.begin(), columns.end(), "status") == columns.end()) {
    refuse(path + ": is no table of runs; --row takes a sweep's runs.csv");
  }
  std::optional<std::vector<std::string>> cells;
  for (std::int64_t i = 0; i < row; ++i) {
    cells = file.next();
    if (!cells) {
      refuse(path + ": has " + std::to_string(i) + " rows; --row " + std::to_string(row) +
             " is not among them");
    }
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Parameter* parameter = find_parameter(columns[i]);
    Problem problem;
    if (parameter && !parse_value(*parameter, (*cells)[i], params, problem)) {
      refuse(file.where() + ": " + problem.message);
    }
  }
}

}  // namespace

TextEntries entries_of_text(const std::string& path) {
  if (names_movie(path)) {
    refuse(path +
           ": a film has its recipe in its comment; give the text that ffprobe prints "
           "(Debian and Ubuntu: apt install ffmpeg): ffprobe -v error -show_entries "
           "format_tags=comment -of default=nokey=1:noprint_wrappers=1 " +
           shell_word(path) + " > recipe.txt");
  }
  return read_csv_header(path);
}

TextEntries entries_of_file(const std::string& path) {
  switch (file_kind(path)) {
    case FileKind::picture:
      return read_png_text(path);
    case FileKind::hdf5:
      return read_hdf5_text(path);
    case FileKind::text:
      break;
  }
  return entries_of_text(path);
}

Params params_of_file(const std::string& path, std::optional<std::int64_t> row) {
  Params params = params_from(entries_of_file(path), path);
  if (row) take_row(path, *row, params);
  return params;
}

}  // namespace pupflow::io
