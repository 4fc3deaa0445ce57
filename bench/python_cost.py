# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""python_cost.py [SCENE...] --json FILE [--quick]: what a call from Python adds to a frame of 640x480 pixels, and how many more
frames a second two Dask workers of one thread do than one. Needs the package on PYTHONPATH.

A call's cost is its time less what the core says of the levels: conversion of the arrays, points, result."""

import argparse
import json
import os
import pathlib
import statistics
import sys
import tempfile
import time

import distributed

import gestalt
import gestalt.dask

ROOT = pathlib.Path(__file__).resolve().parent.parent


def call_cost(scene, calls):
    """Milliseconds of each call beside the core's levels, after one to warm up."""
    segmenter = gestalt.Segmenter()
    depth = (scene.depth * 1000).round().astype("uint16")
    costs = []
    for _ in range(calls + 1):
        begin = time.perf_counter()
        result = segmenter(scene.colour, depth, scene.camera)
        total = 1000 * (time.perf_counter() - begin)
        costs.append(total - sum(result.milliseconds.values()))
    return costs[1:]


def frames_a_second(workers, scene, frames):
    with (
        tempfile.TemporaryDirectory() as links,
        tempfile.TemporaryDirectory() as output,
        distributed.Client(n_workers=workers, threads_per_worker=1, dashboard_address=None) as client,
    ):
        scenes = [os.path.join(links, str(number)) for number in range(max(frames, 4 * workers))]
        for link in scenes:
            os.symlink(scene, link)
        gestalt.dask.segment(client, scenes[: 4 * workers], output)  # plugins and model are loaded
        begin = time.perf_counter()
        outcomes = gestalt.dask.segment(client, scenes[:frames], output)
        seconds = time.perf_counter() - begin
    assert all(outcome.error is None for outcome in outcomes), outcomes
    return frames / seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene", nargs="?", default=ROOT / "examples" / "demo_scene")
    parser.add_argument("--json", required=True, metavar="FILE")
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    scene = os.path.realpath(options.scene)
    costs = call_cost(gestalt.read_scene(scene), 2 if options.quick else 100)
    # In turn, so that a machine that gets slower does so for both.
    rounds = 1 if options.quick else 3
    speeds = [[frames_a_second(workers, scene, 4 if options.quick else 60) for workers in (1, 2)] for _ in range(rounds)]
    report = {
        "call_milliseconds": statistics.median(costs),
        "worst_call_milliseconds": max(costs),
        "frames_a_second": {"1": statistics.median(s[0] for s in speeds), "2": statistics.median(s[1] for s in speeds)},
        "gain": statistics.median(two / one for one, two in speeds),
    }
    pathlib.Path(options.json).write_text(json.dumps(report, indent=1) + "\n")
    print(json.dumps(report, indent=1))


if __name__ == "__main__":
    sys.exit(main())
