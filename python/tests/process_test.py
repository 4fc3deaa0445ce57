# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""The end of the interpreter, forks and Ctrl-C while frames are computed. Programs of their own, a few rounds of each;
GESTALT_ROUNDS says how many."""

import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

import gestalt
from components_test import OWN_RELATION, Size
from scenes import demo, synthesize

ROUNDS = int(os.environ.get("GESTALT_ROUNDS", 3))

BEGIN = """
import multiprocessing, os, random, signal, sys, threading, time
import numpy
import gestalt

scene, overrides = sys.argv[1], []
busy = threading.Event()


class Size(gestalt.Relation):
    values = (gestalt.Value("r_own", 0, 1),)
    parameters = {"power": gestalt.Parameter(1.0, 0.1, 10)}

    def bind(self, scene):
        sizes = scene.sizes

        def measure(pairs):
            return [float(min(sizes[a], sizes[b]) / max(sizes[a], sizes[b])) for a, b in pairs]

        return measure


class Apart(gestalt.Solver):
    def solve(self, sizes, pairs, probabilities, assembly):
        return self.react(range(len(sizes)))

    def react(self, groups):
        return list(groups)


def again_and_again(segmenter, images):
    while True:
        busy.set()
        segmenter(images.colour, images.depth, images.camera)


def begin(segmenter, threads=2):
    images = gestalt.read_scene(scene)
    for _ in range(threads):
        threading.Thread(target=again_and_again, args=(segmenter, images), daemon=True).start()
    busy.wait()
    time.sleep(random.uniform(0, 0.3))
"""


def program(text, *arguments, begin=""):
    """What the program ends with, prints, and says on stderr."""
    whole = textwrap.dedent(begin) + BEGIN + textwrap.dedent(text)
    words = [sys.executable, "-B", "-c", whole, str(demo), *map(str, arguments)]
    ended = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120)
    return ended.returncode, ended.stdout, ended.stderr


class ProcessTest(unittest.TestCase):
    def repeat(self, expected, text, *arguments):
        for number in range(ROUNDS):
            with self.subTest(round=number):
                self.assertEqual(program(text, *arguments), expected)

    def test_the_interpreter_ends_while_a_daemon_thread_computes(self):
        self.repeat((3, "", ""), "begin(gestalt.Segmenter()); sys.exit(3)")
        self.repeat((0, "", ""), "begin(gestalt.Segmenter(threads=1), 4)")

    def test_the_interpreter_ends_while_a_component_in_python_computes(self):
        self.repeat((3, "", ""), "begin(gestalt.Segmenter(overrides=['decision.solver=own'], components={'own': Apart})); sys.exit(3)")
        with tempfile.TemporaryDirectory() as work:
            model = pathlib.Path(work, "model.json")
            gestalt.train(
                synthesize(pathlib.Path(work, "scenes"), 2), model, overrides=OWN_RELATION, components={"own": Size}
            )
            self.repeat(
                (0, "", ""),
                f"begin(gestalt.Segmenter(overrides=[*{OWN_RELATION}, 'model={model}'], components={{'own': Size}}))",
            )

    def test_the_interpreter_ends_while_other_functions_compute(self):
        text = """
        segmenter = gestalt.Segmenter()
        def work(function):
            while True:
                busy.set()
                function()
        for function in (lambda: segmenter.segment(scene).to_dict(), lambda: gestalt.read_scene(scene),
                         lambda: segmenter.evaluate(scene)):
            threading.Thread(target=work, args=(function,), daemon=True).start()
        busy.wait()
        time.sleep(random.uniform(0, 0.5))
        """
        self.repeat((0, "", ""), text)

    def test_no_work_begins_when_the_interpreter_ends(self):
        begin = """
        import atexit
        def late():
            try:
                segmenter.segment(scene)
            except gestalt.Error as error:
                print(error)
        atexit.register(late)  # before gestalt's own: runs after it
        """
        text = """
        segmenter = gestalt.Segmenter()
        atexit.register(lambda: print(segmenter.segment(scene).name))
        """
        told = "the interpreter is shutting down and starts no new work"
        self.assertEqual(program(text, begin=begin), (0, f"{demo.name}\n{told}\n", ""))

    def test_a_fork_during_a_frame_raises_in_the_child(self):
        text = """
        segmenter = gestalt.Segmenter()
        begin(segmenter)
        child = os.fork()
        if child == 0:
            signal.alarm(20)
            for function in (lambda: segmenter.segment(scene), gestalt.Segmenter, lambda: gestalt.read_scene(scene)):
                try:
                    function()
                    sys.exit(4)
                except gestalt.Error as error:
                    if "spawn" not in str(error):
                        sys.exit(5)
            sys.exit(0)
        sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
        """
        self.repeat((0, "", ""), text)

    def test_a_fork_after_a_frame_raises_in_the_child(self):
        text = """
        segmenter = gestalt.Segmenter()
        result = segmenter.segment(scene)
        with multiprocessing.get_context("fork").Pool(2) as pool:
            try:
                pool.map(segmenter_of_all, [scene] * 4)
            except gestalt.Error as error:
                print("spawn" in str(error))
        """
        self.repeat((0, "True\n", ""), "def segmenter_of_all(path): return segmenter.segment(path).name\n" + textwrap.dedent(text))

    def test_a_fork_before_the_first_frame_works(self):
        text = """
        def name_of(path): return segmenter.segment(path).name
        segmenter = gestalt.Segmenter()
        images = gestalt.read_scene(scene)
        with multiprocessing.get_context("fork").Pool(2) as pool:
            print(pool.map(name_of, [scene] * 4))
        print(segmenter.segment(scene).name)
        """
        name = demo.name
        self.repeat((0, f"{[name] * 4}\n{name}\n", ""), text)

    def test_a_fork_between_frames_of_one_thread_works(self):
        text = """
        def name_of(path): return segmenter.segment(path).name
        segmenter = gestalt.Segmenter(threads=1)
        segmenter.segment(scene).to_dict()
        with multiprocessing.get_context("fork").Pool(2) as pool:
            print(pool.map(name_of, [scene] * 4))
        """
        self.repeat((0, f"{[demo.name] * 4}\n", ""), text)

    def test_other_ways_to_begin_a_process_work_at_any_time(self):
        """Of a main module that can be imported."""
        with tempfile.TemporaryDirectory() as work:
            file = pathlib.Path(work, "spawning.py")
            file.write_text(
                BEGIN
                + textwrap.dedent(
                    """
                    def name_of(path): return gestalt.Segmenter().segment(path).name
                    if __name__ == "__main__":
                        begin(gestalt.Segmenter(), 1)
                        for method in ("spawn", "forkserver"):
                            with multiprocessing.get_context(method).Pool(1) as pool:
                                print(pool.map(name_of, [scene]))
                    """
                )
            )
            ended = subprocess.run(
                [sys.executable, "-B", file, demo], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120
            )
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr), (0, 2 * f"{[demo.name]}\n", ""))

    def test_a_component_that_forks_may_not_return_in_the_child(self):
        text = """
        class Forking(Apart):
            def react(self, groups):
                child = os.fork()
                if child == 0 and sys.argv[2] == "exits":
                    sys.exit()
                if child == 0 and sys.argv[2] == "leaves":
                    os._exit(7)
                if child:
                    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
                return list(groups)

        print(gestalt.Segmenter(overrides=['decision.solver=own'], components={'own': Forking}).segment(scene).name)
        """
        for way in ("returns", "exits"):
            code, out, err = program(text, way)
            self.assertEqual((code, out), (0, f"1\n1\n{demo.name}\n"))  # for either level
            self.assertIn("os._exit()", err)
        self.assertEqual(program(text, "leaves"), (0, f"7\n7\n{demo.name}\n", ""))

    def test_a_keyboard_interrupt_stays_one(self):
        text = """
        signal.signal(signal.SIGINT, signal.default_int_handler)  # which a shell's background jobs are without

        class Interrupted(Apart):
            def react(self, groups):
                os.kill(os.getpid(), signal.SIGINT)
                time.sleep(10)
                return list(groups)

        segmenter = gestalt.Segmenter(overrides=['decision.solver=own'], components={'own': Interrupted}, threads=1)
        try:
            segmenter.segment(scene)
        except KeyboardInterrupt as interrupt:
            names = []
            trace = interrupt.__traceback__
            while trace:
                names.append(trace.tb_frame.f_code.co_name)
                trace = trace.tb_next
            print(names[-1])
        print(len(gestalt.Segmenter().segment(scene).objects) > 0)
        """
        self.repeat((0, "react\nTrue\n", ""), text)

    def test_an_exit_in_a_component_is_its_failure(self):
        text = """
        class Exiting(Apart):
            def react(self, groups):
                sys.exit(0)

        try:
            gestalt.Segmenter(overrides=['decision.solver=own'], components={'own': Exiting}).segment(scene)
        except gestalt.PluginError as error:
            print(error)
        """
        code, out, _ = program(text)
        self.assertEqual(code, 0)
        self.assertRegex(out, "solver 'own'.*SystemExit")


if __name__ == "__main__":
    unittest.main()
