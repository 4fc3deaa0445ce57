# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""growth_plot.py DIR FILE: draws time against pixels, patches and pairs from DIR/scaling.json as SVG, both axes
logarithmic. The dashed line is proportional growth from the smallest size."""

import math
import pathlib
import sys

from targets import Reports

PANEL, GAP, TOP, LEFT, BOTTOM = 220, 80, 40, 70, 50
PANELS = [("pixels", "whole frame, ms", "pixels"),
          ("patches", "structural level, ms", "patches"),
          ("pairs", "assembly level, ms", "pairs of patches")]


class Axis:
    """Places values on a logarithmic scale between two ends, given in pixels of the picture."""

    def __init__(self, values, begin, end):
        self.low, self.high = math.log(min(values)) - 0.15, math.log(max(values)) + 0.15
        self.begin, self.end = begin, end

    def __call__(self, value):
        return self.begin + (math.log(value) - self.low) / (self.high - self.low) * (self.end - self.begin)


def short(number):
    if number >= 1e6:
        return f"{number / 1e6:.3g}M"
    if number >= 1e4:
        return f"{number / 1e3:.3g}k"
    return f"{number:.0f}" if number >= 100 else f"{number:.3g}"


def text(x, y, words, anchor="middle"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{words}</text>'


def line(points, style):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polyline points="{path}" fill="none" {style}/>'


def panel(entries, left, title, size_name):
    sizes = [entry["size"] for entry in entries]
    times = [entry["milliseconds"] for entry in entries]
    proportional = [times[0] * size / sizes[0] for size in sizes]
    x = Axis(sizes, left, left + PANEL)
    y = Axis(times + proportional, TOP + PANEL, TOP)
    measured = [(x(size), y(time)) for size, time in zip(sizes, times)]
    parts = [
        f'<rect x="{left}" y="{TOP}" width="{PANEL}" height="{PANEL}" fill="none" stroke="#999"/>',
        text(left + PANEL / 2, TOP - 14, title),
        text(left + PANEL / 2, TOP + PANEL + 38, size_name),
        line([(x(size), y(time)) for size, time in zip(sizes, proportional)], 'stroke="#999" stroke-dasharray="4 4"'),
        line(measured, 'stroke="#1f6fb4" stroke-width="2"'),
    ]
    for (cx, cy), size, time in zip(measured, sizes, times):
        parts += [f'<circle cx="{cx:.1f}" cy="{cy:.1f}" r="3.5" fill="#1f6fb4"/>',
                  text(cx, TOP + PANEL + 18, short(size)),
                  text(left - 6, cy + 4, short(time), "end")]
    return parts


def plot(scaling):
    width = LEFT + len(PANELS) * (PANEL + GAP) - GAP + 30
    height = TOP + PANEL + BOTTOM
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             'font-family="sans-serif" font-size="12">',
             f'<rect width="{width}" height="{height}" fill="white"/>']
    for i, (name, title, size_name) in enumerate(PANELS):
        parts += panel(scaling[name], LEFT + i * (PANEL + GAP), title, size_name)
    return "\n".join([*parts, "</svg>"]) + "\n"


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_text(plot(Reports(sys.argv[1])["scaling"]))
