// Docstrings of what no table has. A function's begins with its call; scripts/stubs.py relies on it.
#pragma once

namespace pupflow::python {

inline constexpr const char* kLitterDoc = R"(Litter(scene=None, **parameters)

A litter of pups in its arena.

scene: the name of a shipped scene (pupflow.scenes()), or the path of a scene file.
parameters: any parameter by name, over those of the scene: Litter('cold', seed=1, ta=0.3).

Its attributes are the fields of its pups (numpy arrays) and its parameters. All of them are also
in three groups: params (parameters), pup (fields of a pup), afferent (fields of an afferent, a
point of a pup). Where a name stands for several things, the attribute is the first of: control,
field, parameter. So heading is the direction of travel, and params.heading what a pup steers about.

Arrays show the state after the last step. They are read-only and keep their numbers when the
litter is stepped; read the attribute again for the next state. A field that the last step did not
record raises RuntimeError: strain, until record('strain'), and a few right after load().

Litters may be stepped in several threads at once, each litter by one thread at a time.)";

inline constexpr const char* kStepDoc = R"(step(count=1)

Takes count steps. Other threads run meanwhile, and Ctrl-C ends the call between two steps.
Raises BadNumbers, then and at each later call.)";

inline constexpr const char* kRecordDoc = R"(record(field)

Has the steps to come record what the field of that name shows. Only strain needs it, which costs
time.)";

inline constexpr const char* kObserveDoc = R"(observe()

The observables of the litter after the last step: a dict by name. Those that compare with an
earlier state (flow, membership_flow) are nan before the first step, after load(), and right after
flow_lag was set.)";

inline constexpr const char* kCopyDoc = R"(copy()

A litter of its own that goes on bit for bit like this one.)";

inline constexpr const char* kSaveDoc = R"(save(path, force=False)

Writes a checkpoint, from which load() or `pupflow run --from` goes on bit for bit.
force: replace a file that exists. Once a step has raised BadNumbers, save() does, too.)";

inline constexpr const char* kImageDoc =
    R"(image(width=1280, height=960, *, color_by='tb', colormap=None, scale=None, camera='orbit:30,35',
      bar=True)

A picture of the litter: a numpy array (height, width, 3) of uint8. Needs no display.

color_by: a field of a pup or an afferent. colormap: by default the field's. scale (low, high): by default
the middle 90 % of what is seen, where the field has a scale.
camera: 'top', 'side' or 'orbit:azimuth,elevation[,distance[,view]]'. bar: draw the legend.
Raises RuntimeError where there is no OpenGL, with what to install.)";

inline constexpr const char* kForceDoc =
    R"((pups, 3) acceleration of each pup [length/s^2] in the steps to come, added to gravity and drive.
Writable: litter.force[3] = (1, 0, 0).)";

inline constexpr const char* kHeatDoc =
    R"((pups,) heat of each pup [normalised/s] in the steps to come, added to g. Writable.
params.heat is the parameter of that name.)";

inline constexpr const char* kTurnDoc =
    R"((pups,) turn of each pup [rad/s] in the steps to come, in place of its own; nan: its own. Writable.
pup.turn is the turn that pups took in the last step.)";

inline constexpr const char* kPointsDoc =
    R"(Points of a pup, 6 face_points^2: face by face (+x, +y, +z, -x, -y, -z of the body), each a grid of
face_points x face_points.)";

inline constexpr const char* kPositionDoc =
    R"((pups, points, 3) positions of all points [length], of float32 or float64 as precision is.)";

inline constexpr const char* kVelocityDoc =
    R"((pups, points, 3) velocities of all points [length/s].)";

inline constexpr const char* kHashDoc =
    R"(The hash of the state, as `pupflow run` prints it: equal for equal bits.)";

inline constexpr const char* kWarningsDoc =
    R"(The impossible states so far, the first of each kind, as messages.)";

inline constexpr const char* kThreadsDoc =
    R"(Threads that share a step, 1 ... 1024; results keep their bits.)";

inline constexpr const char* kParamsDoc = R"(All parameters by name, as attributes and as items.)";

inline constexpr const char* kPupDoc =
    R"(All fields of a pup by name, arrays (pups,), as attributes and as items.)";

inline constexpr const char* kAfferentDoc =
    R"(All fields of an afferent by name, arrays (pups, points), as attributes and as items.)";

inline constexpr const char* kLoadDoc = R"(load(path)

The litter of a checkpoint, which goes on bit for bit like the one saved.)";

inline constexpr const char* kRunDoc = R"(run(scene=None, **parameters)

Steps a whole litter (parameter steps) and returns the means over the steps after discard, as
`pupflow run` prints them: a dict of the observables and exposed_sd, nan where no step is left.

scene and parameters as for Litter. Threads that run litters do so at once, and Ctrl-C ends the call.
A litter in an impossible state gives a RuntimeWarning. Raises BadNumbers.)";

inline constexpr const char* kScenesDoc = R"(scenes()

The shipped scenes: a dict of their titles by name.)";

inline constexpr const char* kParametersDoc = R"(parameters()

The table of parameters: a dict of rows by name. A row is a dict of symbol, title, unit, default,
range, choices, doc and source.)";

inline constexpr const char* kFieldsDoc = R"(fields()

The tables of what comes out: 'litter' (observe()), 'run' (run()), 'pup' and 'afferent', each a dict
of rows by name. A row is a dict of symbol, label, unit, kind, low, high, categories, equation and
doc; low and high are None where the data decide.)";

inline constexpr const char* kBadNumbersDoc =
    R"(A number became infinite or NaN, or a body lost all proportion.

kind, stage, step, pup and point say where, as far as they are known (-1: no single one).
The litter stays as the step left it and takes no more steps.)";

}  // namespace pupflow::python
