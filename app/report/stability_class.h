// What a run is called on the maps of the stability report: one of six classes, by what its bodies
// do in its last quarter.
//
// The paper's litter with its default parameters has to be called stable; the report prints its
// numbers beside the thresholds.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "engine/params.h"
#include "engine/status.h"

namespace pupflow::report {

/// From good to bad. A run that is several of these is called the worst.
enum class Verdict { stable, ringing, interpenetrating, inverted, escaped, diverged };
constexpr int kVerdicts = 6;

std::string_view verdict_name(Verdict verdict);

/// Ringing: the deformation energy (stability_measure.h) of a pup does not settle: its standard
/// deviation in time, mean over pups, is above this. 0.001 is a swing of all points by some 3 % of
/// the radius; the ordinary litter has some hundredth of that.
constexpr double kRingingSwing = 1e-3;

/// Interpenetrating: the nearest two centres are on average nearer than this share of 2 r_pup.
/// Bodies in contact overlap in this model (contacts move points by a small share of their
/// overlap): neighbours in the ordinary litter are at 0.4 to 0.7. Below 0.25 a centre lies deep
/// inside the other body.
constexpr double kOverlap = 0.25;

/// Inverted: the determinant of the linear map fitted to a pup is below zero in more than this
/// share of the looks at all pups: it has been turned inside out for longer than a collision lasts.
constexpr double kInvertedShare = 0.01;

/// Diverged: the step's status went bad (status.h): not finite, or out of all proportion, or
/// escaped.

/// One run and what was seen in its last quarter, every step.
struct Trial {
  Verdict verdict = Verdict::stable;
  Status status;        // when bad, the rest is 0
  double energy = 0;    // mean deformation energy
  double swing = 0;     // its standard deviation in time, mean over pups
  double nearest = 0;   // mean of the nearest centres' distance over 2 r_pup; 0 below two pups
  double inverted = 0;  // share of looks with a negative determinant
};

/// Runs `params.steps` steps and judges. Nothing when `stop`, asked now and then, says so.
std::optional<Trial> try_litter(const Params& params, const std::function<bool()>& stop);

/// The same for heat alone: a pup that nothing pushes, from T_b(0) to its equilibrium. Ringing: T_b
/// passes the equilibrium from one side to the other in most steps. Diverged: the status, or T_b
/// further from equilibrium at the end than at the beginning.
std::optional<Trial> try_heat(const Params& params, const std::function<bool()>& stop);

}  // namespace pupflow::report
