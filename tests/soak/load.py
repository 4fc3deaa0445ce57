# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many frames in one process, little memory, one core, and the same labels everywhere."""

import json
import os
import random
import re
import resource
import shutil
import statistics
import subprocess

from runs import ROOT, Tally, command, run, synthesize


def slope(points):
    """Of the straight line that fits best."""
    xs, ys = zip(*points)
    x, y = statistics.fmean(xs), statistics.fmean(ys)
    return sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a in xs)


def resident(pid):
    """Kilobytes."""
    with open(f"/proc/{pid}/status") as status:
        return int(re.search(r"VmRSS:\s*(\d+)", status.read())[1])


def many_frames(scratch, frames):
    tally = Tally(f"{frames} frames in one process (stream)")
    scenes = synthesize(scratch / "scenes", 100, 160, 120)
    process = subprocess.Popen([command(), "stream", "-", "--output", scratch / "out"], stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    memory, times, done = [], [], 0
    ahead = 4  # frames that wait
    for i in range(frames + ahead):
        if i < frames:
            process.stdin.write(f"{scenes[i % len(scenes)]}\n")
            process.stdin.flush()
        if i >= ahead:
            line = json.loads(process.stdout.readline())
            times.append((done, line["latency_ms"] - line["queued_ms"]))
            done += 1
            if done % 50 == 0:
                memory.append((done, resident(process.pid)))
    process.stdin.close()
    process.stdout.read()
    error = process.stderr.read()
    code = process.wait()
    tally.judge(code, error, {0})
    tally.tried = done
    settled = [point for point in memory if point[0] > frames / 10]
    first, last = ([time for i, time in times if low <= i < high]
                   for low, high in ((frames // 10, frames // 5), (frames - frames // 10, frames)))
    tally.figures = {"RSS kB per frame": round(slope(settled), 4), "RSS MB at the end": memory[-1][1] // 1024,
                     "time of the last tenth / of the second": round(statistics.median(last) / statistics.median(first), 3)}
    return tally


def poor_machine(scratch, times):
    """The demo scene with less and less memory: its labels, or a clear refusal."""
    tally = Tally("nice 19, one core, an address space of 32 MB to 2 GB: the right labels or a clear error")
    scene = ROOT / "examples" / "demo_scene"
    reference = scratch / "reference"
    run([command(), "segment", scene, "--output", reference])
    wanted = (reference / scene.name / "labels.png").read_bytes()
    core = min(os.sched_getaffinity(0))
    least = None
    for i in range(times):
        megabytes = round(32 * 64 ** (i / max(1, times - 1)))

        def limit():
            os.nice(19)
            os.sched_setaffinity(0, {core})
            resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))

        out = scratch / "out"
        shutil.rmtree(out, ignore_errors=True)
        code, error = run([command(), "segment", scene, "--output", out], preexec_fn=limit)
        # 127: the loader has no room for the libraries, before any of our code runs.
        tally.judge(code, f"{megabytes} MB: {error}", {0, 1, 2, 3, 127})
        labels = out / scene.name / "labels.png"
        if code == 0:
            least = megabytes if least is None else min(least, megabytes)
            if labels.read_bytes() != wanted:
                tally.fault("lost or half-written", f"{megabytes} MB: other labels")
        elif not error.strip():
            tally.fault("wrong exit codes", f"{megabytes} MB: {code} without a word")
        elif labels.exists():
            tally.fault("lost or half-written", f"{megabytes} MB: labels of a run that failed")
    tally.figures = {"least MB that sufficed": least}
    return tally


# What a processor of before 2013 has not: the libraries that choose their code by the processor then choose the other.
OLDER_PROCESSOR = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F,-AVX512VL,-BMI1,-BMI2",
                   "OPENCV_CPU_DISABLE": "SSE4.1,SSE4.2,AVX,FP16,AVX2,FMA3,AVX512-SKX"}


def probabilities(out):
    return [pair["p"] for result in sorted(out.glob("*/result.json")) for pair in json.loads(result.read_text())["pairs"]]


def other_processor(scratch, scenes_count):
    """Not the same bytes everywhere: by how much results of another processor differ."""
    tally = Tally("the same scenes with the instructions of an older processor: whole results; how far they differ")
    scenes = [ROOT / "examples" / "demo_scene", *synthesize(scratch / "scenes", scenes_count, 640, 480, "complex_scene")]
    for out, variables in (("new", {}), ("old", OLDER_PROCESSOR)):
        tally.judge(*run([command(), "segment", *scenes, "--output", scratch / out], env=os.environ | variables), {0})
    same = sum((scratch / "new" / scene.name / "labels.png").read_bytes() ==
               (scratch / "old" / scene.name / "labels.png").read_bytes() for scene in scenes)
    new, old = (probabilities(scratch / out) for out in ("new", "old"))
    tally.figures = {"scenes": len(scenes), "with equal labels": same, "pairs": len(new)}
    if len(new) == len(old):
        tally.figures["largest difference of a p"] = float(f"{max(abs(a - b) for a, b in zip(new, old)):.2g}")
    else:
        tally.figures["pairs of the older"] = len(old)
    return tally


def determinism(scratch, times, builds):
    """Threads, orders, runs and builds."""
    tally = Tally(f"labels.png of 21 scenes: any number of threads, any order, builds {', '.join(builds)}")
    chance = random.Random(8)
    scenes = [ROOT / "examples" / "demo_scene", *synthesize(scratch / "scenes", 20, 320, 240, "complex_scene")]
    wanted = None
    for i in range(times):
        order = list(scenes)
        chance.shuffle(order)
        out = scratch / "out"
        shutil.rmtree(out, ignore_errors=True)
        build = builds[1] if len(builds) > 1 and i % 10 == 9 else builds[0]
        code, error = run([command(build), "segment", *order, "--threads", chance.choice([1, 2, 3, 4, 8, 16]),
                           "--output", out])
        tally.judge(code, error, {0})
        labels = {scene.name: (out / scene.name / "labels.png").read_bytes() for scene in scenes if code == 0}
        wanted = wanted or labels
        if labels != wanted:
            tally.fault("lost or half-written", f"run {i} of {build} has other labels")
    return tally
