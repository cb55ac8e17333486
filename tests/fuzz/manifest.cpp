// The manifest of a sweep's folder, beside a table of points. Invariant: it is refused in sound lines,
// or the design comes back the same from its own text, and its first and last run have sound parameters.
#include "app/io/text.h"
#include "app/study/design.h"
#include "app/study/extend.h"
#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

/// The table that corpus/manifest/table.toml belongs to.
constexpr const char* kTable = "ta,beta,seed\n0.2,0.5,1\n0.4,0.5,2\n0.4,0.25,3\n";

void read(const std::string& text, const std::string& table) {
  const study::Design design = study::parse_manifest(text, "manifest.toml", table);
  const std::string own = study::manifest_text(design);
  const study::Design again = read_back([&] { return study::parse_manifest(own, "again", table); });
  require(study::manifest_text(again) == own, "a design comes back changed from its manifest");
  for (const std::int64_t run : {std::int64_t{0}, design.runs() - 1}) {
    require(design.runs() == 0 || check(design.params_of(run)).empty(), "a run is unsound");
    require(design.runs() == 0 || design.run_of(design.number_of(run)) == run,
            "a run has another number than its own");
  }
  study::Design more = design;
  ++more.seeds;
  study::extended_by(more, text);
}

}  // namespace

void one_input(std::string_view bytes) {
  for (const std::string_view line : io::split(bytes, '\n')) {
    if ((line.starts_with("vary") || line.starts_with("lhs")) && is_long(line)) return;
  }
  static const std::string table = file_of(kTable);
  refuses([&] { read(std::string(bytes), table); });
}

}  // namespace pupflow::fuzz
