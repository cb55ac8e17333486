// The journal of an unfinished sweep, its rows with their checksums. Invariant: it is refused in one
// sound line, or each row that is read belongs to the sweep; opened again it holds the same rows; a row
// that is added is there.
#include "app/study/journal.h"

#include "app/io/checksum.h"
#include "app/io/text.h"
#include "app/study/design.h"
#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

/// The sweep that the files of corpus/journal belong to.
study::Design design_of_corpus() {
  study::Design design;
  design.axes = {study::parse_axis("ta=0.2:0.8:4"), study::parse_axis("contact=sum,nearest")};
  design.seeds = 3;
  return design;
}

/// The lines of `bytes` with the checksums that the journal of `design` gives them (journal.cpp).
std::string with_checksums(std::string_view bytes, study::Design design) {
  design.seeds = design.seed_block;
  const std::uint64_t seed = io::checksum(study::manifest_text(design));
  std::string text;
  for (std::size_t end; (end = bytes.find('\n')) != bytes.npos; bytes.remove_prefix(end + 1)) {
    const std::string_view line = bytes.substr(0, end);
    text.append(line).append("," + io::hash_text(io::checksum(line, seed)) + "\n");
  }
  return text.append(bytes);
}

std::string texts(const study::Design& design, const study::Journal& journal) {
  std::string all;
  for (const auto& [run, row] : journal.rows()) {
    require(row.run == run && run < design.runs(), "a row is of no run of the sweep");
    all += study::row_text(design, row) + "\n";
  }
  return all;
}

}  // namespace

void one_input(std::string_view bytes) {
  static const study::Design design = design_of_corpus();
  const std::string path = file_of(with_checksums(bytes, design));
  std::string first;
  study::Row added;
  added.run = design.runs() - 1;
  const bool refused = refuses([&] {
    study::Journal journal(path, design);
    first = texts(design, journal);
    if (journal.rows().contains(added.run)) return;
    journal.add(added);
    first += study::row_text(design, added) + "\n";
  });
  if (refused) return;
  require(read_back([&] { return texts(design, study::Journal(path, design)); }) == first,
          "a journal that is opened again holds other rows");
}

}  // namespace pupflow::fuzz
