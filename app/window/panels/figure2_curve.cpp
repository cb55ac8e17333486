#include "app/window/panels/figure2_curve.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "app/io/text.h"

extern const char figure2_csv_begin[], figure2_csv_end[];

namespace pupflow::window {
namespace {

std::vector<HuddlingPoint> read() {
  const std::string_view file(figure2_csv_begin,
                              static_cast<std::size_t>(figure2_csv_end - figure2_csv_begin));
  std::vector<std::string_view> columns;
  std::vector<HuddlingPoint> points;
  for (const std::string_view line : io::split(file, '\n')) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::vector<std::string_view> cells = io::split(line, ',');
    if (columns.empty()) {
      columns = cells;
      continue;
    }
    const auto number = [&](std::string_view column) {
      const auto found = std::find(columns.begin(), columns.end(), column) - columns.begin();
      const auto place = static_cast<std::size_t>(found);
      const auto value =
          place < cells.size() ? io::read_number<double>(cells[place]) : std::nullopt;
      if (!value) throw std::logic_error("the embedded Figure 2 has no " + std::string(column));
      return *value;
    };
    points.push_back({number("ta"), number("huddling"), number("huddling_sd")});
  }
  return points;
}

}  // namespace

std::span<const HuddlingPoint> figure2_curve() {
  static const std::vector<HuddlingPoint> points = read();
  return points;
}

}  // namespace pupflow::window
