// The scenes of the error report that are not chaotic.
#pragma once

#include "app/report/error/scene.h"

namespace pupflow::report {

Scene fall_scene(bool quick);      // one pup falls and lands
Scene spin_scene(bool quick);      // one pup turns without weight
Scene squeeze_scene(bool quick);   // one pup springs back
Scene press_scene(bool quick);     // two pups pressed together by their drive
Scene cooling_scene(bool quick);   // one pup cools, slowly and fast
Scene steering_scene(bool quick);  // one pup passes a fixed warm neighbour

}  // namespace pupflow::report
