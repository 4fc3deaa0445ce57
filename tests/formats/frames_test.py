# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""frames_test.py GESTALT SCENE: one frame in the files and layouts that people have it in is read as the scene that it was made of;
what cannot be is refused with what was seen and a remedy, and the remedy is followed here."""

import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import unittest

import cv2
import numpy

import formats_test
from formats_test import CAMERA, DEMO, K, depth, read, rgb

SCANNET = "depthWidth = 640\ndepthHeight = 480\nfx_depth = 525\nfy_depth = 525\nmx_depth = 319.5\nmy_depth = 239.5\n"
SENS = """m_depthWidth = 640
m_depthHeight = 480
m_depthShift = 1000
m_calibrationDepthIntrinsic = 525 0 319.5 0 0 525 239.5 0 0 0 1 0 0 0 0 1
"""
HALF_CAMERA = "width: 320\nheight: 240\nfx: 262.5\nfy: 262.5\ncx: 159.5\ncy: 119.5\n"
metres = (depth / 1000).astype(numpy.float32)


def write(file, image, options=()):
    file.parent.mkdir(parents=True, exist_ok=True)
    if file.suffix == ".npy":
        numpy.save(file, image)
    else:
        assert cv2.imwrite(str(file), image, list(options)), file
    return file


class FramesTest(formats_test.FormatsTest):
    def scene(self, depth_name="depth.png", depth_image=depth, colour_name="rgb.png", colour=rgb, camera=CAMERA):
        folder = self.work / "scene"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        if depth_name:
            write(folder / depth_name, depth_image)
        if colour_name:
            write(folder / colour_name, colour)
        if camera:
            (folder / "camera.yaml").write_text(camera)
        return folder

    def arrays(self, *words):
        """What an input is read as, the only one of it."""
        out = self.work / "arrays"
        shutil.rmtree(out, ignore_errors=True)
        if "npz" in words:
            folder = self.convert(*words)
            camera = dict(re.findall(r"^(\w+): (\S+)", (folder / "camera.yaml").read_text(), re.MULTILINE))
            fx, fy, cx, cy, scale = (float(camera[key]) for key in ("fx", "fy", "cx", "cy", "depth_scale"))
            arrays = {"depth": read(folder, "depth.png"), "depth_scale": scale, "K": [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]}
            return {**arrays, **({"rgb": read(folder, "rgb.png")[..., ::-1]} if (folder / "rgb.png").exists() else {})}
        self.run_gestalt("convert", *words, "--to", "npz", "--output", out)
        (file,) = out.glob("*/*.npz")
        return dict(numpy.load(file))

    def expect_read(self, *words, colour=rgb, atol=0):
        arrays = self.arrays(*words)
        numpy.testing.assert_allclose(arrays["depth"] * arrays["depth_scale"], metres, atol=0.00051)
        numpy.testing.assert_allclose(arrays["K"], K)
        if colour is None:
            self.assertNotIn("rgb", arrays)
        else:
            numpy.testing.assert_allclose(arrays["rgb"][..., ::-1].astype(int), colour.astype(int), atol=atol)

    def info(self, *words):
        return json.loads(self.run_gestalt("info", "--json", *words))


class Colour(FramesTest):
    def test_is_read_from_any_file(self):
        for name, image, atol in (
            ("rgb.jpg", rgb, 40),
            ("rgb.jpeg", rgb, 40),
            ("rgb.tif", rgb, 0),
            ("rgb.ppm", rgb, 0),
            ("rgb.png", rgb.astype(numpy.uint16) * 257, 0),
            ("rgb.png", rgb.astype(numpy.uint16), 0),
            ("rgb.tiff", rgb.astype(numpy.uint16) * 257, 0),
            ("rgb.tiff", (rgb / 255).astype(numpy.float32), 8),  # in LogLuv
            ("rgb.exr", (rgb / 255).astype(numpy.float32), 1),
            ("rgb.png", cv2.cvtColor(rgb, cv2.COLOR_BGR2BGRA), 0),
            ("rgb.tif", cv2.cvtColor(rgb, cv2.COLOR_BGR2BGRA), 0),
        ):
            with self.subTest(name=name, type=image.dtype, channels=image.shape[2]):
                self.expect_read(self.scene(colour_name=name, colour=image), "--from", "scene", atol=atol)

    def test_may_be_grey(self):
        grey = cv2.cvtColor(rgb, cv2.COLOR_BGR2GRAY)
        for name in ("rgb.png", "rgb.pgm", "rgb.tif"):
            self.expect_read(self.scene(colour_name=name, colour=grey), "--from", "scene",
                             colour=cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR))
        self.expect_read(self.scene(colour_name="rgb.jpg", colour=grey), "--from", "scene",
                         colour=cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR), atol=40)

    def test_a_jpeg_is_decoded_as_others_do(self):
        scene = self.scene(colour_name="rgb.jpg")
        self.expect_read(scene, "--from", "scene", colour=cv2.imread(str(scene / "rgb.jpg")), atol=2)

    def test_pixels_are_where_they_are_stored(self):
        plain = self.scene(colour_name="rgb.jpg")
        stored = cv2.imread(str(plain / "rgb.jpg"))
        for order, mark in (("little", b"II*\0"), ("big", b"MM\0*")):
            numbers = [(8, 4), (1, 2), (0x112, 2), (3, 2), (1, 4), (6, 2), (0, 2), (0, 4)]  # one entry: orientation 6
            exif = b"Exif\0\0" + mark + b"".join(number.to_bytes(size, order) for number, size in numbers)
            scene = self.scene(colour_name="rgb.jpg")
            bytes_ = (scene / "rgb.jpg").read_bytes()
            (scene / "rgb.jpg").write_bytes(
                bytes_[:2] + b"\xff\xe1" + (len(exif) + 2).to_bytes(2, "big") + exif + bytes_[2:])
            self.assertEqual(cv2.imread(str(scene / "rgb.jpg")).shape, (640, 480, 3))  # as others turn it
            self.expect_read(scene, "--from", "scene", colour=stored, atol=2)
            self.assertIn("EXIF orientation 6", " ".join(self.info(scene)["notes"]))
            exif = b"Exif\0\0" + mark + b"\xff" * 40  # points nowhere
            (scene / "rgb.jpg").write_bytes(
                bytes_[:2] + b"\xff\xe1" + (len(exif) + 2).to_bytes(2, "big") + exif + bytes_[2:])
            self.assertNotIn("notes", self.info(scene))
        self.assertNotIn("notes", self.info(self.scene()))

    def test_has_the_names_that_people_give_it(self):
        for depth_name, name in (("depth.png", "color.png"), ("depth.png", "colour.png"), ("Depth.png", "Color.png"),
                                 ("DEPTH.PNG", "RGB.PNG"), ("depth.png", "Rgb.JPG")):
            with self.subTest(name):
                self.expect_read(self.scene(depth_name=depth_name, colour_name=name), "--from", "scene",
                                 atol=40 if name.endswith("JPG") else 0)

    def test_goes_by_content_not_by_name(self):
        scene = self.scene(colour_name="rgb.jpg")
        (scene / "rgb.jpg").rename(scene / "rgb.png")
        self.expect_read(scene, "--from", "scene", atol=40)

    def test_two_of_them_are_refused(self):
        scene = self.scene(colour_name="color.png")
        write(scene / "colour.png", rgb)
        self.refused("colour.png", "color.png", "could both be", words=("info", scene))
        (scene / "colour.png").unlink()
        self.info(scene)

    def test_damage_is_refused(self):
        scene = self.scene(colour_name="rgb.jpg")
        whole = (scene / "rgb.jpg").read_bytes()
        for cut in (3, 20, len(whole) // 2, len(whole) - 2):
            (scene / "rgb.jpg").write_bytes(whole[:cut])
            self.refused("rgb.jpg", "is not a complete JPEG image", words=("info", scene))
        scene = self.scene(colour_name="rgb.tif")
        whole = (scene / "rgb.tif").read_bytes()
        for cut in (8, 1000, len(whole) // 2):
            (scene / "rgb.tif").write_bytes(whole[:cut])
            self.refused("rgb.tif", words=("info", scene))

    def test_what_claims_too_much_is_refused(self):
        for name, content in (
            ("rgb.ppm", b"P6\n100000 100000\n255\n" + bytes(100)),
            ("rgb.tif", b"II*\0\x08\0\0\0\x02\0" + b"".join(
                tag.to_bytes(2, "little") + b"\x04\0\x01\0\0\0" + (1 << 20).to_bytes(4, "little") for tag in (256, 257))),
        ):
            scene = self.scene(colour_name=None)
            (scene / name).write_bytes(content)
            self.refused(name, "images of 1 to 2^26 pixels can be read", words=("info", scene))

    def test_what_is_no_image_is_named(self):
        scene = self.scene(colour_name=None)
        for content, told in ((b"RIFF0000WEBPVP8 ", "a WebP image"), (b"\0\0\0\x18ftypheic", "HEIC"), (b"GIF89a", "a GIF"),
                              (b"", "is empty"), (b"version https://git-lfs.github.com/spec/v1", "git lfs pull")):
            (scene / "rgb.png").write_bytes(content + bytes(20) if content else content)
            self.refused("rgb.png", told, words=("info", scene))


class Depth(FramesTest):
    def test_is_read_from_any_file(self):
        for name, image in (
            ("depth.tiff", depth),
            ("depth.tif", metres),
            ("depth.tif", metres.astype(numpy.float64)),
            ("depth.pgm", depth),
            ("depth.pfm", metres),
            ("depth.exr", metres),
            ("depth.exr", cv2.merge([metres] * 3)),
            ("depth.npy", depth),
            ("depth.npy", depth.astype(numpy.int64)),
            ("depth.npy", metres),
            ("depth.npy", metres[..., None]),
            ("depth.npy", numpy.asfortranarray(metres)),
            ("depth.npy", metres.astype(">f4")),
        ):
            with self.subTest(name=name, type=image.dtype):
                self.expect_read(self.scene(depth_name=name, depth_image=image), "--from", "scene")

    def test_goes_by_content_not_by_name(self):
        scene = self.scene(depth_name="depth.tiff")
        (scene / "depth.tiff").rename(scene / "depth.png")
        self.expect_read(scene, "--from", "scene")

    def exr(self, scene, channel, name):
        """The file of a scene, with a channel of OpenCV's renamed."""
        file = scene / "depth.exr"
        content = file.read_bytes()
        at = content.index(channel + b"\0", content.index(b"chlist\0") + 11)
        file.write_bytes(content[:at] + name + content[at + 1:])
        return scene

    def test_the_channel_z_of_a_renderer_is_depth(self):
        only = self.scene(depth_name="depth.exr", depth_image=metres)
        self.expect_read(self.exr(only, b"Y", b"Z"), "--from", "scene")
        self.expect_read(self.exr(only, b"Z", b"V"), "--from", "scene")
        many = numpy.dstack([metres * 0 + 0.25, metres * 0 + 0.5, metres])  # blue green red
        self.expect_read(self.exr(self.scene(depth_name="depth.exr", depth_image=many), b"R", b"Z"), "--from", "scene")
        whole = (only / "depth.exr").read_bytes()
        channels = b"".join(b"%03d\0" % i + struct.pack("<i4xii", 2, 1, 1) for i in range(300)) + b"\0"
        at = whole.index(b"chlist\0") + 7
        end = at + 4 + int.from_bytes(whole[at:at + 4], "little")
        (only / "depth.exr").write_bytes(whole[:at] + struct.pack("<i", len(channels)) + channels + whole[end:])
        self.refused("depth.exr: has 300 channels of 640 columns", words=("info", only))
        for cut in (100, 400, len(whole) // 2, len(whole) - 10):
            (only / "depth.exr").write_bytes(whole[:cut])
            self.refused("depth.exr", words=("info", only))

    def test_a_picture_of_it_is_refused(self):
        picture = (depth >> 4).astype(numpy.uint8)
        for name, image in (("depth.tif", picture), ("depth.pgm", picture), ("depth.tif", rgb), ("depth.ppm", rgb)):
            self.refused(name, "depth must be 16-bit grey", words=("info", self.scene(depth_name=name, depth_image=image)))
        self.refused("depth.jpg", "alters depth values", words=("info", self.scene(depth_name="depth.jpg", depth_image=picture)))

    def test_where_it_is_missing_is_told_with_what_is_there(self):
        scene = self.scene(depth_name=None, colour_name="rgb.jpg")
        self.refused("camera.yaml and rgb.jpg are there, but no depth image", "depth.png", words=("info", scene))
        write(scene / "depth.png", depth)
        self.info(scene)


class Npz(FramesTest):
    def npz(self, **arrays):
        file = self.work / "mine.npz"
        numpy.savez_compressed(file, **arrays)
        return file

    def test_depth_of_any_numbers_and_order(self):
        for image in (metres[..., None], metres[None], metres.astype(numpy.float64), numpy.asfortranarray(metres),
                      metres.astype(">f4"), metres.astype(">f8"), depth.astype(">u2"), numpy.asfortranarray(depth),
                      numpy.where(depth, metres, numpy.inf)):
            with self.subTest(type=image.dtype, shape=image.shape):
                self.expect_read(self.npz(depth=image, rgb=rgb[..., ::-1], K=K), "--from", "npz")

    def test_depth_of_half_precision(self):
        arrays = self.arrays(self.npz(depth=metres.astype(numpy.float16), rgb=rgb[..., ::-1], K=K), "--from", "npz")
        expected = numpy.round(metres.astype(numpy.float16).astype(float) * 1000)
        numpy.testing.assert_array_equal(arrays["depth"], expected)

    def test_colour_of_any_kind_and_name(self):
        right = rgb[..., ::-1]
        for name, image in (
            ("color", right), ("colour", right), ("image", right), ("rgb", numpy.asfortranarray(right)),
            ("rgb", right / 255), ("rgb", (right / 255).astype(numpy.float32)), ("rgb", right.astype(numpy.float32)),
            ("rgb", right.astype(numpy.int64)), ("rgb", right.astype(numpy.uint16) * 257), ("rgb", right.transpose(2, 0, 1)),
            ("rgb", numpy.dstack([right, numpy.full_like(depth, 255).astype(numpy.uint8)])),
        ):
            with self.subTest(name=name, type=image.dtype, shape=image.shape):
                self.expect_read(self.npz(depth=metres, K=K, **{name: image}), "--from", "npz")
        grey = cv2.cvtColor(rgb, cv2.COLOR_BGR2GRAY)
        for image in (grey, grey[..., None]):
            self.expect_read(self.npz(depth=metres, rgb=image, K=K), "--from", "npz", colour=cv2.merge([grey] * 3))
        self.expect_read(self.npz(depth=metres, K=K), "--from", "npz", colour=None)

    def test_colour_of_no_range_is_refused(self):
        self.refused("array 'rgb' has values from", words=("info", self.npz(depth=metres, rgb=rgb / 255 - 0.5, K=K)))

    def test_k_of_any_shape_and_name(self):
        wide = numpy.hstack([K, numpy.zeros((3, 1))])
        square = numpy.vstack([wide, [0, 0, 0, 1]])
        for name, k in (("K", K.ravel()), ("K", wide), ("K", square), ("K", K[None]), ("K", K.T.ravel()), ("cam_K", K),
                        ("intrinsics", K.astype(numpy.float32)), ("camera_matrix", numpy.asfortranarray(K))):
            with self.subTest(name=name, shape=k.shape):
                self.expect_read(self.npz(depth=metres, rgb=rgb[..., ::-1], **{name: k}), "--from", "npz")
        for k in (K * 2, K[:2], K + numpy.eye(3)[::-1]):
            self.refused("array 'K'", words=("info", self.npz(depth=metres, rgb=rgb[..., ::-1], K=k)))

    def test_without_k_the_remedy_works(self):
        file = self.npz(depth=metres, rgb=rgb[..., ::-1])
        self.refused("has no array 'K'", "--camera FILE", words=("info", file))
        (self.work / "my.yaml").write_text(CAMERA)
        self.expect_read(file, "--from", "npz", "--camera", self.work / "my.yaml")

    def test_colour_with_more_pixels_of_the_same_view_brings_its_k(self):
        half = metres[::2, ::2]
        file = self.npz(depth=half, rgb=rgb[..., ::-1], K=K)
        told = self.info(file)
        self.assertEqual([told["width"], told["camera"]["fx"]], [320, 262.5])
        self.assertEqual(len(told["warnings"]), 2, told["warnings"])
        quarter = metres[::4, ::4]
        self.refused("array 'K' has its principal point outside", "about 3.99 times", words=(
            "info", self.npz(depth=quarter, rgb=rgb[::4, ::4, ::-1], K=K)))
        self.refused("register one to the other", words=("info", self.npz(depth=half, rgb=rgb[:300, :, ::-1], K=K / [[2], [2], [1]])))

    def test_a_dictionary_becomes_arrays_by_the_remedy(self):
        file = self.work / "dict.npy"
        numpy.save(file, dict(depth=metres, rgb=rgb[..., ::-1], K=K), allow_pickle=True)
        error = self.run_gestalt("info", file, exit_code=3)
        remedy = "numpy.savez_compressed('scene.npz', **numpy.load(FILE, allow_pickle=True).item())"
        self.assertIn(remedy, error)
        scene = self.work / "scene.npz"
        exec(remedy.replace("FILE", "file").replace("'scene.npz'", "scene"), {"numpy": numpy, "file": file, "scene": scene})
        self.expect_read(scene, "--from", "npz")

    def test_no_header_takes_the_stack(self):
        header = b"{'descr': '<f4', 'fortran_order': False, 'shape': (" + b"1," * 30000 + b"), }"
        for text in (header, b"'" * 60000, b"{'descr': '<f4' " + b"(" * 60000, b"{'descr':'", b"{'descr': '<f4', 'shape': (1"):
            file = self.work / "deep.npy"
            file.write_bytes(b"\x93NUMPY\x01\0" + min(len(text), 65535).to_bytes(2, "little") + text[:65535])
            self.refused("deep.npy", words=("info", file))


class Layouts(FramesTest):
    def recording(self, depth_file, colour_file, camera_file=None, camera=CAMERA):
        folder = self.work / "recording"
        shutil.rmtree(folder, ignore_errors=True)
        write(folder / depth_file, depth)
        write(folder / colour_file, rgb)
        if camera_file:
            (folder / camera_file).parent.mkdir(exist_ok=True)
            (folder / camera_file).write_text(camera)
        return folder

    def test_folders_and_names(self):
        matrix = "525 0 319.5\n0 525 239.5\n0 0 1\n"
        four = "525 0 319.5 0\n0 525 239.5 0\n0 0 1 0\n0 0 0 1\n"
        for names in (
            ("depth/00001.png", "color/00001.jpg", "camera.yaml", CAMERA),  # Redwood
            ("depth/0000001-000000033369.png", "rgb/0000001-000000033100.jpg", "camera.yaml", CAMERA),
            ("depth/0000001.png", "rgb/0000001.png", "cam_K.txt", matrix),  # FoundationPose
            ("depth/0.png", "color/0.jpg", "intrinsic/intrinsic_depth.txt", four),  # ScanNet
            ("frame-000000.depth.png", "frame-000000.color.png", "camera-intrinsics.txt", matrix),  # 7-Scenes
            ("0001_depth.png", "0001_rgb.png", "camera.yaml", CAMERA),
            ("0001-depth.png", "0001.png", "camera.yaml", CAMERA),
            ("Depth/1.PNG", "RGB/1.PNG", "K.txt", matrix),
            ("depth_aligned/1.png", "images/1.png", "camera.yaml", CAMERA),
            ("depth/0.png", "color/0.jpg", "recording.txt", SCANNET),  # scene0000_00/scene0000_00.txt
            ("frame-000000.depth.pgm", "frame-000000.color.jpg", "_info.txt", SENS),  # 3RScan
        ):
            with self.subTest(names[:3]):
                folder = self.recording(*names)
                (folder / ".hidden_depth.png").write_bytes(b"")
                self.expect_read(folder, "--from", "frame", atol=40 if names[1].endswith("jpg") else 0)
                self.assertEqual(self.info(folder)["kind"], "recording")
                self.expect_read(folder / names[0], "--from", "frame", atol=40 if names[1].endswith("jpg") else 0)

    def test_lists_tell_what_belongs_together(self):
        for line in ("1.00 rgb/7.png 1.01 depth/8.png", "1.01 depth/8.png 1.00 rgb/7.png"):
            folder = self.recording("depth/8.png", "rgb/7.png", "camera.yaml")
            (folder / "associations.txt").write_text("# comment\n" + line + "\n")
            self.expect_read(folder, "--from", "frame")
            self.expect_read(folder)
        (folder / "associations.txt").write_text("1 a.png 2 b.png\n")
        self.refused("associations.txt:1: cannot tell which of the two is the depth image;", words=("info", folder))

    def test_a_sequence_like_tums_with_its_own_camera(self):
        folder = self.recording("depth/8.png", "rgb/7.png", "camera.yaml", CAMERA + "depth_scale: 0.001\n")
        for name in ("rgb/7.png", "depth/8.png"):
            (folder / (name.split("/")[0] + ".txt")).write_text("1.0 " + name + "\n")
        self.expect_read(folder, "--from", "tum")
        self.expect_read(folder, "--from", "frame")

    def test_a_sequence_of_tum_by_itself(self):
        folder = self.recording("depth/8.png", "rgb/7.png")
        write(folder / "depth/8.png", depth * 5)
        for name in ("rgb/7.png", "depth/8.png"):
            (folder / (name.split("/")[0] + ".txt")).write_text("1.0 " + name + "\n")
        told = self.info(folder)["first"]
        self.assertEqual(told["camera"]["fx"], 525)
        self.assertIn("TUM", " ".join(told["warnings"]))
        self.expect_read(folder, "--from", "frame")

    def test_bop_with_jpeg(self):
        folder = self.work / "train_pbr" / "000000"
        write(folder / "rgb/000003.jpg", rgb)
        write(folder / "depth/000003.png", depth * 10)
        (folder / "scene_camera.json").write_text(json.dumps({"3": {"cam_K": K.ravel().tolist(), "depth_scale": 0.1}}))
        for words in ((folder, "--from", "bop"), (folder.parent, "--from", "bop"), (folder, "--from", "frame"),
                      (folder.parent, "--from", "frame")):
            self.expect_read(*words, atol=40)

    def test_colours_whose_names_do_not_tell(self):
        folder = self.recording("depth/a.png", "rgb/b.png", "camera.yaml")
        self.refused("the names do not tell", "associations.txt", words=("info", folder))
        (folder / "associations.txt").write_text("0 rgb/b.png 0 depth/a.png\n")
        self.expect_read(folder, "--from", "frame")

    def test_without_a_camera_what_was_seen_is_told(self):
        folder = self.recording("depth/1.png", "color/1.jpg")
        self.refused("has no camera (color and depth are in", "--camera FILE", words=("info", folder))
        (self.work / "my.yaml").write_text(CAMERA)
        self.expect_read(folder, "--from", "frame", "--camera", self.work / "my.yaml", atol=40)
        words = ("--fx", 525, "--fy", 525, "--cx", 319.5, "--cy", 239.5)
        self.expect_read(folder, "--from", "frame", *words, atol=40)

    def test_a_folder_without_scenes_tells_what_it_has(self):
        (self.work / "empty").mkdir()
        self.refused("contains no scene (nothing is there)", words=("info", self.work / "empty"))
        (self.work / "empty" / "notes.txt").write_text("")
        self.refused("contains no scene (notes.txt is there)", words=("info", self.work / "empty"))


class OneLine(FramesTest):
    def setUp(self):
        super().setUp()
        self.camera = self.work / "camera.yaml"
        self.camera.write_text(CAMERA)

    def test_a_frame_needs_no_folder(self):
        colour, image = write(self.work / "c.jpg", rgb), write(self.work / "d.png", depth)
        for words in (("--rgb", colour, "--depth", image), (colour, image), (image, colour)):
            told = self.info(*words)
            self.assertEqual([told["name"], told["colour_from"]], ["d", str(colour)])
            self.run_gestalt("segment", *words, "--output", self.work / "out")
            self.assertTrue((self.work / "out" / "d" / "labels.png").exists())
        array = self.work / "e.npz"
        numpy.savez(array, depth=metres)
        for image in (write(self.work / "f.npy", metres), write(self.work / "g.exr", metres), write(self.work / "h.pgm", depth),
                      array):
            self.assertTrue(self.info("--rgb", colour, "--depth", image)["colour"])

    def test_a_depth_image_is_not_its_own_colour(self):
        for name in ("d.png", "d.tiff"):
            write(self.work / name, depth)
        write(self.work / "depth" / "1.png", depth)
        for file in (self.work / "d.png", self.work / "d.tiff", self.work / "depth" / "1.png"):
            for path in (file, os.path.relpath(file)):
                self.assertFalse(self.info(path)["colour"], path)
        write(self.work / "d.jpg", rgb)
        self.assertEqual(self.info(os.path.relpath(self.work / "d.tiff"))["colour_from"], str(self.work / "d.jpg"))

    def test_what_is_not_clear_is_refused(self):
        colour, image = write(self.work / "c.jpg", rgb), write(self.work / "d.png", depth)
        self.refused("c.jpg: no depth image", "--depth FILE --rgb", words=("segment", colour, "--output", self.work / "out"))
        self.assertIn("is required", self.run_gestalt("segment", exit_code=2))
        self.assertIn("remove the other inputs", self.run_gestalt("segment", image, "--depth", image, exit_code=2))
        self.run_gestalt("segment", "--rgb", colour, exit_code=2)

    def test_the_picture_shows_colour_beside_depth(self):
        file = self.work / "picture.png"
        self.run_gestalt("info", DEMO, "--picture", file)
        picture = cv2.imread(str(file))
        self.assertEqual(picture.shape, (480, 1280, 3))
        numpy.testing.assert_array_equal(picture[:, :640], rgb)
        self.assertFalse(picture[:, 640:][depth == 0].any())
        near, far = numpy.percentile(depth[depth > 0], [2, 98])
        self.assertGreater(picture[:, 640:][(depth > 0) & (depth < near)][:, 2].mean(), 80)  # red
        self.assertGreater(picture[:, 640:][depth > far][:, 0].mean(), 40)  # blue


class Sizes(FramesTest):
    def test_the_same_view_is_resampled_and_told(self):
        scene = self.scene(colour=cv2.resize(rgb, (1280, 960), interpolation=cv2.INTER_NEAREST))
        told = self.info(scene)
        self.assertIn("rgb.png: is 1280x960, depth.png is 640x480", told["warnings"][0])
        self.expect_read(scene, "--from", "scene")

    def test_the_same_view_may_be_cut_a_little_as_in_scannet(self):
        self.assertIn("1296x968", self.info(self.scene(colour=cv2.resize(rgb, (1296, 968))))["warnings"][0])

    def test_another_view_is_registered_with_both_cameras(self):
        # The colour camera stands 10 cm to the right and has other intrinsics; colours follow from the points' positions.
        wide = numpy.zeros((480, 800, 3), numpy.uint8)
        wide[:, 400:] = 200
        flat = numpy.full_like(depth, 1000)
        scene = self.scene(depth_image=flat, colour=wide)
        self.refused("rgb.png: is 800x480, depth.png is 640x480", "camera_color.yaml", "extrinsics.txt", words=("info", scene))
        (scene / "camera_color.yaml").write_text("width: 800\nheight: 480\nfx: 525\nfy: 525\ncx: 399.5\ncy: 239.5\n")
        for extrinsics, edge in ((None, 320), ("1 0 0 -0.1\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", 372)):
            if extrinsics:
                (scene / "extrinsics.txt").write_text(extrinsics)
            colour = self.arrays(scene, "--from", "scene")["rgb"]
            bright = numpy.nonzero(colour[240, :, 0] > 100)[0]
            self.assertAlmostEqual(bright.min(), edge, delta=1)
        (scene / "extrinsics.txt").write_text("1 0 0 -100\n0 1 0 0\n0 0 1 0\n")
        self.refused("extrinsics.txt", "more than 2 m", words=("info", scene))
        (scene / "extrinsics.txt").write_text("1 0 0\n")
        self.refused("extrinsics.txt: has 3 numbers", words=("info", scene))

    def test_taking_the_colour_away_helps_too(self):
        scene = self.scene(colour=rgb[:300])
        self.refused("remove the colour image", words=("info", scene))
        (scene / "rgb.png").unlink()
        self.expect_read(scene, "--from", "scene", colour=None)


class Beside(FramesTest):
    def test_colour_beside_a_cloud_or_arrays_is_theirs(self):
        self.run_gestalt("convert", self.scene(colour_name=None), "--to", "pcd", "--output", self.work / "pcd")
        (cloud,) = (self.work / "pcd").glob("*/*.pcd")
        array = self.work / "a.npz"
        numpy.savez(array, depth=metres, K=K)
        for file in (cloud, array):
            self.assertFalse(self.info(file)["colour"])
            write(file.with_suffix(".jpg"), rgb)
            told = self.info(file)
            self.assertEqual([told["colour"], told["colour_from"]], [True, str(file.with_suffix(".jpg"))])
            write(file.with_suffix(".jpg"), rgb[:300])
            told = self.info(file)
            self.assertFalse(told["colour"])
            self.assertIn("640x300", " ".join(told["warnings"]))


class DepthOnly(FramesTest):
    def test_a_scene_without_colour_is_segmented_by_depth(self):
        scene = self.scene(colour_name=None)
        done = self.segment(scene, DEMO)
        self.assertIn("has no colour image; segmented by depth alone", done)
        result = json.loads((self.work / "out" / "scene" / "result.json").read_text())
        self.assertIn("depth_only.json", json.dumps(result["config"]))
        self.assertIn("depth alone", " ".join(result["notes"]))
        other = json.loads((self.work / "out" / DEMO.name / "result.json").read_text())
        self.assertNotIn("depth_only.json", json.dumps(other["config"]))
        self.assertEqual(other["notes"], [])
        self.assertIn("already done, skipped", self.run_gestalt("segment", scene, "--resume", "--output", self.work / "out"))

    def test_who_asks_for_a_config_gets_it(self):
        scene = self.scene(colour_name=None)
        for words in (("--config", "default.yaml"), ("--set", "model=default.json")):
            self.refused("has no colour image", words=("segment", scene, *words, "--output", self.work / "out"))
        self.run_gestalt("segment", scene, "--config", "depth_only.yaml", "--output", self.work / "out")

    def segment(self, *scenes):
        done = subprocess.run([formats_test.GESTALT, "segment", *scenes, "--output", self.work / "out"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr


if __name__ == "__main__":
    unittest.main(argv=formats_test.sys.argv[:1])
