# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""`pip install .` without a network; what it installs needs neither the source nor the build."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

PROGRAM = """
import sys, gestalt
assert gestalt.__file__.startswith(sys.argv[1]), gestalt.__file__
assert gestalt.data_directory().startswith(sys.argv[1]), gestalt.data_directory()
loaded = [line.split()[-1] for line in open("/proc/self/maps") if "gestalt" in line and ".so" in line]
assert loaded and all(file.startswith(sys.argv[1]) for file in loaded), loaded
print(len(gestalt.Segmenter().segment(sys.argv[2]).objects))
"""


class InstallTest(unittest.TestCase):
    def test_a_clean_clone_builds_all_that_is_installed(self):
        source = os.environ["GESTALT_SOURCE"]
        sys.path.insert(0, os.path.join(source, "python"))
        import build_backend  # noqa: PLC0415

        with tempfile.TemporaryDirectory() as work:
            build = pathlib.Path(os.path.realpath(work), "build")
            build_backend.configure(build)
            commands = subprocess.run(["ninja", "-C", build, "-t", "commands", *build_backend.TARGETS], check=True, text=True,
                                      stdout=subprocess.PIPE).stdout
            installed = set()
            for script in build.rglob("cmake_install.cmake"):
                for block in re.split(r"^if\(", script.read_text(), flags=re.MULTILINE):
                    component = re.search(r'CMAKE_INSTALL_COMPONENT STREQUAL "(\w+)"', block)
                    if component and component[1] in build_backend.COMPONENTS:
                        installed |= set(re.findall(rf'"({re.escape(str(build))}/[^"]+\.(?:so|json)[^"]*|{build}/bin/[^"]+)"', block))
            plugins = [file for file in installed if "/plugins/" in file]
            self.assertGreater(len(plugins), 25, installed)
            self.assertIn(str(build / "bin" / "gestalt"), installed)
            names = {str(pathlib.Path(file).relative_to(build)) for file in installed}
            self.assertEqual({name for name in names if name not in commands}, set())

    def test_the_metadata_needs_no_build(self):
        sys.path.insert(0, os.path.join(os.environ["GESTALT_SOURCE"], "python"))
        import build_backend  # noqa: PLC0415

        with tempfile.TemporaryDirectory() as work, mock.patch.dict(os.environ, {"PATH": work}):
            information = build_backend.prepare_metadata_for_build_wheel(work)
            metadata = pathlib.Path(work, information, "METADATA").read_text()
        self.assertIn("Name: gestalt\n", metadata)
        self.assertIn("Requires-Python: >=3.10\n", metadata)
        self.assertIn("Requires-Dist: numpy\n", metadata)
        self.assertRegex(metadata, r"Version: \d+\.\d+\.\d+\n")

    def test_a_failed_configuration_names_the_remedy(self):
        sys.path.insert(0, os.path.join(os.environ["GESTALT_SOURCE"], "python"))
        import build_backend  # noqa: PLC0415

        with tempfile.TemporaryDirectory() as work, mock.patch.dict(os.environ, {"PATH": work}):
            with self.assertRaisesRegex(SystemExit, "scripts/install_dependencies --python"):
                build_backend.configure(pathlib.Path(work, "build"))

    def test_pip_installs_it(self):
        clean = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "GESTALT_PLUGIN_PATH")}
        source = os.environ["GESTALT_SOURCE"]
        with tempfile.TemporaryDirectory() as work:
            venv = pathlib.Path(os.path.realpath(work), "venv")

            def run(*words):
                done = subprocess.run([str(word) for word in words], env=clean, cwd=work, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                self.assertEqual(done.returncode, 0, done.stdout)
                return done.stdout

            run(sys.executable, "-m", "venv", "--system-site-packages", venv)
            run(venv / "bin" / "pip", "install", "--no-index", source)
            objects = run(venv / "bin" / "python", "-c", PROGRAM, venv, pathlib.Path(source, "examples", "demo_scene"))
            self.assertGreater(int(objects), 10)
            run(venv / "bin" / "pip", "uninstall", "--yes", "gestalt")


if __name__ == "__main__":
    unittest.main()
