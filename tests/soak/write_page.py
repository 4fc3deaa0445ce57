# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""write_page.py DIR PAGE: brings what a page says between two marks up to date with the reports fuzz.json, soak.json,
coverage.json and valgrind.json in DIR. The page is docs/reliability.md."""

import json
import pathlib
import sys

from runs import FAULTS

BEGIN, END = "<!-- begin: tests/soak/write_page.py -->\n", "<!-- end: tests/soak/write_page.py -->\n"
FINDS = ("crashes", "hangs", "memory", "leaks")


def table(heading, rows):
    return "".join("| " + " | ".join(str(cell) for cell in line) + " |\n"
                   for line in (heading, ["---"] * len(heading), *rows))


def fuzz_table(report):
    rows = [[f"`{name}`", f"{row['executions']:,}", *(row[kind] for kind in FINDS)] for name, row in report.items()]
    rows.append(["all", f"{sum(row['executions'] for row in report.values()):,}",
                 *(sum(row[kind] for row in report.values()) for kind in FINDS)])
    return table(["fuzz target", "inputs", "crashes", "hangs", "too much memory", "leaks"], rows)


def soak_table(report):
    return table(["what was tried", "times", *FAULTS],
                 [[row["what"], f"{row['tried']:,}", *(row[kind] for kind in FAULTS)] for row in report.values()])


def figures(report):
    lines = [f"* {row['what']}: " + ", ".join(f"{name} {value}" for name, value in row["figures"].items()) + "\n"
             for row in report.values() if row["figures"]]
    return "".join(lines)


def coverage(report):
    rows = [[f"`{folder}`", counts["lines"], counts["covered"], f"{100 * counts['covered'] / counts['lines']:.1f}"]
            for folder, counts in report["folders"].items()]
    rows.append(["all", report["lines"], report["covered"], f"{report['percent']:.1f}"])
    return (table(["lines of core and plugins", "lines", "run by tests", "%"], rows) +
            "\n`scripts/coverage` prints the lines that no test runs.\n")


def memcheck(report):
    return (f"One whole frame under valgrind's memcheck: {report['errors']} errors, {report['definitely_lost_bytes']} bytes "
            "definitely lost.\n")


SECTIONS = {"fuzz": fuzz_table, "soak": lambda report: soak_table(report) + "\n" + figures(report), "valgrind": memcheck,
            "coverage": coverage}


def main(folder, page):
    sections = []
    for name, section in SECTIONS.items():
        file = folder / f"{name}.json"
        sections.append(section(json.loads(file.read_text())) if file.exists() else f"No report of `scripts/{name}`.\n")
    text = "\n".join(sections)
    before, rest = page.read_text().split(BEGIN)
    page.write_text(before + BEGIN + "\n" + text + "\n" + END + rest.split(END)[1])


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
