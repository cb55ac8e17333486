// The extreme scenes one by one. What should happen in each is said in the table
// (stability_scenes.cpp). All of them take the precision and whether to be quick: fewer steps, the
// same check.
#pragma once

#include "app/report/finding.h"
#include "pupflow/parameters.h"

namespace pupflow::report::extreme {

// How many pups, and how near (extreme_crowds.cpp).
Finding pile(Precision precision, bool quick);
/// Soft bodies, much too heavy.
Finding soft_pile(Precision precision, bool quick);
/// 30 pups on a floor for five.
Finding narrow(Precision precision, bool quick);
/// r_pup = 1.9 in an arena of 2.
Finding giants(Precision precision, bool quick);
Finding column(Precision precision, bool quick);
Finding coincident(Precision precision, bool quick);
Finding nobody(Precision precision, bool quick);
Finding alone(Precision precision, bool quick);
Finding quiet_litter(Precision precision, bool quick);

// Falls, steps and drive (extreme_motion.cpp).
Finding drop(Precision precision, bool quick);
Finding heavy(Precision precision, bool quick);
/// g h^2 and alpha are the same as in the ordinary fall: the same positions, step by step.
Finding heavy_scaled(Precision precision, bool quick);
Finding tiny_step(Precision precision, bool quick);
/// h = dt, above the ordinary one.
Finding longer_step(Precision precision, double dt, bool quick);
Finding huge_step(Precision precision, bool quick);
Finding wild_drive(Precision precision, bool quick);

// Single bodies (extreme_bodies.cpp).
/// The default litter with these. Explicit, it may end in a status that names the step, and with
/// alpha above 0 it has to: diverged.
Finding alpha_beta(Precision precision, double alpha, double beta, Integrator integrator,
                   bool quick);
Finding flat(Precision precision, bool quick);
Finding line(Precision precision, bool quick);
Finding point(Precision precision, bool quick);
Finding mirrored(Precision precision, bool quick);
/// k = face_points, 6 k^2 points a pup.
Finding resolution(Precision precision, int face_points, bool quick);
/// r_point = 0.2, nearly r_pup.
Finding large_points(Precision precision, bool quick);
Finding fat_points(Precision precision, bool quick);

// Heat, sensors, a NaN (extreme_numbers.cpp).
/// T_a = ta.
Finding ambient(Precision precision, double ta, bool quick);
Finding no_conductance(Precision precision, bool quick);
Finding stiff_euler(Precision precision, bool quick);
Finding steep_sensors(Precision precision, bool quick);
/// sigma = +-1e9.
Finding sharp_sensors(Precision precision, bool quick);
/// T_b(0) = 1e300.
Finding burning_start(Precision precision, bool quick);
Finding bad_point(Precision precision, bool quick);

}  // namespace pupflow::report::extreme
