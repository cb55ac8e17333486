// Stages, huddling, dispersed and rigid, and the least that their arithmetic takes here.
#include <cstdio>

#include "bench/floors.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

constexpr int kMeasuredSteps = 200;  // in a round

/// One litter and its stage times, one set a round.
struct Scene {
  std::string name;
  Simulation start;
  std::vector<StageTimes> rounds;

  std::vector<double> times(Stage stage) const {
    std::vector<double> times;
    for (const StageTimes& round : rounds) times.push_back(round[static_cast<std::size_t>(stage)]);
    return times;
  }
};

/// What belongs to one precision.
template <class Real>
struct Litters {
  std::string precision;
  Scene huddling, dispersed, rigid;
  TightLitter<Real> tight;
  std::vector<TightVariant<Real>> variants;
  std::vector<std::vector<Floors>> floors;  // one list a variant, one entry a round
};

template <class Real>
Litters<Real> make_litters() {
  const bool single = sizeof(Real) == sizeof(float);
  const Precision precision = single ? Precision::float_ : Precision::double_;
  const std::string name = single ? "float" : "double";
  Params stiff = huddling(precision);
  stiff.deformation = 0;
  Simulation huddle = settled(huddling(precision));
  Litters<Real> litters{name,
                        {name + ", huddling", huddle, {}},
                        {name + ", dispersed", settled(dispersed(precision)), {}},
                        {name + ", huddling, β = 0", settled(stiff), {}},
                        TightLitter<Real>(huddle.snapshot()),
                        tight_variants<Real>(),
                        {}};
  litters.floors.resize(litters.variants.size());
  return litters;
}

template <class Real>
void measure(Litters<Real>& litters) {
  for (Scene* scene : {&litters.huddling, &litters.dispersed, &litters.rigid}) {
    Simulation simulation = scene->start;
    scene->rounds.push_back(stage_times(simulation, kMeasuredSteps));
  }
  for (std::size_t i = 0; i < litters.variants.size(); ++i) {
    litters.floors[i].push_back(litters.tight.measure(*litters.variants[i].kernels));
  }
}

std::vector<double> times(const std::vector<Floors>& rounds, double Floors::*kernel) {
  std::vector<double> times;
  times.reserve(rounds.size());
  for (const Floors& round : rounds) times.push_back(round.*kernel);
  return times;
}

void print_scene(const Scene& scene) {
  std::printf("| %s |", scene.name.c_str());
  for (int stage = 0; stage < kStageCount; ++stage) {
    std::printf(" %.2f |", median(scene.times(static_cast<Stage>(stage))));
  }
  std::printf("\n");
}

template <class Real>
void print_floors(const Litters<Real>& litters) {
  for (std::size_t i = 0; i < litters.variants.size(); ++i) {
    const auto time = [&](double Floors::*kernel) {
      return median(times(litters.floors[i], kernel));
    };
    std::printf("| %s, %s | %.2f | %.2f | %.2f | %.2f | %.2f (%.0f pairs) |\n",
                litters.precision.c_str(), std::string(litters.variants[i].name).c_str(),
                time(&Floors::predict), time(&Floors::match), time(&Floors::rotations),
                time(&Floors::bounds), time(&Floors::distances), litters.tight.distance_tests());
  }
}

void print_stage_head() {
  std::printf("| µs a step |");
  for (int stage = 0; stage < kStageCount; ++stage) {
    std::printf(" %s |", std::string(stage_name(static_cast<Stage>(stage))).c_str());
  }
  std::printf("\n|---|");
  for (int stage = 0; stage < kStageCount; ++stage) std::printf("---|");
  std::printf("\n");
}

template <class Real>
void judge(const Litters<Real>& litters, Verdicts& verdicts) {
  const std::string in = " in " + litters.precision;
  const auto of = [](const Scene& scene, Stage stage) { return scene.times(stage); };
  verdicts.measured(
      "contacts, dispersed through huddling," + in,
      ratio(of(litters.dispersed, Stage::contact), of(litters.huddling, Stage::contact)));
  verdicts.measured(
      "shape matching, β = 0 through β = 0.5," + in,
      ratio(of(litters.rigid, Stage::shape_match), of(litters.huddling, Stage::shape_match)));
  for (std::size_t i = 0; i < litters.variants.size(); ++i) {
    if (litters.variants[i].name != "avx2") continue;
    verdicts.measured(
        "shape matching through its tight kernel (avx2)," + in,
        ratio(of(litters.huddling, Stage::shape_match), times(litters.floors[i], &Floors::match)));
  }
}

}  // namespace

void stages(int rounds, Verdicts& verdicts) {
  auto in_double = make_litters<double>();
  auto in_float = make_litters<float>();
  for (int round = 0; round < rounds; ++round) {
    measure(in_double);
    measure(in_float);
  }
  print_stage_head();
  const auto print_scenes = [](const auto& litters) {
    for (const Scene* scene : {&litters.huddling, &litters.dispersed, &litters.rigid}) {
      print_scene(*scene);
    }
  };
  print_scenes(in_double);
  print_scenes(in_float);
  std::printf(
      "\n| tight kernels, µs | predict | match, no rotations | rotations | bounds |"
      " distances |\n|---|---|---|---|---|---|\n");
  print_floors(in_double);
  print_floors(in_float);
  judge(in_double, verdicts);
  judge(in_float, verdicts);
}

}  // namespace pupflow::bench
