# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same results as the command's, as arrays."""

import concurrent.futures
import json
import os
import pathlib
import pickle
import shutil
import subprocess
import sys
import tempfile
import textwrap
import threading
import unittest

import cv2
import numpy

import gestalt
from scenes import demo, run, synthesize


class PipelineTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = gestalt.read_scene(demo)
        cls.segmenter = gestalt.Segmenter()
        cls.result = cls.segmenter(cls.scene.colour, cls.scene.depth, cls.scene.camera)

    def test_gives_what_the_command_writes(self):
        with tempfile.TemporaryDirectory() as out:
            run("segment", demo, "--output", out)
            folder = pathlib.Path(out, demo.name)
            written = cv2.imread(str(folder / "labels.png"), cv2.IMREAD_UNCHANGED)
            objects = cv2.imread(str(folder / "objects.png"), cv2.IMREAD_UNCHANGED)
            told = json.loads((folder / "result.json").read_text())
        numpy.testing.assert_array_equal(self.result.labels, written)
        numpy.testing.assert_array_equal(self.result.object_labels, objects)
        self.assertEqual(self.result.segments, told["segments"])
        self.assertEqual(self.result.patches, told["patches"])

    def test_saves_what_the_command_writes(self):
        with tempfile.TemporaryDirectory() as out:
            run("segment", demo, "--output", out)
            self.segmenter.segment(demo).save(pathlib.Path(out, "saved"))
            written = {file.name for file in pathlib.Path(out, demo.name).iterdir()}
            self.assertEqual({file.name for file in pathlib.Path(out, "saved").iterdir()}, written)
            for name in ("labels.png", "overlay.png", "patches.png"):
                self.assertEqual(pathlib.Path(out, demo.name, name).read_bytes(), pathlib.Path(out, "saved", name).read_bytes())

    def test_what_many_threads_save_into_one_folder_is_of_one_of_them(self):
        def saved(folder):
            files = json.loads((folder / "result.json").read_text())["files"]
            self.assertEqual({file.name for file in folder.iterdir()}, {*files, "result.json"})
            return {name: (folder / name).read_bytes() for name in files}

        results = [self.result, self.segmenter(self.scene.colour, self.scene.depth * 1.2, self.scene.camera)]
        with tempfile.TemporaryDirectory() as work, concurrent.futures.ThreadPoolExecutor(16) as threads:
            out, alone = pathlib.Path(work, "out"), pathlib.Path(work, "alone")
            expected = [result.save(alone) or saved(alone) for result in results]
            self.assertNotEqual(*expected)
            for _ in range(3):
                for one in [threads.submit(results[i % 2].save, out) for i in range(16)]:
                    one.result()
                self.assertIn(saved(out), expected)

    def test_a_result_shares_nothing_that_can_be_changed(self):
        untouched = self.result.to_dict()
        for changed in (self.result.to_dict(), {"segments": self.result.segments}):
            changed["segments"][0]["label"] = "mine"
            changed["segments"].clear()
        self.result.patches.clear()
        self.assertEqual(self.result.to_dict(), untouched)

    def test_a_mask_is_not_left_out(self):
        masked = numpy.ma.masked_greater(self.scene.depth, 1)
        with self.assertRaisesRegex(gestalt.InputError, r"depth: is a masked array; give depth\.filled"):
            self.segmenter(self.scene.colour, masked, self.scene.camera)
        with self.assertRaisesRegex(gestalt.InputError, "colour: is a masked array"):
            self.segmenter(numpy.ma.masked_equal(self.scene.colour, 0), self.scene.depth, self.scene.camera)
        with self.assertRaisesRegex(gestalt.InputError, "labels: is a masked array"):
            gestalt.score(self.scene.labels, numpy.ma.masked_equal(self.scene.labels, 1))
        self.segmenter(self.scene.colour, masked.filled(0), self.scene.camera)

    def test_an_error_names_a_path_that_is_no_utf8(self):
        path = os.fsdecode(b"/no/such/caf\xe9")
        with self.assertRaisesRegex(gestalt.InputError, path + ".*: "):
            self.segmenter.segment(path)

    def test_a_path_that_is_no_utf8_works(self):
        with tempfile.TemporaryDirectory() as work:
            odd = os.path.join(work, os.fsdecode(b"caf\xe9"))
            shutil.copytree(demo, odd)
            result = self.segmenter.segment(odd)
            self.assertEqual(result.name, os.path.basename(odd))
            self.assertIn(os.path.basename(odd), repr(result))
            self.assertEqual(gestalt.read_scene(odd).name, os.path.basename(odd))
            result.save(work, "result")
            self.assertEqual(len(result.to_dict()["segments"]), len(self.result.segments))
            config = os.path.join(odd, "config.yaml")
            pathlib.Path(config).write_text("schema_version: 1\nextends: default.yaml\n")
            gestalt.Segmenter(config)
            with self.assertWarnsRegex(UserWarning, os.path.basename(odd)):
                shutil.copy(demo.parents[1] / "models" / "default.json", odd)
                pathlib.Path(config).write_text(
                    "schema_version: 1\nextends: default.yaml\nmodel: default.json\n"
                    "primitive: {model_selection: {sigma: 3}}\n"
                )
                gestalt.Segmenter(config)

    def test_a_working_directory_that_is_gone_is_told(self):
        text = """
        import os, sys, gestalt
        segmenter = gestalt.Segmenter()
        scene = gestalt.read_scene(sys.argv[1])
        of_arrays = segmenter(scene.colour, scene.depth, scene.camera)
        os.mkdir("gone"); os.chdir("gone"); os.rmdir("../gone")
        print(len(segmenter.segment(sys.argv[1]).to_dict()["segments"]) > 0)
        for call in (lambda: segmenter.segment("here"), lambda: segmenter.segment(sys.argv[1]).save("here"),
                     lambda: of_arrays.save("here"),
                     lambda: gestalt.Segmenter("mine.yaml"), lambda: gestalt.train("here", "model.json")):
            try:
                call()
            except gestalt.Error as error:
                print(len(str(error)) > 20)
        """
        with tempfile.TemporaryDirectory() as work:
            told = subprocess.run(
                [sys.executable, "-c", textwrap.dedent(text), demo], cwd=work, check=True, stdout=subprocess.PIPE, text=True
            )
        self.assertEqual(told.stdout, 6 * "True\n")

    def test_wrong_arguments_are_errors_of_ours(self):
        with self.assertRaisesRegex(gestalt.InputError, r"colour: .* shape \(0, 0, 3\)"):
            self.segmenter(numpy.zeros((0, 0, 3), numpy.uint8), self.scene.depth, self.scene.camera)
        with self.assertRaisesRegex(gestalt.ConfigError, "config: expected a file"):
            gestalt.Segmenter({"extends": "default.yaml"})

    def test_no_scene_has_no_score(self):
        for call in (
            lambda: self.segmenter.evaluate([]),
            lambda: gestalt.cross_validate([]),
            lambda: gestalt.train([], "no_model.json"),
        ):
            with self.assertRaisesRegex(gestalt.InputError, "scenes: the list is empty"):
                call()

    def test_saves_below_a_folder_and_follows_no_link_there(self):
        with tempfile.TemporaryDirectory() as out:
            root, elsewhere = pathlib.Path(out, "out"), pathlib.Path(out, "elsewhere")
            root.mkdir()
            elsewhere.mkdir()
            (root / "link").symlink_to(elsewhere)
            with self.assertRaisesRegex(gestalt.OutputError, "link: is a symbolic link"):
                self.result.save(root, "link")
            with self.assertRaises(gestalt.OutputError):
                self.result.save(root, "../elsewhere")
            with self.assertRaisesRegex(gestalt.OutputError, "leads outside the output folder"):
                self.result.save(root, str(elsewhere))
            with self.assertRaisesRegex(gestalt.OutputError, "NUL character"):
                self.result.save(root, "frame\0")
            for name in ("", "."):
                with self.assertRaisesRegex(gestalt.OutputError, "is not a name of a folder"):
                    self.result.save(root, name)
            self.assertEqual(list(elsewhere.iterdir()), [])
            self.result.save(root, "frame")
            self.assertTrue((root / "frame" / "result.json").exists())
            self.result.save(root / "link")  # that the user named
            self.assertTrue((elsewhere / "result.json").exists())

    def test_parts_of_a_result_fit_each_other(self):
        result = self.result
        labels = set(numpy.unique(result.labels)) - {0}
        self.assertEqual(labels, {segment["label"] for segment in result.segments})
        self.assertEqual(set(numpy.unique(result.object_labels)) - {0}, {o.label for o in result.objects})
        self.assertEqual(result.patch_labels.max(), len(result.patches))
        for table in (result.structural, result.assembly):
            rows, columns = table["values"].shape
            self.assertEqual(columns, len(table["names"]))
            self.assertEqual(table["pairs"].shape, (rows, 2))
            decided = table["probabilities"][~numpy.isnan(table["probabilities"])]
            self.assertTrue(len(decided) and ((decided >= 0) & (decided <= 1)).all())
        self.assertEqual(set(result.milliseconds), {"signal", "primitive", "structural", "assembly", "decision"})
        lengths = numpy.linalg.norm(result.normals, axis=-1)
        numpy.testing.assert_allclose(lengths[lengths > 0], 1, atol=1e-4)
        self.assertGreater(numpy.count_nonzero(lengths), 200000)

    def test_depth_in_millimetres_is_the_same_as_in_metres(self):
        millimetres = numpy.rint(self.scene.depth * 1000).astype(numpy.uint16)
        for order in "<>":
            depth = millimetres.astype(millimetres.dtype.newbyteorder(order))
            result = self.segmenter(self.scene.colour, depth, self.scene.camera)
            numpy.testing.assert_array_equal(result.labels, self.result.labels)

    def test_other_units_are_told_or_seen(self):
        scene, millimetres = self.scene, 1000 * self.scene.depth
        with self.assertRaisesRegex(gestalt.InputError, "--unit mm.*in Python: depth_scale="):
            self.segmenter(scene.colour, millimetres, scene.camera)
        result = self.segmenter(scene.colour, millimetres, scene.camera, depth_scale=0.001)
        numpy.testing.assert_array_equal(result.labels, self.result.labels)
        fine = numpy.round(10 * millimetres).astype(numpy.uint16)
        with self.assertWarnsRegex(UserWarning, "--unit 0.1mm"):
            self.segmenter(scene.colour, fine, scene.camera)
        with self.assertRaisesRegex(gestalt.InputError, "depth_scale"):
            self.segmenter(scene.colour, fine, scene.camera, depth_scale=-1)
        self.assertAlmostEqual(gestalt.read_scene(demo, depth_scale=0.002).depth.max(), 2 * scene.depth.max(), places=5)

    def test_takes_views_and_double_precision(self):
        depth = numpy.zeros((480, 1280))
        depth[:, ::2] = numpy.where(self.scene.depth > 0, self.scene.depth, numpy.nan)
        result = self.segmenter(self.scene.colour[:, ::-1][:, ::-1], depth[:, ::2], self.scene.camera)
        numpy.testing.assert_array_equal(result.labels, self.result.labels)

    def test_images_cannot_be_written_and_outlive_the_result(self):
        labels = self.segmenter.segment(demo).labels
        with self.assertRaises(ValueError):
            labels[0, 0] = 1
        numpy.testing.assert_array_equal(labels, self.result.labels)

    def test_other_threads_run_meanwhile(self):
        """Frames of threads are computed side by side, each as alone."""
        results = [None] * 4

        def work(i):
            results[i] = self.segmenter(self.scene.colour, self.scene.depth, self.scene.camera)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        ticks = 0
        for thread in threads:
            thread.start()
        while any(thread.is_alive() for thread in threads):
            ticks += 1  # only with the interpreter released
            threads[0].join(0.001)
        self.assertGreater(ticks, 3)
        for result in results:
            numpy.testing.assert_array_equal(result.labels, self.result.labels)

    def test_any_number_of_threads_gives_the_same(self):
        result = gestalt.Segmenter(threads=1).segment(demo)
        numpy.testing.assert_array_equal(result.labels, self.result.labels)
        numpy.testing.assert_array_equal(result.structural["values"], self.result.structural["values"])

    def test_images_that_do_not_fit_are_told(self):
        colour, depth, camera = self.scene.colour, self.scene.depth, self.scene.camera
        for arguments, text in (
            ((colour, depth[:100], camera), "size"),
            ((colour[..., 0], depth, camera), "colour: expected None or uint8 of shape (height, width, 3), got"),
            ((colour.astype(float), depth, camera), "got an array of float64"),
            ((colour, depth.astype(int), camera), "depth: expected uint16 (millimetres) or float (metres)"),
            ((colour, numpy.zeros_like(depth), camera), "no pixel"),
        ):
            with self.subTest(text), self.assertRaises(gestalt.InputError) as raised:
                self.segmenter(*arguments)
            self.assertIn(text, str(raised.exception))

    def test_errors_have_their_class(self):
        with self.assertRaisesRegex(gestalt.ConfigError, "did you mean 'gabor'"):
            gestalt.Segmenter(overrides=["structural.relations.gabr=on"])
        with self.assertRaisesRegex(gestalt.ModelError, "no_such.json"):
            gestalt.Segmenter(overrides=["model=no_such.json"])
        with self.assertRaisesRegex(gestalt.InputError, "no_such_scene"):
            self.segmenter.segment("no_such_scene")
        with self.assertRaisesRegex(gestalt.TimeError, "time_budget of 1 ms"):
            gestalt.Segmenter(overrides=["time_budget=1"]).segment(demo)
        with self.assertRaises(gestalt.OutputError):
            self.result.save("/dev/null/folder")
        self.assertTrue(issubclass(gestalt.InputError, gestalt.Error))

    def test_a_model_of_other_parameters_is_warned_of(self):
        with self.assertWarnsRegex(UserWarning, "was trained with different parameters"):
            gestalt.Segmenter(overrides=["primitive.model_selection.sigma=3"])

    def test_a_camera_can_be_pickled(self):
        self.assertEqual(repr(pickle.loads(pickle.dumps(self.scene.camera))), repr(self.scene.camera))

    def test_learns_and_scores(self):
        with tempfile.TemporaryDirectory() as work:
            scenes = synthesize(pathlib.Path(work, "scenes"), 4)
            model = pathlib.Path(work, "model.json")
            trained = gestalt.train(scenes, model)
            self.assertEqual(trained["structural"]["scenes"], 4)
            self.assertGreater(trained["structural"]["positive_pairs"], 0)
            ours = gestalt.Segmenter(overrides=[f"model={model}"])
            told = json.loads(run("evaluate", scenes, "--set", f"model={model}", "--json"))
            scores = ours.evaluate(scenes)
            self.assertEqual(set(scores), set(told) - {"scored"})
            self.assertAlmostEqual(scores["all"]["P"], told["all"]["P"])
            told = json.loads(run("evaluate", scenes, "--cross-validate", 2, "--set", "levels=structural", "--json"))
            scores = gestalt.cross_validate(scenes, folds=2, overrides=["levels=structural"])
            self.assertAlmostEqual(scores["all"]["R"], told["all"]["R"])

    def test_scores_one_image(self):
        truth = numpy.where(self.scene.depth > 0, self.scene.labels, 0)
        score = gestalt.score(truth, self.result.labels)
        self.assertEqual(score["regions"], len({label if label < 10 else label // 10 for label in numpy.unique(truth)} - {0}) - 1)
        self.assertTrue(0.5 < score["P"] <= 1 and 0.5 < score["R"] <= 1)
        with self.assertRaisesRegex(gestalt.InputError, "size"):
            gestalt.score(truth[1:], self.result.labels)
        with self.assertRaisesRegex(gestalt.InputError, "-1"):
            gestalt.score(truth.astype(int) - 1, self.result.labels)


if __name__ == "__main__":
    unittest.main()
