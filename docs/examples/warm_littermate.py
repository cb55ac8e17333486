#!/usr/bin/env python3
"""One pup is kept at the rim of the huddle, and warmed. What does that do to the others?

Every 10 steps the pup is pushed outwards while it touches more than two littermates, and back when
it touches none. The same litters run without that for comparison.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor

import matplotlib
import numpy as np

import pupflow

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

PUP = 0
FORCE = 5.0  # length/s^2; half of gravity
CASES = {"left alone": None, "kept at the rim": 0.0, "at the rim and warm": 0.3}  # heat of the pup


def keep_at_the_rim(litter):
    """Sets the pup's force and turn for the next steps."""
    centres = litter.position.mean(axis=1)[:, :2]
    outwards = centres[PUP] - np.delete(centres, PUP, axis=0).mean(axis=0)
    outwards /= np.linalg.norm(outwards)
    touched = litter.neighbours[PUP]
    push = 1 if touched > 2 else -1 if touched == 0 else 0
    litter.force[PUP, :2] = FORCE * push * outwards
    wanted = np.arctan2(*outwards[::-1]) + (0 if touched > 1 else np.pi)
    off = (wanted - litter.heading[PUP] + np.pi) % (2 * np.pi) - np.pi
    litter.turn[PUP] = 5 * off


def measures(litter):
    """Of the pup: exposed share. Of the others: T_b, huddling, mean distance from their centre."""
    others = np.arange(litter.pups) != PUP
    centres = litter.position.mean(axis=1)[others, :2]
    spread = np.linalg.norm(centres - centres.mean(axis=0), axis=1).mean()
    return litter.exposed[PUP], litter.tb[others].mean(), litter.huddling[others].mean(), spread


def course(heat, seed, steps):
    """The measures every 10 steps, and the litter at the end."""
    litter = pupflow.Litter("cold", seed=seed)
    rows = []
    for _ in range(steps // 10):
        if heat is not None:
            litter.heat[PUP] = heat
            keep_at_the_rim(litter)
        litter.step(10)
        rows.append(measures(litter))
    return np.array(rows), litter


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--steps", type=int, default=1500)
    options.add_argument("--seeds", type=int, default=8)
    options.add_argument("--out", default="warm_littermate.png")
    options = options.parse_args()
    seeds = range(1, options.seeds + 1)

    figure, axes = plt.subplots(1, 3, figsize=(12, 4), layout="constrained")
    titles = "exposed share of the pup", "T_b of the others", "huddling of the others", "their spread"
    print("case".ljust(21) + "  ".join(f"{title:>24}" for title in titles))
    for case, heat in CASES.items():
        with ThreadPoolExecutor() as threads:  # steps let go of the GIL, so litters run at once
            courses, litters = zip(*threads.map(lambda s: course(heat, s, options.steps), seeds))
        late = np.array(courses)[:, options.steps // 30:].mean(axis=1)  # without the first third
        cells = [f"{mean:.3f} ± {sd:.3f}" for mean, sd in zip(late.mean(axis=0), late.std(axis=0))]
        print(case.ljust(21) + "  ".join(f"{cell:>24}" for cell in cells))
        time = 10 * litters[0].dt * np.arange(1, options.steps // 10 + 1)
        mean = np.mean(courses, axis=0)
        axes[0].plot(time, mean[:, 0], label=case)
        axes[1].plot(time, mean[:, 3])
    axes[0].set(xlabel="time [s]", ylabel="exposed share of the pup", ylim=(0, 1))
    axes[0].legend()
    axes[1].set(xlabel="time [s]", ylabel="mean distance of the others from their centre", ylim=(0, 1.2))
    axes[2].imshow(litters[0].image(720, 640, camera="top"))
    axes[2].set_title(f"at the rim and warm, seed 1, {options.steps} steps", fontsize=10)
    axes[2].axis("off")
    figure.savefig(options.out, dpi=100)
    print(options.out)


if __name__ == "__main__":
    main()
