# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""The objects of a result in Python: that their parts fit each other and result.json."""

import inspect
import json
import os
import pathlib
import pickle
import tempfile
import unittest

import gestalt
import numpy

DEMO = pathlib.Path(os.environ["GESTALT_SOURCE"], "examples", "demo_scene")


class ObjectsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = gestalt.Segmenter().segment(DEMO)

    def test_there_is_one_for_each_segment_that_is_an_object(self):
        labels = [segment["label"] for segment in self.result.segments if segment["role"] == "object"]
        self.assertEqual([thing.label for thing in self.result.objects], labels)
        for thing, segment in zip(self.result.objects, (s for s in self.result.segments if s["role"] == "object")):
            self.assertEqual((thing.pixels, thing.patches), (segment["pixels"], segment["patches"]))

    def test_masks_boxes_and_points_are_of_one_thing(self):
        for thing in self.result.objects:
            numpy.testing.assert_array_equal(thing.mask, self.result.labels == thing.label)
            rows, columns = numpy.nonzero(thing.mask)
            x, y, width, height = thing.box
            self.assertEqual((x, y, width, height), (columns.min(), rows.min(), numpy.ptp(columns) + 1, numpy.ptp(rows) + 1))
            self.assertEqual(len(thing.points), thing.pixels)
            self.assertEqual(thing.normals.shape, thing.points.shape)
            numpy.testing.assert_allclose(thing.points.mean(axis=0), thing.centroid, atol=2e-5)

    def test_run_lengths_are_the_mask(self):
        for thing in self.result.objects:
            mask = thing.content["mask"]
            runs = numpy.repeat(numpy.arange(len(mask["counts"])) % 2, mask["counts"])
            numpy.testing.assert_array_equal(runs.reshape(mask["size"][::-1]).T.astype(bool), thing.mask)

    def test_most_points_are_in_the_oriented_box(self):
        for thing in self.result.objects:
            numpy.testing.assert_allclose(thing.obb.axes @ thing.obb.axes.T, numpy.eye(3), atol=1e-4)
            inside = numpy.abs((thing.points - thing.obb.centre) @ thing.obb.axes.T) <= thing.obb.size / 2 + 1e-4
            self.assertGreater(inside.all(axis=1).mean(), 0.95)
            self.assertEqual(thing.obb.corners.shape, (8, 3))
            self.assertGreaterEqual(thing.obb.size[0], thing.obb.size[1] - 1e-4)

    def test_supports_and_faces_are_planes_that_fit(self):
        self.assertTrue(any(thing.support for thing in self.result.objects))
        for thing in self.result.objects:
            if thing.support:
                heights = thing.points @ thing.support.normal - thing.support.offset
                self.assertAlmostEqual(numpy.quantile(heights, 0.5), (thing.support.bottom + thing.support.top) / 2, delta=0.2)
                self.assertLess(thing.support.bottom, thing.support.top + 1e-9)
            if thing.largest_face:
                self.assertIn(thing.largest_face.patch, thing.patches)
                self.assertGreater(thing.largest_face.area, 0)
                self.assertLess(thing.largest_face.normal @ thing.largest_face.centre, 0)

    def test_confidence_is_a_probability_and_doubts_are_of_the_object(self):
        for thing in self.result.objects:
            self.assertTrue(0 < thing.confidence < 1)
            for a, b, p in thing.doubtful_joins:
                self.assertTrue({a, b} <= set(thing.patches) and p < 0.6)
            for a, b, p in thing.doubtful_cuts:
                self.assertTrue(len({a, b} & set(thing.patches)) == 1 and p > 0.4)

    def test_colour_is_missing_without_a_colour_image(self):
        scene = gestalt.read_scene(DEMO)
        for thing in self.result.objects:
            expected = scene.colour[thing.mask].mean(axis=0)
            numpy.testing.assert_allclose(thing.colour.mean, expected, atol=0.06)
        alone = gestalt.Segmenter("depth_only")(None, scene.depth, scene.camera)
        self.assertTrue(alone.objects and all(thing.colour is None for thing in alone.objects))

    def test_objects_survive_a_pickle_of_their_own_and_of_the_result(self):
        thing = self.result.objects[0]
        for same in (pickle.loads(pickle.dumps(thing)), pickle.loads(pickle.dumps(self.result)).objects[0]):
            self.assertEqual(repr(same), repr(thing))
            numpy.testing.assert_array_equal(same.points, thing.points)

    def test_result_json_has_the_same(self):
        with tempfile.TemporaryDirectory() as out:
            self.result.save(out)
            stored = json.loads(pathlib.Path(out, "result.json").read_text())
        self.assertEqual(stored["objects"], [thing.content for thing in self.result.objects])

    def test_the_text_and_the_signature_can_be_read(self):
        self.assertRegex(repr(self.result.objects[0]), r"^<gestalt.Object \d+: \w+, [\d.]+ x [\d.]+ x [\d.]+ cm, \d+ pixels, confidence 0\.\d\d>$")
        self.assertEqual(str(inspect.signature(gestalt.OrientedBox))[:7], "(centre")


if __name__ == "__main__":
    unittest.main()
