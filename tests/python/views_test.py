"""Arrays that show a litter: shapes, read-only, and theirs for good."""

import unittest

import numpy as np

import pupflow
from program import python


class Views(unittest.TestCase):
    def setUp(self):
        self.litter = pupflow.Litter("cold", pups=3, face_points=4)
        self.litter.step(5)

    def test_shapes(self):
        litter = self.litter
        self.assertEqual(litter.points, 96)
        for name in litter.pup:
            self.assertEqual(litter.pup[name].shape, (3,), name)
        for name in litter.afferent:
            self.assertEqual(litter.afferent[name].shape, (3, 96), name)
        self.assertEqual(litter.position.shape, (3, 96, 3))
        self.assertEqual(litter.velocity.shape, (3, 96, 3))

    def test_precision_is_that_of_the_litter(self):
        self.assertEqual(self.litter.position.dtype, np.float64)
        self.assertEqual(pupflow.Litter(pups=1, precision="float").position.dtype, np.float32)

    def test_positions_are_where_the_pups_are(self):
        np.testing.assert_allclose(self.litter.position[:, :, 2].mean(axis=1), self.litter.height, rtol=1e-12)
        speed = np.linalg.norm(self.litter.velocity.mean(axis=1), axis=1)
        np.testing.assert_allclose(speed, self.litter.speed, rtol=1e-12)

    def test_they_cannot_be_written(self):
        for array in (self.litter.tb, self.litter.afferent.temperature, self.litter.position):
            with self.assertRaises(ValueError):
                array[0] = 1
            with self.assertRaises(ValueError):
                array.setflags(write=True)

    def test_they_keep_their_numbers(self):
        before, copy = self.litter.position, self.litter.position.copy()
        tb = self.litter.tb
        self.litter.step(20)
        np.testing.assert_array_equal(before, copy)
        self.assertFalse(np.array_equal(self.litter.position, before))
        self.assertIsNot(self.litter.tb, tb)
        del self.litter
        np.testing.assert_array_equal(before, copy)

    def test_their_numbers_are_copied_once_a_step(self):
        self.assertTrue(np.shares_memory(self.litter.tb, self.litter.tb))
        self.assertTrue(np.shares_memory(self.litter.position, self.litter.position))

    def test_a_new_shape_is_that_of_one_array(self):
        for name in ("tb", "position"):
            array = getattr(self.litter, name)
            shape, kind = array.shape, array.dtype
            array.shape = (array.size, 1)
            array.dtype = np.int64
            self.assertEqual(getattr(self.litter, name).shape, shape)
            self.assertEqual(getattr(self.litter, name).dtype, kind)

    def test_the_end_of_an_array_may_use_the_litter(self):
        child = python("""if True:
            import weakref, pupflow
            litter = pupflow.Litter("cold", pups=2)
            def use(_):
                litter.step()
                litter.tb, litter.position
            def look():
                for name in ("tb", "position", "velocity", "speed"):
                    end = weakref.ref(getattr(litter, name), use)
                    ends.append(end)
            ends = []
            look()
            litter.step()
            look()
            litter.ta = 0.3
            look()
            litter.record("strain")
            assert litter.steps_done == 13, litter.steps_done""")
        self.assertEqual((child.returncode, child.stderr), (0, ""))

    def test_a_litter_without_pups_has_empty_ones(self):
        empty = pupflow.Litter(pups=0)
        empty.step(3)
        self.assertEqual(empty.tb.shape, (0,))
        self.assertEqual(empty.position.shape, (0, 294, 3))

    def test_what_was_not_recorded_is_refused(self):
        with self.assertRaisesRegex(RuntimeError, r"did not record strain; call record\('strain'\)"):
            self.litter.afferent.strain
        self.assertNotIn("strain", self.litter.afferent.keys())
        other = self.litter.copy()
        self.litter.record("strain")
        self.litter.step(), other.step()
        self.assertTrue(np.isfinite(self.litter.afferent.strain).all())
        self.assertEqual(self.litter.hash, other.hash)
        with self.assertRaisesRegex(ValueError, "record: unknown field 'strian'; did you mean 'strain'"):
            self.litter.record("strian")
