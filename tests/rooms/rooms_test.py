# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""rooms_test.py SOURCE BUILD: a room finds the headers that it may include, and no others; a public header needs no other before it."""

import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys

SOURCE, BUILD = map(pathlib.Path, sys.argv[1:])

# A source of a room, and headers that it must not find.
FORBIDDEN = {
    "core/base/digest.cpp": ["core/scene/frame.h", "core/plugin/parameters.h"],
    "core/scene/scene.cpp": ["core/plugin/relation.h", "core/config/config.h", "io/scene/input.h"],
    "core/plugin/registry.cpp": ["core/config/config.h", "core/pipeline/pipeline.h"],
    "core/config/config.cpp": ["core/pipeline/pipeline.h", "io/result/result.h"],
    "core/pipeline/pipeline.cpp": ["core/objects/object_description.h", "io/scene/input.h", "evaluation/score/evaluation.h"],
    "core/objects/object_description.cpp": ["core/tracking/tracker.h", "io/scene/input.h"],
    "io/scene/input.cpp": ["io/dataset/tum_sequence.h", "io/result/result.h", "core/config/config_node.h"],
    "io/result/result.cpp": ["io/dataset/tum_sequence.h", "evaluation/score/evaluation.h", "core/pipeline/aside.h"],
    "evaluation/score/evaluation.cpp": ["evaluation/experiment/experiment.h", "evaluation/calibration/noise_calibration.h",
                                        "io/scene/npz_file.h"],
    "evaluation/experiment/experiment.cpp": ["inspector/inspection/inspection.h", "synthesis/synthesis.h"],
    "inspector/inspection/inspection.cpp": ["evaluation/experiment/experiment.h"],
    "synthesis/synthesis.cpp": ["evaluation/score/evaluation.h"],
    "relations/gabor/gabor.cpp": ["io/scene/input.h", "evaluation/score/evaluation.h", "core/scene/line_links.h"],
    "fitters/plane/plane.cpp": ["io/result/parametric_surface.h", "core/config/config_draft.h"],
}
PUBLIC_LIBRARIES = ("core", "io", "evaluation")


def flags_of_sources():
    """The compiler and its options for each source, without what names the source and its outputs."""
    flags = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        kept = [word for word in words if word.startswith(("-I", "-isystem", "-std", "/usr/include"))]
        file = pathlib.Path(entry["file"])
        if SOURCE in file.parents:
            flags[str(file.relative_to(SOURCE))] = kept
    return flags


def compiles(flags, header):
    done = subprocess.run(["c++", *flags, "-x", "c++", "-fsyntax-only", "-"], input=f'#include "{header}"\n', text=True,
                          capture_output=True)
    return done.returncode == 0, done.stderr


def main():
    flags = flags_of_sources()
    wrong = []
    for source, headers in FORBIDDEN.items():
        for header in headers:
            assert (SOURCE / header).exists(), f"{header} does not exist; bring this test up to date"
            found, words = compiles(flags[source], f"gestalt/{header}")
            if found or "No such file" not in words:
                wrong.append(f"{source} can include gestalt/{header}\n{words}")
    for source, options in flags.items():
        folders = [pathlib.Path(option[2:]).resolve() for option in options if option.startswith("-I")]
        if any(folder == SOURCE for folder in folders):
            wrong.append(f"{source} has the project's root among its include folders")

    public = {header: library for library in PUBLIC_LIBRARIES
              for header in (BUILD / "include" / f"gestalt_{library}").rglob("*.h")}
    assert len(public) > 40, public
    of_plugins = [option for option in flags["relations/gabor/gabor.cpp"] if not option.startswith("-I")]

    def alone(header):
        libraries = PUBLIC_LIBRARIES[: PUBLIC_LIBRARIES.index(public[header]) + 1]
        includes = [f"-I{BUILD / 'include' / f'gestalt_{library}'}" for library in libraries]
        good, words = compiles(of_plugins + includes, header)
        return "" if good else f"{header} does not compile alone\n{words}"

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong += filter(None, pool.map(alone, public))
    print("\n".join(wrong) or f"{sum(map(len, FORBIDDEN.values()))} wrong includes fail, {len(public)} headers compile alone")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
