# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""recordings_test.py GESTALT: recordings of ROS that other programs wrote, as `gestalt convert` and `info` read them; whole and broken."""

import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy

HERE = pathlib.Path(__file__).resolve().parent
GESTALT = sys.argv.pop(1)
FILES = ("bz2.bag", "lz4.bag", "compressed.bag", "zstd.mcap", "rosbag2.db3")


def gestalt(*words):
    return subprocess.run([GESTALT, *map(str, words)], capture_output=True, text=True, timeout=60)


class RecordingsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "out"

    def convert(self, file, *more, code=0):
        done = gestalt("convert", file, "--output", self.out, *more)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def scenes(self):
        return sorted((self.out / "scenes").iterdir()) if self.out.exists() else []

    def assert_frames(self):
        scenes = self.scenes()
        self.assertEqual(len(scenes), 2)
        for number, scene in enumerate(scenes):
            for image in ("depth", "rgb"):
                numpy.testing.assert_array_equal(
                    cv2.imread(str(scene / f"{image}.png"), cv2.IMREAD_UNCHANGED),
                    cv2.imread(str(HERE / f"{image}_{number}.png"), cv2.IMREAD_UNCHANGED),
                )
            self.assertIn("fx: 49.21875\n", (scene / "camera.yaml").read_text())

    def test_each_gives_the_images_that_went_in(self):
        for file in FILES:
            with self.subTest(file=file):
                told = self.convert(HERE / file)
                self.assertIn("note: ", told)
                self.assertNotIn("warning", told)
                self.assert_frames()
                shutil.rmtree(self.out)

    def test_info_lists_the_topics(self):
        for file in FILES:
            told = gestalt("info", HERE / file)
            self.assertEqual(told.returncode, 0, told.stderr)
            self.assertIn("kind: recording of ROS", told.stdout)
            self.assertRegex(told.stdout, r"/camera/\S+: sensor_msgs/(Compressed)?Image, 2 messages")

    def test_a_folder_of_rosbag2_is_its_recording(self):
        bag = self.folder / "bag"
        bag.mkdir()
        (bag / "metadata.yaml").write_text("rosbag2_bagfile_information: {}\n")
        shutil.copy(HERE / "rosbag2.db3", bag / "bag_0.db3")
        self.convert(bag)
        self.assert_frames()
        shutil.copy(HERE / "rosbag2.db3", bag / "bag_1.db3")
        self.assertIn("has 2 recordings; give one of them", self.convert(bag, code=3))

    def test_other_commands_say_how_to_make_scenes(self):
        for words in (("segment", "--output", self.out), ("stream", "--output", self.out), ("evaluate",)):
            told = gestalt(words[0], HERE / "lz4.bag", *words[1:])
            self.assertEqual(told.returncode, 3)
            self.assertIn(f"is a recording of ROS; make scenes of it with `gestalt convert {HERE / 'lz4.bag'} --output DIR`", told.stderr)

    def test_topics_can_be_chosen(self):
        told = self.convert(HERE / "bz2.bag", "--depth-topic", "/nowhere", code=3)
        self.assertIn("--depth-topic /nowhere: is not a topic of images here; topics: /camera", told)
        self.convert(HERE / "bz2.bag", "--depth-topic", "/camera/depth_registered/image_raw", "--rgb-topic", "/camera/rgb/image_raw")
        self.assert_frames()
        told = gestalt("convert", HERE, "--from", "tum", "--rgb-topic", "/x", "--output", self.out).stderr
        self.assertIn("are of recordings of ROS", told)

    def test_what_was_read_before_a_recording_breaks_off_is_kept(self):
        for file in FILES[:4]:
            with self.subTest(file=file):
                whole = (HERE / file).read_bytes()
                cut = self.folder / file
                for share, frames in ((0.5, 1), (0.8, 1 if file.endswith("mcap") else 2)):
                    cut.write_bytes(whole[: int(share * len(whole))])
                    self.assertIn("warning: " + str(cut) + ": breaks off", self.convert(cut))
                    self.assertEqual(len(self.scenes()), frames)
                    shutil.rmtree(self.out)

    def test_a_chunk_that_differs_from_its_checksum_is_refused(self):
        damaged = bytearray((HERE / "zstd.mcap").read_bytes())
        damaged[6393] = 0
        file = self.folder / "damaged.mcap"
        file.write_bytes(damaged)
        self.assertIn("checksum", self.convert(file, code=3))
        self.assertFalse(self.out.exists())

    def test_a_database_that_is_none_of_rosbag2_is_refused(self):
        for schema, why in (
            ("CREATE TABLE other(id)", "has no table 'topics'"),
            ("CREATE VIEW messages AS SELECT 1 AS id; CREATE TABLE topics(id, name, type, serialization_format)", "has no table 'messages'"),
            ("CREATE TABLE topics(id); CREATE TABLE messages(id)", "the database cannot be read"),
        ):
            file = self.folder / "other.db3"
            file.unlink(missing_ok=True)
            database = sqlite3.connect(file)
            database.executescript(schema)
            database.close()
            self.assertIn(why, self.convert(file, code=3))
        file.write_bytes((HERE / "rosbag2.db3").read_bytes()[:9000])
        self.convert(file, code=3)


if __name__ == "__main__":
    unittest.main()
