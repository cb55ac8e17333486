"""run() gives the means that `pupflow run` prints."""

import json
import math
import unittest

import pupflow
from program import pupflow as program


class Run(unittest.TestCase):
    def test_the_means_are_those_of_the_program(self):
        means = pupflow.run("warm", seed=2, steps=80, discard=30)
        options = ("--seed", "2", "--steps", "80", "--set", "discard=30", "--json")
        self.assertEqual(means, json.loads(program("run", "warm", *options))["means"])

    def test_no_step_left_gives_nan(self):
        self.assertTrue(all(map(math.isnan, pupflow.run(pups=1, steps=3, discard=3).values())))

    def test_impossible_states_are_warned_of(self):
        with self.assertWarnsRegex(RuntimeWarning, "from step"):
            pupflow.run(drive=60, steps=200, discard=0)  # presses pups through the wall
