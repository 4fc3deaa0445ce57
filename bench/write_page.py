# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""write_page.py DIR PAGE: brings what a page says between two marks, and growth.svg beside it, up to date with the
reports of scripts/bench in DIR. The page is docs/benchmarks.md."""

import pathlib
import platform
import re
import sys

from growth_plot import plot
from targets import Reports, targets

BEGIN, END = "<!-- begin: bench/write_page.py -->\n", "<!-- end: bench/write_page.py -->\n"

CONTESTANTS = {
    "default": "`configs/default.yaml`",
    "realtime": "`configs/realtime.yaml`",
    "paper": "`configs/paper.yaml`",
    "pcl_normals": "PCL IntegralImageNormalEstimation",
    "pcl_planes": "the same and OrganizedMultiPlaneSegmentation",
    "pcl_lccp": "PCL SupervoxelClustering and LCCPSegmentation",
    "pcl_lccp_best": "the same with the settings that score best",
}
SPREAD = ("median", "p95", "p99", "worst")
MEGABYTE = 2**20


def table(heading, rows):
    lines = [heading, ["---"] * len(heading), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def numbers(values):
    return [f"{value:.1f}" for value in values]


def processor():
    names = re.findall(r"model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return names[0] if names else platform.machine()


def target_table(reports):
    return table(["", "target", "measured", ""],
                 [[target.what, target.aim.replace("<=", "≤").replace(">=", "≥"), target.figure, target.verdict]
                  for target in targets(reports)])


def comparison(compare):
    times, ratios = compare["milliseconds"], compare["ratios"]
    rows = [[CONTESTANTS[name], *numbers(spread[column] for column in SPREAD),
             "1" if name == "pcl_lccp" else f"{ratios[name]['pcl_lccp']:.2f}"] for name, spread in times.items()]
    return table(["milliseconds of a frame", *SPREAD, "median / LCCP's"], rows)


def frame(report):
    rows = [[level.replace("_", " "), *numbers(spread[column] for column in SPREAD)]
            for level, spread in report["milliseconds"].items()]
    counted = (f"{report['allocations']['median']:.0f} allocations of {report['allocated_bytes']['median'] / MEGABYTE:.0f} "
               f"MB in sum for the median frame; peak memory of the process {report['peak_megabytes']:.0f} MB.\n")
    return table([f"`{report['config']}`, milliseconds", *SPREAD], rows) + "\n" + counted


def growth(scaling):
    rows = [[f"{entry['size']:.0f} {what}", f"{entry['milliseconds']:.2f}", f"{entry['size_ratio']:.3g}",
             f"{entry['time_ratio']:.3g}"] for what in ("pixels", "patches", "pairs") for entry in scaling[what]]
    return table(["size", "milliseconds", "size, ratio", "time, ratio"], rows)


def startup(report):
    names = {"config_plugins_model": "config, plugins and model, in a process that has none of them",
             "gestalt_version": "whole process of `gestalt --version`",
             "gestalt_plugins_list": "whole process of `gestalt plugins list`"}
    rows = [[names[name], *numbers(spread[column] for column in SPREAD)]
            for name, spread in report["milliseconds"].items()]
    return table(["milliseconds", *SPREAD], rows)


def sections(reports):
    compare, throughput = reports["compare"], reports["throughput"]
    yield f"Processor: {processor()}; {compare['threads']} threads.\n"
    yield target_table(reports)
    yield f"## Against PCL\n\n{compare['frames']} frames, {compare['repeats']} runs each, in turn frame by frame.\n"
    yield comparison(compare)
    yield "## By level\n"
    yield from (frame(reports[name]) for name in ("frame", "frame_realtime", "frame_paper") if reports[name])
    yield "## Growth\n\n![time against pixels, patches and pairs](growth.svg)\n"
    yield growth(reports["scaling"])
    rates = throughput["frames_per_second"]
    yield (f"## Many frames at once\n\n{rates['one_thread']:.1f} frames a second with one thread, "
           f"{rates['all_threads']:.1f} with {throughput['threads']}: {throughput['gain']:.2f} times as many.\n")
    yield "## Start-up\n"
    yield startup(reports["startup"])


if __name__ == "__main__":
    results = Reports(sys.argv[1])
    page = pathlib.Path(sys.argv[2])
    before, _, rest = page.read_text().partition(BEGIN)
    _, mark, after = rest.partition(END)
    if not mark:
        sys.exit(f"{page}: lacks the line {BEGIN.strip()} or {END.strip()}; put back what stands between them")
    page.write_text(before + BEGIN + "\n" + "\n".join(sections(results)) + "\n" + END + after)
    (page.parent / "growth.svg").write_text(plot(results["scaling"]))
