// The runs whose hashes are fixed, for the test and for the program that prints them.
#pragma once

#include <array>
#include <cstdint>

#include "pupflow/parameters.h"

namespace pupflow {

struct GoldenRun {
  const char* name;
  void (*edit)(Params&);  // of the paper's litter at T_a 0.2
  std::uint64_t hash;     // after 800 steps
};

constexpr std::int64_t kGoldenSteps = 800;

inline Params params_of(const GoldenRun& run) {
  Params params;
  params.ambient_temperature = 0.2;
  run.edit(params);
  return params;
}

/// A change of the arithmetic changes these numbers; it must be meant, and the changelog must say
/// so. The sums' hashes are those of version 0.1.0, whose only rule this was.
constexpr std::array kGoldenRuns{
    GoldenRun{"paper", [](Params&) {}, 0xc696efdc14174a71u},
    GoldenRun{"paper-float", [](Params& p) { p.precision = Precision::float_; },
              0x9040f420f93e22e4u},
    GoldenRun{"sum", [](Params& p) { p.contact = ContactRule::sum; }, 0x6b6d41fe3fe481dfu},
    GoldenRun{"sum-float",
              [](Params& p) {
                p.contact = ContactRule::sum;
                p.precision = Precision::float_;
              },
              0x3837bb0f659df27au},
    GoldenRun{"mean", [](Params& p) { p.contact = ContactRule::mean; }, 0x937cb4eec8c07a3du},
    GoldenRun{"mean-float",
              [](Params& p) {
                p.contact = ContactRule::mean;
                p.precision = Precision::float_;
              },
              0x9de8564ff916b62u},
    GoldenRun{"body-heading-euler",
              [](Params& p) {
                p.heading = Heading::body;
                p.heat = HeatRule::euler;
              },
              0xa09d33c4bfec3780u},
    GoldenRun{"rigid-carpet-float",
              [](Params& p) {
                p.rigidity = 1;
                p.deformation = 0;
                p.pups = 40;
                p.start = Start::carpet;
                p.precision = Precision::float_;
              },
              0x938c6eb4c9484adcu},
};

}  // namespace pupflow
