"""Litters in threads, and Ctrl-C."""

import os
import signal
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import pupflow
from program import python


def hash_of(seed):
    litter = pupflow.Litter("cold", seed=seed, pups=4)
    for _ in range(50):
        litter.step()
        litter.tb
    return litter.hash


class Threads(unittest.TestCase):
    def test_litters_in_threads_are_those_of_one_thread(self):
        seeds = range(16)
        with ThreadPoolExecutor(8) as threads:
            self.assertEqual(list(threads.map(hash_of, seeds)), list(map(hash_of, seeds)))

    def test_a_litter_that_is_being_stepped_refuses(self):
        litter = pupflow.Litter("cold")
        thread = threading.Thread(target=litter.step, args=(3000,))
        thread.start()
        refusals = 0
        while thread.is_alive():  # here this thread has the GIL, so step() has let go of it
            for look in (lambda: litter.tb, lambda: litter.ta, litter.copy, litter.step, lambda: litter.hash):
                try:
                    look()
                except RuntimeError as error:
                    self.assertIn("another call steps or draws this litter", str(error))
                    refusals += 1
        self.assertGreater(refusals, 0)
        litter.tb

    def test_a_daemon_thread_in_a_call_does_not_disturb_the_end_of_the_process(self):
        for call in ("pupflow.Litter('cold').step(10**9)", "pupflow.run('cold', steps=10**9)"):
            child = python(f"""if True:
                import threading, time, pupflow
                threading.Thread(target=lambda: {call}, daemon=True).start()
                time.sleep(0.2)""")
            self.assertEqual((child.returncode, child.stderr), (0, ""))

    def test_a_fork_steps_a_litter_whose_threads_stayed_behind(self):
        child = python("""if True:
            import os, signal, pupflow
            litter = pupflow.Litter(pups=64, start="carpet", arena_radius=8)
            litter.threads = 2
            litter.step()
            if os.fork() == 0:
                signal.alarm(20)
                litter.step(5)
                print(litter.hash, flush=True)
                del litter
                os._exit(0)
            print(os.wait()[1], flush=True)
            litter.step(5)
            print(litter.hash)""")
        self.assertEqual((child.returncode, child.stderr), (0, ""))
        in_child, status, here = child.stdout.split()
        self.assertEqual(status, "0")
        self.assertEqual(in_child, here)

    def test_a_value_that_has_the_litter_stepped_is_refused(self):
        litter = pupflow.Litter("cold")

        class Value:
            def __float__(self):
                thread.start()
                time.sleep(0.1)
                return 0.3

        thread = threading.Thread(target=litter.step, args=(3000,))
        with self.assertRaisesRegex(RuntimeError, "another call steps"):
            litter.ta = Value()
        thread.join()
        other = pupflow.Litter("cold")
        other.step(3000)
        self.assertEqual((litter.hash, litter.ta), (other.hash, other.ta))

    def test_interrupts_end_a_call_between_steps(self):
        litter = pupflow.Litter("cold", pups=2)
        for call in (lambda: litter.step(10**12), lambda: pupflow.run("cold", steps=10**12)):
            with self.assertRaises(KeyboardInterrupt):
                threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
                call()
        steps = litter.steps_done
        self.assertGreater(steps, 0)
        litter.step()
        self.assertEqual(litter.steps_done, steps + 1)
