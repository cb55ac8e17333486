#include "app/report/stability/extreme/scenes.h"

#include <array>

#include "app/report/stability/extreme/each.h"

namespace pupflow::report {
namespace {

using namespace extreme;

template <int Alpha, int Beta, Integrator Which>
Finding corner(Precision precision, bool quick) {
  return alpha_beta(precision, Alpha, Beta, Which, quick);
}

template <int FacePoints>
Finding points(Precision precision, bool quick) {
  return resolution(precision, FacePoints, quick);
}

template <int Hundredths>
Finding step_of(Precision precision, bool quick) {
  return longer_step(precision, Hundredths / 100.0, quick);
}

template <int Sign>
Finding air(Precision precision, bool quick) {
  return ambient(precision, Sign * 1e6, quick);
}

constexpr Integrator kPredictive = Integrator::predictive, kExplicit = Integrator::explicit_;

constexpr std::array kScenes{
    ExtremeScene{
        "pile", "200 pups in an arena of radius 1",
        "Numbers stay fine and nobody leaves. Bodies keep their volume, but sink into each "
        "other, so that each touches many.",
        pile},
    ExtremeScene{
        "soft_pile", "α = 1, β = 0.99, 200 pups, gravity 1000",
        "Crushed bodies with next to no shape of their own grow out of proportion, and the "
        "step says so.",
        soft_pile},
    ExtremeScene{"narrow", "30 pups in an arena of radius 0.6",
                 "They sink into each other, most points inside another body, and keep their "
                 "shapes.",
                 narrow},
    ExtremeScene{"giants", "r_pup = 1.9 in an arena of radius 2",
                 "There is room for one. Twelve lie in the same place, each in its shape.", giants},
    ExtremeScene{"column", "10,000 pups in one column",
                 "Only neighbours are searched: steps stay short, and numbers fine.", column},
    ExtremeScene{
        "coincident", "two pups at the very same points",
        "Distance 0 is no division by 0; ties go to the lower pup, and both keep their shape.",
        coincident},
    ExtremeScene{"drop", "one pup dropped from a height of 10⁴",
                 "It falls as the closed form says. At 450 a second the floor turns all points "
                 "round within one step, so it bounces about as high again, and keeps its shape.",
                 drop},
    ExtremeScene{"heavy", "gravity 10⁵, h = 0.01",
                 "A step falls g h² = 10, which is 40 radii: the floor flattens every pup in every "
                 "step, crushed but finite.",
                 heavy},
    ExtremeScene{"heavy_scaled", "gravity 10⁵, h = 10⁻⁴",
                 "g h² is the ordinary one, so the fall and the landing are, too.", heavy_scaled},
    ExtremeScene{"alpha0_beta0", "α = 0, β = 0", "A loose cloud: scattered, but finite.",
                 corner<0, 0, kPredictive>},
    ExtremeScene{"alpha0_beta1", "α = 0, β = 1", "The same: without α, β means nothing.",
                 corner<0, 1, kPredictive>},
    ExtremeScene{"alpha1_beta0", "α = 1, β = 0", "Rigid: no deformation beyond rounding.",
                 corner<1, 0, kPredictive>},
    ExtremeScene{"alpha1_beta1", "α = 1, β = 1",
                 "No shape of their own: bodies spread over the floor, and do not grow.",
                 corner<1, 1, kPredictive>},
    ExtremeScene{"explicit_alpha0_beta0", "α = 0, β = 0, explicit",
                 "The same loose cloud; nothing can be undamped without α.",
                 corner<0, 0, kExplicit>},
    ExtremeScene{"explicit_alpha1_beta0", "α = 1, β = 0, explicit",
                 "Undamped, it diverges, and the step says so.", corner<1, 0, kExplicit>},
    ExtremeScene{"explicit_alpha1_beta1", "α = 1, β = 1, explicit",
                 "Undamped, it diverges, and the step says so.", corner<1, 1, kExplicit>},
    ExtremeScene{"flat", "a cloud started flat", "It gets its shape back.", flat},
    ExtremeScene{"line", "a cloud started as a line", "It gets its shape back, turned somehow.",
                 line},
    ExtremeScene{"point", "a cloud started as a point", "It gets its shape back, turned somehow.",
                 point},
    ExtremeScene{
        "mirrored", "a cloud started inside out",
        "It gets its shape back with the right handedness: rotations are never reflections.",
        mirrored},
    ExtremeScene{"k2", "24 points a pup (k = 2)", "Ordinary shapes.", points<2>},
    ExtremeScene{"k32", "6144 points a pup (k = 32)", "Ordinary shapes.", points<32>},
    ExtremeScene{"large_points", "r_point = 0.2, r_pup = 0.25",
                 "Bodies stay apart: no point gets inside another body.", large_points},
    ExtremeScene{"fat_points", "r_point = 0.5 above r_pup = 0.25",
                 "Fine, since the nearest contact decides. With contact = sum each point adds up "
                 "displacements from most of the other's, many radii, and the contact stage says "
                 "so.",
                 fat_points},
    ExtremeScene{"freezing", "T_a = −10⁶",
                 "T_b goes there and not beyond, but for the heat that a huddle makes itself.",
                 air<-1>},
    ExtremeScene{"burning", "T_a = 10⁶",
                 "T_b goes there and not beyond, but for the heat that a huddle makes itself.",
                 air<1>},
    ExtremeScene{"no_conductance", "k₁ = k₂ = 0", "T_b = T_b(0) + G t; with G = 0, T_b(0).",
                 no_conductance},
    ExtremeScene{"stiff_heat", "k₁ = 500 by Euler, 10³⁰⁰ exactly",
                 "Euler overshoots by more each step, and the heat stage says so; the exact "
                 "solution is at T_a at once.",
                 stiff_euler},
    ExtremeScene{"steep_sensors", "σ = v = 10³⁰⁰", "Headings stay finite.", steep_sensors},
    ExtremeScene{"sharp_sensors", "σ = ± 10⁹",
                 "S is 0 or 1, headings finite, and the litter an ordinary one; with a negative σ "
                 "pups shun what they would seek.",
                 sharp_sensors},
    ExtremeScene{"burning_start", "T_b(0) = 10³⁰⁰",
                 "T_b falls by at most e^(−k₁ t), however high it is.", burning_start},
    ExtremeScene{"nobody", "no pup", "Steps do nothing.", nobody},
    ExtremeScene{"alone", "one pup", "It touches nobody; T_b follows its closed form.", alone},
    ExtremeScene{"tiny_step", "h = 10⁻⁸",
                 "It falls from rest by v = −g t. Single precision is refused: its rounding, "
                 "divided by h, would push the pups.",
                 tiny_step},
    ExtremeScene{"step_003", "h = 0.03", "A softer litter, but an ordinary one.", step_of<3>},
    ExtremeScene{"step_005", "h = 0.05", "Deformed by each landing, and ringing, but whole.",
                 step_of<5>},
    ExtremeScene{"step_01", "h = 0.1",
                 "Beyond what the floor can carry: a step falls g h² = 0.1, nearly half a radius, "
                 "and the engine warns of pups under the floor.",
                 step_of<10>},
    ExtremeScene{"huge_step", "h = 1",
                 "Crushed like gravity 10⁵, but finite; with drive, f h > 2/3 outruns the wall, "
                 "and the step says so.",
                 huge_step},
    ExtremeScene{"wild_drive", "drive 10⁵", "f h > 2/3 outruns the wall, and the step says so.",
                 wild_drive},
    ExtremeScene{"quiet", "ten million steps of three quiet pups (200,000 with --quick)",
                 "Heights and shapes stay as they are. Sideways they wander within the arena, "
                 "pushed by contacts and rounding, since nothing on the floor slows them.",
                 quiet_litter},
    ExtremeScene{"bad_point", "a NaN put into one point",
                 "The next step names step, pup and point.", bad_point},
};

}  // namespace

std::span<const ExtremeScene> extreme_scenes() {
  return kScenes;
}

}  // namespace pupflow::report
