#include "app/study/table.h"

#include <map>
#include <set>

#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/io/text_stream.h"

namespace pupflow::study {
namespace {

constexpr std::size_t kLargestTable = std::size_t{1} << 28;

/// Everything wrong with a file, a line each.
class Problems {
 public:
  explicit Problems(std::string where) : where_(std::move(where)) {}

  void add(std::int64_t line, const std::string& what) {
    constexpr std::int64_t kListed = 20;
    if (++count_ > kListed) return;
    lines_.push_back(where_ + ":" + std::to_string(line) + ":" + what);
    if (count_ == kListed) lines_.emplace_back("... more problems follow");
  }
  std::int64_t count() const { return count_; }

  /// Throws when there is one.
  void refuse_all() const { io::refuse_all(lines_); }

 private:
  std::string where_;
  std::vector<std::string> lines_;
  std::int64_t count_ = 0;
};

std::string_view trimmed(std::string_view cell) {
  constexpr const char* kBlanks = " \t\r";
  const std::size_t first = cell.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return cell.substr(first, cell.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells = io::split(line, ',');
  for (std::string_view& cell : cells) {
    cell = trimmed(cell);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
  }
  return cells;
}

class Reader {
 public:
  Reader(const std::string& where, Design& design) : problems_(where), design_(design) {}

  void header(std::int64_t line, std::string_view text) {
    std::set<std::string_view> seen;
    for (const std::string_view cell : cells_of(text)) {
      const std::string name(cell);
      columns_.push_back(find_parameter(name));
      if (!columns_.back()) {
        try {
          parameter_named(name, name);
        } catch (const io::Failure& unknown) {
          problems_.add(line, unknown.what());
        }
      } else if (!seen.insert(columns_.back()->name).second) {
        problems_.add(line, name + ": this column is there twice");
      }
    }
  }

  void row(std::int64_t line, std::string_view text) {
    const std::vector<std::string_view> cells = cells_of(text);
    if (cells.size() != columns_.size()) {
      return problems_.add(line, " has " + std::to_string(cells.size()) +
                                     " values, and the header names " +
                                     std::to_string(columns_.size()) + " columns");
    }
    Params params = design_.base;
    const std::int64_t before = problems_.count();
    for (std::size_t c = 0; c < cells.size(); ++c) {
      Problem problem;
      if (columns_[c] && !parse_value(*columns_[c], cells[c], params, problem))
        problems_.add(line, problem.parameter + ": " + problem.message);
    }
    if (problems_.count() > before) return;
    for (const std::string& problem : run_problems(params)) problems_.add(line, " " + problem);
    keep(line, params);
  }

  /// Throws all problems, or completes the design.
  void finish() {
    problems_.refuse_all();
    if (!rows_.empty()) design_.seeds = design_.seed_block = 1;
  }

 private:
  void keep(std::int64_t line, const Params& params) {
    if (design_.axes.empty() && design_.given_seeds.empty()) {
      for (const Parameter* column : columns_) {
        if (column && column->name != "seed") design_.axes.push_back({column, {}});
      }
    }
    std::vector<double> values;
    for (Axis& axis : design_.axes) {
      values.push_back(axis.parameter->get(params));
      axis.values.push_back(values.back());
    }
    const bool seeds = std::any_of(columns_.begin(), columns_.end(),
                                   [](const Parameter* c) { return c && c->name == "seed"; });
    if (!seeds) return;
    design_.given_seeds.push_back(params.seed);
    values.push_back(static_cast<double>(params.seed));
    const auto [first, added] = rows_.try_emplace(std::move(values), line);
    if (!added) problems_.add(line, " is the same run as line " + std::to_string(first->second));
  }

  Problems problems_;
  Design& design_;
  std::vector<const Parameter*> columns_;             // null where the name is unknown
  std::map<std::vector<double>, std::int64_t> rows_;  // of runs with given seeds: their lines
};

}  // namespace

void parse_table(const std::string& text, const std::string& where, Design& design) {
  design.layout = Layout::table;
  Reader reader(where, design);
  io::TextStream lines(text);
  std::int64_t number = 0, rows = -1;  // -1: no header yet
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::string_view content = line;
    if (number == 1 && content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
    content = trimmed(content);
    if (content.empty() || content.starts_with('#')) continue;
    if (++rows == 0) {
      reader.header(number, content);
    } else {
      reader.row(number, content);
    }
    if (rows > kMostValues)
      io::refuse(where + ": has more than " + std::to_string(kMostValues) + " rows; split it");
  }
  reader.finish();
  if (rows < 1) {
    io::refuse(where +
               ": has no runs: the first line must name parameters, e.g. ta,beta, and each "
               "line below it must give their values");
  }
}

void read_table(const std::string& path, Design& design) {
  parse_table(io::read_file(path, kLargestTable), path, design);
}

std::string table_text(const Design& design) {
  std::vector<std::string> cells;
  for (const Axis& axis : design.axes) cells.emplace_back(axis.parameter->name);
  if (!design.given_seeds.empty()) cells.emplace_back("seed");
  std::string text = io::joined(cells, ",") + "\n";
  for (std::int64_t point = 0; point < design.points(); ++point) {
    const std::vector<double> values = design.values_at(point);
    for (std::size_t a = 0; a < values.size(); ++a)
      cells[a] = format_value(*design.axes[a].parameter, values[a]);
    if (!design.given_seeds.empty()) cells.back() = std::to_string(design.seed_of(point));
    text += io::joined(cells, ",") + "\n";
  }
  return text;
}

std::string table_hash(const Design& design) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : table_text(design)) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  return io::formatted("%016llx", static_cast<unsigned long long>(hash));
}

}  // namespace pupflow::study
