# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes that are read as their files alone do not tell, warned of, refused, or without colour."""

import json
import pathlib
import shutil
import tempfile
import unittest
import warnings

import cv2
import gestalt
import numpy
from scenes import demo, run, synthesize


class Reading(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        cls.scenes = synthesize(pathlib.Path(cls.work.name, "scenes"), 2)

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def copy(self, name):
        """The scenes, to be changed."""
        copy = pathlib.Path(self.work.name, name)
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(self.scenes, copy)
        return copy

    def without_colour(self, name, count):
        copy = self.copy(name)
        for file in sorted(copy.glob("*/rgb.png"))[:count]:
            file.unlink()
        return copy

    def quiet(self):
        """A context in which a warning is an error."""
        context = warnings.catch_warnings()
        context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)
        warnings.simplefilter("error")


class WithoutColour(Reading):
    def test_a_frame_is_segmented_by_depth_alone(self):
        scene = gestalt.read_scene(demo)
        expected = gestalt.Segmenter("depth_only.yaml")(None, scene.depth, scene.camera)
        segmenter = gestalt.Segmenter()
        with self.assertWarnsRegex(UserWarning, "frame: has no colour image; segmented by depth alone"):
            result = segmenter(None, scene.depth, scene.camera)
        numpy.testing.assert_array_equal(result.labels, expected.labels)
        self.assertEqual(result.to_dict()["config"]["values"], expected.to_dict()["config"]["values"])
        self.assertIn("depth alone", " ".join(result.to_dict()["notes"]))
        bare = min(self.without_colour("one", 1).glob("*/"))
        with self.assertWarnsRegex(UserWarning, "depth alone"):
            segmenter.segment(bare)
        self.quiet()
        self.assertNotIn("depth alone", str(segmenter(scene.colour, scene.depth, scene.camera).to_dict()["notes"]))
        gestalt.Segmenter("depth_only.yaml").segment(bare)

    def test_who_asks_for_a_config_gets_it(self):
        scene = gestalt.read_scene(demo)
        for config, overrides in (("default.yaml", []), (None, ["model=default.json"])):
            with self.assertRaisesRegex(gestalt.InputError, "has no colour image, and relation"):
                gestalt.Segmenter(config, overrides)(None, scene.depth, scene.camera)

    def test_scenes_are_scored_and_learnt_from_by_depth_alone(self):
        bare = self.without_colour("bare", 2)
        with self.assertWarnsRegex(UserWarning, "no scene has a colour image; scored by depth alone"):
            scores = gestalt.Segmenter().evaluate(bare)
        told = json.loads(run("evaluate", bare, "--config", "depth_only.yaml", "--json"))
        self.assertAlmostEqual(scores["all"]["P"], told["all"]["P"])
        model = pathlib.Path(self.work.name, "bare.json")
        with self.assertWarnsRegex(UserWarning, "no scene has a colour image; depth alone is used"):
            gestalt.train(bare, model)
        with self.assertWarnsRegex(UserWarning, "no scene has a colour image"):
            gestalt.cross_validate(bare, folds=2)
        self.quiet()
        gestalt.Segmenter("depth_only.yaml", [f"model={model}"]).evaluate(bare)

    def test_scenes_with_and_without_are_never_scored_by_two_configs(self):
        mixed = self.without_colour("mixed", 1)
        for call in (
            lambda: gestalt.Segmenter().evaluate(mixed),
            lambda: gestalt.train(mixed, "no_model.json"),
            lambda: gestalt.cross_validate(mixed, folds=2),
        ):
            with self.assertRaisesRegex(gestalt.InputError, r'other scenes of the set.*config="depth_only\.yaml"'):
                call()
        gestalt.Segmenter(config="depth_only.yaml").evaluate(mixed)


class Told(Reading):
    def test_depth_can_be_the_distance(self):
        scene, camera = gestalt.read_scene(demo), gestalt.read_scene(demo).camera
        v, u = numpy.indices(scene.depth.shape)
        rays = numpy.sqrt(((u - camera.cx) / camera.fx) ** 2 + ((v - camera.cy) / camera.fy) ** 2 + 1)
        distance = scene.depth * rays
        segmenter = gestalt.Segmenter()
        result = segmenter(scene.colour, distance, camera, depth_kind="radial")
        numpy.testing.assert_allclose(result.points[..., 2], scene.depth, atol=1e-5)
        with self.assertRaisesRegex(gestalt.InputError, "depth_kind: 'polar' is not one of plain, radial, rotated"):
            segmenter(scene.colour, distance, camera, depth_kind="polar")
        with self.assertRaisesRegex(gestalt.InputError, "labels: 'coco' is not one of osd, objects, colours"):
            gestalt.read_scene(demo, labels="coco")
        self.assertLess(gestalt.read_scene(demo, depth_kind="radial").depth.max(), scene.depth.max())

    def test_labels_count_what_is_told(self):
        objects = self.copy("objects")
        for file in objects.glob("*/label.png"):
            labels = cv2.imread(str(file), cv2.IMREAD_UNCHANGED)
            cv2.imwrite(str(file), numpy.where(labels < 20, labels > 0, labels // 10).astype(numpy.uint8))
        segmenter, model = gestalt.Segmenter(), pathlib.Path(self.work.name, "model.json")
        for call in (
            segmenter.evaluate,
            lambda scenes, **told: gestalt.train(scenes, model, **told),
            lambda scenes, **told: gestalt.cross_validate(scenes, folds=2, **told),
        ):
            with self.assertRaisesRegex(gestalt.InputError, "no scene has an object.*labels=\"objects\""):
                call(objects, labels="osd")
            call(objects, labels="objects")
        self.assertEqual(segmenter.evaluate(objects, labels="objects")["all"]["images"], 2)
        scene = next(objects.glob("*/"))
        self.assertGreater(gestalt.read_scene(scene, labels="objects").labels.max(), 20)
        segmenter.segment(scene, labels="objects")

    def test_what_is_probably_wrong_is_warned_of(self):
        fine = self.copy("fine")
        for file in fine.glob("*/depth.png"):
            cv2.imwrite(str(file), cv2.imread(str(file), cv2.IMREAD_UNCHANGED) * numpy.uint16(10))
        for call in (
            lambda: gestalt.Segmenter().evaluate(fine),
            lambda: gestalt.train(fine, pathlib.Path(self.work.name, "model.json")),
            lambda: gestalt.cross_validate(fine, folds=2),
        ):
            with self.assertWarnsRegex(UserWarning, "--unit 0.1mm.*in Python: depth_scale="):
                try:
                    call()
                except gestalt.ModelError:
                    pass  # depth of tenfold size may have no pairs


if __name__ == "__main__":
    unittest.main()
