# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""formats_test.py GESTALT SCENE: layouts and files of others, written here as their definitions say, become the scene that they
were made of; damaged ones are refused with their name, the place and the remedy."""

import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

import cv2
import numpy

GESTALT, DEMO = sys.argv[1], pathlib.Path(sys.argv[2])
K = numpy.array([[525, 0, 319.5], [0, 525, 239.5], [0, 0, 1]])
CAMERA = "width: 640\nheight: 480\nfx: 525\nfy: 525\ncx: 319.5\ncy: 239.5\n"


def read(folder, name):
    return cv2.imread(str(pathlib.Path(folder, name)), cv2.IMREAD_UNCHANGED)


depth, rgb, label = read(DEMO, "depth.png"), read(DEMO, "rgb.png"), read(DEMO, "label.png")
objects = numpy.where((depth > 0) & (label >= 20), label.astype(int) // 10 - 1, 0)  # 0 background, 1 the first object
expected_label = numpy.where(depth > 0, numpy.where(objects > 0, 10 * (objects + 1), 1), 0)


def points():
    v, u = numpy.mgrid[0:480, 0:640]
    z = depth / 1000
    return numpy.stack([(u - 319.5) * z / 525, (v - 239.5) * z / 525, z], axis=-1).astype(numpy.float32)


class FormatsTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.work = pathlib.Path(temporary.name)

    def run_gestalt(self, *words, exit_code=0):
        done = subprocess.run([GESTALT, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, exit_code, done.stderr or done.stdout)
        return done.stdout if exit_code == 0 else done.stderr

    def convert(self, source, *options):
        """The folder of the only scene that it is converted to."""
        out = self.work / "converted"
        shutil.rmtree(out, ignore_errors=True)
        self.run_gestalt("convert", source, "--output", out, *options)
        return next(out.glob("*/*/depth.png")).parent

    def refused(self, *parts, words):
        """An unusable input: exit code 3, and a message that has the parts."""
        error = self.run_gestalt(*words, exit_code=3)
        for part in parts:
            self.assertIn(str(part), error)
        self.assertNotIn("terminate", error)

    def expect_demo(self, folder, scale=1, labels=label, colour=rgb):
        numpy.testing.assert_array_equal(read(folder, "depth.png"), depth.astype(int) * scale)
        numpy.testing.assert_array_equal(read(folder, "rgb.png"), colour)
        if labels is None:
            self.assertFalse((folder / "label.png").exists())
        else:
            numpy.testing.assert_array_equal(read(folder, "label.png"), labels)


class Npz(FormatsTest):
    def test_arrays_of_numpy_are_a_scene(self):
        file = self.work / "mine.npz"
        for save, kind in ((numpy.savez, numpy.uint16), (numpy.savez_compressed, numpy.int64)):
            save(file, depth=depth, rgb=rgb[..., ::-1], label=label.astype(kind), K=K)
            self.expect_demo(self.convert(file))
        numpy.savez(file, depth=(depth / 1000).astype(numpy.float32), rgb=rgb[..., ::-1], K=K.astype(numpy.float32))
        self.expect_demo(self.convert(file), labels=None)

    def test_they_segment_as_the_folder_does(self):
        numpy.savez(self.work / "demo.npz", depth=depth, rgb=rgb[..., ::-1], K=K)
        self.run_gestalt("segment", DEMO, self.work / "demo.npz", "--output", self.work / "out")
        ours, theirs = (read(self.work / "out" / name, "labels.png") for name in (DEMO.name, "demo"))
        numpy.testing.assert_array_equal(ours, theirs)
        self.assertIn("scene of arrays", self.run_gestalt("info", self.work / "demo.npz"))

    def test_a_scene_becomes_arrays(self):
        self.run_gestalt("convert", DEMO, "--to", "npz", "--output", self.work / "out")
        arrays = numpy.load(self.work / "out" / "scenes" / "demo_scene.npz")
        numpy.testing.assert_array_equal(arrays["depth"], depth)
        numpy.testing.assert_array_equal(arrays["rgb"], rgb[..., ::-1])
        numpy.testing.assert_array_equal(arrays["label"], label)
        numpy.testing.assert_array_equal(arrays["K"], K)
        self.assertEqual(arrays["depth_scale"], 0.001)

    def test_the_scale_of_depth_is_kept_in_mind(self):
        numpy.savez(self.work / "fine.npz", depth=depth * 2, depth_scale=0.0005, rgb=rgb[..., ::-1], K=K)
        self.expect_demo(self.convert(self.work / "fine.npz"), labels=None)

    def test_what_is_wrong_is_named(self):
        file = self.work / "wrong.npz"
        good = {"depth": depth, "rgb": rgb[..., ::-1], "K": K}
        for text, change in (
            ("no array 'depth'", {"depth": None}),
            ("array 'depth' has the shape (480, 640, 2)", {"depth": numpy.dstack([depth, depth])}),
            ("array 'rgb' is of 640x470 pixels, depth of 640x480", {"rgb": rgb[10:]}),
            ("array 'rgb' must be of numbers and have the shape (480, 640, 3)", {"rgb": rgb[..., :2]}),
            ("array 'K' must have the shape (3, 3)", {"K": K[0]}),
            ("no array 'K', nor is there a camera.yaml", {"K": None}),
            ("array 'depth': has the type '<c8'", {"depth": depth.astype(numpy.complex64)}),
            ("array 'depth_scale' must be one number", {"depth_scale": numpy.array([1, 2])}),
            ("array 'depth': is a pickled object", {"depth": numpy.array([[{}]])}),
        ):
            with self.subTest(text):
                arrays = {name: array for name, array in {**good, **change}.items() if array is not None}
                numpy.savez(file, **arrays)
                self.refused("wrong.npz", text, words=("info", file))

    def test_labels_that_cannot_be_read_are_told_and_left_out(self):
        file = self.work / "labelled.npz"
        for text, wrong in (
            ("array 'label' has a label outside 0 to 65535", label.astype(int) - 1),
            ("array 'label' must have the shape of depth, (480, 640)", label[1:]),
            ("array 'label' is of floats; write it as integers", label.astype(float)),
        ):
            numpy.savez(file, depth=depth, rgb=rgb[..., ::-1], K=K, label=wrong)
            told = json.loads(self.run_gestalt("info", file, "--json"))
            self.assertIn(text, told["labels_problem"])
            self.assertIn(text, told["warnings"][0])
            self.refused(text, words=("evaluate", file))

    def test_damage_and_huge_claims_are_refused(self):
        file = self.work / "damaged.npz"
        numpy.savez_compressed(file, depth=depth, K=K)
        whole = file.read_bytes()
        for cut in (10, len(whole) // 2, len(whole) - 10):
            file.write_bytes(whole[:cut])
            self.refused("damaged.npz", "is not a .npz file", words=("info", file))
        flipped = bytearray(whole)
        flipped[len(whole) // 2] ^= 0xFF
        file.write_bytes(flipped)
        self.refused("damaged.npz", "array 'depth'", "cannot be read", words=("info", file))
        for shape in ((2**31, 2**31), (2**62, 4), (10**30, 1), (100000, 100000)):
            header = io.BytesIO()
            numpy.lib.format.write_array_header_1_0(header, {"descr": "<u2", "fortran_order": False, "shape": shape})
            with zipfile.ZipFile(file, "w") as archive:
                archive.writestr("depth.npy", header.getvalue())
            self.refused("damaged.npz", "array 'depth'", words=("info", file))
        short = io.BytesIO()
        numpy.save(short, depth)
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("depth.npy", short.getvalue()[:-10])
        self.refused("damaged.npz", f"has {depth.nbytes - 10} bytes of data, its shape needs {depth.nbytes}", words=("info", file))
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:  # a megabyte that unpacks to more than memory is for
            with archive.open("depth.npy", "w", force_zip64=True) as entry:
                for _ in range(1100):
                    entry.write(bytes(1 << 20))
        self.refused("damaged.npz", "more than 2^30 bytes", words=("info", file))
        with zipfile.ZipFile(file, "w", zipfile.ZIP_BZIP2) as archive:
            archive.writestr("depth.npy", short.getvalue())
        self.refused("damaged.npz", "compressed in a way that numpy does not use", words=("info", file))
        numpy.savez_compressed(file, depth=depth, K=K)
        claim = bytearray(file.read_bytes())  # a few bytes that say they become a gigabyte
        for signature, field in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
            at = claim.index(signature) + field
            claim[at:at + 4] = (2**30 - 1).to_bytes(4, "little")
        file.write_bytes(claim)
        self.refused("damaged.npz", "array 'depth'", "more bytes than its compressed data can hold", words=("info", file))


class Ply(FormatsTest):
    def write_ply(self, file, form="binary_little_endian", with_label=True, after=True):
        seen = depth.ravel() > 0
        fields = [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("red", "u1"), ("green", "u1"), ("blue", "u1")]
        names = {"<f4": "float", "u1": "uchar", "<u2": "ushort"}
        if with_label:
            fields.append(("label", "<u2"))
        vertices = numpy.zeros(numpy.count_nonzero(seen), fields)
        xyz = points().reshape(-1, 3)[seen]
        vertices["x"], vertices["y"], vertices["z"] = xyz.T
        vertices["blue"], vertices["green"], vertices["red"] = rgb.reshape(-1, 3)[seen].T
        if with_label:
            vertices["label"] = label.ravel()[seen]
        properties = "".join(f"property {names[kind]} {name}\n" for name, kind in fields)
        faces = "element face 1\nproperty list uchar int vertex_indices\n" if after else ""
        head = f"ply\nformat {form} 1.0\ncomment from a test\nelement vertex {len(vertices)}\n{properties}{faces}end_header\n"
        if form == "ascii":
            body = "\n".join(" ".join(repr(x) if isinstance(x, float) else str(x) for x in row) for row in vertices.tolist())
            file.write_text(head + body + ("\n3 0 1 2\n" if after else "\n"))
        else:
            file.write_bytes(head.encode() + vertices.tobytes() + (b"\x03" + bytes(12) if after else b""))
        return head, vertices

    def test_a_cloud_is_a_scene(self):
        file = self.work / "cloud.ply"
        (self.work / "camera.yaml").write_text(CAMERA)
        shown = numpy.where(depth[..., None] > 0, rgb, 0)
        for form in ("ascii", "binary_little_endian"):
            self.write_ply(file, form)
            self.expect_demo(self.convert(file), labels=numpy.where(depth > 0, label, 0), colour=shown)
        self.assertIn("PLY cloud", self.run_gestalt("info", file))

    def test_a_scene_becomes_a_cloud_and_back(self):
        self.run_gestalt("convert", DEMO, "--to", "ply", "--output", self.work / "out")
        shown = numpy.where(depth[..., None] > 0, rgb, 0)
        file = self.work / "out" / "scenes" / "demo_scene.ply"
        self.expect_demo(self.convert(file), labels=numpy.where(depth > 0, label, 0), colour=shown)

    def test_what_is_wrong_is_named(self):
        file = self.work / "wrong.ply"
        (self.work / "camera.yaml").write_text(CAMERA)
        head, vertices = self.write_ply(file, after=False)
        body = vertices.tobytes()
        for text, damaged in (
            ("wrong.ply:2: expected 'format ascii 1.0'", head.replace("little", "middle")),
            ("the number of vertices must be from 1 to 2^26", head.replace(f"vertex {len(vertices)}", "vertex 99999999999")),
            ("the number of vertices must be from 1 to 2^26", head.replace(f"vertex {len(vertices)}", "vertex -1")),
            ("has no field 'x'", head.replace("float x", "float a")),
            ("appears twice", head.replace("float y", "float x")),
            ("must be 'property TYPE NAME'", head.replace("property float z", "property list uchar int z")),
            ("ends within vertex", head.replace(f"vertex {len(vertices)}", f"vertex {len(vertices) + 1}")),
            ("must be a colour from 0 to 1", head.replace("uchar red", "char red")),
            ("is not a line of a PLY header", head.replace("comment", "remark")),
            ("the PLY header ends here", head[:100]),
            ("'vertex'", "ply\nformat ascii 1.0\nend_header\n"),
            ("wrong.ply:1: a PLY file begins with 'ply', not 'plyx'", head.replace("ply", "plyx", 1)),
            ("ends within the elements before the vertices", head.replace("element vertex", "element a 9999999\nproperty int b\nelement vertex")),
        ):
            with self.subTest(text):
                file.write_bytes(damaged.encode() + (body if "end_header" in damaged else b""))
                self.refused("wrong.ply", text, words=("info", file))
        file.write_text("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 three\n")
        self.refused("wrong.ply:8", "three", words=("info", file))
        (self.work / "camera.yaml").unlink()
        self.write_ply(file)
        self.assertIn("a virtual one of", self.run_gestalt("info", file))


class Tum(FormatsTest):
    def sequence(self):
        folder = self.work / "rgbd_dataset"
        for name in ("rgb", "depth"):
            (folder / name).mkdir(parents=True)
        cv2.imwrite(str(folder / "rgb" / "100.000.png"), 255 - rgb)
        cv2.imwrite(str(folder / "rgb" / "100.033.png"), rgb)
        cv2.imwrite(str(folder / "depth" / "100.030.png"), depth * 5)
        cv2.imwrite(str(folder / "depth" / "107.000.png"), depth)
        (folder / "rgb.txt").write_text("# colour images\n100.000 rgb/100.000.png\n100.033 rgb/100.033.png\n")
        (folder / "depth.txt").write_text("# depth maps\n100.030 depth/100.030.png\n107.000 depth/107.000.png\n")
        return folder

    def test_images_nearest_in_time_are_a_frame(self):
        folder = self.convert(self.sequence())
        self.assertEqual(folder.name, "100.030")
        self.expect_demo(folder, scale=5, labels=None)
        camera = (folder / "camera.yaml").read_text()
        self.assertIn("depth_scale: 0.0002\n", camera)
        self.run_gestalt("segment", DEMO, folder, "--output", self.work / "out")
        ours, theirs = (read(self.work / "out" / name, "labels.png") for name in (DEMO.name, "100.030"))
        numpy.testing.assert_array_equal(ours, theirs)

    def test_a_recording_of_ones_own_may_be_in_millimetres(self):
        sequence = self.sequence()
        cv2.imwrite(str(sequence / "depth" / "100.030.png"), depth)
        camera = self.work / "own.yaml"
        camera.write_text(CAMERA + "depth_scale: 0.001\n")
        done = subprocess.run([GESTALT, "convert", sequence, "--output", self.work / "near"], capture_output=True, text=True)
        self.assertIn("give --unit mm", done.stderr)
        for options in (("--camera", camera), ("--unit", "mm")):
            folder = self.convert(sequence, *options)
            self.expect_demo(folder, labels=None)
            self.assertIn("depth_scale: 0.001\n", (folder / "camera.yaml").read_text())

    def test_what_is_wrong_is_named(self):
        sequence = self.sequence()
        lists = {name: (sequence / name).read_text() for name in ("rgb.txt", "depth.txt")}
        for name, text, told in (
            ("rgb.txt", "noon rgb/100.000.png\n", "rgb.txt:1: expected 'timestamp filename'"),
            ("depth.txt", "# a\n100.0\n", "depth.txt:2: expected 'timestamp filename'"),
            ("depth.txt", "nan depth/100.030.png\n", "depth.txt:1: expected 'timestamp filename'"),
            ("depth.txt", "# nothing\n", "depth.txt: names no images"),
            ("depth.txt", "200.0 depth/100.030.png\n", "no colour image is within 0.02 s"),
            ("depth.txt", "100.03 depth/none.png\n", "none.png: does not exist"),
            ("rgb.txt", None, "rgb.txt: does not exist"),
        ):
            with self.subTest(told):
                (sequence / name).unlink() if text is None else (sequence / name).write_text(text)
                self.refused(told, words=("convert", sequence, "--from", "tum", "--output", self.work / "out"))
                (sequence / name).write_text(lists[name])


class Bop(FormatsTest):
    def scene(self):
        folder = self.work / "test" / "000002"
        for name in ("rgb", "depth", "mask_visib"):
            (folder / name).mkdir(parents=True)
        cv2.imwrite(str(folder / "rgb" / "000007.png"), rgb)
        cv2.imwrite(str(folder / "depth" / "000007.png"), depth * 10)
        for i in range(objects.max()):
            cv2.imwrite(str(folder / "mask_visib" / f"000007_{i:06}.png"), numpy.where(objects == i + 1, 255, 0))
        (folder / "scene_camera.json").write_text(json.dumps({"7": {"cam_K": K.ravel().tolist(), "depth_scale": 0.1}}))
        return folder

    def test_masks_are_ground_truth(self):
        folder = self.convert(self.scene().parent, "--from", "bop")
        self.assertEqual(folder.name, "000002_000007")
        self.expect_demo(folder, scale=10, labels=expected_label)
        self.assertIn("depth_scale: 0.0001\n", (folder / "camera.yaml").read_text())

    def test_without_masks_there_is_no_ground_truth(self):
        scene = self.scene()
        shutil.rmtree(scene / "mask_visib")
        self.expect_demo(self.convert(scene), scale=10, labels=None)

    def test_what_is_wrong_is_named(self):
        scene = self.scene()
        file = scene / "scene_camera.json"
        for text, told in (
            ("{", "scene_camera.json:1:2: is not valid JSON"),
            ("[]", "scene_camera.json: is not a JSON map"),
            ('{"../7": {}}', "is not the number of an image"),
            ('{"7": {}, "007": {}}', "7: has two cameras"),
            ('{"7": {}}', "7: cam_K must be a list of 9 numbers"),
            ('{"7": 3}', "7: cam_K must be a list of 9 numbers"),
            ('{"7": {"cam_K": [1, 2, 3, 4, 5, 6, 7, 8, "nine"]}}', "cam_K must be a list of 9 numbers"),
            ('{"7": {"cam_K": [525, 0, 320, 0, 525, 240, 0, 0, 1], "depth_scale": 0}}', "depth_scale must be a number"),
            ('{"7": {"cam_K": [0, 0, 320, 0, 525, 240, 0, 0, 1]}}', "7: cam_K must have focal lengths"),
            ('{"8": {"cam_K": [525, 0, 320, 0, 525, 240, 0, 0, 1]}}', "000008.png: does not exist"),
        ):
            with self.subTest(told):
                file.write_text(text)
                self.refused(told, words=("convert", scene, "--from", "bop", "--output", self.work / "out"))
        for text, told in (('{"8": {}}', "7: has no camera"), ('{"7": {}, "000007": {}}', "7: has two cameras")):
            file.write_text(text)
            self.refused("scene_camera.json", told, words=("info", scene))
        self.refused("neither it nor a folder in it", words=("convert", DEMO, "--from", "bop", "--output", self.work / "out"))
        good = self.work / "good"
        scene.rename(good)
        self.scene()
        cv2.imwrite(str(scene / "mask_visib" / "000007_000001.png"), numpy.zeros((2, 2), numpy.uint8))
        self.refused("000007_000001.png: is 2x2", words=("convert", scene, "--output", self.work / "out"))

    def test_images_that_cannot_be_used_are_named(self):
        scene = self.scene()
        words = ("convert", scene, "--output", self.work / "out")
        camera = self.work / "camera.yaml"
        camera.write_text("width: 320\nheight: 200\nfx: 262\nfy: 262\ncx: 160\ncy: 100\n")
        self.refused("camera.yaml: is for 320x200 images", "depth/000007.png is 640x480", words=(*words, "--camera", camera))
        cv2.imwrite(str(scene / "depth" / "000007.png"), depth * 0)
        self.refused("depth/000007.png: no pixel has a measurement", words=words)
        (scene / "rgb" / "000007.png").unlink()
        self.refused("rgb/000007.png: does not exist, nor is there one in gray/", words=words)

    def test_a_camera_of_another_resolution_is_scaled(self):
        camera = self.work / "half.yaml"
        camera.write_text("width: 320\nheight: 240\nfx: 262.5\nfy: 262.5\ncx: 159.5\ncy: 119.5\ndepth_scale: 0.0001\n")
        folder = self.convert(self.scene(), "--camera", camera)
        self.expect_demo(folder, scale=10, labels=expected_label)
        written = (folder / "camera.yaml").read_text()
        for line in ("width: 640", "fx: 525\n", "cx: 319.5\n"):
            self.assertIn(line, written)

    def test_a_lens_is_rectified_as_segment_does(self):
        camera = self.work / "lens.yaml"
        camera.write_text(CAMERA + "k1: -0.2\nk2: 0.05\n")
        same = self.work / "same"
        same.mkdir()
        for name, image in (("rgb", rgb), ("depth", depth), ("label", expected_label.astype(numpy.uint8))):
            cv2.imwrite(str(same / f"{name}.png"), image)
        self.run_gestalt("convert", same, "--camera", camera, "--to", "npz", "--output", self.work / "arrays")
        expected = numpy.load(self.work / "arrays" / "scenes" / "same.npz")
        folder = self.convert(self.scene(), "--camera", camera, "--unit", "0.1mm")
        numpy.testing.assert_array_equal(read(folder, "depth.png"), expected["depth"] * 10)
        numpy.testing.assert_array_equal(read(folder, "rgb.png"), expected["rgb"][..., ::-1])
        numpy.testing.assert_array_equal(read(folder, "label.png"), expected["label"])
        self.assertGreater(numpy.count_nonzero(expected["depth"] != depth), 10000)
        self.assertNotIn("k1", (folder / "camera.yaml").read_text())
        # What was found in the sequence's folder is not passed over, either.
        sequence = self.work / "tum"
        for name, image in (("rgb", rgb), ("depth", depth)):
            (sequence / name).mkdir(parents=True)
            cv2.imwrite(str(sequence / name / "1.png"), image)
            (sequence / f"{name}.txt").write_text(f"1.0 {name}/1.png\n")
        (sequence / "camera.yaml").write_text(camera.read_text() + "depth_scale: 0.001\n")
        numpy.testing.assert_array_equal(read(self.convert(sequence), "depth.png"), expected["depth"])

    def test_what_depth_says_counts(self):
        scene = self.scene()
        v, u = numpy.mgrid[0:480, 0:640]
        rays = numpy.sqrt(((u - 319.5) / 525) ** 2 + ((v - 239.5) / 525) ** 2 + 1)
        cv2.imwrite(str(scene / "depth" / "000007.png"), numpy.rint(depth * 10 * rays).astype(numpy.uint16))
        folder = self.convert(scene, "--depth-kind", "radial")
        numpy.testing.assert_allclose(read(folder, "depth.png").astype(int), depth.astype(int) * 10, atol=1)
        cv2.imwrite(str(scene / "depth" / "000007.png"), depth << 3)
        folder = self.convert(scene, "--depth-kind", "rotated", "--unit", "mm")
        numpy.testing.assert_array_equal(read(folder, "depth.png"), depth)

    def test_scenes_are_in_the_order_of_their_numbers(self):
        scene = self.scene()
        for name in ("10", "9"):
            shutil.copytree(scene, scene.parent / name)
        out = self.work / "out"
        told = self.run_gestalt("convert", scene.parent, "--from", "bop", "--output", out)
        names = re.findall(r"(\w+)_000007", told)
        self.assertEqual(sorted(set(names), key=names.index), ["000002", "9", "10"], told)


class Ocid(FormatsTest):
    def sequence(self, place, background):
        folder = self.work / "OCID" / place / "seq01"
        for name in ("rgb", "depth", "label"):
            (folder / name).mkdir(parents=True)
        cv2.imwrite(str(folder / "rgb" / "result_1.png"), rgb)
        cv2.imwrite(str(folder / "depth" / "result_1.png"), depth)
        labels = numpy.where(objects > 0, objects + background, background)
        cv2.imwrite(str(folder / "label" / "result_1.png"), labels.astype(numpy.uint8))
        return folder

    def test_floor_and_table_are_background(self):
        (self.work / "camera.yaml").write_text(CAMERA)
        for place, background in (("floor", 1), ("table", 2)):
            self.sequence(place, background)
        out = self.work / "converted"
        release = self.work / "OCID"
        self.run_gestalt("convert", release, "--from", "ocid", "--camera", self.work / "camera.yaml", "--output", out)
        self.assertEqual(sorted(folder.name for folder in (out / "scenes").iterdir()),
                         ["floor_seq01_result_1", "table_seq01_result_1"])
        for folder in (out / "scenes").iterdir():
            self.expect_demo(folder, labels=expected_label)

    def test_the_camera_is_that_of_the_points(self):
        folder = self.sequence("floor", 1)
        (folder / "pcd").mkdir()
        self.run_gestalt("convert", DEMO, "--to", "pcd", "--output", self.work / "cloud")
        shutil.copy(self.work / "cloud" / "scenes" / "demo_scene.pcd", folder / "pcd" / "result_1.pcd")
        converted = self.convert(folder)
        self.expect_demo(converted, labels=expected_label)
        camera = dict(line.split(": ") for line in (converted / "camera.yaml").read_text().splitlines()[1:])
        self.assertAlmostEqual(float(camera["fx"]), 525, delta=0.1)

    def test_what_is_wrong_is_named(self):
        folder = self.sequence("floor", 1)
        words = ("convert", folder, "--output", self.work / "out")
        self.refused("result_1.pcd: does not exist", "--camera", words=words)
        (self.work / "camera.yaml").write_text(CAMERA)
        words += ("--camera", self.work / "camera.yaml")
        (folder / "label" / "result_1.png").unlink()
        self.refused("label/result_1.png: does not exist", words=words)
        shutil.rmtree(folder / "depth")
        self.refused("contains no folder with depth, rgb and label", words=("convert", folder, "--from", "ocid", *words[2:]))


class CameraInfo(FormatsTest):
    calibrated = """image_width: 640
image_height: 480
camera_name: rgb_camera
camera_matrix:
  rows: 3
  cols: 3
  data: [525, 0, 319.5, 0, 525, 239.5, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0, 0, 0, 0, 0]
"""
    printed = """header:
  frame_id: camera
height: 480
width: 640
distortion_model: plumb_bob
D: [0.0, 0.0, 0.0, 0.0, 0.0]
K: [525.0, 0.0, 319.5, 0.0, 525.0, 239.5, 0.0, 0.0, 1.0]
R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
"""

    def test_both_forms_are_cameras(self):
        scene = self.work / "scene"
        shutil.copytree(DEMO, scene)
        file = self.work / "info.yaml"
        for text in (self.calibrated, self.printed, self.printed.replace("K:", "k:").replace("D:", "d:"),
                     self.printed.replace("[0.0, 0.0, 0.0, 0.0, 0.0]", "[]") + "---\n"):
            file.write_text(text)
            self.run_gestalt("segment", scene, "--camera", file, "--output", self.work / "out")
            told = json.loads((self.work / "out" / "scene" / "result.json").read_text())["camera"]
            self.assertEqual((told["fx"], told["cy"], told["width"]), (525, 239.5, 640))

    def test_what_is_wrong_is_named(self):
        file = self.work / "info.yaml"
        for told, text in (
            ("info.yaml:5:19: the distortion model 'fov' cannot be read", self.printed.replace("plumb_bob", "fov").replace("D: [0.0", "D: [0.1")),
            ("K has skewed axes", self.printed.replace("K: [525.0, 0.0", "K: [525.0, 5.5")),
            ("must have 9 numbers", self.printed.replace("K: [525.0,", "K: [")),
            ("K must be a list of numbers", self.printed.replace("319.5", "nine")),
            ("width is '6.5'; it must be a whole number", self.printed.replace("width: 640", "width: 6.5")),
            ("'image_height' is missing", self.calibrated.replace("image_height: 480\n", "")),
            ("must have focal lengths from 0.01", self.printed.replace("525.0", "-1")),
            ("camera_matrix must be a list of numbers", self.calibrated.replace("  data: [525", "  date: [525")),
        ):
            with self.subTest(told):
                file.write_text(text)
                self.refused("info.yaml", told, words=("segment", DEMO, "--camera", file, "--output", self.work / "out"))


class Also(FormatsTest):
    def setUp(self):
        super().setUp()
        self.run_gestalt("segment", DEMO, "--also", "pcd,ply,coco", "--output", self.work)
        self.folder = self.work / DEMO.name

    def test_a_kind_may_be_named_twice(self):
        self.run_gestalt("segment", DEMO, "--also", "pcd,pcd", "--output", self.work / "twice")
        self.assertEqual(read(self.work / "twice" / DEMO.name, "labels.png").shape, (480, 640))

    def test_clouds_have_the_labels(self):
        labels = read(self.folder, "labels.png")
        data = (self.folder / "labelled.pcd").read_bytes().split(b"DATA binary\n", 1)[1]
        cloud = numpy.frombuffer(data, [("xyz", "<f4", 3), ("rgb", "<u4"), ("label", "<u4")]).reshape(480, 640)
        numpy.testing.assert_array_equal(cloud["label"], labels)
        numpy.testing.assert_array_equal(numpy.isnan(cloud["xyz"][..., 2]), depth == 0)
        numpy.testing.assert_allclose(cloud["xyz"][depth > 0], points()[depth > 0], atol=1e-6)
        data = (self.folder / "labelled.ply").read_bytes().split(b"end_header\n", 1)[1]
        vertices = numpy.frombuffer(data, [("xyz", "<f4", 3), ("rgb", "u1", 3), ("label", "<u2")])
        numpy.testing.assert_array_equal(vertices["label"], labels[depth > 0])
        numpy.testing.assert_array_equal(vertices["rgb"], rgb[depth > 0][:, ::-1])

    def test_instances_are_the_objects(self):
        objects_found = read(self.folder, "objects.png")
        coco = json.loads((self.folder / "coco.json").read_text())
        self.assertEqual([(image["width"], image["height"]) for image in coco["images"]], [(640, 480)])
        self.assertEqual({a["id"] for a in coco["annotations"]}, set(numpy.unique(objects_found)) - {0})
        for annotation in coco["annotations"]:
            counts = annotation["segmentation"]["counts"]
            runs = numpy.concatenate([numpy.full(count, i % 2) for i, count in enumerate(counts)])
            mask = runs.reshape(640, 480).T
            numpy.testing.assert_array_equal(mask, objects_found == annotation["id"])
            self.assertEqual(annotation["area"], mask.sum())
            v, u = numpy.nonzero(mask)
            self.assertEqual(annotation["bbox"], [u.min(), v.min(), u.max() - u.min() + 1, v.max() - v.min() + 1])


class Units(FormatsTest):
    """Each remedy that a message gives is followed."""

    def scene(self, numbers, **more):
        folder = self.work / "units"
        folder.mkdir(exist_ok=True)
        cv2.imwrite(str(folder / "depth.png"), numbers.astype(numpy.uint16))
        cv2.imwrite(str(folder / "rgb.png"), rgb)
        (folder / "camera.yaml").write_text(CAMERA + "".join(f"{key}: {value}\n" for key, value in more.items()))
        return folder

    def range_of(self, scene, *options):
        told = json.loads(self.run_gestalt("info", scene, "--json", *options))
        return told["depth_range_m"], told.get("warnings", [])

    def expect_right(self, scene, *options):
        (nearest, farthest), warnings = self.range_of(scene, *options)
        self.assertAlmostEqual(nearest, depth[depth > 0].min() / 1000, delta=0.0011)
        self.assertAlmostEqual(farthest, depth.max() / 1000, delta=0.0011)
        self.assertEqual(warnings, [])

    def test_millimetres_for_metres_are_refused(self):
        file = self.work / "mm.npz"
        numpy.savez(file, depth=depth.astype(numpy.float32), rgb=rgb[..., ::-1], K=K)
        self.refused("mm.npz", "read in m ", "give --unit mm (0.", words=("segment", file, "--output", self.work / "out"))
        self.expect_right(file, "--unit", "mm")
        self.expect_right(file, "--depth-scale", "0.001")
        cloud = self.work / "mm.ply"
        seen = 1000 * points()[depth > 0]
        header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(seen)}\n"
        header += "".join(f"property float {axis}\n" for axis in "xyz") + "end_header\n"
        cloud.write_bytes(header.encode() + seen.astype("<f4").tobytes())
        (self.work / "camera.yaml").write_text(CAMERA)
        self.refused("mm.ply", "give --unit mm (0.", words=("segment", cloud, "--output", self.work / "out"))
        self.expect_right(cloud, "--unit", "mm")

    def test_finer_units_are_a_warning(self):
        for scale, unit in ((10, "0.1mm"), (8.1, "0.125mm")):
            scene = self.scene(depth * scale)
            done = subprocess.run([GESTALT, "segment", scene, "--output", self.work / "out"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0)
            self.assertIn("gestalt: warning: ", done.stderr)
            self.assertIn("--unit 0.1mm", done.stderr)
            result = json.loads((self.work / "out" / "units" / "result.json").read_text())
            self.assertIn("--unit 0.1mm", result["warnings"][0])
            self.assertIn("0.001 m", result["depth_unit"])
        self.expect_right(self.scene(depth * 10), "--unit", "0.1mm")

    def test_whole_metres_and_pictures_are_refused(self):
        self.refused("rounded to metres", "numpy.uint16(1000 * depth)", words=("info", self.scene(numpy.ceil(depth / 1000))))
        self.refused("8-bit picture", words=("info", self.scene(depth // 8 * 257)))
        self.assertIn("scaled to the 16-bit range", self.range_of(self.scene(depth / depth.max() * 65535))[1][0])

    def test_rotated_bits_are_turned_back(self):
        scene = self.scene(depth.astype(int) << 3 | depth >> 13)
        self.refused("--depth-kind rotated", words=("segment", scene, "--output", self.work / "out"))
        self.expect_right(scene, "--depth-kind", "rotated")

    def test_65535_is_no_measurement(self):
        self.expect_right(self.scene(numpy.where(depth > 0, depth, 65535)))

    def test_the_scale_of_a_camera_counts(self):
        camera = self.work / "fine.yaml"
        camera.write_text(CAMERA + "depth_scale: 0.0005\n")
        twice = self.scene(depth * 2)
        self.expect_right(twice, "--camera", camera)
        file = self.work / "twice.npz"
        numpy.savez(file, depth=depth * 2, rgb=rgb[..., ::-1])
        self.expect_right(file, "--camera", camera)
        info = self.work / "info.yaml"
        info.write_text(f"width: 640\nheight: 480\ndistortion_model: plumb_bob\nD: []\nK: {K.ravel().tolist()}\ndepth_scale: 0.0005\n")
        self.expect_right(twice, "--camera", info)

    def test_the_camera_json_of_bop_is_in_millimetres(self):
        camera = self.work / "camera.json"
        keys = {"cx": 319.5, "cy": 239.5, "fx": 525.0, "fy": 525.0, "height": 480, "width": 640}
        camera.write_text(json.dumps({**keys, "depth_scale": 1.0}, indent=2))
        self.expect_right(self.scene(depth), "--camera", camera)
        camera.write_text(json.dumps({**keys, "depth_scale": 0.1}))
        self.expect_right(self.scene(depth * 10), "--camera", camera)
        camera.write_text(json.dumps({**keys, "depth_scale": 0.001}))
        self.expect_right(self.scene(depth), "--camera", camera)

    def test_a_unit_is_a_length(self):
        self.run_gestalt("info", DEMO, "--unit", "furlong", exit_code=2)
        self.run_gestalt("info", DEMO, "--unit", "mm", "--depth-scale", "0.001", exit_code=2)


class Labels(FormatsTest):
    def scene(self, labels=None, name="label.png"):
        folder = self.work / "labelled"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(DEMO, folder)
        (folder / "label.png").unlink()
        if labels is not None:
            (folder / name).parent.mkdir(exist_ok=True)
            cv2.imwrite(str(folder / name), labels)
        return folder

    def scores(self, scene, *options):
        return json.loads(self.run_gestalt("evaluate", scene, "--json", *options))["all"]

    def expect_scores(self, expected, scene, *options):
        found = self.scores(scene, *options)
        self.assertEqual(found.keys(), expected.keys())
        for name, value in expected.items():
            self.assertAlmostEqual(found[name], value, places=9, msg=name)  # sums in the order of the labels

    def test_every_scheme_scores_the_same(self):
        expected = self.scores(self.scene(expected_label.astype(numpy.uint16)))
        self.expect_scores(expected, self.scene(objects.astype(numpy.uint8)))
        self.expect_scores(expected, self.scene(objects.astype(numpy.uint8)), "--labels", "objects")
        colours = numpy.zeros((*objects.shape, 3), numpy.uint8)
        for number in range(1, objects.max() + 1):
            colours[objects == number] = (10 * number, 250 - 10 * number, 90)
        self.expect_scores(expected, self.scene(colours))
        colours[objects == 0] = (1, 2, 3)
        scene = self.scene(colours)
        self.refused("--labels colours", words=("evaluate", scene))
        self.run_gestalt("segment", scene, "--output", self.work / "out")
        self.expect_scores(expected, scene, "--labels", "colours")
        scene = self.scene()
        (scene / "masks").mkdir()
        for number in range(1, objects.max() + 1):
            cv2.imwrite(str(scene / "masks" / f"{number}.png"), numpy.uint8(objects == number) * 255)
        self.expect_scores(expected, scene)
        scene = self.scene()
        annotations = []
        for number in range(1, objects.max() + 1):
            flat = (objects == number).ravel(order="F")
            edges = numpy.flatnonzero(numpy.diff(numpy.concatenate([[False], flat]).astype(int))).tolist()
            counts = numpy.diff([0, *edges, flat.size]).tolist()
            annotations.append({"image_id": 1, "segmentation": {"size": [480, 640], "counts": counts}})
        images = [{"id": 1, "width": 640, "height": 480, "file_name": "rgb.png"}]
        (scene / "coco.json").write_text(json.dumps({"images": images, "annotations": annotations}))
        self.expect_scores(expected, scene)

    def test_where_no_region_would_be_found_there_is_no_score(self):
        nothing = self.scene(numpy.ones_like(objects, numpy.uint8))
        self.refused("no scene has an object", "--labels objects", words=("evaluate", nothing))
        self.refused("no scene has an object", words=("train", nothing, "--output", self.work / "model.json"))

    def test_what_is_not_certain_is_asked_for(self):
        scene = self.scene(numpy.where(objects > 0, 1000 + objects, 0).astype(numpy.uint16))
        self.refused("label.png", "--labels objects or --labels osd", words=("evaluate", scene))
        expected = self.scores(self.scene(objects.astype(numpy.uint8)))
        scene = self.scene(numpy.where(objects > 0, 1000 + objects, 0).astype(numpy.uint16))
        self.expect_scores(expected, scene, "--labels", "objects")
        self.run_gestalt("segment", scene, "--output", self.work / "out")

    def test_segment_never_fails_for_labels(self):
        scene = self.scene()
        (scene / "label.png").write_text("no image")
        done = subprocess.run([GESTALT, "segment", scene, "--output", self.work / "out"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0)
        self.assertIn("label.png", done.stderr)
        self.refused("label.png", words=("train", scene, "--output", self.work / "model.json"))


class Convert(FormatsTest):
    def test_a_layout_that_cannot_be_guessed_is_asked_for(self):
        self.refused("give --from", words=("convert", self.work, "--output", self.work / "out"))

    def test_nothing_is_converted_to_itself(self):
        self.refused("already has the layout of --to", words=("convert", DEMO, "--output", self.work / "out"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
