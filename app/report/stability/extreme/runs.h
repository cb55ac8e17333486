// The functions that run the extreme scenes. The table in scenes.cpp has the expected results. To
// add a scene, write its function here and its row there. `quick` means fewer steps and the same
// check.
#pragma once

#include "app/report/stability/extreme/finding.h"
#include "pupflow/parameters.h"

namespace pupflow::report::extreme {

// Number and density of pups (crowds.cpp).
Finding pile(Precision precision, bool quick);
/// Soft bodies that are too heavy.
Finding soft_pile(Precision precision, bool quick);
/// 30 pups in an arena that has room for five.
Finding narrow(Precision precision, bool quick);
/// r_pup = 1.9 in an arena of 2.
Finding giants(Precision precision, bool quick);
Finding column(Precision precision, bool quick);
Finding coincident(Precision precision, bool quick);
Finding no_pup(Precision precision, bool quick);
Finding alone(Precision precision, bool quick);
Finding quiet_litter(Precision precision, bool quick);

// Falls, steps and drive (motion.cpp).
Finding drop(Precision precision, bool quick);
Finding heavy(Precision precision, bool quick);
/// g h^2 and alpha are the same as in the ordinary fall: the same positions, step by step.
Finding heavy_scaled(Precision precision, bool quick);
Finding tiny_step(Precision precision, bool quick);
/// h = dt, longer than the default.
Finding longer_step(Precision precision, double dt, bool quick);
Finding huge_step(Precision precision, bool quick);
Finding wild_drive(Precision precision, bool quick);

// Single bodies (bodies.cpp).
/// The default litter with these values. With the explicit integrator it may end in a status that
/// names the step; with alpha > 0 it must, as diverged.
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

// Heat, sensors, a NaN (numbers.cpp).
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
