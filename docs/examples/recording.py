#!/usr/bin/env python3
"""Huddling and pup flow from a recording, and that they equal the columns of the CSV.

The two files come from one run:

    pupflow run critical --record litter.h5 --record-every 1 --csv litter.csv

Needs h5py and matplotlib, and not the module pupflow.
"""

import argparse
import csv

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def mean(values):
    """Over the pups, added up one by one as the program does it, so that all bits are the same."""
    return sum(values.T) / values.shape[1]


def from_recording(path):
    """step, time, huddling and flow of each frame but the first, which flow needs."""
    with h5py.File(path) as file:
        step, time, exposed = (file[name][:] for name in ("step", "time", "pup/exposed"))
        dt = float(file.attrs["dt"])
    if (np.diff(step) != 1).any():
        raise SystemExit(f"{path}: flow needs every step: record with --record-every 1")
    huddling = 1 - mean(exposed)
    flow = mean(np.abs(np.diff(exposed, axis=0))) / dt
    return step[1:], time[1:], huddling[1:], flow


def from_csv(path):
    """The rows of a metrics CSV by step."""
    with open(path) as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {int(row["step"]): row for row in rows}


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("recording")
    options.add_argument("csv")
    options.add_argument("--out", default="recording.png")
    options = options.parse_args()

    step, time, huddling, flow = from_recording(options.recording)
    rows = from_csv(options.csv)
    for name, values in (("huddling", huddling), ("flow", flow)):
        column = np.array([float(rows[s][name]) for s in step])
        if not np.array_equal(values, column):
            raise SystemExit(f"{name}: differs from the CSV by up to {abs(values - column).max():.2g}")
        print(f"{name}: {len(values)} steps, equal to the CSV")

    figure, axes = plt.subplots(2, sharex=True, figsize=(8, 5), layout="constrained")
    axes[0].plot(time, huddling)
    axes[0].set(ylabel="huddling 1 − A", ylim=(0, None))
    axes[1].plot(time, flow, linewidth=0.5, color="0.7", label="each step")
    if len(flow) >= 100:
        smooth = np.convolve(flow, np.full(100, 0.01), mode="valid")
        axes[1].plot(time[50:50 + len(smooth)], smooth, label="mean over 1 s")
    axes[1].set(xlabel="time [s]", ylabel="pup flow [1/s]", ylim=(0, None))
    axes[1].legend()
    figure.savefig(options.out, dpi=100)
    print(options.out)


if __name__ == "__main__":
    main()
