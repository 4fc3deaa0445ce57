# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""The type stubs are those of the module, and the package is typed strictly."""

import os
import subprocess
import sys
import tempfile
import unittest


class TypesTest(unittest.TestCase):
    def run_module(self, *words):
        with tempfile.TemporaryDirectory() as cache:
            done = subprocess.run(
                [sys.executable, "-m", *words],
                env={**os.environ, "MYPYPATH": os.environ["PYTHONPATH"], "MYPY_CACHE_DIR": cache},
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=cache,
            )
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_stubs_agree_with_the_module(self):
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as inherent:
            # What every class of pybind11 has, and those without a constructor.
            inherent.write("gestalt\\._gestalt\\.(Camera|Result|SceneView|Segmenter|Tracker)(\\.__init__)?\n")
            # Without depth or a camera it says what is missing, so that both are optional to Python alone.
            inherent.write("gestalt\\._gestalt\\.Segmenter\\.__call__\n")
            inherent.flush()
            self.run_module("mypy.stubtest", "gestalt._gestalt", "--ignore-missing-stub", "--allowlist", inherent.name)

    def test_the_package_is_typed(self):
        self.run_module("mypy", "--strict", "--allow-untyped-calls", "-p", "gestalt")


if __name__ == "__main__":
    unittest.main()
