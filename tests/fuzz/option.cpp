// Options whose values have a grammar, one a line: the option's name, a blank, the value. Invariant: it
// is refused in sound lines, or what was read comes back the same from the text that files hold of it.
#include "app/io/recording.h"
#include "app/io/schedule_text.h"
#include "app/io/settings.h"
#include "app/io/text.h"
#include "app/study/design.h"
#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

bool same(const study::Axis& a, const study::Axis& b) {
  return a.parameter == b.parameter && a.values == b.values;
}

void vary(const std::string& value) {
  // A small step makes as many values as a large count.
  for (const char* const small : {"step=0.0", "e-"}) {
    if (value.find(small) != std::string::npos) return;
  }
  if (is_long(value)) return;
  const study::Axis axis = study::parse_axis(value);
  const std::string text = study::axis_text(axis);
  require(same(read_back([&] { return study::parse_axis(text); }), axis),
          "--vary " + value + " comes back changed");
}

void span(const std::string& value) {
  const study::Span read = study::parse_span(value);
  const study::Span again = read_back([&] { return study::parse_span(study::span_text(read)); });
  require(same(again.axis, read.axis) && again.between == read.between,
          "--vary " + value + " with --lhs comes back changed");
}

void set(const std::string& value) {
  io::Settings settings;
  settings.sets = {value};
  io::set_up(settings);
}

void at(const std::string& value) {
  io::Settings settings;
  settings.at = {value};
  const Params params = io::set_up(settings).params;
  std::vector<std::string> problems;
  const std::string text = io::schedule_text(params.schedule);
  require(io::parse_schedule(text, "again", problems) == params.schedule && problems.empty(),
          "--at " + value + " comes back changed");
}

void shard(const std::string& value) {
  const study::Shard read = study::parse_shard(value);
  require(1 <= read.number && read.number <= read.of, "--shard " + value + " is no shard");
}

void record_fields(const std::string& value) {
  const io::RecordedFields read = io::parse_recorded_fields(value);
  require(read.positions || !read.fields.empty(), "--record-fields " + value + " records nothing");
}

struct Option {
  std::string_view name;
  void (*read)(const std::string& value);
};

constexpr Option kOptions[] = {{"vary", vary}, {"lhs", span},    {"set", set},
                               {"at", at},     {"shard", shard}, {"record-fields", record_fields}};

}  // namespace

void one_input(std::string_view bytes) {
  for (const std::string_view line : io::split(bytes, '\n')) {
    const std::size_t blank = std::min(line.find(' '), line.size());
    for (const Option& option : kOptions) {
      if (line.substr(0, blank) != option.name || blank == line.size()) continue;
      refuses([&] { option.read(std::string(line.substr(blank + 1))); });
    }
  }
}

}  // namespace pupflow::fuzz
