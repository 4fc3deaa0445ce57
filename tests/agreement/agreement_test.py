# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""`gestalt evaluate` must agree with the reference scorer: every value to 1e-9, every printed digit.

    agreement_test.py GESTALT SHARED     (SHARED holds score/score.py and osd/learn)

Both score label images that are made here: the ground truth of the learn set, damaged in a different way for each scene,
and of a few degenerate scenes. Exits with 77 where something that it needs is missing.
"""
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SKIPPED = 77
GESTALT, SHARED = (Path(a).resolve() for a in sys.argv[1:3])
SCORER, LEARN = SHARED / "score" / "score.py", SHARED / "osd" / "learn"

for needed in (SCORER, LEARN):
    if not needed.exists():
        print(f"skipped: there is no {needed}")
        sys.exit(SKIPPED)
try:
    import cv2
    import numpy as np
    import scipy.optimize  # noqa: F401  (the scorer needs it)
except ImportError as error:
    print(f"skipped: {sys.executable}: {error}")
    sys.exit(SKIPPED)


def stripes(width):
    return lambda labels, _: np.where(labels > 1, labels * 100 + np.arange(labels.shape[1]) // width, labels)


def tiles(labels, _):
    v, u = np.indices(labels.shape)
    return 1 + (v // 40) * 64 + u // 40


def shift(dv, du):
    return lambda labels, _: np.roll(labels, (dv, du), (0, 1))


def permute(labels, random):
    return (1 + random.permutation(60000))[labels] * (labels > 0)


def keep(wanted):
    return lambda labels, _: np.where(wanted(labels), labels, 0)


def rename(old, new):
    return lambda labels, _: np.where(labels == old, new, labels)


def grow(labels, _):
    return cv2.dilate(labels.astype(np.uint16), np.ones((7, 7), np.uint8)).astype(labels.dtype)


def speckle(labels, random):
    return np.where(random.rand(*labels.shape) < 0.02, random.randint(0, 6, labels.shape), labels)


def halve_table(labels, _):
    return np.where((labels == 1) & (np.indices(labels.shape)[0] % 100 < 49), 900, labels)


# What is done to labels 0 none, 1 table, 2 and up objects.
DAMAGES = [
    lambda labels, _: labels,
    permute,
    rename(2, 3),                       # two objects are one
    rename(2, 1),                       # an object is part of the table
    stripes(25),                        # objects in many pieces: many segments without a region
    stripes(3),
    tiles,
    shift(2, -1),
    shift(-9, 14),
    keep(lambda labels: labels > 1),    # no table
    keep(lambda labels: labels % 2 == 1),
    keep(lambda labels: labels == 1),   # table only: fewer segments than regions
    lambda labels, _: labels * 0,       # no segment at all
    lambda labels, _: labels * 0 + 7,   # one segment
    grow,
    speckle,
    halve_table,
    lambda labels, random: permute(speckle(stripes(25)(shift(3, 3)(labels, random), random), random), random),
]


def read(file):
    return cv2.imread(str(file), cv2.IMREAD_UNCHANGED)


def write(file, image):
    file.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(file), image)


def natural(name):
    return [int(t) if t.isdigit() else t for t in re.split(r"(\d+)", name)]


def write_predictions(scenes, folder, image, first):
    """A damaged ground truth for each scene, in either of the places and depths that are allowed."""
    for i, scene in enumerate(sorted(os.listdir(scenes), key=natural)):
        truth = read(scenes / scene / "label.png").astype(np.int64)
        labels = np.where(truth >= 20, truth // 10, truth > 0).astype(np.int64)
        labels = DAMAGES[(first + i) % len(DAMAGES)](labels, np.random.RandomState(i))
        file = folder / f"{scene}.png" if i % 3 == 0 else folder / scene / image
        write(file, labels.astype(np.uint8 if labels.max() < 256 else np.uint16))


def write_degenerate_scenes(folder):
    random = np.random.RandomState(1)

    def scene(name, label, depth):
        write(folder / name / "label.png", label.astype(np.uint16))
        write(folder / name / "depth.png", depth.astype(np.uint16))

    table = np.ones((60, 80))
    scene("only_table", table, table * 900)
    scene("only_object", table * 20, table * 900)
    scene("no_truth", table * 0, table * 900)
    scene("no_depth", table * 20, table * 0)
    scene("one_pixel", np.full((1, 1), 20), np.full((1, 1), 900))
    scene("one_row", np.arange(20, 90)[None, :], np.full((1, 70), 900))
    scene("holes", np.where(random.rand(60, 80) < 0.3, 20 + 10 * (np.arange(80) // 8), 1), 900 * (random.rand(60, 80) < 0.9))


def equal(a, b):
    undefined = [x is None or (isinstance(x, float) and math.isnan(x)) for x in (a, b)]
    return all(undefined) if any(undefined) else abs(a - b) <= 1e-9


def numbers(tables):
    """The lines of the tables that hold category and numbers, in order, without those of the mean over categories."""
    lines = [line for line in tables.splitlines() if re.match(r"\S+( +(-?[0-9.]+|nan))+$", line)]
    return [line for line in lines if not line.startswith("mean ")]


class Agreement(unittest.TestCase):
    def compare(self, scenes, predictions, *options):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "rows.json"
            reference = subprocess.run(
                [sys.executable, "-W", "ignore", SCORER, predictions, "--gt", scenes, "--json", file, "--jobs", "2", *options],
                check=True, stdout=subprocess.PIPE, text=True).stdout
            expected = json.loads(file.read_text())
        command = [GESTALT, "evaluate", scenes, "--predictions", predictions, *options]
        self.compare_first_tables(command, expected)
        command.append("--all")
        tables = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        actual = json.loads(subprocess.run(command + ["--json"], check=True, stdout=subprocess.PIPE, text=True).stdout)

        # What the reference has not: how it was scored, and the mean over the categories.
        image = options[options.index("--image") + 1] if "--image" in options else "labels.png"
        self.assertEqual(actual.pop("scored")["image"], image)
        mean = actual.pop("mean")
        for key in ("P", "R", "majority:oF", "none:F>.75", "parts_objects:WOv"):
            values = [row[key] for category, row in expected.items() if category != "all"]
            undefined = any(value is None or math.isnan(value) for value in values)
            self.assertTrue(equal(mean[key], None if undefined else sum(values) / len(values)), key)
        self.assertEqual(list(actual), list(expected))
        for category, row in expected.items():
            self.assertEqual(list(actual[category]), list(row))
            for key, value in row.items():
                self.assertTrue(equal(actual[category][key], value), (category, key, actual[category][key], value))
        tables = tables.split("\n\n", 2)[2]  # the first table holds columns of a later one
        self.assertGreaterEqual(len(numbers(tables)), 6 * len(expected))
        self.assertEqual(numbers(tables), numbers(reference))

    def compare_first_tables(self, command, expected):
        """Without --all the rule decides what is printed: F > 0.75, overlap F and boundary F of each row."""
        for rule in ("majority", "none"):
            text = subprocess.run([*command, "--rule", rule], check=True, stdout=subprocess.PIPE, text=True).stdout
            self.assertIn(f"under the rule {rule}:", text)
            printed = [line.split() for line in numbers(text)[:len(expected)]]
            self.assertEqual([line[0] for line in printed], list(expected))
            for (category, images, *values), row in zip(printed, expected.values()):
                self.assertEqual(int(images), row["images"])
                wanted = [row[f"{rule}:{key}"] for key in ("F>.75", "oF", "bF")]
                self.assertEqual(values, [f"{100 * value:.2f}" for value in wanted], category)

    def test_learn_set_by_category(self):
        with tempfile.TemporaryDirectory() as folder:
            write_predictions(LEARN, Path(folder), "labels.png", 0)
            self.compare(LEARN, Path(folder))

    def test_every_scene_by_itself(self):
        for first, options in ((5, ()), (11, ("--parts", "--image", "objects.png"))):
            with tempfile.TemporaryDirectory() as folder:
                scenes = Path(folder) / "scenes"
                write_degenerate_scenes(scenes)
                for scene in LEARN.iterdir():
                    (scenes / scene.name).symlink_to(scene)
                rows = [f"{name},{name}\n" for name in sorted(os.listdir(scenes))]
                (Path(folder) / "scenes.csv").write_text("scene,category\n" + "".join(rows))
                write_predictions(scenes, Path(folder) / "predictions", "objects.png" if options else "labels.png", first)
                self.compare(scenes, Path(folder) / "predictions", *options)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
