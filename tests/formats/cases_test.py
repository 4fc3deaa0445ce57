# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""cases_test.py GESTALT SCENE: a row for every kind of input that people have. Each is the scene in other files: `gestalt segment`
finds the objects that it finds in the scene folder, or says what is wrong; what it names as the remedy is then done literally, and
the objects are found. What the readers do in detail, formats_test.py and frames_test.py tell."""

import json
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest
from typing import Callable, NamedTuple

import cv2
import numpy

import formats_test
from formats_test import DEMO, GESTALT
from frames_test import write

# Half of the pixels, for the time that it takes.
mm, bgr = (formats_test.read(DEMO, name)[::2, ::2].copy() for name in ("depth.png", "rgb.png"))
height, width = mm.shape
f, cx, cy = 262.5, 159.75, 119.75
K = numpy.array([[f, 0, cx], [0, f, cy], [0, 0, 1]])
NINE = K.ravel().tolist()
CAMERA = f"width: {width}\nheight: {height}\nfx: {f}\nfy: {f}\ncx: {cx}\ncy: {cy}\n"
metres = (mm / 1000).astype(numpy.float32)
grey = cv2.cvtColor(bgr, cv2.COLOR_BGR2GRAY)
v, u = numpy.indices(mm.shape)
rays = numpy.dstack([(u - cx) / f, (v - cy) / f, numpy.ones(mm.shape)])
points = (rays * metres[..., None]).astype(numpy.float32)
points[mm == 0] = numpy.nan
# An L515 has less noise than the sensor that this scene is made with.
quarters = numpy.rint(numpy.where(mm, cv2.bilateralFilter(mm.astype("f4") * 4, 7, 60, 3), 0)).astype("u2")


class Case(NamedTuple):
    kind: str
    write: Callable  # makes the input in a folder, gives the words for `gestalt segment`
    told: str | None = None  # part of what it says: an error without objects, else a warning or a note
    refused: bool = False
    remedy: str | Callable | None = None  # expression of the option in the message; or what does in the folder as it says


def scene(depth=mm, colour=bgr, camera=CAMERA, depth_name="depth.png", colour_name="rgb.png", more=()):
    def make(folder):
        folder = folder / "scene"
        write(folder / depth_name, depth)
        if colour is not None:
            write(folder / colour_name, colour)
        if camera:
            (folder / "camera.yaml").write_text(camera)
        for name, content in dict(more).items():
            write(folder / name, content) if isinstance(content, numpy.ndarray) else (folder / name).write_text(content)
        return [folder]

    return make


def camera_file(name, text):
    def make(folder):
        (folder / name).write_text(text)
        return [*scene(camera=None)(folder), "--camera", folder / name]

    return make


def npz(**arrays):
    def make(folder):
        numpy.savez(folder / "scene.npz", **arrays)
        return [folder / "scene.npz"]

    return make


def recording(depth_file, colour_file, camera=("camera.yaml", CAMERA), depth=mm, more=()):
    def make(folder):
        folder = folder / "recording"
        write(folder / depth_file, depth)
        write(folder / colour_file, bgr)
        for name, text in (camera, *more):
            (folder / name).parent.mkdir(exist_ok=True)
            (folder / name).write_text(text)
        return [folder]

    return make


def images(depth_name, depth, *words):
    def make(folder):
        write(folder / "c.jpg", bgr, [cv2.IMWRITE_JPEG_QUALITY, 98])
        write(folder / depth_name, depth)
        return [folder / word if word in ("c.jpg", depth_name) else word for word in words] + [
            "--fx", f, "--cx", cx, "--cy", cy]  # fmt: skip

    return make


def pcd(xyz=points, fields="rgb", size=(width, height), version="0.7", viewpoint="0 0 0 1 0 0 0", camera=None, scale=1):
    def make(folder):
        flat = (xyz * scale).reshape(-1, 3).astype("<f4")
        kinds = {"rgb": [("rgb", "<u4", "4", "U", 1)], "three": [(c, "u1", "1", "U", 1) for c in ("r", "g", "b")],
                 "count0": [("t", "<u4", "4", "U", 0), ("rgb", "<u4", "4", "U", 1)], "none": []}[fields]  # fmt: skip
        rows = [("x", "<f4", "4", "F", 1), ("y", "<f4", "4", "F", 1), ("z", "<f4", "4", "F", 1), *kinds]
        table = numpy.zeros(len(flat), [(name, kind) for name, kind, *_, count in rows if count])
        for i, name in enumerate("xyz"):
            table[name] = flat[:, i]
        channels = bgr.reshape(-1, 3).astype(numpy.uint32)
        if fields == "three":
            table["b"], table["g"], table["r"] = channels.T
        elif kinds:
            table["rgb"] = channels[:, 2] << 16 | channels[:, 1] << 8 | channels[:, 0]
        if size[1] == 1:
            table = table[~numpy.isnan(flat[:, 0])]
        lines = [("VERSION", version)]
        lines += [(key, " ".join(str(row[i]) for row in rows)) for key, i in (("FIELDS", 0), ("SIZE", 2), ("TYPE", 3), ("COUNT", 4))]
        lines += [("WIDTH", len(table) if size[1] == 1 else size[0]), ("HEIGHT", size[1]), ("VIEWPOINT", viewpoint), ("POINTS", len(table))]
        header = "".join(f"{key} {value}\n" for key, value in lines) + "DATA binary\n"
        (folder / "scene.pcd").write_bytes(header.encode() + table.tobytes())
        if camera:
            (folder / "camera.yaml").write_text(camera)
        return [folder / "scene.pcd"]

    return make


def ply(xyz=points, order="<", names=("red", "green", "blue"), kind="uchar", before="", ascii_lines=False, camera=CAMERA):
    def make(folder):
        seen = mm.ravel() > 0
        flat, colours = xyz.reshape(-1, 3)[seen], bgr.reshape(-1, 3)[seen][:, ::-1]
        colours = colours / 255 if kind == "float" else colours
        table = numpy.zeros(len(flat), [(c, order + "f4") for c in "xyz"] + [(n, order + "f4" if kind == "float" else "u1") for n in names])
        for i, name in enumerate(("x", "y", "z", *names)):
            table[name] = flat[:, i] if i < 3 else colours[:, i - 3]
        form = "ascii" if ascii_lines else "binary_little_endian" if order == "<" else "binary_big_endian"
        header = f"ply\nformat {form} 1.0\n" + ("element camera 1\nproperty float view\n" if before else "") + f"element vertex {len(flat)}\n"
        header += "".join(f"property float {c}\n" for c in "xyz") + "".join(f"property {kind} {n}\n" for n in names) + "end_header\n"
        if ascii_lines:
            body = "".join(f"{x} {y} {z}\n{r} {g} {b}\n" for (x, y, z), (r, g, b) in zip(flat, colours)).encode()
        else:
            body = (struct.pack(order + "f", 1) if before else b"") + table.tobytes()
        (folder / "scene.ply").write_bytes(header.encode() + body)
        if camera:
            (folder / "camera.yaml").write_text(camera)
        return [folder / "scene.ply"]

    return make


def beside(folder):
    write(folder / "scene.png", bgr)
    return pcd(fields="none")(folder)


def write_metres(folder):
    write(folder / "scene" / "depth.png", numpy.uint16(1000 * metres))  # as the message says


def write_colour_camera(folder):
    wide = CAMERA.replace(f"width: {width}", f"width: {width + 80}").replace(f"cx: {cx}", f"cx: {cx + 40}")
    (folder / "scene" / "camera_color.yaml").write_text(wide)


def write_camera(folder):
    (folder / "recording" / "camera.yaml").write_text(CAMERA)


def associations(*order):
    return ("associations.txt", "1.0 {} 1.01 {}\n".format(*order))


turn = numpy.array([[0.36, -0.8, 0.48], [0.8, 0.0, -0.6], [0.48, 0.6, 0.64]])  # a rotation
framed = cv2.copyMakeBorder(bgr, 0, 0, 40, 40, cv2.BORDER_CONSTANT)
ROWS = "".join(f"{a} {b} {c}\n" for a, b, c in K)
SIZED = {"width": width, "height": height}
right_of = bgr[..., ::-1]
plain_lens = "distortion_model: plumb_bob\n"
info_of_ros = f"width: {width}\nheight: {height}\nk: {NINE}\n"

CASES = [
    # Units
    Case("millimetres", scene()),
    Case("65535 for no measurement", scene(numpy.where(mm == 0, numpy.uint16(65535), mm))),
    Case("floats in millimetres, npz", npz(depth=mm.astype("f4"), rgb=right_of, K=K), "outside the range of depth sensors", True, r"--unit mm"),
    Case("a cloud in millimetres, PCD", pcd(scale=1000), "outside the range of depth sensors", True, r"--unit mm"),
    Case("a cloud in millimetres, PLY", ply(points * 1000), "outside the range of depth sensors", True, r"--unit mm"),
    Case("0.1 mm", scene(mm * numpy.uint16(10)), "--unit 0.1mm", False, r"--unit 0\.1mm"),
    Case("0.25 mm (L515)", scene(quarters), "--unit", False, r"--unit 0\.25mm"),
    Case("0.2 mm (TUM)", scene(mm * numpy.uint16(5)), "--unit", False, r"--unit 0\.2mm"),
    Case("rounded to metres", scene(numpy.round(metres).astype("u2")), "rounded to metres", True, write_metres),
    Case("depth scaled to its type", scene((mm * (65535 / mm.max())).astype("u2")), "warning"),
    Case("SUN RGB-D's bits", scene(mm << 3 | mm >> 13), "rotated", True, r"--depth-kind rotated"),
    # Whether it is that, depth_plausibility_test.cpp asks of planes.
    Case("distance from the camera", lambda folder: [*scene(numpy.rint(mm * numpy.linalg.norm(rays, axis=2)).astype("u2"))(folder), "--depth-kind", "radial"]),
    # The scale of depth
    Case("depth_scale of camera.yaml", scene(mm * numpy.uint16(10), camera=CAMERA + "depth_scale: 0.0001\n")),
    Case("depth_scale of arrays", npz(depth=mm * numpy.uint16(10), rgb=right_of, K=K, depth_scale=0.0001)),
    Case("BOP's camera.json, 1 mm", camera_file("camera.json", json.dumps({**SIZED, "fx": f, "fy": f, "cx": cx, "cy": cy, "depth_scale": 1.0}))),
    # Cameras
    Case("our YAML", camera_file("my.yaml", CAMERA)),
    Case("numbers", lambda folder: [*scene(camera=None)(folder), "--fx", f, "--fy", f, "--cx", cx, "--cy", cy]),
    Case("ROS 2", camera_file("info.yaml", info_of_ros + plain_lens + "d: [0.0, 0.0, 0.0, 0.0, 0.0]\n")),
    Case("ROS 1", camera_file("info.yaml", info_of_ros.replace("k:", "K:") + plain_lens + "D: []\n")),
    Case("OpenCV", camera_file("calibration.yaml", f"%YAML:1.0\n---\nimage_width: {width}\nimage_height: {height}\ncamera_matrix: !!opencv-matrix\n"
                               f"   rows: 3\n   cols: 3\n   dt: d\n   data: {NINE}\n")),
    Case("Open3D", camera_file("open3d.json", json.dumps({**SIZED, "intrinsic_matrix": K.T.ravel().tolist()}))),
    Case("RealSense", camera_file("rs.json", json.dumps({"depth": {**SIZED, "fx": f, "fy": f, "ppx": cx, "ppy": cy, "coeffs": [0] * 5}}))),
    Case("cam_K", camera_file("k.json", json.dumps({"cam_K": NINE}))),
    Case("K as text", camera_file("K.txt", ROWS)),
    Case("COLMAP", camera_file("cameras.txt", f"# cameras\n1 PINHOLE {width} {height} {f} {f} {cx + 0.5} {cy + 0.5}\n")),
    Case("ORB-SLAM", camera_file("orb.yaml", f"%YAML:1.0\nCamera.fx: {f}\nCamera.fy: {f}\nCamera.cx: {cx}\nCamera.cy: {cy}\n")),
    Case("kalibr", camera_file("chain.yaml", f"cam0:\n  camera_model: pinhole\n  intrinsics: [{f}, {f}, {cx}, {cy}]\n  resolution: [{width}, {height}]\n")),
    Case("ARKit", camera_file("arkit.json", json.dumps({"intrinsics": K.T.ravel().tolist()}))),
    Case("ScanNet", camera_file("scan.txt", f"depthWidth = {width}\ndepthHeight = {height}\nfx_depth = {f}\nfy_depth = {f}\nmx_depth = {cx}\nmy_depth = {cy}\n")),
    Case("another resolution", camera_file("twice.yaml", f"width: {2 * width}\nheight: {2 * height}\nfx: {2 * f}\nfy: {2 * f}\ncx: 320\ncy: 240\n"), "scaled"),
    Case("another aspect", camera_file("wide.yaml", CAMERA.replace(f"height: {height}", "height: 200")), "give the camera file of this sensor mode", True,
         lambda folder: (folder / "wide.yaml").write_text(CAMERA)),
    Case("a little distortion", scene(camera=CAMERA + "k1: 0.005\n"), "its lens moves pixels"),
    Case("distortion", scene(camera=CAMERA + "k1: 0.08\n"), "rectified"),
    Case("an unknown lens", camera_file("fov.yaml", info_of_ros + "distortion_model: fov\nd: [0.1]\n"), "give a camera without distortion", True,
         lambda folder: (folder / "fov.yaml").write_text(CAMERA)),
    Case("no camera", scene(camera=None), "has no camera", True, lambda folder: (folder / "scene" / "camera.yaml").write_text(CAMERA)),
    Case("no camera for arrays", npz(depth=metres, rgb=right_of), "has no array 'K'", True, lambda folder: npz(depth=metres, rgb=right_of, K=K)(folder)),
    Case("no camera for a cloud", ply(camera=None), "virtual"),
    # Frames of reference
    Case("an organized cloud", pcd()),
    Case("an unorganized cloud", pcd(size=(0, 1), camera=CAMERA)),
    Case("in OpenGL's frame", pcd(points * [1, -1, -1]), "note"),
    Case("in a robot's frame", pcd(points[..., [2, 0, 1]] * [1, -1, -1]), "note"),
    Case("in a base's frame", pcd(points @ turn.T + [1, 2, 3]), "note"),
    Case("of realsense-viewer", ply(points * [1, -1, -1]), "note"),
    Case("in a robot's frame with a camera", pcd(points[..., [2, 0, 1]] * [1, -1, -1], camera=CAMERA), "note"),
    # Colour
    Case("none", scene(colour=None), "depth alone"),
    Case("none in a cloud", pcd(fields="none"), "depth alone"),
    Case("beside a cloud", beside, "the image of the same name"),
    Case("TIFF", scene(colour_name="rgb.tif")),
    Case("JPEG", scene(colour_name="color.jpg")),
    Case("grey PGM", scene(colour=grey, colour_name="rgb.pgm")),
    Case("EXR", scene(colour=(bgr / 255).astype("f4"), colour_name="rgb.exr")),
    Case("16 bits", scene(colour=bgr.astype("u2") * 257)),
    Case("RGBA", scene(colour=cv2.cvtColor(bgr, cv2.COLOR_BGR2BGRA))),
    Case("floats in arrays", npz(depth=metres, rgb=right_of / 255, K=K)),
    Case("another name for arrays", npz(depth=metres, color=right_of, K=K)),
    Case("of twice the size", scene(colour=cv2.resize(bgr, None, fx=2, fy=2)), "same view"),
    Case("of another camera", scene(colour=framed), "camera_color.yaml", True, write_colour_camera),
    # One line
    *(Case(f"--rgb and --depth {name}", images(name, depth, "--rgb", "c.jpg", "--depth", name)) for name, depth in (
        ("d.png", mm), ("d.tiff", mm), ("d.pgm", mm), ("d.exr", metres), ("d.npy", metres))),
    Case("two images", images("d.png", mm, "c.jpg", "d.png")),
    Case("a colour image alone", images("d.png", mm, "c.jpg"), "no depth image", True, lambda folder: images("d.png", mm, "--depth", "d.png", "--rgb", "c.jpg")(folder)),
    # Layouts
    Case("Redwood", recording("depth/00001.png", "color/00001.jpg")),
    Case("FoundationPose", recording("depth/0000001.png", "rgb/0000001.png", ("cam_K.txt", ROWS))),
    Case("ScanNet's folders", recording("depth/0.png", "color/0.jpg", ("intrinsic/intrinsic_depth.txt", ROWS))),
    Case("7-Scenes", recording("frame-000000.depth.png", "frame-000000.color.png", ("camera-intrinsics.txt", ROWS))),
    Case("3RScan", recording("frame-000000.depth.pgm", "frame-000000.color.jpg", ("_info.txt", f"m_depthWidth = {width}\nm_depthHeight = {height}\n"
         f"m_depthShift = 1000\nm_calibrationDepthIntrinsic = {f} 0 {cx} 0 0 {f} {cy} 0 0 0 1 0 0 0 0 1\n"))),
    Case("associations.txt alone", recording("depth/8.png", "rgb/7.png", more=[associations("rgb/7.png", "depth/8.png")])),
    Case("BOP with JPEG", recording("depth/000003.png", "rgb/000003.jpg", ("scene_camera.json", json.dumps({"3": {"cam_K": NINE, "depth_scale": 0.1}})), mm * numpy.uint16(10))),
    Case("dot files", recording("depth/1.png", "rgb/1.png", more=[("depth/._1.png", "of a Mac"), ("rgb/.DS_Store", "")])),
    Case("names in capitals", scene(depth_name="Depth.PNG", colour_name="Color.png")),
    Case("names that do not tell", recording("depth/a.png", "rgb/b.png"), "associations.txt", True,
         lambda folder: (folder / "recording" / "associations.txt").write_text("0 rgb/b.png 0 depth/a.png\n")),
    Case("a recording without camera", recording("depth/1.png", "color/1.jpg", ("notes.txt", "")), "has no camera", True, write_camera),
    # Clouds' files
    Case("PCD .5", pcd(version=".5")),
    Case("COUNT 0", pcd(fields="count0")),
    Case("r g b as three fields", pcd(fields="three")),
    Case("a VIEWPOINT far away", pcd(viewpoint="452123.25 5411234.5 233.1 0.7 0.1 0 0.7")),
    Case("big-endian PLY", ply(order=">")),
    Case("an element before the vertices", ply(before="camera")),
    Case("diffuse_red", ply(names=("diffuse_red", "diffuse_green", "diffuse_blue"))),
    Case("colour as floats", ply(kind="float")),
    Case("vertices over several lines", ply(ascii_lines=True)),
    # Depth that is none
    Case("a picture of depth", scene((mm >> 4).astype("u1")), "not a picture of it", True, lambda folder: scene()(folder)),
    Case("depth as JPEG", scene((mm >> 4).astype("u1"), depth_name="depth.jpg"), "16-bit PNG", True,
         lambda folder: ((folder / "scene" / "depth.jpg").unlink(), scene()(folder))),
    # Labels, which segment does not need
    Case("labels of any kind", scene(more={"label.png": (u % 300).astype("u2")})),
    Case("labels that are damaged", scene(more={"label.png": "no image"}), "treated as having no ground truth"),
]


class Cases(unittest.TestCase):
    def segment(self, folder, words):
        out = folder / "out"
        done = subprocess.run([GESTALT, "segment", *map(str, words), "--output", out], capture_output=True, text=True)
        files = list(out.glob("*/objects.png"))
        objects = cv2.imread(str(files[0]), cv2.IMREAD_UNCHANGED) if done.returncode == 0 and len(files) == 1 else None
        return done.returncode, done.stderr, objects

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as work:
            folder = pathlib.Path(work)
            code, cls.said, cls.objects = cls.segment(cls, folder, scene()(folder))
            assert code == 0, cls.said
        cls.numbers = [n for n in numpy.unique(cls.objects) if n and numpy.count_nonzero(cls.objects == n) > 300]

    def test_the_scene_has_its_objects_and_nothing_is_said(self):
        self.assertGreaterEqual(len(self.numbers), 4)
        self.assertEqual(self.said, "")

    def found(self, objects):
        """How many objects of the scene folder are found."""
        if objects.shape != self.objects.shape:  # by a camera that was made for the points
            return len([n for n in numpy.unique(objects) if n and numpy.count_nonzero(objects == n) > 300])
        count = 0
        for number in self.numbers:
            mine = self.objects == number
            theirs = numpy.bincount(objects[mine])
            theirs[0] = 0
            best = theirs.argmax()
            count += 2 * theirs[best] >= 0.8 * (mine.sum() + numpy.count_nonzero(objects == best))
        return count

    def expect_objects(self, code, said, objects):
        self.assertEqual(code, 0, said)
        self.assertGreaterEqual(self.found(objects), len(self.numbers) - 1, said)

    def judge(self, case, folder):
        words = case.write(folder)
        code, said, objects = self.segment(folder, words)
        self.assertNotIn("terminate", said)
        if case.told:
            self.assertIn(case.told, said)
        if case.refused:
            self.assertEqual(code, 3, said)
        elif case.told is None:
            self.assertNotIn("warning", said)
        if case.remedy is None:
            if "warning" not in said or case.told != "warning":
                self.expect_objects(code, said, objects)
            return
        if isinstance(case.remedy, str):
            option = re.search(case.remedy, said)
            self.assertTrue(option, said)
            words = [*words, *option[0].split(" ")]
        else:
            given = case.remedy(folder)
            words = given if isinstance(given, list) else words
        code, said, objects = self.segment(folder, words)
        if isinstance(case.remedy, str):
            self.assertNotIn("warning", said)
        self.expect_objects(code, said, objects)


def test_of(case):
    def test(self):
        with tempfile.TemporaryDirectory() as work:
            self.judge(case, pathlib.Path(work))

    test.__doc__ = case.kind
    return test


for number, case in enumerate(CASES):
    setattr(Cases, "test_{:02}_{}".format(number, re.sub(r"\W+", "_", case.kind)), test_of(case))

if __name__ == "__main__":
    unittest.main(argv=formats_test.sys.argv[:1])
