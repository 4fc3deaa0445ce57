# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""page_test.py DIR: makes the table, the plot and the page of the reports in DIR, on a copy of the page."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

BENCH = pathlib.Path(__file__).parent
reports = sys.argv[1]


def run(script, *arguments):
    return subprocess.run([sys.executable, BENCH / script, *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


with tempfile.TemporaryDirectory() as folder:
    page = pathlib.Path(folder) / "benchmarks.md"
    shutil.copy(BENCH.parent / "docs" / "benchmarks.md", page)
    run("write_page.py", reports, page)
    once = page.read_text()
    run("write_page.py", reports, page)
    assert page.read_text() == once, "the page changes when it is written again"
    xml.etree.ElementTree.parse(page.parent / "growth.svg")
    plot = pathlib.Path(folder) / "plot.svg"
    run("growth_plot.py", reports, plot)
    assert plot.read_text() == (page.parent / "growth.svg").read_text()

table = run("targets.py", reports)
assert all(f"{config}: median frame" in table for config in ("default", "realtime")), table
