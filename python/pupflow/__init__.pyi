"""Litters of soft, warm pups that huddle (Wilson 2017).

>>> import pupflow
>>> litter = pupflow.Litter("cold", seed=1, ta=0.3)
>>> litter.step(500)
>>> litter.tb.shape
(12,)

help(pupflow.Litter) lists all that a litter shows and takes; docs/python.md has examples.
"""

# Written by scripts/stubs.py.

from collections.abc import Callable, Iterator, Mapping
from os import PathLike
from typing import Any, Literal, Protocol, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
__all__: list[str]

_Numbers = NDArray[np.float64]

class BadNumbers(ArithmeticError):
    """A number became infinite or NaN, or a body lost all proportion.

    kind, stage, step, pup and point say where, as far as they are known (-1: no single one).
    The litter stays as the step left it and takes no more steps.
    """
    kind: str
    stage: str
    step: int
    pup: int
    point: int

class Observables(TypedDict):
    mean_tb: float
    huddling: float
    groups: float
    largest: float
    flow: float
    membership_flow: float

class Means(TypedDict):
    mean_tb: float
    huddling: float
    groups: float
    largest: float
    flow: float
    membership_flow: float
    exposed_sd: float

class _Group(Mapping[str, Any]):
    def keys(self) -> list[str]: ...  # type: ignore[override]
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def __getitem__(self, name: str, /) -> Any: ...

class Params(_Group):
    """All parameters by name, as attributes and as items."""
    @property
    def alpha(self) -> float:
        """rigidity α [per step]: 0 … 1; 0.7 by default.

        Share of the way to its goal that a point goes in one step; 1 is rigid, 0 a loose cloud.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @alpha.setter
    def alpha(self, value: float) -> None: ...
    @property
    def arena_radius(self) -> float:
        """arena radius r_arena [length]: > 1e-06 and ≤ 1e+09; 2 by default.

        Radius of the round wall; must exceed r_pup + r_point.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @arena_radius.setter
    def arena_radius(self, value: float) -> None: ...
    @property
    def beta(self) -> float:
        """deformation β: 0 … 1; 0.5 by default.

        How far goals follow the best quadratic fit (1) instead of the best rotation (0); 1 has no shape of its own.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @beta.setter
    def beta(self, value: float) -> None: ...
    @property
    def contact(self) -> Literal["nearest", "mean", "sum"]:
        """contact rule: nearest or mean or sum; nearest by default.

        nearest: a point is moved by its nearest touching lower point alone; mean: by the mean over all of them; sum: by their sum.
        A change acts from the next step on.
        Source: readings of Wilson 2017
        """
    @contact.setter
    def contact(self, value: Literal["nearest", "mean", "sum"]) -> None: ...
    @property
    def discard(self) -> int:
        """steps left out: a whole number 0 … 2^53 - 1; 500 by default.

        Steps at the beginning that stay out of a run's means.
        Belongs to a run, not to the litter.
        Source: Wilson 2017
        """
    @discard.setter
    def discard(self, value: int) -> None: ...
    @property
    def drive(self) -> float:
        """drive f [length/s²]: ≥ 0; 1 by default.

        Acceleration of a pup along its direction of travel.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @drive.setter
    def drive(self, value: float) -> None: ...
    @property
    def dt(self) -> float:
        """time step h [s]: > 1e-09 and ≤ 1000; 0.01 by default.

        Length of a step. Rigidity acts per step, so 0.01 is part of the model.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @dt.setter
    def dt(self, value: float) -> None: ...
    @property
    def face_points(self) -> int:
        """points along a face edge k: a whole number 2 … 32; 7 by default.

        Each pup has n = 6 k² points on its surface.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @face_points.setter
    def face_points(self, value: int) -> None: ...
    @property
    def flow_lag(self) -> int:
        """lag of pup flow [steps]: a whole number 1 … 10000; 1 by default.

        Pup flow is the change of A over so many steps, divided by their time.
        Belongs to a run, not to the litter.
        Source: Wilson 2017
        """
    @flow_lag.setter
    def flow_lag(self, value: int) -> None: ...
    @property
    def g(self) -> float:
        """thermogenesis G [1/s]: any finite number; 0.055 by default.

        Heat that each pup makes.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @g.setter
    def g(self, value: float) -> None: ...
    @property
    def gravity(self) -> float:
        """gravity g [length/s²]: ≥ 0; 10 by default.

        Acceleration downwards.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @gravity.setter
    def gravity(self, value: float) -> None: ...
    @property
    def heading(self) -> Literal["course", "body"]:
        """heading: course or body; course by default.

        course: the direction of travel is the pup's own state and turns; body: it is taken from the body axis at every step.
        A change acts from the next step on.
        Source: both readings of Wilson 2017
        """
    @heading.setter
    def heading(self, value: Literal["course", "body"]) -> None: ...
    @property
    def heat(self) -> Literal["exact", "euler"]:
        """heat rule: exact or euler; exact by default.

        How body temperature is stepped: the exact solution over the step, or forward Euler.
        A change acts from the next step on.
        Source: exact: this program; euler: Wilson 2017
        """
    @heat.setter
    def heat(self, value: Literal["exact", "euler"]) -> None: ...
    @property
    def integrator(self) -> Literal["predictive", "explicit"]:
        """integrator: predictive or explicit; predictive by default.

        predictive: goals from the predicted points; explicit: from the current ones, undamped.
        A change acts from the next step on.
        Source: predictive: Müller 2005; explicit: Wilson 2017
        """
    @integrator.setter
    def integrator(self, value: Literal["predictive", "explicit"]) -> None: ...
    @property
    def k1(self) -> float:
        """conductance to the air k₁ [1/s]: ≥ 0; 0.9 by default.

        Rate of heat loss through the exposed surface.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @k1.setter
    def k1(self, value: float) -> None: ...
    @property
    def k2(self) -> float:
        """conductance to others k₂ [1/s]: ≥ 0; 1 by default.

        Rate of heat exchange through the touching surface.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @k2.setter
    def k2(self, value: float) -> None: ...
    @property
    def point_radius(self) -> float:
        """point radius r_point [length]: > 1e-06 and ≤ 1e+06; 0.05 by default.

        Radius of the sphere at each point, by which it touches.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @point_radius.setter
    def point_radius(self, value: float) -> None: ...
    @property
    def precision(self) -> Literal["float", "double"]:
        """precision: float or double; double by default.

        Arithmetic of the points; temperatures and headings are always double.
        Defines the litter: only a new Litter takes another value.
        Source: this program
        """
    @precision.setter
    def precision(self, value: Literal["float", "double"]) -> None: ...
    @property
    def pup_radius(self) -> float:
        """pup radius r_pup [length]: > 1e-06 and ≤ 1e+06; 0.25 by default.

        Radius of the sphere on which a pup's points rest.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @pup_radius.setter
    def pup_radius(self, value: float) -> None: ...
    @property
    def pups(self) -> int:
        """pups N: a whole number 0 … 10000; 12 by default.

        Number of pups in the litter.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @pups.setter
    def pups(self, value: int) -> None: ...
    @property
    def refinement(self) -> Literal["naive", "consistent"]:
        """refinement: naive or consistent; naive by default.

        naive: rigidity per step, whatever dt; consistent: per 0.01 s, so that a smaller dt is the same body.
        A change acts from the next step on.
        Source: naive: Wilson 2017; consistent: this program
        """
    @refinement.setter
    def refinement(self, value: Literal["naive", "consistent"]) -> None: ...
    @property
    def seed(self) -> int:
        """seed: a whole number 0 … 2^53 - 1; 1 by default.

        Fixes every random number: same seed, same bits.
        Defines the litter: only a new Litter takes another value.
        Source: this program
        """
    @seed.setter
    def seed(self, value: int) -> None: ...
    @property
    def sigma(self) -> float:
        """sensitivity σ: any finite number; 38 by default.

        Steepness of the two temperature sensors.
        A change acts from the next step on.
        Source: not in the paper; 0.01 per deg C² in the author's 2-D model × 61.67²
        """
    @sigma.setter
    def sigma(self, value: float) -> None: ...
    @property
    def start(self) -> Literal["column", "carpet"]:
        """start layout: column or carpet; column by default.

        column: dropped one above the other at the centre; carpet: laid out over the floor, for many pups.
        Defines the litter: only a new Litter takes another value.
        Source: column: Wilson 2017
        """
    @start.setter
    def start(self, value: Literal["column", "carpet"]) -> None: ...
    @property
    def start_spread(self) -> float:
        """start spread [length]: 0 … 1e+06; 0.25 by default.

        Half-width of the drop column in x and y; at most r_arena / √2, for all pups to start inside.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @start_spread.setter
    def start_spread(self, value: float) -> None: ...
    @property
    def steps(self) -> int:
        """steps: a whole number 0 … 2^53 - 1; 1500 by default.

        Length of a run.
        Belongs to a run, not to the litter.
        Source: Wilson 2017
        """
    @steps.setter
    def steps(self, value: int) -> None: ...
    @property
    def ta(self) -> float:
        """ambient temperature T_a: any finite number; 0.4 by default.

        Temperature of the arena; every afferent without contact reads it. 0.6 is 37 deg C.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @ta.setter
    def ta(self, value: float) -> None: ...
    @property
    def tb0(self) -> float:
        """initial body temperature T_b(0): any finite number; 0.6 by default.

        Body temperature of every pup at t = 0.
        Defines the litter: only a new Litter takes another value.
        Source: not in the paper; the author's 2-D model
        """
    @tb0.setter
    def tb0(self, value: float) -> None: ...
    @property
    def tp(self) -> float:
        """preferred temperature T_p: any finite number; 0.6 by default.

        Body temperature that a pup seeks; 0.6 is 37 deg C.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @tp.setter
    def tp(self, value: float) -> None: ...
    @property
    def v(self) -> float:
        """steering gain v: ≥ 0; 200 by default.

        Gain from sensor contrast to turning.
        A change acts from the next step on.
        Source: not in the paper; the author's 2-D model
        """
    @v.setter
    def v(self, value: float) -> None: ...

class PupFields(_Group):
    """All fields of a pup by name, arrays (pups,), as attributes and as items."""
    @property
    def deformation(self) -> _Numbers:
        """(pups,) deformation, continuous, drawn from 0 to data.

        Root mean square distance of the points from the undeformed pup q at its best rotation R, in pup radii.
        sqrt(mean over points of |x − x_cm − R q|²) / r_pup
        """
    @property
    def exposed(self) -> _Numbers:
        """(pups,) exposed share A, continuous, drawn from 0 to 1.

        Share of the pup's points that touch no other pup.
        points without contact / n
        """
    @property
    def felt_tb(self) -> _Numbers:
        """(pups,) felt body temperature T_b', continuous, drawn from 0 to 1.

        What others felt of the pup in the step.
        T_b before the heat stage of the step
        """
    @property
    def group(self) -> _Numbers:
        """(pups,) group, categorical, drawn from 0 to data.

        Number of the pup's group.
        component of the contact graph, numbered by its lowest pup
        """
    @property
    def group_size(self) -> _Numbers:
        """(pups,) pups in the group [pups], continuous, drawn from 1 to data.

        Pups in the pup's group, itself included.
        """
    @property
    def heading(self) -> _Numbers:
        """(pups,) direction of travel θ [rad], angle, drawn from -3.141592653589793 to 3.141592653589793.

        Direction in which the pup drives, counter-clockwise from the x axis.
        """
    @property
    def height(self) -> _Numbers:
        """(pups,) height z [length], continuous, drawn from 0 to data.

        Height of the pup's centre above the floor.
        mean over points of z
        """
    @property
    def huddling(self) -> _Numbers:
        """(pups,) touching share 1 − A, continuous, drawn from 0 to 1.

        Share of the pup's points that touch another pup.
        1 − A
        """
    @property
    def neighbours(self) -> _Numbers:
        """(pups,) pups touched [pups], continuous, drawn from 0 to data.

        Other pups that the pup touches.
        """
    @property
    def qw(self) -> _Numbers:
        """(pups,) orientation, w qw, signed, drawn from -1 to 1.

        Part of the unit quaternion that turns the pup at rest to where it is; qw is not negative.
        R nearest to the sum over points of (x − x_cm) qᵀ
        """
    @property
    def qx(self) -> _Numbers:
        """(pups,) orientation, x qx, signed, drawn from -1 to 1.

        Part of the unit quaternion that turns the pup at rest to where it is; qw is not negative.
        R nearest to the sum over points of (x − x_cm) qᵀ
        """
    @property
    def qy(self) -> _Numbers:
        """(pups,) orientation, y qy, signed, drawn from -1 to 1.

        Part of the unit quaternion that turns the pup at rest to where it is; qw is not negative.
        R nearest to the sum over points of (x − x_cm) qᵀ
        """
    @property
    def qz(self) -> _Numbers:
        """(pups,) orientation, z qz, signed, drawn from -1 to 1.

        Part of the unit quaternion that turns the pup at rest to where it is; qw is not negative.
        R nearest to the sum over points of (x − x_cm) qᵀ
        """
    @property
    def speed(self) -> _Numbers:
        """(pups,) speed |v| [length/s], continuous, drawn from 0 to data.

        Speed of the pup's centre.
        |mean over points of v|
        """
    @property
    def t_left(self) -> _Numbers:
        """(pups,) temperature felt on the left T_L, continuous, drawn from 0 to 1.

        Mean temperature of the afferents on the left; T_a where there is none.
        mean of T_c over the points on the left
        """
    @property
    def t_right(self) -> _Numbers:
        """(pups,) temperature felt on the right T_R, continuous, drawn from 0 to 1.

        Mean temperature of the afferents on the right; T_a where there is none.
        mean of T_c over the points on the right
        """
    @property
    def tb(self) -> _Numbers:
        """(pups,) body temperature T_b, continuous, drawn from 0 to 1.

        Body temperature after the step; 0.6 is 37 deg C.
        dT_b/dt = G − k_1 A (T_b − T_a) − k_2 (1 − A) (T_b − mean of touched T_c)
        """
    @property
    def turn(self) -> _Numbers:
        """(pups,) turn Δθ [rad/s], signed, drawn from -1.5707963267948966 to 1.5707963267948966.

        How fast the pup turns to the left; with heading = body the angle, in rad, from body axis to direction of travel.
        atan(v (S_L − S_R) / (S_L + S_R)), S = 1 / (1 + exp(−σ T (T_p − T_b')))
        """
    @property
    def x(self) -> _Numbers:
        """(pups,) centre x [length], continuous, drawn from data to data.

        Coordinate of the pup's centre; z is its height above the floor.
        mean over points of the coordinate
        """
    @property
    def y(self) -> _Numbers:
        """(pups,) centre y [length], continuous, drawn from data to data.

        Coordinate of the pup's centre; z is its height above the floor.
        mean over points of the coordinate
        """
    @property
    def z(self) -> _Numbers:
        """(pups,) centre z [length], continuous, drawn from data to data.

        Coordinate of the pup's centre; z is its height above the floor.
        mean over points of the coordinate
        """

class AfferentFields(_Group):
    """All fields of an afferent by name, arrays (pups, points), as attributes and as items."""
    @property
    def normal_x(self) -> _Numbers:
        """(pups, points) normal at rest, x q_x, signed, drawn from -1 to 1.

        Outward direction of the point on the pup at rest, x in body axes.
        """
    @property
    def normal_y(self) -> _Numbers:
        """(pups, points) normal at rest, y q_y, signed, drawn from -1 to 1.

        Outward direction of the point on the pup at rest, y in body axes.
        """
    @property
    def normal_z(self) -> _Numbers:
        """(pups, points) normal at rest, z q_z, signed, drawn from -1 to 1.

        Outward direction of the point on the pup at rest, z in body axes.
        """
    @property
    def side(self) -> _Numbers:
        """(pups, points) side, categorical, drawn from 0 to 1.

        Side that the afferent was on when the pup steered: 1 left, 0 right. φ is θ before the turn; with heading = body it is the body axis, and the tail is on the right.
        1 where cos φ (y − y_cm) − sin φ (x − x_cm) > 0, else 0
        """
    @property
    def strain(self) -> _Numbers:
        """(pups, points) strain, continuous, drawn from 0 to data.

        Distance of the point from its goal before it is pulled there, in pup radii.
        |g − x*| / r_pup
        """
    @property
    def temperature(self) -> _Numbers:
        """(pups, points) afferent temperature T_c, continuous, drawn from 0 to 1.

        What the afferent feels: felt_tb of the pup that it touches, T_a where it touches no pup.
        T_b' of the touched pup, or T_a
        """
    @property
    def touched(self) -> _Numbers:
        """(pups, points) touched pup, categorical, drawn from -1 to data.

        The pup whose point is the nearest touching one; -1 where there is none.
        """

class Litter:
    """Litter(scene=None, **parameters)

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

    Litters may be stepped in several threads at once, each litter by one thread at a time.
    """
    def __init__(self, scene: str | PathLike[str] | None = None, *, ta: float = ..., alpha: float = ..., beta: float = ..., gravity: float = ..., contact: Literal["nearest", "mean", "sum"] = ..., tp: float = ..., k1: float = ..., k2: float = ..., g: float = ..., heat: Literal["exact", "euler"] = ..., tb0: float = ..., drive: float = ..., sigma: float = ..., v: float = ..., heading: Literal["course", "body"] = ..., pups: int = ..., face_points: int = ..., pup_radius: float = ..., point_radius: float = ..., arena_radius: float = ..., start: Literal["column", "carpet"] = ..., start_spread: float = ..., dt: float = ..., refinement: Literal["naive", "consistent"] = ..., integrator: Literal["predictive", "explicit"] = ..., steps: int = ..., discard: int = ..., flow_lag: int = ..., seed: int = ..., precision: Literal["float", "double"] = ...) -> None: ...
    @property
    def afferent(self) -> AfferentFields:
        """All fields of an afferent by name, arrays (pups, points), as attributes and as items."""
    @property
    def alpha(self) -> float:
        """rigidity α [per step]: 0 … 1; 0.7 by default.

        Share of the way to its goal that a point goes in one step; 1 is rigid, 0 a loose cloud.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @alpha.setter
    def alpha(self, value: float) -> None: ...
    @property
    def arena_radius(self) -> float:
        """arena radius r_arena [length]: > 1e-06 and ≤ 1e+09; 2 by default.

        Radius of the round wall; must exceed r_pup + r_point.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @arena_radius.setter
    def arena_radius(self, value: float) -> None: ...
    @property
    def beta(self) -> float:
        """deformation β: 0 … 1; 0.5 by default.

        How far goals follow the best quadratic fit (1) instead of the best rotation (0); 1 has no shape of its own.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @beta.setter
    def beta(self, value: float) -> None: ...
    @property
    def contact(self) -> Literal["nearest", "mean", "sum"]:
        """contact rule: nearest or mean or sum; nearest by default.

        nearest: a point is moved by its nearest touching lower point alone; mean: by the mean over all of them; sum: by their sum.
        A change acts from the next step on.
        Source: readings of Wilson 2017
        """
    @contact.setter
    def contact(self, value: Literal["nearest", "mean", "sum"]) -> None: ...
    def copy(self) -> Litter:
        """A litter of its own that goes on bit for bit like this one."""
    @property
    def deformation(self) -> _Numbers:
        """(pups,) deformation, continuous, drawn from 0 to data.

        Root mean square distance of the points from the undeformed pup q at its best rotation R, in pup radii.
        sqrt(mean over points of |x − x_cm − R q|²) / r_pup
        """
    @property
    def discard(self) -> int:
        """steps left out: a whole number 0 … 2^53 - 1; 500 by default.

        Steps at the beginning that stay out of a run's means.
        Belongs to a run, not to the litter.
        Source: Wilson 2017
        """
    @discard.setter
    def discard(self, value: int) -> None: ...
    @property
    def drive(self) -> float:
        """drive f [length/s²]: ≥ 0; 1 by default.

        Acceleration of a pup along its direction of travel.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @drive.setter
    def drive(self, value: float) -> None: ...
    @property
    def dt(self) -> float:
        """time step h [s]: > 1e-09 and ≤ 1000; 0.01 by default.

        Length of a step. Rigidity acts per step, so 0.01 is part of the model.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @dt.setter
    def dt(self, value: float) -> None: ...
    @property
    def exposed(self) -> _Numbers:
        """(pups,) exposed share A, continuous, drawn from 0 to 1.

        Share of the pup's points that touch no other pup.
        points without contact / n
        """
    @property
    def face_points(self) -> int:
        """points along a face edge k: a whole number 2 … 32; 7 by default.

        Each pup has n = 6 k² points on its surface.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @face_points.setter
    def face_points(self, value: int) -> None: ...
    @property
    def felt_tb(self) -> _Numbers:
        """(pups,) felt body temperature T_b', continuous, drawn from 0 to 1.

        What others felt of the pup in the step.
        T_b before the heat stage of the step
        """
    @property
    def flow_lag(self) -> int:
        """lag of pup flow [steps]: a whole number 1 … 10000; 1 by default.

        Pup flow is the change of A over so many steps, divided by their time.
        Belongs to a run, not to the litter.
        Source: Wilson 2017
        """
    @flow_lag.setter
    def flow_lag(self, value: int) -> None: ...
    @property
    def force(self) -> _Numbers:
        """(pups, 3) acceleration of each pup [length/s^2] in the steps to come, added to gravity and drive.
        Writable: litter.force[3] = (1, 0, 0).
        """
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    @property
    def g(self) -> float:
        """thermogenesis G [1/s]: any finite number; 0.055 by default.

        Heat that each pup makes.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @g.setter
    def g(self, value: float) -> None: ...
    @property
    def gravity(self) -> float:
        """gravity g [length/s²]: ≥ 0; 10 by default.

        Acceleration downwards.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @gravity.setter
    def gravity(self, value: float) -> None: ...
    @property
    def group(self) -> _Numbers:
        """(pups,) group, categorical, drawn from 0 to data.

        Number of the pup's group.
        component of the contact graph, numbered by its lowest pup
        """
    @property
    def group_size(self) -> _Numbers:
        """(pups,) pups in the group [pups], continuous, drawn from 1 to data.

        Pups in the pup's group, itself included.
        """
    @property
    def hash(self) -> str:
        """The hash of the state, as `pupflow run` prints it: equal for equal bits."""
    @property
    def heading(self) -> _Numbers:
        """(pups,) direction of travel θ [rad], angle, drawn from -3.141592653589793 to 3.141592653589793.

        Direction in which the pup drives, counter-clockwise from the x axis.
        """
    @property
    def heat(self) -> _Numbers:
        """(pups,) heat of each pup [normalised/s] in the steps to come, added to g. Writable.
        params.heat is the parameter of that name.
        """
    @heat.setter
    def heat(self, value: ArrayLike) -> None: ...
    @property
    def height(self) -> _Numbers:
        """(pups,) height z [length], continuous, drawn from 0 to data.

        Height of the pup's centre above the floor.
        mean over points of z
        """
    @property
    def huddling(self) -> _Numbers:
        """(pups,) touching share 1 − A, continuous, drawn from 0 to 1.

        Share of the pup's points that touch another pup.
        1 − A
        """
    def image(
            self, width: int = 1280, height: int = 960, *, color_by: str = "tb", colormap: str | None = None,
            scale: tuple[float, float] | None = None, camera: str = "orbit:30,35", bar: bool = True
        ) -> NDArray[np.uint8]:
        """A picture of the litter: a numpy array (height, width, 3) of uint8. Needs no display.

        color_by: a field of a pup or an afferent. colormap: by default the field's. scale (low, high): by default
        the middle 90 % of what is seen, where the field has a scale.
        camera: 'top', 'side' or 'orbit:azimuth,elevation[,distance[,view]]'. bar: draw the legend.
        Raises RuntimeError where there is no OpenGL, with what to install.
        """
    @property
    def integrator(self) -> Literal["predictive", "explicit"]:
        """integrator: predictive or explicit; predictive by default.

        predictive: goals from the predicted points; explicit: from the current ones, undamped.
        A change acts from the next step on.
        Source: predictive: Müller 2005; explicit: Wilson 2017
        """
    @integrator.setter
    def integrator(self, value: Literal["predictive", "explicit"]) -> None: ...
    @property
    def k1(self) -> float:
        """conductance to the air k₁ [1/s]: ≥ 0; 0.9 by default.

        Rate of heat loss through the exposed surface.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @k1.setter
    def k1(self, value: float) -> None: ...
    @property
    def k2(self) -> float:
        """conductance to others k₂ [1/s]: ≥ 0; 1 by default.

        Rate of heat exchange through the touching surface.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @k2.setter
    def k2(self, value: float) -> None: ...
    @property
    def neighbours(self) -> _Numbers:
        """(pups,) pups touched [pups], continuous, drawn from 0 to data.

        Other pups that the pup touches.
        """
    def observe(self) -> Observables:
        """The observables of the litter after the last step: a dict by name. Those that compare with an
        earlier state (flow, membership_flow) are nan before the first step, after load(), and right after
        flow_lag was set.
        """
    @property
    def params(self) -> Params:
        """All parameters by name, as attributes and as items."""
    @property
    def point_radius(self) -> float:
        """point radius r_point [length]: > 1e-06 and ≤ 1e+06; 0.05 by default.

        Radius of the sphere at each point, by which it touches.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @point_radius.setter
    def point_radius(self, value: float) -> None: ...
    @property
    def points(self) -> int:
        """Points of a pup, 6 face_points^2: face by face (+x, +y, +z, -x, -y, -z of the body), each a grid of
        face_points x face_points.
        """
    @property
    def position(self) -> NDArray[np.floating[Any]]:
        """(pups, points, 3) positions of all points [length], of float32 or float64 as precision is."""
    @property
    def precision(self) -> Literal["float", "double"]:
        """precision: float or double; double by default.

        Arithmetic of the points; temperatures and headings are always double.
        Defines the litter: only a new Litter takes another value.
        Source: this program
        """
    @precision.setter
    def precision(self, value: Literal["float", "double"]) -> None: ...
    @property
    def pup(self) -> PupFields:
        """All fields of a pup by name, arrays (pups,), as attributes and as items."""
    @property
    def pup_radius(self) -> float:
        """pup radius r_pup [length]: > 1e-06 and ≤ 1e+06; 0.25 by default.

        Radius of the sphere on which a pup's points rest.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @pup_radius.setter
    def pup_radius(self, value: float) -> None: ...
    @property
    def pups(self) -> int:
        """pups N: a whole number 0 … 10000; 12 by default.

        Number of pups in the litter.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @pups.setter
    def pups(self, value: int) -> None: ...
    @property
    def qw(self) -> _Numbers:
        """(pups,) orientation, w qw, signed, drawn from -1 to 1.

        Part of the unit quaternion that turns the pup at rest to where it is; qw is not negative.
        R nearest to the sum over points of (x − x_cm) qᵀ
        """
    @property
    def qx(self) -> _Numbers:
        """(pups,) orientation, x qx, signed, drawn from -1 to 1.

        Part of the unit quaternion that turns the pup at rest to where it is; qw is not negative.
        R nearest to the sum over points of (x − x_cm) qᵀ
        """
    @property
    def qy(self) -> _Numbers:
        """(pups,) orientation, y qy, signed, drawn from -1 to 1.

        Part of the unit quaternion that turns the pup at rest to where it is; qw is not negative.
        R nearest to the sum over points of (x − x_cm) qᵀ
        """
    @property
    def qz(self) -> _Numbers:
        """(pups,) orientation, z qz, signed, drawn from -1 to 1.

        Part of the unit quaternion that turns the pup at rest to where it is; qw is not negative.
        R nearest to the sum over points of (x − x_cm) qᵀ
        """
    def record(self, field: str) -> None:
        """Has the steps to come record what the field of that name shows. Only strain needs it, which costs
        time.
        """
    @property
    def refinement(self) -> Literal["naive", "consistent"]:
        """refinement: naive or consistent; naive by default.

        naive: rigidity per step, whatever dt; consistent: per 0.01 s, so that a smaller dt is the same body.
        A change acts from the next step on.
        Source: naive: Wilson 2017; consistent: this program
        """
    @refinement.setter
    def refinement(self, value: Literal["naive", "consistent"]) -> None: ...
    def save(self, path: str | PathLike[str], force: bool = False) -> None:
        """Writes a checkpoint, from which load() or `pupflow run --from` goes on bit for bit.
        force: replace a file that exists. Once a step has raised BadNumbers, save() does, too.
        """
    @property
    def seed(self) -> int:
        """seed: a whole number 0 … 2^53 - 1; 1 by default.

        Fixes every random number: same seed, same bits.
        Defines the litter: only a new Litter takes another value.
        Source: this program
        """
    @seed.setter
    def seed(self, value: int) -> None: ...
    @property
    def sigma(self) -> float:
        """sensitivity σ: any finite number; 38 by default.

        Steepness of the two temperature sensors.
        A change acts from the next step on.
        Source: not in the paper; 0.01 per deg C² in the author's 2-D model × 61.67²
        """
    @sigma.setter
    def sigma(self, value: float) -> None: ...
    @property
    def speed(self) -> _Numbers:
        """(pups,) speed |v| [length/s], continuous, drawn from 0 to data.

        Speed of the pup's centre.
        |mean over points of v|
        """
    @property
    def start(self) -> Literal["column", "carpet"]:
        """start layout: column or carpet; column by default.

        column: dropped one above the other at the centre; carpet: laid out over the floor, for many pups.
        Defines the litter: only a new Litter takes another value.
        Source: column: Wilson 2017
        """
    @start.setter
    def start(self, value: Literal["column", "carpet"]) -> None: ...
    @property
    def start_spread(self) -> float:
        """start spread [length]: 0 … 1e+06; 0.25 by default.

        Half-width of the drop column in x and y; at most r_arena / √2, for all pups to start inside.
        Defines the litter: only a new Litter takes another value.
        Source: Wilson 2017
        """
    @start_spread.setter
    def start_spread(self, value: float) -> None: ...
    def step(self, count: int = 1) -> None:
        """Takes count steps. Other threads run meanwhile, and Ctrl-C ends the call between two steps.
        Raises BadNumbers, then and at each later call.
        """
    @property
    def steps(self) -> int:
        """steps: a whole number 0 … 2^53 - 1; 1500 by default.

        Length of a run.
        Belongs to a run, not to the litter.
        Source: Wilson 2017
        """
    @steps.setter
    def steps(self, value: int) -> None: ...
    @property
    def steps_done(self) -> int:
        """Steps taken."""
    @property
    def t_left(self) -> _Numbers:
        """(pups,) temperature felt on the left T_L, continuous, drawn from 0 to 1.

        Mean temperature of the afferents on the left; T_a where there is none.
        mean of T_c over the points on the left
        """
    @property
    def t_right(self) -> _Numbers:
        """(pups,) temperature felt on the right T_R, continuous, drawn from 0 to 1.

        Mean temperature of the afferents on the right; T_a where there is none.
        mean of T_c over the points on the right
        """
    @property
    def ta(self) -> float:
        """ambient temperature T_a: any finite number; 0.4 by default.

        Temperature of the arena; every afferent without contact reads it. 0.6 is 37 deg C.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @ta.setter
    def ta(self, value: float) -> None: ...
    @property
    def tb(self) -> _Numbers:
        """(pups,) body temperature T_b, continuous, drawn from 0 to 1.

        Body temperature after the step; 0.6 is 37 deg C.
        dT_b/dt = G − k_1 A (T_b − T_a) − k_2 (1 − A) (T_b − mean of touched T_c)
        """
    @property
    def tb0(self) -> float:
        """initial body temperature T_b(0): any finite number; 0.6 by default.

        Body temperature of every pup at t = 0.
        Defines the litter: only a new Litter takes another value.
        Source: not in the paper; the author's 2-D model
        """
    @tb0.setter
    def tb0(self, value: float) -> None: ...
    @property
    def threads(self) -> int:
        """Threads that share a step, 1 ... 1024; results keep their bits."""
    @threads.setter
    def threads(self, value: int) -> None: ...
    @property
    def time(self) -> float:
        """Model time [s]."""
    @property
    def tp(self) -> float:
        """preferred temperature T_p: any finite number; 0.6 by default.

        Body temperature that a pup seeks; 0.6 is 37 deg C.
        A change acts from the next step on.
        Source: Wilson 2017
        """
    @tp.setter
    def tp(self, value: float) -> None: ...
    @property
    def turn(self) -> _Numbers:
        """(pups,) turn of each pup [rad/s] in the steps to come, in place of its own; nan: its own. Writable.
        pup.turn is the turn that pups took in the last step.
        """
    @turn.setter
    def turn(self, value: ArrayLike) -> None: ...
    @property
    def v(self) -> float:
        """steering gain v: ≥ 0; 200 by default.

        Gain from sensor contrast to turning.
        A change acts from the next step on.
        Source: not in the paper; the author's 2-D model
        """
    @v.setter
    def v(self, value: float) -> None: ...
    @property
    def velocity(self) -> NDArray[np.floating[Any]]:
        """(pups, points, 3) velocities of all points [length/s]."""
    @property
    def warnings(self) -> list[str]:
        """The impossible states so far, the first of each kind, as messages."""
    @property
    def x(self) -> _Numbers:
        """(pups,) centre x [length], continuous, drawn from data to data.

        Coordinate of the pup's centre; z is its height above the floor.
        mean over points of the coordinate
        """
    @property
    def y(self) -> _Numbers:
        """(pups,) centre y [length], continuous, drawn from data to data.

        Coordinate of the pup's centre; z is its height above the floor.
        mean over points of the coordinate
        """
    @property
    def z(self) -> _Numbers:
        """(pups,) centre z [length], continuous, drawn from data to data.

        Coordinate of the pup's centre; z is its height above the floor.
        mean over points of the coordinate
        """

def run(scene: str | PathLike[str] | None = None, *, ta: float = ..., alpha: float = ..., beta: float = ..., gravity: float = ..., contact: Literal["nearest", "mean", "sum"] = ..., tp: float = ..., k1: float = ..., k2: float = ..., g: float = ..., heat: Literal["exact", "euler"] = ..., tb0: float = ..., drive: float = ..., sigma: float = ..., v: float = ..., heading: Literal["course", "body"] = ..., pups: int = ..., face_points: int = ..., pup_radius: float = ..., point_radius: float = ..., arena_radius: float = ..., start: Literal["column", "carpet"] = ..., start_spread: float = ..., dt: float = ..., refinement: Literal["naive", "consistent"] = ..., integrator: Literal["predictive", "explicit"] = ..., steps: int = ..., discard: int = ..., flow_lag: int = ..., seed: int = ..., precision: Literal["float", "double"] = ...) -> Means:
    """Steps a whole litter (parameter steps) and returns the means over the steps after discard, as
    `pupflow run` prints them: a dict of the observables and exposed_sd, nan where no step is left.

    scene and parameters as for Litter. Threads that run litters do so at once, and Ctrl-C ends the call.
    A litter in an impossible state gives a RuntimeWarning. Raises BadNumbers.
    """
def load(path: str | PathLike[str]) -> Litter:
    """The litter of a checkpoint, which goes on bit for bit like the one saved."""
def scenes() -> dict[str, str]:
    """The shipped scenes: a dict of their titles by name."""
def parameters() -> dict[str, dict[str, Any]]:
    """The table of parameters: a dict of rows by name. A row is a dict of symbol, title, unit, default,
    range, choices, doc and source.
    """
def fields() -> dict[str, dict[str, dict[str, Any]]]:
    """The tables of what comes out: 'litter' (observe()), 'run' (run()), 'pup' and 'afferent', each a dict
    of rows by name. A row is a dict of symbol, label, unit, kind, low, high, categories, equation and
    doc; low and high are None where the data decide.
    """
def littermates(scene: str | PathLike[str] | None = None, *, actions: tuple[Literal["force", "heat", "turn"], ...] = ("turn",), steps_per_action: int = 10, reward: Callable[[Litter], ArrayLike] | None = None, ta: float = ..., alpha: float = ..., beta: float = ..., gravity: float = ..., contact: Literal["nearest", "mean", "sum"] = ..., tp: float = ..., k1: float = ..., k2: float = ..., g: float = ..., heat: Literal["exact", "euler"] = ..., tb0: float = ..., drive: float = ..., sigma: float = ..., v: float = ..., heading: Literal["course", "body"] = ..., pups: int = ..., face_points: int = ..., pup_radius: float = ..., point_radius: float = ..., arena_radius: float = ..., start: Literal["column", "carpet"] = ..., start_spread: float = ..., dt: float = ..., refinement: Literal["naive", "consistent"] = ..., integrator: Literal["predictive", "explicit"] = ..., steps: int = ..., discard: int = ..., flow_lag: int = ..., seed: int = ..., precision: Literal["float", "double"] = ...) -> Littermates:
    """An environment of the shape of PettingZoo's ParallelEnv, with an agent for each pup.

    scene, parameters: as for Litter; the parameter steps is the length of an episode.
    actions: what an action sets, some of 'force' (3 numbers), 'heat' and 'turn', in this order.
    steps_per_action: steps of the litter for each step of the environment.
    reward: a function of the litter that gives a number per pup; by default -|T_b - T_p|.

    An observation is a dict: afferents (6, face_points, face_points), the temperatures felt on the
    pup's six faces (+x, +y, +z, -x, -y, -z of the body); tb (1,); sides (2,), those on its left and
    right. The packages pettingzoo and gymnasium are used where they are installed; only the two spaces
    need gymnasium.
    """

class Littermates(Protocol):
    """What littermates() returns; PettingZoo's ParallelEnv where that is installed."""
    metadata: dict[str, Any]
    render_mode: str
    possible_agents: list[str]
    agents: list[str]
    litter: Litter | None
    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, dict[str, _Numbers]], dict[str, dict[str, Any]]]: ...
    def step(
        self, actions: Mapping[str, ArrayLike | None]
    ) -> tuple[
        dict[str, dict[str, _Numbers]],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]: ...
    def observation_space(self, agent: str) -> Any: ...
    def action_space(self, agent: str) -> Any: ...
    @property
    def num_agents(self) -> int: ...
    @property
    def max_num_agents(self) -> int: ...
    def render(self) -> NDArray[np.uint8]: ...
    def close(self) -> None: ...
