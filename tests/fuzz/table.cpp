// A table of points (--design). Invariant: it is refused in sound lines, or the design comes back the
// same from its own text.
#include "app/study/table.h"

#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

bool same(const study::Design& a, const study::Design& b) {
  return study::table_text(a) == study::table_text(b) && a.given_seeds == b.given_seeds &&
         a.points() == b.points();
}

}  // namespace

void one_input(std::string_view bytes) {
  refuses([&] {
    study::Design design;
    study::parse_table(std::string(bytes), "table.csv", design);
    study::check_design(design);
    study::Design again;
    read_back([&] { study::parse_table(study::table_text(design), "again", again); });
    require(same(design, again), "a table comes back changed");
  });
}

}  // namespace pupflow::fuzz
