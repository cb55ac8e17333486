#include "app/report/stability/extreme/scenes.h"

#include <array>

#include "app/report/stability/extreme/runs.h"

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
        "All numbers are finite and no pup leaves the arena. Bodies keep their volume but overlap, "
        "so each touches many.",
        pile},
    ExtremeScene{
        "soft_pile", "α = 1, β = 0.99, 200 pups, gravity 1000",
        "Crushed bodies with almost no restoring shape grow without bound, which the status "
        "reports.",
        soft_pile},
    ExtremeScene{"narrow", "30 pups in an arena of radius 0.6",
                 "They overlap, with most points inside another body, and keep their shapes.",
                 narrow},
    ExtremeScene{
        "giants", "r_pup = 1.9 in an arena of radius 2",
        "The arena has room for one. Twelve pups lie in the same place and keep their shapes.",
        giants},
    ExtremeScene{
        "column", "10,000 pups in one column",
        "Only neighbours are searched, so a step takes little time; all numbers are finite.",
        column},
    ExtremeScene{
        "coincident", "two pups with the same points",
        "A distance of 0 causes no division by 0; ties go to the lower pup, and both keep their "
        "shape.",
        coincident},
    ExtremeScene{
        "drop", "one pup dropped from a height of 10⁴",
        "The fall equals the closed form. At a speed of 450 the floor reverses all points "
        "within one step, so the pup bounces to about the same height and keeps its shape.",
        drop},
    ExtremeScene{
        "heavy", "gravity 10⁵, h = 0.01",
        "A pup falls g h² = 10 in a step, which is 40 radii: the floor flattens every pup in "
        "every step. All numbers are finite.",
        heavy},
    ExtremeScene{"heavy_scaled", "gravity 10⁵, h = 10⁻⁴",
                 "g h² has the default value, so the fall and the landing are the same.",
                 heavy_scaled},
    ExtremeScene{"alpha0_beta0", "α = 0, β = 0", "The points scatter; all numbers are finite.",
                 corner<0, 0, kPredictive>},
    ExtremeScene{"alpha0_beta1", "α = 0, β = 1", "The same: with α = 0, β has no effect.",
                 corner<0, 1, kPredictive>},
    ExtremeScene{"alpha1_beta0", "α = 1, β = 0", "Rigid: no deformation beyond rounding.",
                 corner<1, 0, kPredictive>},
    ExtremeScene{"alpha1_beta1", "α = 1, β = 1",
                 "No restoring shape: bodies spread over the floor and do not grow.",
                 corner<1, 1, kPredictive>},
    ExtremeScene{"explicit_alpha0_beta0", "α = 0, β = 0, explicit",
                 "The points scatter; with α = 0 there is no oscillation.",
                 corner<0, 0, kExplicit>},
    ExtremeScene{"explicit_alpha1_beta0", "α = 1, β = 0, explicit",
                 "Undamped: it diverges, which the status reports.", corner<1, 0, kExplicit>},
    ExtremeScene{"explicit_alpha1_beta1", "α = 1, β = 1, explicit",
                 "Undamped: it diverges, which the status reports.", corner<1, 1, kExplicit>},
    ExtremeScene{"flat", "a cloud that starts flat", "Its shape is restored.", flat},
    ExtremeScene{"line", "a cloud that starts as a line",
                 "Its shape is restored, with any rotation.", line},
    ExtremeScene{"point", "a cloud that starts as a point",
                 "Its shape is restored, with any rotation.", point},
    ExtremeScene{"mirrored", "a cloud that starts inverted",
                 "Its shape is restored without reflection: rotations have the determinant 1.",
                 mirrored},
    ExtremeScene{"k2", "24 points a pup (k = 2)", "Ordinary shapes.", points<2>},
    ExtremeScene{"k32", "6144 points a pup (k = 32)", "Ordinary shapes.", points<32>},
    ExtremeScene{"large_points", "r_point = 0.2, r_pup = 0.25",
                 "Bodies do not overlap: no point gets inside another body.", large_points},
    ExtremeScene{
        "fat_points", "r_point = 0.5 above r_pup = 0.25",
        "Fine with contact = nearest. With contact = sum each point adds up displacements by "
        "most points of the other pup, many radii, and the status of the contact stage "
        "reports it.",
        fat_points},
    ExtremeScene{"freezing", "T_a = −10⁶",
                 "T_b converges to T_a, apart from the heat that a huddle makes.", air<-1>},
    ExtremeScene{"burning", "T_a = 10⁶",
                 "T_b converges to T_a, apart from the heat that a huddle makes.", air<1>},
    ExtremeScene{"no_conductance", "k₁ = k₂ = 0", "T_b = T_b(0) + G t; with G = 0, T_b(0).",
                 no_conductance},
    ExtremeScene{
        "stiff_heat", "k₁ = 500 by Euler, 10³⁰⁰ exactly",
        "Euler overshoots more in each step, which the status of the heat stage reports; the "
        "exact solution is at T_a after one step.",
        stiff_euler},
    ExtremeScene{"steep_sensors", "σ = v = 10³⁰⁰", "Headings are finite.", steep_sensors},
    ExtremeScene{
        "sharp_sensors", "σ = ± 10⁹",
        "S is 0 or 1, headings are finite, and bodies keep their shapes; with σ < 0 pups turn "
        "away from what they would approach.",
        sharp_sensors},
    ExtremeScene{"burning_start", "T_b(0) = 10³⁰⁰", "T_b falls by at most the factor e^(−k₁ t).",
                 burning_start},
    ExtremeScene{"no_pup", "no pup", "Steps do nothing.", no_pup},
    ExtremeScene{"alone", "one pup", "It has no contact; T_b equals its closed form.", alone},
    ExtremeScene{
        "tiny_step", "h = 10⁻⁸",
        "v = −g t from rest. Single precision is refused: its rounding, divided by h, would "
        "accelerate the pups.",
        tiny_step},
    ExtremeScene{"step_003", "h = 0.03", "Softer bodies that keep their shapes.", step_of<3>},
    ExtremeScene{"step_005", "h = 0.05", "Bodies deform at each landing and ring, but stay whole.",
                 step_of<5>},
    ExtremeScene{
        "step_01", "h = 0.1",
        "A pup falls g h² = 0.1 in a step, nearly half a radius, so the floor cannot hold it, "
        "and the engine warns of pups under the floor.",
        step_of<10>},
    ExtremeScene{"huge_step", "h = 1",
                 "As with gravity 10⁵; all numbers are finite. With drive, f h > 2/3, so the wall "
                 "cannot hold the pups, which the status reports.",
                 huge_step},
    ExtremeScene{"wild_drive", "drive 10⁵",
                 "f h > 2/3, so the wall cannot hold the pups, which the status reports.",
                 wild_drive},
    ExtremeScene{
        "quiet", "ten million steps of three pups without drive (200,000 with --quick)",
        "Heights and shapes do not change. Pups drift sideways within the arena by contacts "
        "and rounding, since there is no friction.",
        quiet_litter},
    ExtremeScene{"bad_point", "one point set to NaN",
                 "The status of the next step names step, pup and point.", bad_point},
};

}  // namespace

std::span<const ExtremeScene> extreme_scenes() {
  return kScenes;
}

}  // namespace pupflow::report
