# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs of the command, what counts as a fault of one, and whether its results are whole."""

import collections
import functools
import json
import pathlib
import re
import signal
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
PATIENCE = 300  # seconds, after which a run hangs
CRASHES = {-signal.SIGSEGV, -signal.SIGABRT, -signal.SIGBUS, -signal.SIGFPE, -signal.SIGILL}
FAULTS = ("crashes", "hangs", "wrong exit codes", "lost or half-written")


def command(build="build"):
    return ROOT / build / "bin" / "gestalt"


class Tally:
    """What was tried, how often, and what came out; other figures as they come."""

    def __init__(self, what):
        self.what = what
        self.tried = 0
        self.faults = collections.Counter()
        self.notes = []
        self.figures = {}

    def fault(self, kind, note):
        assert kind in FAULTS
        self.faults[kind] += 1
        self.notes.append(f"{kind}: {note}"[:2000])

    def judge(self, code, error, expected):
        """The exit code of a run; None: it had to be ended."""
        self.tried += 1
        if code is None:
            self.fault("hangs", error)
        elif code in CRASHES or "Sanitizer" in error:
            self.fault("crashes", f"{code}: {error}")
        elif code not in expected:
            self.fault("wrong exit codes", f"{code}: {error}")

    def report(self):
        return {"what": self.what, "tried": self.tried, **{kind: self.faults[kind] for kind in FAULTS},
                "figures": self.figures, "notes": self.notes}


def start(arguments, **options):
    return subprocess.Popen([str(word) for word in arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                            text=True, errors="replace", **options)


def finish(process):
    """Exit code, None of one that hangs, and what it said."""
    try:
        error = process.communicate(timeout=PATIENCE)[1]
        return process.returncode, error
    except subprocess.TimeoutExpired:
        process.kill()
        return None, process.communicate()[1]


def run(arguments, **options):
    return finish(start(arguments, **options))


def synthesize(folder, count, width, height, category="mixed_objects"):
    code, error = run([command(), "synthesize", "--category", category, "--seed", 5, "--count", count, "--width", width,
                       "--height", height, "--output", folder])
    if code != 0:
        raise SystemExit(f"scenes cannot be made: {error}")
    return sorted(path for path in folder.iterdir() if path.is_dir())


def content(file):
    """Of a result, what does not depend on a run's speed."""
    if file.name != "result.json":
        return file.read_bytes()
    text = file.read_text()
    json.loads(text)  # whole
    return re.sub(r'"milliseconds": \{[^}]*\}', "", text)


def tree(folder):
    """Content of every file by its path; of a damaged result.json its bytes."""
    files = {}
    for file in folder.rglob("*"):
        if file.is_file():
            try:
                files[str(file.relative_to(folder))] = content(file)
            except ValueError:
                files[str(file.relative_to(folder))] = file.read_bytes()
    return files


@functools.cache
def whole_tree(folder):
    """Of what does not change any more."""
    return tree(folder)


def check_whole(tally, out, reference):
    """Every result that has its result.json is that of the undisturbed run."""
    for result in out.rglob("result.json"):
        found, wanted = tree(result.parent), whole_tree(reference / result.parent.name)
        for name, data in wanted.items():
            if name not in found:
                tally.fault("lost or half-written", f"{result.parent.name}/{name} is missing beside its result.json")
            elif found[name] != data:
                tally.fault("lost or half-written", f"{result.parent.name}/{name} is another than that of the undisturbed run")


def check_same(tally, out, reference):
    """Every file is there once, and nothing else."""
    found, wanted = tree(out), whole_tree(reference)
    for path in sorted(found.keys() | wanted.keys()):
        if found.get(path) != wanted.get(path):
            why = "is missing" if path not in found else "is left over" if path not in wanted else "differs"
            tally.fault("lost or half-written", f"{path} {why}")
