"""What goes wrong is an exception with the sentence of the program."""

import copy
import pickle
import unittest

import pupflow
from program import python


class Errors(unittest.TestCase):
    def refused(self, error, words, call):
        with self.assertRaises(error) as caught:
            call()
        self.assertEqual(str(caught.exception), words)

    def setUp(self):
        self.litter = pupflow.Litter("cold", pups=2)

    def test_unknown_names(self):
        self.refused(TypeError, "unknown parameter 'sigmma'; did you mean 'sigma'?",
                     lambda: pupflow.Litter(sigmma=1))
        self.refused(TypeError, "unknown parameter 'tta'; did you mean 'ta'?", lambda: pupflow.run(tta=1))
        self.refused(AttributeError, "Litter has no attribute 'sigmma'; did you mean 'sigma'?",
                     lambda: self.litter.sigmma)
        self.refused(AttributeError, "Litter has no attribute 'sigmma'; did you mean 'sigma'?",
                     lambda: setattr(self.litter, "sigmma", 1))
        self.refused(AttributeError, "AfferentFields has no attribute 'temprature'; did you mean 'temperature'?",
                     lambda: self.litter.afferent.temprature)
        with self.assertRaisesRegex(ValueError, "no scene 'colt'; did you mean 'cold'"):
            pupflow.Litter("colt")
        with self.assertRaisesRegex(TypeError, "must be one of ta, "):
            pupflow.Litter(completely_different=1)

    def test_subclasses_may_have_attributes_of_their_own(self):
        class Logged(pupflow.Litter):
            def __init__(self, *args, **parameters):
                self.log = []
                super().__init__(*args, **parameters)

            def step(self, count=1):
                super().step(count)
                self.log.append(self.steps_done)

        litter = Logged("cold", pups=2)
        litter.step(3)
        litter.ta = 0.3
        self.assertEqual((litter.log, litter.params.ta), ([3], 0.3))
        self.refused(AttributeError, "Logged has no attribute 'sigmma'; did you mean 'sigma'?",
                     lambda: litter.sigmma)
        with self.assertRaises(AttributeError):
            litter.tb = 1

    def test_wrong_values(self):
        words = "alpha = 2: rigidity must be 0 … 1"
        self.refused(ValueError, words, lambda: pupflow.Litter(alpha=2))
        self.refused(ValueError, words, lambda: setattr(self.litter, "alpha", 2))
        self.assertEqual(self.litter.alpha, 0.7)
        self.refused(ValueError, "heading = 'boddy': heading must be course or body; did you mean 'body'?",
                     lambda: pupflow.Litter(heading="boddy"))
        with self.assertRaisesRegex(ValueError, "alpha = nan"):
            pupflow.Litter(alpha=float("nan"))
        with self.assertRaisesRegex(ValueError, "a whole number"):
            pupflow.Litter(pups=1.5)
        with self.assertRaisesRegex(ValueError, "pups"):
            pupflow.Litter(pups=10**400)

    def test_all_problems_are_told_at_once(self):
        with self.assertRaises(ValueError) as caught:
            pupflow.Litter(alpha=2, beta=2, arena_radius=0.1)
        lines = str(caught.exception).splitlines()
        self.assertEqual([line.split(" = ")[0] for line in lines], ["alpha", "beta", "arena_radius"])

    def test_wrong_types(self):
        self.refused(TypeError, "ta must be a number, not str", lambda: pupflow.Litter(ta="0.3"))
        self.refused(TypeError, "contact must be a str, not int", lambda: pupflow.Litter(contact=1))
        with self.assertRaises(TypeError):
            self.litter.step(1.5)
        with self.assertRaises(TypeError):
            pupflow.Litter(3)

    def test_text_that_is_not_utf8_is_escaped(self):
        self.refused(ValueError, r"heading = '\udc80': heading must be course or body",
                     lambda: pupflow.Litter(heading="\udc80"))
        self.refused(ValueError, r"heading = 'course\x00': heading must be course or body",
                     lambda: pupflow.Litter(heading="course\0"))
        for name, shown in (("\udc80", r"\\udc80"), ("ta\0", r"ta\\x00")):
            with self.assertRaisesRegex(TypeError, f"^unknown parameter '{shown}'; must be one of ta, "):
                pupflow.run(**{name: 1})
        self.refused(AttributeError, r"Litter has no attribute '\udc80'", lambda: getattr(self.litter, "\udc80"))
        with self.assertRaisesRegex(ValueError, r"record: unknown field '\\udc80'"):
            self.litter.record("\udc80")
        with self.assertRaisesRegex(ValueError, r"color_by: unknown field '\\udc80'"):
            self.litter.image(color_by="\udc80")

    def test_errors_of_a_value_are_its_own(self):
        class Value:
            def __init__(self, error):
                self.error = error

            def __float__(self):
                raise self.error

        for error in (KeyboardInterrupt, ValueError("mine"), RuntimeError("mine")):
            with self.assertRaisesRegex(BaseException, "^(mine)?$") as caught:
                self.litter.ta = Value(error)
            self.assertIsInstance(caught.exception, error if isinstance(error, type) else type(error))
        self.refused(TypeError, "ta must be a number, not Value", lambda: pupflow.Litter(ta=Value(TypeError)))
        with self.assertRaisesRegex(ValueError, "^ta = -inf"):
            self.litter.ta = -10**400
        with self.assertRaisesRegex(ValueError, "^ta = inf"):
            self.litter.ta = 10**400

    def test_what_defines_the_litter_cannot_change(self):
        self.refused(AttributeError, "pups defines the litter and cannot change; make a new one: Litter(pups=...)",
                     lambda: setattr(self.litter, "pups", 3))
        self.litter.pups = 2  # no change
        with self.assertRaises(AttributeError):
            self.litter.tb = 1

    def test_counts(self):
        self.refused(ValueError, "step(-1): must be 0 or more steps", lambda: self.litter.step(-1))
        self.refused(ValueError, "step(-1): must be 0 or more steps", lambda: self.litter.step(count=-1))
        for beyond in (2**63, -2**63 - 1, 10**5000):
            with self.assertRaisesRegex(ValueError, "^count must be a whole number from .*$"):
                self.litter.step(beyond)
        for threads in (0, -1, 1025, 2**31, 2**64):
            self.refused(ValueError, "threads must be a whole number from 1 to 1024",
                         lambda: setattr(self.litter, "threads", threads))
        self.refused(TypeError, "threads must be a whole number, not float",
                     lambda: setattr(self.litter, "threads", 1.5))
        for sides, name in (((2**31, 1), "width"), ((64, -1), "height"), ((64, 2**64), "height")):
            self.refused(ValueError, f"{name} must be a whole number from 1 to 2147483647",
                         lambda: self.litter.image(*sides))
        self.litter.threads = 2
        self.assertEqual(self.litter.threads, 2)

    def test_what_is_not_made_yet_is_refused(self):
        child = python("""if True:
            import pupflow
            class Early(pupflow.Litter):
                def __init__(self):
                    self.force
            litter = pupflow.Litter(pups=1)
            Params = type(litter.params)
            unmade = pupflow.Litter.__new__(pupflow.Litter)
            for use in (Early, lambda: unmade.turn, lambda: unmade.params, lambda: unmade.step(), unmade.copy,
                        lambda: Params.__new__(Params).ta, lambda: len(Params.__new__(Params))):
                try:
                    use()
                except RuntimeError as error:
                    print(error)""")
        self.assertEqual((child.returncode, child.stderr), (0, ""))
        self.assertEqual(child.stdout.splitlines(), 5 * ["Litter.__init__() has not finished"]
                         + 2 * ["Params.__init__() has not finished"])

    def test_pickles_are_refused(self):
        child = python("""if True:
            import pickle, pupflow
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                try:
                    pickle.dumps(pupflow.Litter(pups=1), protocol)
                except TypeError as error:
                    print(error)""")
        self.assertEqual((child.returncode, child.stderr), (0, ""))
        self.assertEqual(set(child.stdout.splitlines()),
                         {"cannot pickle 'Litter'; save() and load() it, or copy() it"})
        self.refused(TypeError, "cannot pickle 'Params'; dict() of it can be",
                     lambda: pickle.dumps(self.litter.params, 0))
        self.assertEqual(copy.copy(self.litter).hash, copy.deepcopy(self.litter).hash)

    def test_bad_numbers_say_where(self):
        litter = pupflow.Litter(pups=2, gravity=1e300)
        with self.assertRaises(pupflow.BadNumbers) as caught:
            litter.step(1000)
        error = caught.exception
        self.assertIsInstance(error, ArithmeticError)
        self.assertIn(f"at step {error.step}, stage {error.stage}, pup {error.pup}", str(error))
        for again in (litter.step, litter.observe):
            with self.assertRaises(pupflow.BadNumbers):
                again()
        with self.assertRaises(pupflow.BadNumbers):
            pupflow.run(pups=2, gravity=1e300)
