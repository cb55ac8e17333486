"""run() gives the means that `pupflow run` prints."""

import functools
import inspect
import json
import math
import multiprocessing
import pickle
import unittest
from concurrent.futures import ProcessPoolExecutor

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
        with self.assertWarnsRegex(RuntimeWarning, "from step") as warned:
            pupflow.run(drive=60, steps=200, discard=0)  # presses pups through the wall
        self.assertEqual(warned.filename, __file__)

    def test_processes_run_litters(self):
        run = functools.partial(pupflow.run, seed=2, steps=20, discard=0)
        with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as processes:
            self.assertEqual(list(processes.map(run, ["cold", "warm"])), list(map(run, ["cold", "warm"])))

    def test_functions_have_signatures_and_can_be_pickled(self):
        signatures = {"run": "(scene=None, **parameters)", "load": "(path)", "scenes": "()", "parameters": "()",
                      "fields": "()"}
        for name, signature in signatures.items():
            function = getattr(pupflow, name)
            self.assertEqual(str(inspect.signature(function)), signature)
            self.assertIs(pickle.loads(pickle.dumps(function)), function)
            self.assertTrue(function.__doc__)
