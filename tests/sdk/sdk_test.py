# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""sdk_test.py TEST SOURCE BUILD INSTALLATION: one test of what others build with.

`install` installs the build tree and moves it to INSTALLATION; every other test uses only what is there."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

KINDS = ("clusterer", "fitter", "relation", "classifier", "solver")
EXAMPLES = ("coloured_regions", "quadric", "logistic_regression", "correlation_clustering")


def run(*command, exit_code=0):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != exit_code:
        sys.exit(f"{' '.join(map(str, command))}\nexit code {done.returncode}, expected {exit_code}:\n{done.stdout}")
    return done.stdout


def expect(part, text):
    if part not in text:
        sys.exit(f"expected '{part}' in:\n{text}")


class Sdk:
    def __init__(self, source, build, installation):
        self.source, self.build, self.installation = source, build, installation
        self.gestalt = installation / "bin" / "gestalt"

    def install(self):
        shutil.rmtree(self.installation, ignore_errors=True)
        elsewhere = self.installation.with_name("installed_here_first")
        shutil.rmtree(elsewhere, ignore_errors=True)
        run("cmake", "--install", self.build, "--prefix", elsewhere)
        elsewhere.rename(self.installation)
        version = run(self.gestalt, "--version")
        expect("gestalt", version)
        components = json.loads(run(self.gestalt, "plugins", "list", "--json"))["components"]
        strangers = [c for c in components if not c["library"].startswith(str(self.installation))]
        assert components and not strangers, strangers
        for file in (self.installation / "lib" / "cmake").rglob("*.cmake"):
            for root in (self.source, self.build):
                assert str(root) not in file.read_text(), f"{file} names {root}"

    def build_project(self, source, build, *options):
        run("cmake", "-S", source, "-B", build, f"-DCMAKE_PREFIX_PATH={self.installation}", *options)
        run("cmake", "--build", build)

    def new_plugin(self, kind, name, folder):
        expect(f"cmake -S {folder}", run(self.gestalt, "new-plugin", kind, name, folder))

    def plugin(self, kind):
        """What new-plugin writes builds, passes its tests, and does its part in the whole program."""
        with tempfile.TemporaryDirectory() as work:
            project = pathlib.Path(work) / "project"
            scenes = pathlib.Path(work) / "scenes"
            self.new_plugin(kind, f"own_{kind}", project)
            self.build_project(project, project / "build")
            expect("100% tests passed", run("ctest", "--test-dir", project / "build", "--output-on-failure"))
            config = ("--config", project / "config.yaml")
            expect(f"own_{kind}", run(self.gestalt, "plugins", "list", *config))
            run(self.gestalt, "synthesize", "--category", "complex_scene", "--seed", 3, "--count", 2, "--output", scenes)
            if kind != "solver":
                run(self.gestalt, "train", scenes, *config, "--output", project / f"own_{kind}.json")
            run(self.gestalt, "segment", scenes, *config, "--output", pathlib.Path(work) / "out")
            expect("P", run(self.gestalt, "evaluate", scenes, *config))

    def example(self, name):
        """An example builds where it is copied to, passes its tests, and is learned with and scored as its README says."""
        with tempfile.TemporaryDirectory() as work:
            project, scenes = pathlib.Path(work) / name, pathlib.Path(work) / "scenes"
            shutil.copytree(self.source / "examples" / name, project)
            self.build_project(project, project / "build")
            expect("100% tests passed", run("ctest", "--test-dir", project / "build", "--output-on-failure"))
            run(self.gestalt, "synthesize", "--category", "complex_scene", "--seed", 3, "--count", 4, "--output", scenes)
            config = ("--config", project / "config.yaml")
            expect(name, run(self.gestalt, "config", "print", project / "config.yaml"))
            # So few scenes have no pairs to learn the assembly level from.
            structural = ("--set", "levels=structural")
            expect("balanced error", run(self.gestalt, "evaluate", scenes, "--cross-validate", 2, "--all", *config,
                                           *structural))

    def own_program(self):
        with tempfile.TemporaryDirectory() as work:
            self.build_project(self.source / "examples" / "own_program", work)
            program = pathlib.Path(work) / "own_program"
            expect("object 2: ", run(program, self.source / "examples" / "demo_scene"))
            expect("no_such_scene", run(program, "no_such_scene", exit_code=1))

    def flags(self):
        """A plugin built with flags that change the layout of types is rejected before any of its code runs; one that
        is built for debugging works."""
        with tempfile.TemporaryDirectory() as work:
            project = pathlib.Path(work) / "project"
            self.new_plugin("solver", "own_solver", project)
            config = ("--config", project / "config.yaml")
            segment = (self.gestalt, "segment", self.source / "examples" / "demo_scene", *config, "--output",
                       pathlib.Path(work) / "out")
            no_tests = "-DBUILD_TESTING=OFF"
            self.build_project(project, project / "build", no_tests, "-DCMAKE_CXX_FLAGS=-mavx2")
            listed = run(self.gestalt, "plugins", "list", *config)
            expect("solver_own_solver.so: it was built as [", listed)
            expect("eigen_align=32", listed)
            expect("rebuild it with the core's compiler flags", run(*segment, exit_code=2))
            self.build_project(project, project / "build", no_tests, "-DCMAKE_CXX_FLAGS=", "-DCMAKE_BUILD_TYPE=Debug")
            run(*segment)


def main():
    test, *folders = sys.argv[1:]
    sdk = Sdk(*(pathlib.Path(folder).resolve() for folder in folders))
    if test in KINDS:
        sdk.plugin(test)
    elif test in EXAMPLES:
        sdk.example(test)
    else:
        getattr(sdk, test)()


main()
