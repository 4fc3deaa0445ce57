# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""report_test.py PROGRAM GESTALT FILE: runs a benchmark once, which writes its report to FILE, and checks that the
report is complete, not what it measured."""

import json
import pathlib
import subprocess
import sys

SPREAD = ("median", "p95", "p99", "worst")
LEVELS = ("signal", "primitive", "structural", "assembly", "decision")
CONTESTANTS = ("default", "paper", "pcl_normals", "pcl_planes", "pcl_lccp")
GROWTH = ("size", "milliseconds", "size_ratio", "time_ratio")


def run(program, *arguments):
    return subprocess.run([program, *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


def report_of(program, file, *arguments):
    file.parent.mkdir(exist_ok=True)
    file.unlink(missing_ok=True)
    run(program, *arguments)
    return json.loads(file.read_text())


def require_numbers(values, names):
    for name in names:
        assert isinstance(values[name], (int, float)) and values[name] >= 0, f"{name} of {values}"


def require_spreads(spreads, names):
    for name in names:
        require_numbers(spreads[name], SPREAD)
        assert spreads[name]["median"] <= spreads[name]["worst"], f"{name} of {spreads}"


def check_frame(report):
    require_spreads(report["milliseconds"], (*LEVELS, "whole_frame"))
    require_spreads(report, ("allocations", "allocated_bytes"))
    require_numbers(report, ("frames", "repeats", "threads", "peak_megabytes"))
    assert report["allocated_bytes"]["median"] > 640 * 480, "a frame allocates more than a byte a pixel"


def check_compare(report):
    scored = ("default", "paper", "pcl_lccp", "pcl_lccp_best")
    for one in scored:
        require_numbers(report["scores"][one], ("majority:F>.75", "majority:oF", "majority:bF", "P", "R"))
        assert report["scores"][one]["images"] == 1, report["scores"][one]
    assert report["scores"]["default"]["R"] > 0.5, report["scores"]["default"]
    assert "pcl_normals" not in report["scores"]
    require_spreads(report["milliseconds"], CONTESTANTS)
    for one in CONTESTANTS:
        require_numbers(report["ratios"][one], (other for other in CONTESTANTS if other != one))


def check_scaling(report):
    for what in ("pixels", "patches", "pairs"):
        for entry in report[what]:
            require_numbers(entry, GROWTH)
        sizes = [entry["size"] for entry in report[what]]
        assert sizes == sorted(set(sizes)), f"{what} do not grow: {sizes}"


def check_throughput(report):
    require_numbers(report["frames_per_second"], ("one_thread", "all_threads"))
    require_numbers(report, ("gain",))


def check_boundary(report):
    require_numbers(report["milliseconds"], ("plugins", "linked"))
    assert isinstance(report["boundary_percent"], float), report


def check_startup(report):
    require_spreads(report["milliseconds"], ("config_plugins_model", "gestalt_version", "gestalt_plugins_list"))


def check_levels(names):
    measured = {name.rpartition("/")[0] for name in names}  # less the kind of time
    missing = {f"{config}/{level}" for config in ("default", "paper") for level in LEVELS} - measured
    assert not missing, missing


def check_relations(names):
    plugins = json.loads(run(sys.argv[2], "plugins", "list", "--json"))["components"]
    relations = [plugin["name"] for plugin in plugins if plugin["kind"] == "relation"]
    assert relations
    missing = {f"{relation}/{part}/real_time" for relation in relations for part in ("bind", "pairs")} - names
    assert not missing, missing


def check_surfaces(names):
    assert "fit_merged/control_points:3" in names, names


REPORTS = {"bench_frame": check_frame, "bench_compare": check_compare, "bench_scaling": check_scaling,
           "bench_throughput": check_throughput, "bench_startup": check_startup, "bench_boundary": check_boundary}
GOOGLE_BENCHMARKS = {"bench_levels": check_levels, "bench_relations": check_relations, "bench_surfaces": check_surfaces}

program, file = sys.argv[1], pathlib.Path(sys.argv[3])
name = pathlib.Path(program).name
if name in REPORTS:
    more = ["--score"] if name == "bench_compare" else []
    REPORTS[name](report_of(program, file, "--quick", "--json", file, *more))
else:
    report = report_of(program, file, "--benchmark_min_time=0", f"--benchmark_out={file}", "--benchmark_out_format=json")
    failed = [benchmark for benchmark in report["benchmarks"] if benchmark.get("error_occurred")]
    assert not failed, failed
    GOOGLE_BENCHMARKS[name]({benchmark["name"] for benchmark in report["benchmarks"]})
