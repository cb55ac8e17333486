"""Force, heat and turn of single pups."""

import unittest

import numpy as np

import pupflow


def falling(**parameters):
    """A pup alone, that nothing drives, heats or cools."""
    return pupflow.Litter(pups=1, drive=0, k1=0, g=0, **parameters)


class Controls(unittest.TestCase):
    def test_heat_is_added_to_thermogenesis(self):
        litter = falling()
        litter.heat[0] = 0.1
        litter.step(50)
        self.assertAlmostEqual(litter.tb[0], litter.tb0 + 0.1 * litter.time, places=12)

    def test_force_accelerates(self):
        litter = falling(gravity=0)
        litter.force[0] = (1, 0, 2)
        litter.step(10)
        np.testing.assert_allclose(litter.velocity.mean(axis=1)[0], (0.1, 0, 0.2), atol=1e-12)
        litter.force = 0
        litter.step(10)
        np.testing.assert_allclose(litter.velocity.mean(axis=1)[0], (0.1, 0, 0.2), atol=1e-12)

    def test_turn_takes_the_place_of_its_own(self):
        litter = pupflow.Litter("cold", pups=2)
        heading = litter.heading[1]
        litter.turn[1] = 0.5
        litter.step(20)
        self.assertAlmostEqual(np.sin(litter.heading[1]), np.sin(heading + 0.5 * litter.time), places=10)
        self.assertTrue(np.isnan(litter.turn[0]))

    def test_nothing_set_changes_nothing(self):
        litter, other = pupflow.Litter("cold"), pupflow.Litter("cold")
        litter.force[2] = 0
        litter.turn[:] = np.nan
        litter.step(30), other.step(30)
        self.assertEqual(litter.hash, other.hash)

    def test_a_copy_goes_on_alike_with_controls_of_its_own(self):
        litter = pupflow.Litter("cold")
        litter.step(20)
        litter.force[3] = (1, 0, 0)
        litter.turn[3] = 0.5
        copy = litter.copy()
        litter.step(20), copy.step(20)
        self.assertEqual(litter.hash, copy.hash)
        copy.force[3] = 0
        self.assertEqual(litter.force[3, 0], 1)
        litter.step(5), copy.step(5)
        self.assertNotEqual(litter.hash, copy.hash)

    def test_what_is_no_number_is_refused_and_named(self):
        litter = pupflow.Litter("cold", pups=2)
        litter.heat[1] = np.inf
        with self.assertRaisesRegex(ValueError, "heat of a pup is not a finite number"):
            litter.step()
        litter.heat[1] = 0
        litter.step()
        with self.assertRaises(IndexError):
            litter.heat[2] = 0
        with self.assertRaises(ValueError):
            litter.force = (1, 2)
        with self.assertRaises(ValueError):
            litter.force.resize((1, 3), refcheck=False)
