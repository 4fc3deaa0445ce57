# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes for the tests."""

import os
import pathlib
import subprocess

demo = pathlib.Path(os.environ["GESTALT_SOURCE"], "examples", "demo_scene")


def run(*command):
    """What a command of gestalt prints."""
    words = [os.environ["GESTALT_COMMAND"], *map(str, command)]
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout


def synthesize(folder, count):
    """A folder of labelled scenes."""
    run("synthesize", "--category", "complex_scene", "--seed", 5, "--count", count, "--output", folder)
    return folder
