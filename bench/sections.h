// The sections of pupflow_bench_ratios. Each measures in turns what it compares, prints its tables
// in Markdown and adds to the verdicts.
#pragma once

#include "bench/verdicts.h"

namespace pupflow::bench {

/// Whole steps of the huddling litter: the baselines and the engine. And of others: plain Eigen and
/// the engine.
void whole_steps(int rounds, Verdicts& verdicts);

/// Stages, huddling, dispersed and rigid, and the least that their arithmetic takes here.
void stages(int rounds, Verdicts& verdicts);

/// The contact stage by rule, on the same positions.
void contact_rules(int rounds, Verdicts& verdicts);

/// How far a step is from the rate of memory, and the contact search from the least that it must
/// compare, in sentences.
void step_floors(int rounds, Verdicts& verdicts);

/// Cost of a pup and step, and memory of a pup, at constant density.
void scaling(int rounds, Verdicts& verdicts);

/// One thread and two: a single big litter, and a sweep by the program.
void threads(int rounds, Verdicts& verdicts);

/// Recording: what it adds to a run's time, and its memory.
void recording(int rounds, Verdicts& verdicts);

/// Starting the program.
void start_up(int rounds, Verdicts& verdicts);

/// Pictures: drawing, reading back, encoding. Throws io::Failure without OpenGL.
void pictures(int rounds, Verdicts& verdicts);

}  // namespace pupflow::bench
