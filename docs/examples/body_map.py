#!/usr/bin/env python3
"""A self-organising map learns from what the afferents of one litter feel.

Each pup gives a sample every 10 steps: how much warmer than the air its afferents are, which is where
it touches others. Units that are neighbours on the map come to stand for neighbouring parts of the
body. The measure: how well the units around a sample's winner tell from which side of the body the
warmth comes (1: exactly, 0: as well as the mean does). The same afferents, shuffled in each sample,
teach a map for comparison. Both are tested on samples that neither has seen.
"""

import argparse

import matplotlib
import numpy as np

import pupflow

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

EDGE = 10  # units along an edge of the map
PLACES = np.array([(row, column) for row in range(EDGE) for column in range(EDGE)])
APART = ((PLACES[:, None] - PLACES) ** 2).sum(axis=2)  # squared distances of units


def feel(litter, looks):
    """Samples (unit vectors) and the side that the warmth of each comes from, in body axes."""
    warmth = []
    for _ in range(looks):
        litter.step(10)
        warmth.append(litter.afferent.temperature - litter.ta)
    warmth = np.maximum(np.concatenate(warmth), 0)
    warmth = warmth[warmth.sum(axis=1) > 1]  # pups that touch somebody
    skin = litter.afferent
    normals = np.stack([skin.normal_x[0], skin.normal_y[0], skin.normal_z[0]], axis=1)
    sides = warmth @ normals / warmth.sum(axis=1, keepdims=True)
    return warmth / np.linalg.norm(warmth, axis=1, keepdims=True), sides


def winners(weights, samples):
    return (samples @ weights.T).argmax(axis=1)


def learn(samples, random, rounds=30):
    """Kohonen's batch map: each unit takes the mean of the samples that are won around it."""
    weights = random.random((EDGE * EDGE, samples.shape[1]))
    for width in np.geomspace(EDGE / 2, 0.6, rounds):
        won = np.zeros_like(weights)
        np.add.at(won, winners(weights, samples), samples)
        weights = np.exp(-APART / (2 * width**2)) @ won
        weights /= np.linalg.norm(weights, axis=1, keepdims=True)
    return weights


def order(weights, seen, unseen):
    """The measure for each body axis, and the mean side of the samples that each unit wins."""
    (samples, sides), (test, truth) = seen, unseen
    won = winners(weights, samples)
    counts = np.bincount(won, minlength=EDGE * EDGE)
    sums = np.stack([np.bincount(won, side, EDGE * EDGE) for side in sides.T], axis=1)
    around = (APART > 0) & (APART <= 2)
    told = (around @ sums) / np.maximum(around @ counts, 1)[:, None]
    errors = ((truth - told[winners(weights, test)]) ** 2).sum(axis=0)
    return 1 - errors / ((truth - truth.mean(axis=0)) ** 2).sum(axis=0), sums / np.maximum(counts, 1)[:, None]


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--looks", type=int, default=400)
    options.add_argument("--out", default="body_map.png")
    options = options.parse_args()

    litter = pupflow.Litter("critical", seed=1)
    litter.step(500)
    seen, unseen = feel(litter, options.looks // 2), feel(litter, options.looks // 2)
    random = np.random.default_rng(1)
    inputs = {"learned": seen[0], "from shuffled input": random.permuted(seen[0], axis=1)}

    figure, axes = plt.subplots(1, 2, figsize=(8, 4), layout="constrained")
    for axis, (name, samples) in zip(axes, inputs.items()):
        measure, side = order(learn(samples, random), seen, unseen)
        print(f"{name}: order left-right {measure[1]:.2f}, front-back {measure[0]:.2f}")
        picture = axis.imshow(side[:, 1].reshape(EDGE, EDGE), cmap="RdBu_r", vmin=-0.7, vmax=0.7)
        axis.set(title=f"{name}: order {measure[1]:.2f}", xticks=[], yticks=[])
    figure.colorbar(picture, ax=axes, label="side of the warmth: right … left")
    figure.savefig(options.out, dpi=100)
    print(options.out)


if __name__ == "__main__":
    main()
