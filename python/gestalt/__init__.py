# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Segments unknown objects in RGB-D frames by learned perceptual grouping.

>>> segmenter = gestalt.Segmenter()
>>> result = segmenter(colour, depth, gestalt.Camera(640, 480, 525, 525, 319.5, 239.5))
>>> result.object_labels, result.objects, result.structural["probabilities"]
"""

from typing import NamedTuple

import numpy
from numpy.typing import NDArray

from . import _gestalt
from ._gestalt import (
    Camera,
    ConfigError,
    Error,
    InputError,
    ModelError,
    OutputError,
    Segmenter,
    PluginError,
    Result,
    SceneView,
    TimeError,
    Tracker,
    __version__,
    cross_validate,
    data_directory,
    score,
    train,
)
from .components import Classifier, Parameter, Relation, Solver, Value, register
from .objects import Object, OrientedBox
from .stored import StoredResult
from .types import CameraLike, DepthKind, LabelScheme, Path

__all__ = [
    "Camera",
    "Classifier",
    "ConfigError",
    "Error",
    "InputError",
    "ModelError",
    "Object",
    "OrientedBox",
    "OutputError",
    "Parameter",
    "Segmenter",
    "PluginError",
    "Relation",
    "Result",
    "Scene",
    "SceneView",
    "Solver",
    "StoredResult",
    "TimeError",
    "Tracker",
    "Value",
    "__version__",
    "cross_validate",
    "data_directory",
    "read_scene",
    "register",
    "score",
    "train",
]


class Scene(NamedTuple):
    """A frame with its ground truth."""

    name: str
    colour: NDArray[numpy.uint8] | None
    """(height, width, 3) uint8, red green blue."""
    depth: NDArray[numpy.float32]
    """(height, width) float32, metres; 0 where there is none."""
    camera: Camera
    labels: NDArray[numpy.uint16] | None
    """(height, width) uint16: the ground truth."""


def read_scene(
    path: Path,
    camera: CameraLike | None = None,
    *,
    depth_scale: float | None = None,
    depth_kind: DepthKind | None = None,
    labels: LabelScheme | None = None,
) -> Scene:
    """Reads a scene folder or a cloud. camera replaces the scene's camera, depth_scale (metres per unit) its unit of
    depth. depth_kind is "plain", "radial" or "rotated", labels "osd", "objects" or "colours", as for --depth-kind and
    --labels of the command. Warns about improbable input. Raises InputError."""
    read = _gestalt.read_scene(path, camera, depth_scale=depth_scale, depth_kind=depth_kind, labels=labels)
    return Scene(*read)
