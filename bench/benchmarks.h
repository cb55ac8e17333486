// The benchmarks of pupflow_bench, registered by name: PART/SCENE/... with precision, instruction
// set or threads where they vary.
#pragma once

namespace pupflow::bench {

/// Whole steps over T_a, k, pups, precision, instruction set and threads. Each carries the hash of
/// its litter after some further steps from the common start, so that a wrong answer shows.
void register_steps();

/// Each stage of a step, huddling and dispersed, in both precisions.
void register_stages();

/// Observables, snapshots, copies, hashes and ensembles.
void register_litters();

/// Draw lists, pictures and PNG files.
void register_pictures();

}  // namespace pupflow::bench
