# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""stream_latency_test.py GESTALT SCENE: whether the report accounts for every frame, not what it measured."""

import json
import pathlib
import subprocess
import sys
import tempfile

gestalt, scene = sys.argv[1:]
program = [sys.executable, pathlib.Path(__file__).with_name("stream_latency.py"), gestalt]

with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder) / "stream.json"
    subprocess.run([*program, scene, "--rate", "20", "--seconds", "0.5", "--json", file], check=True)
    report = json.loads(file.read_text())
    assert report["sent"] == 10 and report["segmented"] >= 1, report
    assert report["segmented"] + report["dropped"] == report["sent"], report
    latency = report["latency_milliseconds"]
    assert 0 < latency["median"] <= latency["p99"] <= latency["worst"], report
    assert all(megabytes > 0 for megabytes in report["megabytes"].values()), report

    empty = subprocess.run([*program, folder], stderr=subprocess.PIPE, text=True)
    assert empty.returncode == 2 and "no scene" in empty.stderr, empty
