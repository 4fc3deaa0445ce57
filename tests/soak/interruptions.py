# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed or interrupted at random moments, and those that go on after them."""

import random
import shutil
import signal
import time

from runs import Tally, check_same, check_whole, command, finish, run, start, synthesize


def timed(arguments):
    begin = time.monotonic()
    code, error = run(arguments)
    if code != 0:
        raise SystemExit(f"the undisturbed run failed: {error}")
    return time.monotonic() - begin


def disturb(process, how, seconds):
    time.sleep(seconds)
    process.send_signal(how)
    return finish(process)


def killed(scratch, what, arguments, resumed, times, outputs, seed):
    """arguments(folder) are those of the run, resumed(folder) those of the run that goes on; outputs are compared."""
    tally = Tally(what)
    chance = random.Random(seed)
    reference = scratch / "reference"
    duration = timed(arguments(reference))
    for _ in range(times):
        out = scratch / "out"
        shutil.rmtree(out, ignore_errors=True)
        code, error = disturb(start(arguments(out)), signal.SIGKILL, chance.uniform(0, duration))
        tally.judge(code, error, {0, -signal.SIGKILL})
        if out.exists():
            check_whole(tally, out, reference)
        code, error = run(resumed(out))
        if code != 0:
            tally.fault("wrong exit codes", f"going on: {code}: {error}")
        outputs(tally, out, reference)
    return tally


def batch(scratch, times, scenes_count):
    scenes = scratch / "scenes"
    synthesize(scenes, scenes_count, 160, 120)

    def segment(out, *more):
        return [command(), "segment", scenes, "--output", out, *more]

    return killed(scratch, f"SIGKILL in a batch of {scenes_count} scenes, then --resume", segment,
                  lambda out: segment(out, "--resume"), times, check_same, 1)


def training(scratch, times, scenes_count):
    scenes = scratch / "scenes"
    synthesize(scenes, scenes_count, 160, 120)

    def train(out):
        return [command(), "train", scenes, "--output", out / "model.json"]

    return killed(scratch, f"SIGKILL in train with {scenes_count} scenes, then the same again", train, train, times,
                  check_same, 2)


def ablation(scratch, times, scenes_count):
    scenes = scratch / "scenes"
    synthesize(scenes, scenes_count, 160, 120)

    def ablate(out):
        return [command(), "ablate", scenes, "--cross-validate", 2, "--grid", "structural.minimum_size=10,20,30,40",
                "--output", out]

    return killed(scratch, f"SIGKILL in ablate with {scenes_count} scenes, then the same again", ablate, ablate, times,
                  check_same, 3)


def signals(scratch, times, scenes_count):
    tally = Tally(f"SIGINT and SIGTERM in a batch of {scenes_count} scenes, then --resume")
    chance = random.Random(4)
    scenes, reference = scratch / "scenes", scratch / "reference"
    synthesize(scenes, scenes_count, 160, 120)
    duration = timed([command(), "segment", scenes, "--output", reference])
    for i in range(times):
        how = (signal.SIGINT, signal.SIGTERM)[i % 2]
        out = scratch / "out"
        shutil.rmtree(out, ignore_errors=True)
        process = start([command(), "segment", scenes, "--output", out])
        code, error = disturb(process, how, chance.uniform(0, duration))
        tally.judge(code, error, {128 + how, -how, 0})  # the last two: before it listens, after all is done
        if out.exists():
            check_whole(tally, out, reference)
            if left := list(out.rglob(".gestalt-*")):
                tally.fault("lost or half-written", f"{left[0].name} is left")
        code, error = run([command(), "segment", scenes, "--output", out, "--resume"])
        if code != 0:
            tally.fault("wrong exit codes", f"going on: {code}: {error}")
        check_same(tally, out, reference)
    return tally
