// A CSV file, as --like, --row, info and compare read it. Invariant: each reader refuses in sound
// lines or reads; parameters come back the same from the file that they are written to; a summary
// does not differ from itself.
#include "app/io/csv.h"
#include "app/io/about.h"
#include "app/io/params_of_file.h"
#include "app/io/provenance.h"
#include "app/study/compare.h"
#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

void read_rows(const std::string& path) {
  io::CsvReader file(path);
  while (const auto cells = file.next()) {
    require(cells->size() == file.columns().size(), "a row has another length than the header");
  }
}

void read_parameters(const std::string& path, std::optional<std::int64_t> row) {
  const Params params = io::params_of_file(path, row);
  if (!check(params).empty()) return;
  const std::string written = no_file();
  io::CsvFile(written, true, io::provenance(params), "step").commit();
  require(read_back([&] { return io::params_of_file(written); }) == params,
          "the parameters come back changed");
}

void compare_with_itself(const std::string& path) {
  const study::Comparison comparison = study::compare_summaries(path, path);
  require(comparison.beyond_three == 0, "a summary differs from itself");
  study::comparison_text(comparison);
}

}  // namespace

void one_input(std::string_view bytes) {
  const std::string path = file_of(bytes);
  refuses([&] { read_rows(path); });
  refuses([&] { read_parameters(path, {}); });
  refuses([&] { read_parameters(path, 2); });
  refuses([&] { io::about_file(path); });
  refuses([&] { compare_with_itself(path); });
}

}  // namespace pupflow::fuzz
