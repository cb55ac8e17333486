"""littermates() has the shape of PettingZoo's ParallelEnv."""

import math
import sys
import types
import unittest
from unittest import mock

import numpy as np

import pupflow
from pupflow import _littermates


class Littermates(unittest.TestCase):
    def setUp(self):
        self.env = pupflow.littermates("cold", actions=("heat", "turn"), steps_per_action=8, pups=3, steps=20)

    def test_observations_are_what_the_pups_feel(self):
        observations, infos = self.env.reset(seed=5)
        self.assertEqual(self.env.agents, ["pup_0", "pup_1", "pup_2"])
        self.assertEqual(list(observations), self.env.agents)
        self.assertEqual(infos, {agent: {} for agent in self.env.agents})
        observations = self.env.step({})[0]
        litter = pupflow.Litter("cold", pups=3, seed=5)
        litter.step(8)
        for pup, agent in enumerate(self.env.agents):
            seen = observations[agent]
            self.assertEqual(seen["afferents"].shape, (6, 7, 7))
            np.testing.assert_array_equal(seen["afferents"].ravel(), litter.afferent.temperature[pup])
            np.testing.assert_array_equal(seen["tb"], litter.tb[pup:pup + 1])
            np.testing.assert_array_equal(seen["sides"], [litter.t_left[pup], litter.t_right[pup]])

    def test_actions_act_for_one_step(self):
        self.env.reset(seed=5)
        self.env.step({"pup_1": (0.1, 0.5), "pup_2": None})
        litter = pupflow.Litter("cold", pups=3, seed=5)
        litter.heat[1], litter.turn[1] = 0.1, 0.5
        litter.step(8)
        self.assertEqual(self.env.litter.hash, litter.hash)
        self.env.step({})
        litter.heat[1], litter.turn[1] = 0, math.nan
        litter.step(8)
        self.assertEqual(self.env.litter.hash, litter.hash)

    def test_an_episode_ends_with_the_run(self):
        self.env.reset()
        ends = []
        while self.env.agents:
            _, rewards, terminations, truncations, _ = self.env.step({})
            self.assertFalse(any(terminations.values()))
            ends.append(all(truncations.values()))
        self.assertEqual(ends, [False, False, True])
        self.assertEqual(self.env.litter.steps_done, 20)
        np.testing.assert_allclose(list(rewards.values()), -abs(self.env.litter.tb - 0.6))
        with self.assertRaisesRegex(RuntimeError, "reset"):
            self.env.step({})

    def test_seeds(self):
        seeds = []
        for seed in (None, None, 9, None):
            self.env.reset(seed=seed)
            seeds.append(self.env.litter.seed)
        self.assertEqual(seeds, [1, 2, 9, 10])
        self.env.reset(seed=2**53 - 1)
        self.env.reset()
        self.assertEqual(self.env.litter.seed, 0)

    def test_a_litter_stepped_elsewhere_ends_the_episode(self):
        self.env.reset()
        self.env.litter.step(23)
        self.assertTrue(all(self.env.step({})[3].values()))
        self.assertEqual((self.env.litter.steps_done, self.env.agents), (23, []))

    def test_actions_may_come_from_a_generator(self):
        env = pupflow.littermates("cold", actions=(name for name in ("heat", "turn")), pups=1, steps=20)
        env.reset()
        env.step({"pup_0": (0.1, 0.5)})
        self.assertEqual((env.litter.heat[0], env.litter.turn[0]), (0.1, 0.5))

    def test_a_picture_needs_a_reset(self):
        with self.assertRaisesRegex(RuntimeError, "there is no litter yet: call reset"):
            self.env.render()

    def test_a_reward_of_ones_own(self):
        env = pupflow.littermates(pups=2, reward=lambda litter: 10 * litter.huddling)
        env.reset()
        self.assertEqual(env.step({})[1], {"pup_0": 0.0, "pup_1": 0.0})

    def test_uses_the_packages_where_they_are(self):
        class ParallelEnv:
            pass

        class Box:
            def __init__(self, low, high, shape=None, dtype=None):
                self.high, self.shape, self.dtype = high, shape, dtype

        spaces = types.SimpleNamespace(Box=Box, Dict=dict)
        stand_ins = {"pettingzoo": types.SimpleNamespace(ParallelEnv=ParallelEnv),
                     "gymnasium": types.SimpleNamespace(spaces=spaces)}
        forget = _littermates._environment.cache_clear
        with mock.patch.dict(sys.modules, stand_ins):
            forget()
            self.addCleanup(forget)
            env = pupflow.littermates("cold", actions=("force", "turn"), pups=2, face_points=3, drive=2)
            self.assertIsInstance(env, ParallelEnv)
            seen, action = env.observation_space("pup_0"), env.action_space("pup_1")
        self.assertEqual({name: box.shape for name, box in seen.items()},
                         {"afferents": (6, 3, 3), "tb": (1,), "sides": (2,)})
        np.testing.assert_array_equal(action.high, [2, 2, 2, math.pi / 2])
        self.assertIs(env.action_space("pup_1"), action)  # PettingZoo wants the same object each time

    def test_without_them_only_spaces_are_missing(self):
        with mock.patch.dict(sys.modules, {"gymnasium": None}):
            with self.assertRaisesRegex(ImportError, "spaces are gymnasium's: pip install gymnasium"):
                self.env.action_space("pup_0")

    def test_wrong_arguments(self):
        with self.assertRaisesRegex(ValueError, "'warmth' must be one of force, heat, turn"):
            pupflow.littermates(actions=("warmth",))
        with self.assertRaisesRegex(ValueError, "steps_per_action = 0"):
            pupflow.littermates(steps_per_action=0)
        for actions in ((), ("turn", "turn")):
            with self.assertRaisesRegex(ValueError, "actions = .*: must be one or more, each once"):
                pupflow.littermates(actions=actions)
        for reward, shape in (([1.0], r"\(1,\)"), (1.0, r"\(\)")):
            env = pupflow.littermates(pups=2, reward=lambda litter: reward)
            env.reset()
            with self.assertRaisesRegex(ValueError, rf"reward must give a number per pup \(2,\), not {shape}"):
                env.step({})
        with self.assertRaisesRegex(TypeError, "unknown parameter 'tta'"):
            pupflow.littermates(tta=1)
        self.env.reset()
        with self.assertRaisesRegex(ValueError, r"must be 2 numbers \(heat, turn\)"):
            self.env.step({"pup_0": 1})
