// The scenes of the error report. To add one, write its function in a file beside this header and
// add it to the list.
#pragma once

#include "app/report/error/scene.h"

namespace pupflow::report {

ErrorScene fall_scene(bool quick);      // one pup falls and lands
ErrorScene spin_scene(bool quick);      // one pup turns without weight
ErrorScene squeeze_scene(bool quick);   // one pup springs back
ErrorScene press_scene(bool quick);     // two pups pressed together by their drive
ErrorScene cooling_scene(bool quick);   // one pup cools, slowly and fast
ErrorScene steering_scene(bool quick);  // one pup passes a fixed warm neighbour

/// All of them, in the order of the report.
inline constexpr ErrorScene (*kErrorScenes[])(bool quick) = {
    fall_scene, spin_scene, squeeze_scene, press_scene, cooling_scene, steering_scene};

}  // namespace pupflow::report
