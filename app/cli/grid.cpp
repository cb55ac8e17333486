#include "app/cli/grid.h"

#include <string_view>

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/study/axis.h"

namespace pupflow::cli {
namespace {

[[noreturn]] void refuse_many(const std::string& text) {
  io::refuse("--grid " + io::quoted(text) + ": a sheet has at most " +
             std::to_string(pictures::kMostPanels) + " panels");
}

/// The values of "from..to".
std::vector<double> whole_numbers(const std::string& text, std::string_view from,
                                  std::string_view to) {
  const auto first = io::read_number<std::int64_t>(from), last = io::read_number<std::int64_t>(to);
  if (!first || !last || *first > *last) {
    io::refuse("--grid " + io::quoted(text) +
               ": must be whole numbers, in from..to the smaller first, e.g. seed=1..6");
  }
  std::vector<double> values;
  for (std::int64_t i = *first;; ++i) {
    if (values.size() == pictures::kMostPanels) refuse_many(text);
    values.push_back(static_cast<double>(i));
    if (i == *last) return values;
  }
}

/// Seeds are no axis of a sweep, which gives every run its own.
std::vector<double> seeds(const std::string& text, std::string_view list) {
  std::vector<double> values;
  for (const std::string_view part : io::split(list, ',')) {
    values.push_back(whole_numbers(text, part, part).front());
  }
  return values;
}

pictures::Axis parse_axis(const std::string& text) {
  const std::size_t equals = text.find('='), dots = text.find("..");
  if (equals != std::string::npos && dots != std::string::npos && dots > equals) {
    const std::string name = text.substr(0, equals);
    study::parameter_named(name, "--grid");
    return {name, whole_numbers(text, std::string_view(text).substr(equals + 1, dots - equals - 1),
                                std::string_view(text).substr(dots + 2))};
  }
  if (text.starts_with("seed=")) return {"seed", seeds(text, std::string_view(text).substr(5))};
  try {
    const study::Axis axis = study::parse_axis(text);
    return {std::string(axis.parameter->name), axis.values};
  } catch (const io::Failure& failure) {
    const std::string what = failure.what();
    const std::string_view option = "--vary";
    io::refuse(what.starts_with(option) ? "--grid" + what.substr(option.size()) : what);
  }
}

}  // namespace

std::vector<pictures::Axis> parse_grid(const std::vector<std::string>& texts) {
  if (texts.size() > 2) {
    io::refuse("--grid: a sheet varies one or two parameters, not " + std::to_string(texts.size()));
  }
  std::vector<pictures::Axis> axes;
  std::size_t panels = 1;
  for (const std::string& text : texts) {
    axes.push_back(parse_axis(text));
    panels *= axes.back().values.size();
    if (panels > pictures::kMostPanels) refuse_many(text);
  }
  if (axes.size() == 2 && axes[0].parameter == axes[1].parameter) {
    io::refuse("--grid: " + axes[0].parameter + " is given twice");
  }
  return axes;
}

}  // namespace pupflow::cli
