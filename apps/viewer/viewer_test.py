# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""gestalt-view and `segment --view` on a display in memory, and where there is none.

viewer_test.py GESTALT SCENE
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy

GESTALT, SCENE = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1))
VIEWER = GESTALT.with_name("gestalt-view")
DISPLAY = ["xvfb-run", "--auto-servernum", "--server-args=-screen 0 1400x1000x24"]


def run(*command, display=None):
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    if display:
        environment["DISPLAY"] = display
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, env=environment, timeout=300)


def share_of(picture, colour):
    """Of the pixels that have nearly this colour (blue green red)."""
    return (numpy.abs(picture.astype(int) - colour).max(axis=2) <= 30).mean()


class Viewer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name)
        done = run(GESTALT, "segment", SCENE, "--output", cls.out, "--also", "pcd")
        assert done.returncode == 0, done.stderr
        cls.result = cls.out / SCENE.name

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def picture(self):
        file = self.out / "picture.png"
        done = run(*DISPLAY, VIEWER, self.result, "--screenshot", file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return cv2.imread(str(file))

    def test_objects_are_seen_in_their_colours(self):
        """Those of overlay.png: the colour of the largest object there is the tint that gestalt gives its label."""
        labels = cv2.imread(str(self.result / "objects.png"), cv2.IMREAD_UNCHANGED)
        largest = numpy.bincount(labels[labels > 0]).argmax()
        mesh = self.out / "mesh.ply"
        self.assertEqual(run(GESTALT, "export", self.result / "result.json", "--output", mesh).returncode, 0)
        lines = mesh.read_text().splitlines()
        faces = [line.split() for line in lines if line.startswith("3 ")]
        header = lines.index("end_header") + 1
        vertex = next(int(face[1]) for face in faces if int(face[4]) == largest)
        red, green, blue = (int(value) for value in lines[header + vertex].split()[3:6])
        picture = self.picture()
        self.assertEqual(picture.shape, (960, 1280, 3))
        self.assertGreater(share_of(picture, (blue, green, red)), 0.005)

    def test_no_display_is_told_with_what_to_do_instead(self):
        for display in None, ":987":
            done = run(VIEWER, self.result, display=display)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn("gestalt inspect", done.stderr)

    def test_segment_says_so_before_it_begins(self):
        other = self.out / "nothing"
        done = run(GESTALT, "segment", SCENE, "--output", other, "--view")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("$DISPLAY is not set", done.stderr)
        self.assertFalse(other.exists())

    def test_segment_opens_a_window_that_keys_change_and_close(self):
        other = self.out / "viewed"
        script = """
          "$1" segment "$2" --output "$3" --also pcd --view &
          timeout 60 xdotool search --sync --onlyvisible --name "^gestalt: $(basename "$2")$" windowfocus --sync
          for key in m i Next Prior q; do sleep 0.5; xdotool key $key; done
          wait $!"""
        done = run(*DISPLAY, "bash", "-euc", script, "bash", GESTALT, SCENE, other)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((other / SCENE.name / "labelled.pcd").exists())

    def test_what_is_no_result_is_refused(self):
        for folder, words in (self.out / "absent", "result.json"), (self.strip("labelled.pcd"), "--also pcd"):
            done = run(*DISPLAY, VIEWER, folder)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn(words, done.stderr)

    def strip(self, name):
        """A copy of the result without one of its files."""
        folder = self.out / "stripped"
        folder.mkdir(exist_ok=True)
        for file in self.result.iterdir():
            if file.name != name:
                (folder / file.name).write_bytes(file.read_bytes())
        return folder


if __name__ == "__main__":
    unittest.main()
