#include <array>
#include <limits>
#include <optional>
#include <type_traits>

#include "pupflow/parameters.h"

namespace pupflow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array<std::string_view, 2> kHeadingNames{"course", "body"};
constexpr std::array<std::string_view, 2> kStartNames{"column", "carpet"};
constexpr std::array<std::string_view, 3> kContactNames{"nearest", "mean", "sum"};
constexpr std::array<std::string_view, 2> kRefinementNames{"naive", "consistent"};
constexpr std::array<std::string_view, 2> kIntegratorNames{"predictive", "explicit"};
constexpr std::array<std::string_view, 2> kHeatNames{"exact", "euler"};
constexpr std::array<std::string_view, 2> kPrecisionNames{"float", "double"};

using Effect = Parameter::Effect;

/// Allowed values of a number; by default any finite one.
struct Limits {
  double min = -kInfinity, max = kInfinity;
  bool min_open = false;  // min itself is excluded
};

struct Slider {
  double min = 0, max = 1;
  bool log = false;
};

/// A row as it is written below. Fields that are left out keep these defaults.
struct Row {
  std::string_view name;
  std::string_view symbol = "";
  std::string_view title;
  std::string_view unit = "";
  Limits range = {};
  Slider slider = {};
  std::span<const std::string_view> choices = {};  // the names; they set range and slider
  std::optional<double> before = {};               // by default that of Params
  Effect effect;
  std::string_view group;
  std::string_view source;
  std::string_view doc;
};

/// The row of the member `Member` of Params.
template <auto Member>
constexpr Parameter row(const Row& r) {
  using Value = std::remove_cvref_t<decltype(Params{}.*Member)>;
  constexpr bool kChoice = std::is_enum_v<Value>;
  const double last = static_cast<double>(r.choices.size()) - 1;
  const Limits range = kChoice ? Limits{.min = 0, .max = last} : r.range;
  const Slider slider = kChoice ? Slider{.min = 0, .max = last} : r.slider;
  return {
      .name = r.name,
      .symbol = r.symbol,
      .title = r.title,
      .unit = r.unit,
      .group = r.group,
      .source = r.source,
      .doc = r.doc,
      .kind = kChoice                     ? Parameter::Kind::choice
              : std::is_integral_v<Value> ? Parameter::Kind::integer
                                          : Parameter::Kind::real,
      .effect = r.effect,
      .min = range.min,
      .max = range.max,
      .min_open = range.min_open,
      .slider_min = slider.min,
      .slider_max = slider.max,
      .slider_log = slider.log,
      .choices = r.choices,
      .get = [](const Params& p) { return static_cast<double>(p.*Member); },
      .set =
          [](Params& p, double value) {
            if constexpr (std::is_same_v<Value, double>) {
              p.*Member = value;
            } else {
              p.*Member = static_cast<Value>(static_cast<std::int64_t>(value));
            }
          },
      .before = r.before.value_or(static_cast<double>(Params{}.*Member)),
  };
}

constexpr std::string_view kPaper = "Wilson 2017";
constexpr std::string_view kAuthor2d = "not in the paper; the author's 2-D model";
constexpr std::string_view kProgram = "this program";

constexpr std::array kTable{
    row<&Params::ambient_temperature>({
        .name = "ta",
        .symbol = "T_a",
        .title = "ambient temperature",
        .slider = {.min = 0, .max = 1},
        .effect = Effect::next_step,
        .group = "heat",
        .source = kPaper,
        .doc = "Temperature of the arena; every afferent without contact reads it. 0.6 is 37 "
               "deg C.",
    }),
    row<&Params::rigidity>({
        .name = "alpha",
        .symbol = "α",
        .title = "rigidity",
        .unit = "per step",
        .range = {.min = 0, .max = 1},
        .slider = {.min = 0, .max = 1},
        .effect = Effect::next_step,
        .group = "body",
        .source = kPaper,
        .doc = "Share of the way to its goal that a point goes in one step; 1 is rigid, 0 a loose "
               "cloud.",
    }),
    row<&Params::deformation>({
        .name = "beta",
        .symbol = "β",
        .title = "deformation",
        .range = {.min = 0, .max = 1},
        .slider = {.min = 0, .max = 1},
        .effect = Effect::next_step,
        .group = "body",
        .source = kPaper,
        .doc = "How far goals follow the best quadratic fit (1) instead of the best rotation (0); "
               "1 has no shape of its own.",
    }),
    row<&Params::gravity>({
        .name = "gravity",
        .symbol = "g",
        .title = "gravity",
        .unit = "length/s²",
        .range = {.min = 0},
        .slider = {.min = 0, .max = 50},
        .effect = Effect::next_step,
        .group = "body",
        .source = kPaper,
        .doc = "Acceleration downwards.",
    }),
    row<&Params::contact>({
        .name = "contact",
        .title = "contact rule",
        .choices = kContactNames,
        .before = static_cast<double>(ContactRule::sum),
        .effect = Effect::next_step,
        .group = "body",
        .source = "readings of Wilson 2017",
        .doc = "nearest: a point is moved by its nearest touching lower point alone; mean: by the "
               "mean over all of them; sum: by their sum.",
    }),
    row<&Params::preferred_temperature>({
        .name = "tp",
        .symbol = "T_p",
        .title = "preferred temperature",
        .slider = {.min = 0, .max = 1},
        .effect = Effect::next_step,
        .group = "heat",
        .source = kPaper,
        .doc = "Body temperature that a pup seeks; 0.6 is 37 deg C.",
    }),
    row<&Params::air_conductance>({
        .name = "k1",
        .symbol = "k₁",
        .title = "conductance to the air",
        .unit = "1/s",
        .range = {.min = 0},
        .slider = {.min = 0, .max = 5},
        .effect = Effect::next_step,
        .group = "heat",
        .source = kPaper,
        .doc = "Rate of heat loss through the exposed surface.",
    }),
    row<&Params::contact_conductance>({
        .name = "k2",
        .symbol = "k₂",
        .title = "conductance to others",
        .unit = "1/s",
        .range = {.min = 0},
        .slider = {.min = 0, .max = 5},
        .effect = Effect::next_step,
        .group = "heat",
        .source = kPaper,
        .doc = "Rate of heat exchange through the touching surface.",
    }),
    row<&Params::thermogenesis>({
        .name = "g",
        .symbol = "G",
        .title = "thermogenesis",
        .unit = "1/s",
        .slider = {.min = 0, .max = 0.5},
        .effect = Effect::next_step,
        .group = "heat",
        .source = kPaper,
        .doc = "Heat that each pup makes.",
    }),
    row<&Params::heat>({
        .name = "heat",
        .title = "heat rule",
        .choices = kHeatNames,
        .effect = Effect::next_step,
        .group = "heat",
        .source = "exact: this program; euler: Wilson 2017",
        .doc =
            "How body temperature is stepped: the exact solution over the step, or forward Euler.",
    }),
    row<&Params::initial_temperature>({
        .name = "tb0",
        .symbol = "T_b(0)",
        .title = "initial body temperature",
        .slider = {.min = 0, .max = 1},
        .effect = Effect::restart,
        .group = "heat",
        .source = kAuthor2d,
        .doc = "Body temperature of every pup at t = 0.",
    }),
    row<&Params::drive>({
        .name = "drive",
        .symbol = "f",
        .title = "drive",
        .unit = "length/s²",
        .range = {.min = 0},
        .slider = {.min = 0, .max = 10},
        .effect = Effect::next_step,
        .group = "steering",
        .source = kPaper,
        .doc = "Acceleration of a pup along its direction of travel.",
    }),
    row<&Params::sensitivity>({
        .name = "sigma",
        .symbol = "σ",
        .title = "sensitivity",
        .slider = {.min = 0, .max = 200},
        .effect = Effect::next_step,
        .group = "steering",
        .source = "not in the paper; 0.01 per deg C² in the author's 2-D model × 61.67²",
        .doc = "Steepness of the two temperature sensors.",
    }),
    row<&Params::steering_gain>({
        .name = "v",
        .symbol = "v",
        .title = "steering gain",
        .range = {.min = 0},
        .slider = {.min = 0, .max = 1000},
        .effect = Effect::next_step,
        .group = "steering",
        .source = kAuthor2d,
        .doc = "Gain from sensor contrast to turning.",
    }),
    row<&Params::heading>({
        .name = "heading",
        .title = "heading",
        .choices = kHeadingNames,
        .effect = Effect::next_step,
        .group = "steering",
        .source = "both readings of Wilson 2017",
        .doc = "course: the direction of travel is the pup's own state and turns; body: it is "
               "taken from the body axis at every step.",
    }),
    row<&Params::pups>({
        .name = "pups",
        .symbol = "N",
        .title = "pups",
        .range = {.min = 0, .max = 10000},
        .slider = {.min = 0, .max = 200},
        .effect = Effect::restart,
        .group = "litter",
        .source = kPaper,
        .doc = "Number of pups in the litter.",
    }),
    row<&Params::face_points>({
        .name = "face_points",
        .symbol = "k",
        .title = "points along a face edge",
        .range = {.min = 2, .max = kMaxFacePoints},
        .slider = {.min = 2, .max = 15},
        .effect = Effect::restart,
        .group = "litter",
        .source = kPaper,
        .doc = "Each pup has n = 6 k² points on its surface.",
    }),
    row<&Params::pup_radius>({
        .name = "pup_radius",
        .symbol = "r_pup",
        .title = "pup radius",
        .unit = "length",
        .range = {.min = 1e-6, .max = 1e6, .min_open = true},
        .slider = {.min = 0.05, .max = 1},
        .effect = Effect::restart,
        .group = "litter",
        .source = kPaper,
        .doc = "Radius of the sphere on which a pup's points rest.",
    }),
    row<&Params::point_radius>({
        .name = "point_radius",
        .symbol = "r_point",
        .title = "point radius",
        .unit = "length",
        .range = {.min = 1e-6, .max = 1e6, .min_open = true},
        .slider = {.min = 0.01, .max = 0.3},
        .effect = Effect::restart,
        .group = "litter",
        .source = kPaper,
        .doc = "Radius of the sphere at each point, by which it touches.",
    }),
    row<&Params::arena_radius>({
        .name = "arena_radius",
        .symbol = "r_arena",
        .title = "arena radius",
        .unit = "length",
        .range = {.min = 1e-6, .max = 1e9, .min_open = true},
        .slider = {.min = 0.5, .max = 10},
        .effect = Effect::restart,
        .group = "litter",
        .source = kPaper,
        .doc = "Radius of the round wall; must exceed r_pup + r_point.",
    }),
    row<&Params::start>({
        .name = "start",
        .title = "start layout",
        .choices = kStartNames,
        .effect = Effect::restart,
        .group = "litter",
        .source = "column: Wilson 2017",
        .doc = "column: dropped one above the other at the centre; carpet: laid out over the "
               "floor, for many pups.",
    }),
    row<&Params::start_spread>({
        .name = "start_spread",
        .title = "start spread",
        .unit = "length",
        .range = {.min = 0, .max = 1e6},
        .slider = {.min = 0, .max = 1.4},
        .effect = Effect::restart,
        .group = "litter",
        .source = kPaper,
        .doc = "Half-width of the drop column in x and y; at most r_arena / √2, for all pups to "
               "start inside.",
    }),
    row<&Params::dt>({
        .name = "dt",
        .symbol = "h",
        .title = "time step",
        .unit = "s",
        .range = {.min = 1e-9, .max = 1e3, .min_open = true},
        .slider = {.min = 0.001, .max = 0.05, .log = true},
        .effect = Effect::next_step,
        .group = "run",
        .source = kPaper,
        .doc = "Length of a step. Rigidity acts per step, so 0.01 is part of the model.",
    }),
    row<&Params::refinement>({
        .name = "refinement",
        .title = "refinement",
        .choices = kRefinementNames,
        .effect = Effect::next_step,
        .group = "run",
        .source = "naive: Wilson 2017; consistent: this program",
        .doc = "naive: rigidity per step, whatever dt; consistent: per 0.01 s, so that a smaller "
               "dt is the same body.",
    }),
    row<&Params::integrator>({
        .name = "integrator",
        .title = "integrator",
        .choices = kIntegratorNames,
        .effect = Effect::next_step,
        .group = "run",
        .source = "predictive: Müller 2005; explicit: Wilson 2017",
        .doc = "predictive: goals from the predicted points; explicit: from the current ones, "
               "undamped.",
    }),
    row<&Params::steps>({
        .name = "steps",
        .title = "steps",
        .range = {.min = 0, .max = kExactInteger},
        .slider = {.min = 0, .max = 10000},
        .effect = Effect::run,
        .group = "run",
        .source = kPaper,
        .doc = "Length of a run.",
    }),
    row<&Params::discard>({
        .name = "discard",
        .title = "steps left out",
        .range = {.min = 0, .max = kExactInteger},
        .slider = {.min = 0, .max = 10000},
        .effect = Effect::run,
        .group = "run",
        .source = kPaper,
        .doc = "Steps at the beginning that stay out of a run's means.",
    }),
    row<&Params::flow_lag>({
        .name = "flow_lag",
        .title = "lag of pup flow",
        .unit = "steps",
        .range = {.min = 1, .max = 10000},
        .slider = {.min = 1, .max = 100},
        .effect = Effect::run,
        .group = "run",
        .source = kPaper,
        .doc = "Pup flow is the change of A over so many steps, divided by their time.",
    }),
    row<&Params::seed>({
        .name = "seed",
        .title = "seed",
        .range = {.min = 0, .max = kExactInteger},
        .slider = {.min = 0, .max = 1000},
        .effect = Effect::restart,
        .group = "run",
        .source = kProgram,
        .doc = "Fixes every random number: same seed, same bits.",
    }),
    row<&Params::precision>({
        .name = "precision",
        .title = "precision",
        .choices = kPrecisionNames,
        .effect = Effect::restart,
        .group = "run",
        .source = kProgram,
        .doc = "Arithmetic of the points; temperatures and headings are always double.",
    }),
};

}  // namespace

std::span<const Parameter> parameters() {
  return kTable;
}

}  // namespace pupflow
