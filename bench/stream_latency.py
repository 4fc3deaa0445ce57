# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""stream_latency.py GESTALT SCENES...: what a camera at a fixed rate would see of `gestalt stream --drop`.

The scenes, folders of scenes among them, are sent over and over for ten minutes. Reports latencies from a frame's
arrival until its result is written, reading included, the frames that were dropped, and the memory of the process
after a tenth of the time and at the end.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time


def scenes_in(paths):
    """The scenes that are named, and those in folders that are named."""
    for path in paths:
        if (path / "depth.png").exists():
            yield path.resolve()
        else:
            yield from sorted(depth.parent.resolve() for depth in path.glob("*/depth.png"))


def resident_megabytes(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024
    return None  # the process has ended


def percentile(values, percent):
    """The smallest value that so many percent of the values do not exceed."""
    return sorted(values)[max(0, -(-len(values) * percent // 100) - 1)]


def send(process, scenes, rate, count):
    """Writes scene names when they are due; memory after each tenth of them."""
    memory = []
    start = time.monotonic()
    for i in range(count):
        time.sleep(max(0.0, start + i / rate - time.monotonic()))
        try:
            process.stdin.write(f"{scenes[i % len(scenes)]}\n")
            process.stdin.flush()
        except BrokenPipeError:  # it has ended; its exit code tells
            return memory
        if (i + 1) % max(1, count // 10) == 0:
            memory.append(resident_megabytes(process.pid))
    process.stdin.close()
    return memory


def measure(options, scenes):
    count = max(1, round(options.rate * options.seconds))
    frames = []
    with tempfile.TemporaryDirectory() as output:
        command = [options.gestalt, "stream", "-", "--drop", "--output", output, "--config", options.config]
        process = subprocess.Popen([*command, "--threads", str(options.threads)], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, text=True)
        reader = threading.Thread(target=lambda: frames.extend(json.loads(line) for line in process.stdout))
        reader.start()
        memory = send(process, scenes, options.rate, count)
        reader.join()
        if process.wait() != 0:
            sys.exit(f"gestalt stream ended with exit code {process.returncode}")
    if not frames:
        sys.exit("gestalt stream segmented no frame; see its messages above")
    latencies = [frame["latency_ms"] for frame in frames]
    return {
        "config": options.config,
        "rate": options.rate,
        "sent": count,
        "segmented": len(frames),
        "dropped": count - len(frames),
        "latency_milliseconds": {
            "median": percentile(latencies, 50), "p99": percentile(latencies, 99), "worst": max(latencies)},
        "megabytes": {"after_a_tenth": memory[0], "at_the_end": memory[-1]},
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gestalt", help="the command, build/bin/gestalt")
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    parser.add_argument("--config", default="default.yaml")
    parser.add_argument("--rate", type=float, default=30, help="frames a second (30)")
    parser.add_argument("--seconds", type=float, default=600, help="how long (600)")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--json", type=pathlib.Path, help="write the figures to this file")
    options = parser.parse_args()
    scenes = list(scenes_in(options.scenes))
    if not scenes:
        parser.error("no scene with a depth.png is named; name scenes or folders of scenes")
    report = measure(options, scenes)
    if options.json:
        options.json.write_text(json.dumps(report, indent=1) + "\n")
    latency, megabytes = report["latency_milliseconds"], report["megabytes"]
    print(f"{report['sent']} frames sent, {report['segmented']} segmented, {report['dropped']} dropped; latency: median "
          f"{latency['median']:.1f} ms, 99th percentile {latency['p99']:.1f} ms, worst {latency['worst']:.1f} ms; memory: "
          f"{megabytes['after_a_tenth']:.0f} MB after a tenth of the time, {megabytes['at_the_end']:.0f} MB at the end")


if __name__ == "__main__":
    main()
