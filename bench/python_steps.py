#!/usr/bin/env python3
"""What stepping from Python costs over C++: the paper's litter in a huddle, in turns, by processor time.

    cmake --preset bench && cmake --build --preset bench
    PYTHONPATH=build/bench/python python3 bench/python_steps.py build/bench/bench/pupflow_stepper
"""

import statistics
import subprocess
import sys
import time

import pupflow

STEPS = 200


def timed(work):
    start = pupflow.Litter(ta=0.2)
    start.step(500)

    def seconds():
        litter = start.copy()
        before = time.process_time()
        work(litter)
        return time.process_time() - before, litter.hash
    return seconds


def stepped(litter):
    for _ in range(STEPS):
        litter.step()


def looked_at(litter):
    for _ in range(STEPS):
        litter.step()
        litter.tb, litter.heading


def observed(litter):
    for _ in range(STEPS):
        litter.step()
        litter.observe()


def main():
    stepper, rounds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 31
    child = subprocess.Popen([stepper], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def in_cpp():
        print(STEPS, file=child.stdin, flush=True)
        seconds, state = child.stdout.readline().split()
        return float(seconds), state

    cases = {
        "C++, step()": in_cpp,
        "Python, step(200)": timed(lambda litter: litter.step(STEPS)),
        "Python, step() 200 times": timed(stepped),
        "the same, tb and heading read each time": timed(looked_at),
        "the same, observe() each time": timed(observed),
    }
    times = {case: [] for case in cases}
    for _ in range(rounds):
        results = {case: run() for case, run in cases.items()}
        if len({state for _, state in results.values()}) != 1:
            sys.exit(f"the litters differ: {results}")
        for case, (seconds, _) in results.items():
            times[case].append(seconds)
    first = next(iter(times.values()))
    print("| 12 pups | µs a step | times as long |\n|---|---|---|")
    for case, all_of_it in times.items():
        ratio = statistics.median(one / other for one, other in zip(all_of_it, first))
        print(f"| {case} | {1e6 * statistics.median(all_of_it) / STEPS:.1f} | {ratio:.3f} |")


if __name__ == "__main__":
    main()
