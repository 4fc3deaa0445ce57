# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Odd arguments for every public function: an error of Python's or of ours, never a crash, never another one.

What is tried follows from a seed (GESTALT_SEED, GESTALT_ARGUMENT_ROUNDS); a call that breaks the process is the last one in the
file that the message names.
"""

import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy

import gestalt
from scenes import demo

SEED = int(os.environ.get("GESTALT_SEED", 1))
ROUNDS = int(os.environ.get("GESTALT_ARGUMENT_ROUNDS", 300))
EXPECTED = (TypeError, ValueError, OSError, gestalt.Error, NotImplementedError)  # the last is of a memoryview in two dimensions
DTYPES = ("uint8", "uint16", "int32", "int64", "uint64", "float16", "float32", "float64", "bool", "complex64", "U3", "O", "M8[s]")
SHAPES = ((), (0,), (3,), (0, 0), (0, 0, 3), (1, 1), (1, 1, 3), (4, 5), (4, 5, 3), (4, 5, 4), (48, 64), (48, 64, 3),
          (1, 70000), (2, 3, 4, 5))


class Odd(Exception):
    """What an argument's own code raises; it must come out as it is."""


class Raising:
    def __fspath__(self):
        raise Odd("path")

    def __array__(self, *_):
        raise Odd("array")

    def __iter__(self):
        raise Odd("iter")

    def __float__(self):
        raise Odd("float")

    def __index__(self):
        raise Odd("index")


class Generator:
    """Arguments that follow from a seed."""

    def __init__(self, seed, work):
        self.random, self.numbers, self.work = random.Random(seed), numpy.random.default_rng(seed), work
        (work / "scene").symlink_to(demo)
        (work / "empty").write_bytes(b"")
        (work / "binary").write_bytes(self.numbers.bytes(5000))
        (work / "folder").mkdir()
        os.mkfifo(work / "pipe")

    def number(self):
        return self.random.choice(
            (0, 1, -1, 7, 2**31, -(2**31) - 1, 2**63, 2**64, 10**30, 0.0, 0.5, -0.0, 1e-320, 1e308, float("nan"), float("inf"),
             -float("inf"), True, numpy.float32(2), numpy.int8(-3), 1j)
        )

    def text(self):
        return self.random.choice(
            ("", "a", "default.yaml", "model=", "=", "a.b.c=1", "levels=structural", "time_budget=-1", "\0", "a\0b", "é\n\x1b[31m", "\ud800",
             "\udce9", "x" * 5000, "[" * 300, "{a: [1", "../..", "category", "set", "structural.relations.gabor=off")
        )

    def path(self):
        name = self.random.choice(("scene", "empty", "binary", "folder", "pipe", "none", "none/none", ".", "", "a\0b", "\udce9", "n" * 300))
        path = f"{self.work}/{name}"
        return self.random.choice((str, pathlib.Path, os.fsencode, lambda p: [p], lambda p: (p, p)))(path)

    def array(self):
        shape, dtype = self.random.choice(SHAPES), self.random.choice(DTYPES)
        array = numpy.asarray(self.numbers.random(shape) * self.random.choice((0, 1, 3, 300, 70000)))
        if self.random.random() < 0.2 and array.size:
            array.flat[0] = self.random.choice((float("nan"), float("inf"), -1, 1e300))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            array = array.astype(dtype)
        return self.random.choice((
            lambda a: a, lambda a: a.T, lambda a: a[::-1] if a.ndim else a, lambda a: a.tolist(), lambda a: a.astype(a.dtype.newbyteorder()),
            numpy.ma.masked_array, numpy.asfortranarray, lambda a: numpy.broadcast_to(a[:1] if a.ndim else a, a.shape),
            lambda a: memoryview(a) if a.dtype.kind in "uif" else a,
        ))(array)

    def camera(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                return gestalt.Camera(*(self.random.choice((self.number(), 64, 48, 60.0)) for _ in range(6)))
            except EXPECTED:
                return gestalt.Camera(64, 48, 60, 60, 31.5, 23.5)

    def component(self):
        class Own(self.random.choice((gestalt.Relation, gestalt.Classifier, gestalt.Solver, object))):
            values = self.random.choice(((), (gestalt.Value("r_own", 0, 1),), (gestalt.Value("", 1, 0),), None, "ab", [self.number()]))
            parameters = self.random.choice(({}, {"p": gestalt.Parameter(1)}, {"p": self.number()}, None, {1: 2}))
            description = classmethod(lambda cls: self.random.choice(("text", None, 3)))

            def bind(own, scene):
                return self.anything()

            def train(own, values, positive):
                return self.anything()

            def restore(own, state, columns):
                return lambda values: self.anything()

            def solve(own, sizes, pairs, probabilities, assembly):
                return self.random.choice((lambda: self.anything(), lambda: list(sizes)))()

        return {self.random.choice(("own", "", "gabor", "a.b")): self.random.choice((Own, Own, Own(), None))} if Own.__mro__[1] is not object else {
            "own": Own
        }

    def anything(self):
        return self.random.choice((
            lambda: None, self.number, self.text, self.path, self.array, self.camera, Raising, object, dict, list, lambda: {"a": 1}, lambda: [1, "a"],
            lambda: len, lambda: b"bytes", lambda: slice(1), lambda: iter([1]), lambda: [None], lambda: Ellipsis,
        ))()

    def likely(self, make, share=0.7):
        """Mostly what the parameter is for, so that what lies behind its check is reached."""
        return make() if self.random.random() < share else self.anything()


def calls(g):
    """A call of each function: its name, and a function that makes it."""
    good = gestalt.Segmenter(threads=1)
    result = good.segment(demo)
    scale = lambda: g.random.choice((None, 0.001, g.number()))
    overrides = lambda: [g.text() for _ in range(g.random.randint(0, 2))]

    def images():
        shape = g.random.choice(((48, 64), (4, 5), (1, 1), (1, 300)))
        depth = (g.numbers.random(shape) * g.random.choice((0, 1, 4, 3000))).astype(g.random.choice(("float32", "uint16", "float64")))
        camera = g.random.choice((gestalt.Camera(shape[1], shape[0], 60, 60, shape[1] / 2, shape[0] / 2), g.camera()))
        return (g.numbers.random((*shape, 3)) * 255).astype("uint8"), depth, camera

    def frame():
        colour, depth, camera = images()
        return good(g.likely(lambda: colour), g.likely(lambda: depth), g.likely(lambda: camera), g.likely(g.text), depth_scale=scale())

    def component():
        components = g.likely(g.component)
        name = next(iter(components)) if isinstance(components, dict) and components else "own"
        chosen = g.random.choice((f"decision.solver={name}", f"structural.classifier={name}", f"structural.relations.{name}=on"))
        return gestalt.Segmenter(overrides=[chosen], components=components, threads=1).segment(demo)

    def view():
        got = []

        class Sees(gestalt.Relation):
            values = (gestalt.Value("r_own", 0, 1),)

            def bind(self, scene):
                for ask in (lambda: scene.border(g.likely(g.number), g.likely(g.number), g.anything()), lambda: scene.surface(g.likely(g.number))):
                    try:
                        ask()
                    except (IndexError, *EXPECTED, Odd) as error:
                        got.append(error)
                return lambda pairs: g.anything()

        gestalt.train(demo, g.work / "model.json", overrides=["structural.relations.own=on", "levels=structural"], components={"own": Sees}, threads=1)

    return {
        "Camera": lambda: gestalt.Camera(*(g.likely(g.number) for _ in range(g.random.randint(4, 7)))),
        "Segmenter": lambda: gestalt.Segmenter(g.likely(lambda: g.random.choice((g.path(), g.text()))), g.likely(overrides),
                                               components=g.likely(lambda: None), threads=g.likely(lambda: g.random.choice((1, g.number())))),
        "Segmenter.__call__": frame,
        "Segmenter.segment": lambda: good.segment(g.likely(g.path), g.random.choice((None, g.camera(), g.anything())), depth_scale=scale()),
        "Segmenter.evaluate": lambda: good.evaluate(g.likely(g.path), depth_scale=scale()),
        "Result.save": lambda: result.save(g.likely(lambda: g.work / "out"), g.likely(g.text)),
        "read_scene": lambda: gestalt.read_scene(g.likely(g.path), g.random.choice((None, g.camera(), g.anything())), depth_scale=scale()),
        "train": lambda: gestalt.train(g.likely(g.path), g.likely(lambda: g.work / "model.json"), None, g.likely(overrides), depth_scale=scale()),
        "cross_validate": lambda: gestalt.cross_validate(g.likely(g.path), g.likely(g.number), g.likely(g.number), None, g.likely(overrides),
                                                         leave_one_out=g.likely(g.text), also_train=g.likely(g.path), threads=1),
        "score": lambda: gestalt.score(g.likely(g.array), g.likely(g.array)),
        "Parameter": lambda: gestalt.Parameter(*(g.anything() for _ in range(g.random.randint(1, 4)))),
        "Value": lambda: gestalt.Value(*(g.anything() for _ in range(g.random.randint(2, 4)))),
        "register": lambda: gestalt.register(g.anything())(g.anything()),
        "component": component,
        "SceneView": view,
    }


def run(seed, rounds, log):
    """Tries it, and gives what came out that should not."""
    wrong = []
    with tempfile.TemporaryDirectory() as folder, open(log, "w", buffering=1) as report:
        warnings.simplefilter("ignore")
        os.chdir(folder)  # relative names are written to
        g = Generator(seed, pathlib.Path(folder))
        known = calls(g)
        for number in range(rounds):
            name = g.random.choice(sorted(known))
            print(f"round {number}: {name}", file=report)
            try:
                known[name]()
            except (*EXPECTED, Odd):
                pass
            except BaseException as error:  # anything else is a find
                wrong.append(f"round {number}: {name}: {error!r}")
                print(wrong[-1], file=report)
    return wrong


class ArgumentsTest(unittest.TestCase):
    def test_odd_arguments_are_refused_or_taken(self):
        """In a process of its own, which must not crash, hang, or run out of memory."""
        with tempfile.TemporaryDirectory() as work:
            log = os.path.join(work, "log")
            program = "import resource, sys; resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30)); "
            program += f"import arguments_test; print(*arguments_test.run({SEED}, {ROUNDS}, {log!r}), sep='\\n')"
            done = subprocess.run([sys.executable, "-B", "-c", program], cwd=pathlib.Path(__file__).parent, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60 + 5 * ROUNDS, errors="replace")
            last = pathlib.Path(log).read_text(errors="replace").splitlines()[-1:] if os.path.exists(log) else []
        self.assertEqual((done.returncode, done.stdout.strip()), (0, ""), f"seed {SEED}, last {last}: {done.stderr[-3000:]}")


if __name__ == "__main__":
    unittest.main()
