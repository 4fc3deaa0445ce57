# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""targets.py DIR: what was aimed at and what the reports of scripts/bench say, as a table."""

import json
import operator
import pathlib
import sys
from dataclasses import dataclass


class Reports:
    """The reports of a folder, by the name of their file. A report that does not exist is None."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def __getitem__(self, name):
        file = self.folder / f"{name}.json"
        return json.loads(file.read_text()) if file.exists() else None


@dataclass
class Target:
    what: str
    bound: float
    measured: float | None  # None: not measured
    unit: str = ""
    at_least: bool = False

    @property
    def aim(self):
        return f"{'>=' if self.at_least else '<='} {self.bound:g}{self.unit}"

    @property
    def figure(self):
        return "-" if self.measured is None else f"{self.measured:.3g}{self.unit}"

    @property
    def verdict(self):
        if self.measured is None:
            return "not measured"
        met = (operator.ge if self.at_least else operator.le)(self.measured, self.bound)
        return "met" if met else "not met"


def frame_targets(compare, config, median, p99, lccp):
    times = compare["milliseconds"].get(config)
    ratio = compare["ratios"][config]["pcl_lccp"] if times else None
    return [
        Target(f"{config}: median frame", median, times and times["median"], " ms"),
        Target(f"{config}: 99th percentile", p99, times and times["p99"], " ms"),
        Target(f"{config}: median frame against PCL's LCCP", lccp, ratio, "x"),
    ]


def growth_to(entries, size_ratio):
    """How much longer it takes where the size is about that many times the reference's; None where nothing is."""
    near = [entry for entry in entries if abs(entry["size_ratio"] / size_ratio - 1) < 0.05]
    return near[0]["time_ratio"] if near else None


def targets(reports):
    scaling, startup = reports["scaling"], reports["startup"]["milliseconds"]
    boundary = reports["boundary"] or {"boundary_percent": None}
    python = reports["python"] or {"call_milliseconds": None, "gain": None}
    return [
        *frame_targets(reports["compare"], "default", median=110, p99=220, lccp=0.35),
        *frame_targets(reports["compare"], "realtime", median=60, p99=120, lccp=0.2),
        Target("1280x960 against 640x480", 1.5, growth_to(scaling["pixels"], 4), "x"),
        Target("1920x1440 against 640x480", 2, growth_to(scaling["pixels"], 9), "x"),
        Target("3840x2880 against 640x480", 4, growth_to(scaling["pixels"], 36), "x"),
        Target("200 patches against 100, structural level", 2.2, growth_to(scaling["patches"], 2), "x"),
        Target("400 patches against 100, structural level", 4.8, growth_to(scaling["patches"], 4), "x"),
        Target("800 patches against 100, structural level", 10.6, growth_to(scaling["patches"], 8), "x"),
        Target("frames a second, two threads against one", 1.85, reports["throughput"]["gain"], "x", at_least=True),
        Target("config, plugins and model loaded", 100, startup["config_plugins_model"]["median"], " ms"),
        Target("whole process of gestalt --version", 100, startup["gestalt_version"]["median"], " ms"),
        Target("components as plugins against linked ones", 1, boundary["boundary_percent"], " %"),
        Target("a frame called from Python, beside its levels", 2, python["call_milliseconds"], " ms"),
        Target("frames a second, two Dask workers against one", 1.8, python["gain"], "x", at_least=True),
        Target("peak memory", 120, reports["frame"]["peak_megabytes"], " MB"),
    ]


if __name__ == "__main__":
    table = [("", "target", "measured", "")]
    table += [(target.what, target.aim, target.figure, target.verdict) for target in targets(Reports(sys.argv[1]))]
    for what, aim, figure, verdict in table:
        print(f"{what:<46}{aim:>12}{figure:>12}  {verdict}")
