# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""What users of Python expect of any package: short errors, readable texts, pickles."""

import ast
import inspect
import os
import pathlib
import pickle
import unittest

import gestalt
import numpy

DEMO = pathlib.Path(os.environ["GESTALT_SOURCE"], "examples", "demo_scene")
CAMERA = {"width": 640, "height": 480, "fx": 525, "fy": 525.0, "cx": 319.5, "cy": 239.5}


class HabitsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.segmenter = gestalt.Segmenter()
        cls.scene = gestalt.read_scene(DEMO)
        cls.result = cls.segmenter(cls.scene.colour, cls.scene.depth, cls.scene.camera, "demo")

    def test_texts_name_what_there_is(self):
        self.assertEqual(repr(self.segmenter), "<gestalt.Segmenter of 'default.yaml': levels structural+assembly, model 'default.json'>")
        objects, patches = len(self.result.objects), len(self.result.patches)
        self.assertEqual(repr(self.result), f"<gestalt.Result of 'demo': {objects} objects, {patches} patches>")

    def test_a_result_survives_a_pickle(self):
        stored = pickle.loads(pickle.dumps(self.result))
        self.assertIsInstance(stored, gestalt.StoredResult)
        for name in ("labels", "object_labels", "patch_labels", "normals", "points"):
            numpy.testing.assert_array_equal(getattr(stored, name), getattr(self.result, name), name)
        for name in ("name", "milliseconds", "segments", "patches"):
            self.assertEqual(getattr(stored, name), getattr(self.result, name), name)
        self.assertEqual(repr(stored.objects), repr(self.result.objects))
        self.assertEqual(stored.to_dict(), self.result.to_dict())
        numpy.testing.assert_array_equal(stored.assembly["values"], self.result.assembly["values"])
        self.assertEqual(repr(stored).replace("StoredResult", "Result"), repr(self.result))
        self.assertEqual(len(pickle.loads(pickle.dumps(stored)).objects), len(stored.objects))
        with self.assertRaisesRegex(gestalt.OutputError, "save it before it is pickled"):
            stored.save("out")

    def test_points_are_those_of_the_camera_frame(self):
        points, depth = self.result.points, self.scene.depth
        numpy.testing.assert_allclose(points[..., 2], depth)
        numpy.testing.assert_allclose(points[100, 200, 0], depth[100, 200] * (200 - 319.5) / 525, rtol=1e-5)

    def test_a_camera_may_be_a_dictionary(self):
        same = self.segmenter(self.scene.colour, self.scene.depth, CAMERA)
        numpy.testing.assert_array_equal(same.labels, self.result.labels)
        numpy.testing.assert_array_equal(self.segmenter.segment(DEMO, CAMERA).labels, self.result.labels)
        self.assertEqual(repr(gestalt.read_scene(DEMO, CAMERA).camera), repr(self.scene.camera))
        without = {key: value for key, value in CAMERA.items() if key != "fy"}
        for error, camera, text in (
            (gestalt.InputError, without, "the key 'fy' is missing"),
            (gestalt.InputError, {**CAMERA, "f": 1}, "unknown key 'f'"),
            (TypeError, {**CAMERA, "fx": "wide"}, "'fx' is a str; expected a number"),
            (TypeError, {**CAMERA, "width": 640.5}, "'width' is a float"),
            (TypeError, [525, 525], "got a list; expected gestalt.Camera"),
            (TypeError, None, "camera: is missing"),
        ):
            with self.assertRaisesRegex(error, text):
                self.segmenter(self.scene.colour, self.scene.depth, camera)

    def test_a_camera_comes_from_a_matrix_or_a_file(self):
        camera = gestalt.Camera(640, 480, 525, 525, 319.5, 239.5)
        matrix = numpy.array([[525, 0, 319.5], [0, 525, 239.5], [0, 0, 1]])
        self.assertEqual(gestalt.Camera.from_K(matrix, 640, 480), camera)
        self.assertEqual(gestalt.Camera.from_K(matrix.tolist(), width=640, height=480), camera)
        self.assertEqual(gestalt.Camera.from_file(DEMO / "camera.yaml"), camera)
        self.assertEqual(hash(pickle.loads(pickle.dumps(camera))), hash(camera))
        self.assertNotEqual(gestalt.Camera(640, 480, 525, 525, 319.5, 240), camera)
        self.assertNotEqual(camera, "camera")
        with self.assertRaisesRegex(gestalt.InputError, r"shape \(3, 3\)"):
            gestalt.Camera.from_K([525, 525, 319.5, 239.5], 640, 480)
        with self.assertRaisesRegex(gestalt.InputError, "pass K.T"):
            gestalt.Camera.from_K(matrix.T, 640, 480)
        with self.assertRaises(gestalt.InputError):
            gestalt.Camera.from_file("missing.yaml")

    def test_a_tracker_keeps_numbers(self):
        tracker = gestalt.Tracker(keep=1)
        first = tracker.update(self.result)
        self.assertEqual(set(first["numbers"]), {thing.label for thing in self.result.objects})
        self.assertEqual(sorted(first["numbers"].values()), first["new"])
        again = tracker.update(self.result, pose=numpy.eye(4))
        self.assertEqual(again["numbers"], first["numbers"])
        self.assertEqual([again[event] for event in ("new", "hidden", "lost", "split", "merged")], [[]] * 5)
        for pose, text in ((numpy.eye(3), r"shape \(4, 4\)"), (2 * numpy.eye(4), "a rotation"), (numpy.full((4, 4), numpy.nan), "a rotation")):
            with self.assertRaisesRegex(gestalt.InputError, text):
                tracker.update(self.result, pose)
        with self.assertRaises(TypeError):
            tracker.update("result")
        with self.assertRaises(ValueError):
            gestalt.Tracker(keep=-1)

    def test_overrides_may_be_a_dictionary(self):
        def config(overrides):
            return gestalt.Segmenter(overrides=overrides).config

        self.assertEqual(config({}), self.segmenter.config)
        self.assertEqual(config(None), self.segmenter.config)
        given = {"structural.minimum_size": 77, "decision.figure_ground.max_depth": 1.5, "sensor.noise": "realsense",
                 "decision.figure_ground.separate": True}
        texts = ["structural.minimum_size=77", "decision.figure_ground.max_depth=1.5", "sensor.noise=realsense",
                 "decision.figure_ground.separate=true"]
        self.assertEqual(config(given), config(texts))
        self.assertEqual(config({"sensor": {"noise": "realsense"}}), config(["sensor.noise=realsense"]))
        for overrides, text in (
            ("structural.minimum_size=77", "got a str; expected a list"),
            (7, "got a int"),
            ([7], "got a int in the list"),
            ({7: 1}, "a key is a int"),
            ({"sensor.noise": numpy}, "the value of 'sensor.noise' is a module"),
        ):
            with self.assertRaisesRegex(TypeError, text):
                config(overrides)

    def test_a_missing_depth_is_explained_in_few_words(self):
        for arguments in ((self.scene.colour,), (None, self.scene.depth.tolist(), CAMERA), (self.scene.colour, "depth.png", CAMERA)):
            with self.assertRaisesRegex(TypeError, "^depth: .*expected a numpy array of shape") as caught:
                self.segmenter(*arguments)
            self.assertLess(len(str(caught.exception)), 300)

    def test_an_object_that_was_never_initialised_is_a_type_error(self):
        for cls in (gestalt.Result, gestalt.Segmenter, gestalt.SceneView, gestalt.Camera, gestalt.Tracker):
            empty = cls.__new__(cls)
            own = {name for name in vars(cls) if name not in ("__init__", "__module__", "__doc__")}
            for name in sorted(own):
                with self.subTest(cls=cls.__name__, name=name), self.assertRaises(TypeError):
                    value = getattr(empty, name)
                    value() if callable(value) else self.fail(f"{name} is {value!r}")
        with self.assertRaises(TypeError):
            self.segmenter(self.scene.colour, self.scene.depth, gestalt.Camera.__new__(gestalt.Camera))

    def test_signatures_can_be_read(self):
        for function, signature in (
            (gestalt.Segmenter, "(config=None, overrides=(), *, components=None, threads=0)"),
            (gestalt.Camera, "(width, height, fx, fy, cx, cy)"),
            (self.segmenter, "(colour, depth=None, camera=None, name='frame', *, depth_scale=None, depth_kind=None)"),
            (self.segmenter.segment, "(scene, camera=None, *, depth_scale=None, depth_kind=None, labels=None)"),
            (gestalt.score, "(ground_truth, labels)"),
            (gestalt.data_directory, "()"),
        ):
            self.assertEqual(str(inspect.signature(function)), signature)
        names = [name for name in gestalt.__all__ if callable(getattr(gestalt, name)) and not name.endswith("Error")]
        for name in set(names) - {"Result", "SceneView"}:  # those come from the package alone
            with self.subTest(name):
                self.assertGreater(len(str(inspect.signature(getattr(gestalt, name)))), 1)
        self.assertTrue(gestalt.score.__doc__ and not gestalt.score.__doc__.startswith("score("))
        self.assertTrue(gestalt.Segmenter.__call__.__doc__.startswith("Segments a frame."))

    def test_the_stub_has_the_arguments_of_the_compiled_functions(self):
        stub = ast.parse((pathlib.Path(gestalt.__file__).parent / "_gestalt.pyi").read_text())

        def compare(owner, functions):
            for declared in functions:
                if not isinstance(declared, ast.FunctionDef) or declared.decorator_list or declared.name == "__reduce__":
                    continue
                arguments = declared.args
                named = [a.arg for a in arguments.posonlyargs + arguments.args + arguments.kwonlyargs]
                with self.subTest(f"{owner.__name__}.{declared.name}"):
                    self.assertEqual(list(inspect.signature(getattr(owner, declared.name)).parameters), named)

        compare(gestalt._gestalt, stub.body)
        for declared in stub.body:
            if isinstance(declared, ast.ClassDef):
                compare(getattr(gestalt._gestalt, declared.name), declared.body)


if __name__ == "__main__":
    unittest.main()
