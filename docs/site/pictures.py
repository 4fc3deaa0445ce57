# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the pages: what the command makes of the demo scene, and drawings of what it tells in result.json."""

import json
import pathlib
import subprocess

import cv2
import numpy as np

ENLARGE = 2
SHOWN = 40  # pairs of the assembly level: nearly all patches are pairs there


def run(command, *arguments, cwd):
    outcome = subprocess.run([command, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, check=False)
    if outcome.returncode:
        raise RuntimeError(f"gestalt {' '.join(map(str, arguments))}: {outcome.stderr}")


def depth_picture(scene):
    """Depth from near (bright) to far; black where there is none."""
    depth = cv2.imread(str(scene / "depth.png"), cv2.IMREAD_UNCHANGED).astype(float)
    near, far = np.percentile(depth[depth > 0], [1, 99])
    shade = np.clip((far - depth) / (far - near), 0, 1)
    picture = cv2.applyColorMap((255 * shade).astype(np.uint8), cv2.COLORMAP_VIRIDIS)
    picture[depth == 0] = 0
    return picture


def project(points, camera):
    """Pixels of points in the camera frame, metres: n x 2."""
    points = np.asarray(points, float)
    return np.stack(
        [
            camera["fx"] * points[:, 0] / points[:, 2] + camera["cx"],
            camera["fy"] * points[:, 1] / points[:, 2] + camera["cy"],
        ],
        axis=1,
    )


def centre(surface):
    """Where the node of a patch is drawn, metres."""
    if surface["type"] == "plane":
        return surface["centre"]
    return np.mean(np.reshape(surface["control_points"], (-1, 3)), axis=0)


def object_window(result, nodes, camera, margin=50):
    """The part of the image that shows the objects: slices of rows and columns."""
    objects = [patch for segment in result["segments"] if segment["role"] == "object" for patch in segment["patches"]]
    low, high = nodes[objects].min(axis=0) - margin, nodes[objects].max(axis=0) + margin
    clip = lambda value, size: int(np.clip(value, 0, size))
    return (
        slice(clip(low[1], camera["height"]), clip(high[1], camera["height"])),
        slice(clip(low[0], camera["width"]), clip(high[0], camera["width"])),
    )


def relation_pictures(result, backdrop):
    """For each level and value, the pairs as lines between their patches, from its smallest (dark) to its largest
    (bright). Of the assembly level only the likeliest pairs are shown."""
    camera = result["camera"]
    nodes = project([centre(patch["surface"]) for patch in result["patches"]], camera)
    rows, columns = object_window(result, nodes, camera)
    below = cv2.resize(backdrop[rows, columns], None, fx=ENLARGE, fy=ENLARGE, interpolation=cv2.INTER_NEAREST)
    below = (0.4 * below).astype(np.uint8)
    place = lambda node: tuple(int(round(ENLARGE * (x - s.start))) for x, s in zip(node, (columns, rows)))

    pictures = {}
    for level in ("structural", "assembly"):
        pairs = [pair for pair in result["pairs"] if pair["level"] == level]
        if level == "assembly":
            pairs = sorted(pairs, key=lambda pair: -pair["p"])[:SHOWN]
        for name in pairs[0]["relations"] if pairs else []:
            values = np.array([pair["relations"][name] for pair in pairs])
            low, high = values.min(), values.max()
            shades = np.full(len(values), 127) if high == low else 255 * (values - low) / (high - low)
            colours = cv2.applyColorMap(shades.astype(np.uint8).reshape(-1, 1), cv2.COLORMAP_VIRIDIS).reshape(-1, 3)
            picture = below.copy()
            for i in np.argsort(values, kind="stable"):
                ends = place(nodes[pairs[i]["a"]]), place(nodes[pairs[i]["b"]])
                cv2.line(picture, *ends, colours[i].tolist(), 3 if level == "structural" else 2, cv2.LINE_AA)
            pictures[f"{level}_{name}"] = (picture, float(low), float(high))
    return pictures


def shade(mesh, size=(960, 600), turn=0.35):
    """The triangles of an exported mesh seen from above and aside, nearest last."""
    triangles, colours = [], []
    for segment in mesh["segments"]:
        vertices = np.asarray(segment["vertices"], float)
        corners = vertices[np.asarray(segment["triangles"], int)]
        triangles.append(corners)
        hue = int(180 * (segment["label"] * 0.618034 % 1))
        colour = cv2.cvtColor(np.uint8([[[hue, 130, 235]]]), cv2.COLOR_HSV2BGR)[0, 0]
        colours.append(np.tile(colour.astype(float), (len(corners), 1)))
    triangles, colours = np.concatenate(triangles), np.concatenate(colours)
    middle = triangles.reshape(-1, 3).mean(axis=0)
    cosine, sine = np.cos(turn), np.sin(turn)
    about_y = np.array([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]])
    seen = (triangles - middle) @ about_y.T
    normals = np.cross(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    light = np.array([0.4, -0.6, -0.7])
    bright = 0.35 + 0.65 * np.abs(normals @ light / np.linalg.norm(light))
    flat = seen[:, :, :2]
    low, high = flat.reshape(-1, 2).min(axis=0), flat.reshape(-1, 2).max(axis=0)
    scale = 0.94 * min(size[0] / (high[0] - low[0]), size[1] / (high[1] - low[1]))
    pixels = (flat - (low + high) / 2) * scale + np.array(size) / 2
    picture = np.full((size[1], size[0], 3), 255, np.uint8)
    for i in np.argsort(-seen[:, :, 2].mean(axis=1), kind="stable"):
        corners = np.round(pixels[i] * 16).astype(int)
        cv2.fillConvexPoly(picture, corners, (colours[i] * bright[i]).tolist(), cv2.LINE_8, 4)
    return picture


def make(gestalt, scene, folder):
    """Writes all pictures into a folder; gives, for each value of a relation, [(level, file, smallest, largest)]."""
    folder = pathlib.Path(folder)
    work = folder / "work"
    work.mkdir(parents=True)
    run(gestalt, "segment", scene, "--debug-images", "--output", work / "default", cwd=work)
    run(gestalt, "segment", scene, "--config", "paper.yaml", "--output", work / "paper", cwd=work)
    default, paper = work / "default" / scene.name, work / "paper" / scene.name
    for name in ("normals", "signal_patches", "surfaces", "patches", "lines", "graph", "overlay"):
        (default / f"{name}.png").rename(folder / f"{name}.png")
    colour = cv2.imread(str(scene / "rgb.png"))
    cv2.imwrite(str(folder / "colour.png"), colour)
    cv2.imwrite(str(folder / "depth.png"), depth_picture(scene))

    run(gestalt, "export", default / "result.json", "--format", "json", "--output", work / "mesh.json", cwd=work)
    cv2.imwrite(str(folder / "mesh.png"), shade(json.loads((work / "mesh.json").read_text())))

    run(gestalt, "synthesize", "--category", "complex_scene", "--seed", 1, "--count", 6, "--output", "scenes", cwd=work)
    run(gestalt, "evaluate", "scenes", "--cross-validate", 3, "--output", "evaluation", cwd=work)
    (work / "evaluation" / "reliability.svg").rename(folder / "reliability.svg")

    found = {}
    # Where both configs have a value at a level, the default's picture.
    for source in (paper, default):
        result = json.loads((source / "result.json").read_text())
        for name, (picture, low, high) in relation_pictures(result, colour).items():
            level, value = name.split("_", 1)
            cv2.imwrite(str(folder / f"{name}.png"), picture)
            found.setdefault(value, {})[level] = (f"{name}.png", low, high)
    return found
