"""A litter is the program's litter: bits, parameters, fields, observables."""

import csv
import io
import math
import unittest
from collections.abc import Mapping

import numpy as np

import pupflow
from program import pupflow as program, summary


class SameLitter(unittest.TestCase):
    def test_has_the_bits_of_the_program(self):
        litter = pupflow.Litter("cold", seed=3, ta=0.3, precision="float")
        litter.step(60)
        text = program("run", "cold", "--seed", "3", "--set", "ta=0.3", "--precision", "float",
                       "--steps", "60", "--set", "discard=0")
        self.assertEqual(litter.hash, summary(text)["hash"])

    def test_one_step_at_a_time_has_the_same_bits(self):
        at_once, one_by_one = pupflow.Litter(seed=2), pupflow.Litter(seed=2)
        at_once.step(40)
        for _ in range(40):
            one_by_one.step()
            one_by_one.observe(), one_by_one.tb  # looking changes nothing
        self.assertEqual(at_once.hash, one_by_one.hash)
        self.assertEqual(at_once.observe(), one_by_one.observe())

    def test_fields_and_observables_are_those_of_the_files(self):
        metrics = program("run", "cold", "--steps", "45", "--csv", "-", "--quiet")
        pups = program("run", "cold", "--steps", "45", "--every", "45", "--pups", "-", "--quiet")

        def rows(text):
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            return list(csv.DictReader(io.StringIO("\n".join(lines))))

        litter = pupflow.Litter("cold")
        litter.step(45)
        last = rows(metrics)[-1]
        for name, value in litter.observe().items():
            self.assertEqual(value, float(last[name]), name)
        table = rows(pups)
        compared = [name for name in table[0] if name in litter.pup.keys()]
        self.assertGreaterEqual(len(compared), 3)
        for name in compared:
            # The centres of the CSV are added up in another order.
            tolerance = 1e-12 if name in "xyz" else 0
            np.testing.assert_allclose(litter.pup[name], [float(row[name]) for row in table],
                                       rtol=0, atol=tolerance, err_msg=name)

    def test_flow_is_nan_until_it_is_known(self):
        litter = pupflow.Litter("cold", flow_lag=3, ta=0.1)
        seen = []
        for _ in range(4):
            seen.append(math.isnan(litter.observe()["flow"]))
            litter.step()
        self.assertEqual(seen, [True, True, True, False])

    def test_a_new_lag_begins_anew(self):
        litter = pupflow.Litter("cold")
        litter.step(30)
        self.assertFalse(math.isnan(litter.observe()["flow"]))
        litter.flow_lag = 2
        litter.step()
        self.assertTrue(math.isnan(litter.observe()["flow"]))


class Tables(unittest.TestCase):
    def test_every_parameter_and_field_is_an_attribute_with_words(self):
        litter = pupflow.Litter(pups=2)
        litter.record("strain")
        fields = pupflow.fields()
        groups = {"params": pupflow.parameters(), "pup": fields["pup"], "afferent": fields["afferent"]}
        for name, table in groups.items():
            group = getattr(litter, name)
            self.assertEqual(sorted(group), sorted(table), name)
            for key, row in table.items():
                self.assertIs(type(group[key]), type(getattr(group, key)))
                doc = getattr(type(group), key).__doc__
                self.assertIn(row["doc"], doc)
                self.assertIn(row["symbol"], doc)
                self.assertIn(row.get("source", ""), doc)

    def test_short_ways_lead_to_fields_and_parameters(self):
        litter = pupflow.Litter("cold", pups=2)
        self.assertTrue(np.shares_memory(litter.tb, litter.pup.tb))
        self.assertEqual(litter.sigma, litter.params.sigma)
        self.assertEqual(litter.heading.shape, (2,))
        self.assertEqual(litter.params.heading, "course")
        for name in pupflow.parameters():
            self.assertTrue(hasattr(litter, name), name)

    def test_groups_are_mappings(self):
        litter = pupflow.Litter(pups=1)
        self.assertEqual(len(litter.params), len(pupflow.parameters()))
        self.assertEqual(pupflow.Litter(**litter.params).hash, litter.hash)
        litter.step()
        for name in ("__class__", "strain", 3, None):
            with self.assertRaises(KeyError):
                litter.pup[name]
            self.assertNotIn(name, litter.afferent)
        for group in (litter.params, litter.pup, litter.afferent):
            self.assertIsInstance(group, Mapping)
            self.assertEqual([name for name, _ in group.items()], group.keys())
            self.assertEqual(len(list(group.values())), len(group))
        self.assertEqual(dict(litter.params.items()), dict(litter.params))
        self.assertEqual((litter.params.get("ta"), litter.params.get("tta", 7)), (litter.ta, 7))
        self.assertIn("tb", litter.pup)

    def test_types_are_those_of_the_table(self):
        litter = pupflow.Litter("cold", seed=np.int64(7), ta=np.float32(0.5), contact="sum")
        self.assertEqual((litter.seed, litter.ta, litter.contact), (7, 0.5, "sum"))
        self.assertIs(type(litter.seed), int)
        self.assertIs(type(litter.params.g), float)

    def test_shipped_scenes_are_there(self):
        self.assertIn("cold", pupflow.scenes())
        for scene in pupflow.scenes():
            pupflow.Litter(scene, pups=1)

    def test_a_parameter_acts_on_the_next_step(self):
        litter, other = pupflow.Litter("cold"), pupflow.Litter("cold")
        litter.step(5), other.step(5)
        litter.ta = 0.8
        self.assertEqual(litter.hash, other.hash)
        litter.step(), other.step()
        self.assertNotEqual(litter.hash, other.hash)
