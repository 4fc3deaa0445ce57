# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/train_models makes the same models, to the byte, from run to run and for any number of threads: those in models/.

    models_test.py GESTALT LEARN REAL     (the folders of the OSD learn scenes and of labelled scenes of other sensors)

Exits with 77 where the scenes are missing.
"""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SKIPPED = 77
ROOT = Path(__file__).resolve().parents[2]
GESTALT, LEARN, REAL = (Path(a).resolve() for a in sys.argv[1:4])
for folder in (LEARN, REAL):
    if not folder.is_dir():
        print(f"skipped: there is no {folder}")
        sys.exit(SKIPPED)


def train(output, processors):
    """On so many processors, which is the number of threads that the program uses."""
    own = os.sched_getaffinity(0)
    os.sched_setaffinity(0, set(sorted(own)[:processors]))
    try:
        subprocess.run([ROOT / "scripts" / "train_models", LEARN, REAL, output], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, "GESTALT": str(GESTALT)})
    finally:
        os.sched_setaffinity(0, own)
    return {file.name: file.read_bytes() for file in Path(output).iterdir()}


class Models(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as all_of_them:
            cls.one_thread = train(one, 1)
            cls.all_threads = train(all_of_them, len(os.sched_getaffinity(0)))

    def test_do_not_depend_on_the_run_or_its_threads(self):
        self.assertEqual(sorted(self.one_thread), ["default.json", "depth_only.json", "paper.json", "realtime.json", "synthetic.json"])
        for name, model in self.one_thread.items():
            self.assertTrue(model == self.all_threads[name], f"{name} differs")

    def test_are_those_that_are_shipped(self):
        for name, model in self.one_thread.items():
            shipped = (ROOT / "models" / name).read_bytes()
            remedy = f"models/{name} is not what this program learns on this processor: run scripts/train_models LEARN REAL"
            self.assertTrue(model == shipped, remedy)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
