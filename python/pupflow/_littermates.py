"""A litter in the shape of PettingZoo's ParallelEnv: each pup is an agent."""

import functools
import math

import numpy as np

from pupflow._core import Litter

# The largest seed.
_LAST_SEED = 2**53 - 1

# The controls of a pup that actions may set: how many numbers, and the value that leaves it alone.
_CONTROLS = {"force": (3, 0.0), "heat": (1, 0.0), "turn": (1, math.nan)}


def _thermal_comfort(litter):
    """The default reward: how near each body temperature is to the preferred one, 0 at best."""
    return -np.abs(litter.tb - litter.tp)


class Littermates:
    """What littermates() returns; PettingZoo's ParallelEnv where that is installed.

    litter is the pupflow.Litter behind it, None before the first reset.
    """

    metadata = {"name": "pupflow_littermates", "render_modes": ["rgb_array"]}
    render_mode = "rgb_array"

    def __init__(self, scene, actions, steps_per_action, reward, parameters):
        actions = tuple(actions)
        if not actions or len(set(actions)) < len(actions):
            raise ValueError(f"actions = {actions}: must be one or more, each once")
        for name in actions:
            if name not in _CONTROLS:
                raise ValueError(f"actions: {name!r} must be one of {', '.join(_CONTROLS)}")
        if steps_per_action < 1:
            raise ValueError(f"steps_per_action = {steps_per_action}: must be at least 1")
        self._scene, self._parameters = scene, parameters
        self._actions, self._steps = actions, steps_per_action
        self._reward = reward or _thermal_comfort
        self._start = Litter(scene, **parameters)  # whose sizes and limits the spaces have
        self.possible_agents = [f"pup_{pup}" for pup in range(self._start.pups)]
        self.agents, self.litter = [], None

    def reset(self, seed=None, options=None):
        """A new litter, and (observations, infos). Without a seed: that of the scene at first, then
        the next one each time (0 after the last, 2^53 - 1). options does nothing."""
        if seed is None and self.litter is None:
            seed = self._start.seed
        elif seed is None:
            seed = self.litter.seed + 1 if self.litter.seed < _LAST_SEED else 0
        self.litter = Litter(self._scene, **{**self._parameters, "seed": seed})
        self.agents = self.possible_agents[:]
        return self._observations(), {agent: {} for agent in self.agents}

    def step(self, actions):
        """Takes steps_per_action steps with an action per agent; a pup without one, or with None,
        does as it likes. Returns (observations, rewards, terminations, truncations, infos). The
        litter's step number `steps` is the last: it truncates all agents."""
        if not self.agents:
            raise RuntimeError("no agent is left: call reset()")
        for name in self._actions:
            setattr(self.litter, name, _CONTROLS[name][1])
        for agent, action in actions.items():
            if action is not None:
                self._act(self.possible_agents.index(agent), action)
        left = max(0, self.litter.steps - self.litter.steps_done)  # the litter may be stepped elsewhere
        self.litter.step(min(self._steps, left))
        agents, ended = self.agents, self.litter.steps_done >= self.litter.steps
        rewards = self._rewards()
        observations = self._observations()
        if ended:
            self.agents = []
        return (observations, rewards, dict.fromkeys(agents, False), dict.fromkeys(agents, ended),
                {agent: {} for agent in agents})

    def _rewards(self):
        rewards = np.asarray(self._reward(self.litter), dtype=float)
        if rewards.shape != (len(self.agents),):
            raise ValueError(f"reward must give a number per pup ({len(self.agents)},), not {rewards.shape}")
        return dict(zip(self.agents, rewards.tolist()))

    def _act(self, pup, action):
        numbers = np.asarray(action, dtype=float)
        if numbers.shape != (self._width(),):
            raise ValueError(f"an action must be {self._width()} numbers ({', '.join(self._actions)}), "
                             f"not of shape {numbers.shape}")
        at = 0
        for name in self._actions:
            width = _CONTROLS[name][0]
            control = getattr(self.litter, name)
            control[pup] = numbers[at] if width == 1 else numbers[at:at + width]
            at += width

    def _width(self):
        return sum(_CONTROLS[name][0] for name in self._actions)

    def _observations(self):
        litter, k = self.litter, self.litter.face_points
        sheets = litter.afferent.temperature.reshape(litter.pups, 6, k, k)
        sides = np.stack([litter.t_left, litter.t_right], axis=1)
        return {agent: {"afferents": sheets[pup], "tb": litter.tb[pup:pup + 1], "sides": sides[pup]}
                for pup, agent in enumerate(self.agents)}

    def observation_space(self, agent):
        """A gymnasium Dict of boxes: afferents (6, face_points, face_points), tb (1,), sides (2,)."""
        return self._observation_space

    def action_space(self, agent):
        """A gymnasium Box, as wide as what a pup does by itself: drive, g, pi / 2 rad/s."""
        return self._action_space

    @functools.cached_property
    def _observation_space(self):
        k = self._start.face_points
        shapes = {"afferents": (6, k, k), "tb": (1,), "sides": (2,)}
        return _spaces().Dict({name: _spaces().Box(-np.inf, np.inf, shape, np.float64)
                               for name, shape in shapes.items()})

    @functools.cached_property
    def _action_space(self):
        own = {"force": self._start.drive, "heat": self._start.g, "turn": math.pi / 2}
        high = np.concatenate([np.full(_CONTROLS[name][0], own[name]) for name in self._actions])
        return _spaces().Box(-high, high, dtype=np.float64)

    @property
    def num_agents(self):
        return len(self.agents)

    @property
    def max_num_agents(self):
        return len(self.possible_agents)

    def render(self):
        """A picture of the litter, (960, 1280, 3) uint8."""
        if self.litter is None:
            raise RuntimeError("there is no litter yet: call reset()")
        return self.litter.image()

    def close(self):
        """Does nothing; the litter is freed with the environment."""


def _spaces():
    try:
        from gymnasium import spaces
    except ImportError:
        raise ImportError("spaces are gymnasium's: pip install gymnasium") from None
    return spaces


@functools.cache
def _environment():
    try:
        from pettingzoo import ParallelEnv
    except ImportError:
        return Littermates
    return type("Littermates", (Littermates, ParallelEnv), {"__doc__": Littermates.__doc__})


def littermates(scene=None, *, actions=("turn",), steps_per_action=10, reward=None, **parameters):
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
    return _environment()(scene, actions, steps_per_action, reward, parameters)
