# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""The objects of a result: where they are, how large, of what kind, how certain."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, NamedTuple

import numpy
from numpy.typing import NDArray

__all__ = ["Colour", "Doubt", "Face", "Object", "OrientedBox", "Support"]

Vector = NDArray[numpy.float64]


class OrientedBox(NamedTuple):
    """A box around points, in the camera frame."""

    centre: Vector
    """(3,) metres."""
    axes: NDArray[numpy.float64]
    """(3, 3): rows are unit axes of a right-handed frame; the last is the normal of the support, or of the largest surface."""
    size: Vector
    """(3,) metres along the axes, of what is seen."""

    @property
    def corners(self) -> NDArray[numpy.float64]:
        """(8, 3) metres."""
        signs = numpy.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        return self.centre + (signs * self.size / 2) @ self.axes


class Support(NamedTuple):
    """The background plane that an object is on."""

    patch: int
    normal: Vector
    """(3,) unit, towards the camera."""
    offset: float
    """Metres: points of the plane have normal . p = offset."""
    bottom: float
    """Metres over the plane, of the object's lowest point that is seen."""
    top: float
    """The same of its highest."""


class Face(NamedTuple):
    """A plane part of an object's surface."""

    patch: int
    centre: Vector
    """(3,) metres."""
    normal: Vector
    """(3,) unit, towards the camera."""
    area: float
    """Square metres, of what is seen."""


class Colour(NamedTuple):
    """Red, green and blue, 0 to 255."""

    mean: Vector
    deviation: Vector


class Doubt(NamedTuple):
    """Two patches whose decision was close."""

    a: int
    b: int
    p: float
    """Probability that both belong to one object."""


@dataclass(frozen=True, eq=False, repr=False)
class Object:
    """A segment that is an object. Sizes are of what the camera sees; metres are in the camera frame."""

    content: dict[str, Any]
    """The element of "objects" in result.json (docs/objects.md)."""
    patches: list[int]
    """Numbers of the object's patches."""
    _labels: NDArray[numpy.uint16]
    _points: NDArray[numpy.float32]
    _normals: NDArray[numpy.float32]

    @property
    def label(self) -> int:
        """The object's number in Result.labels."""
        return int(self.content["label"])

    @property
    def pixels(self) -> int:
        return int(self.content["pixels"])

    @property
    def box(self) -> tuple[int, int, int, int]:
        """x, y, width and height in the image, pixels."""
        x, y, width, height = self.content["box"]
        return x, y, width, height

    @cached_property
    def mask(self) -> NDArray[numpy.bool_]:
        """(height, width) bool: the object's pixels."""
        return numpy.asarray(self._labels == self.label)

    @cached_property
    def points(self) -> NDArray[numpy.float32]:
        """(n, 3) metres, of the object's pixels with depth, row by row."""
        return self._points[self._measured]

    @cached_property
    def normals(self) -> NDArray[numpy.float32]:
        """(n, 3) unit, towards the camera, of the same pixels; 0 where there is none."""
        return self._normals[self._measured]

    @property
    def centroid(self) -> Vector:
        """(3,) metres: the mean of the points."""
        return numpy.array(self.content["centroid"])

    @property
    def obb(self) -> OrientedBox:
        """The oriented bounding box."""
        return OrientedBox(*(numpy.array(self.content["oriented_box"][name]) for name in ("centre", "axes", "size")))

    @property
    def support(self) -> Support | None:
        """The background plane that the object is on, if there is one."""
        told = self.content["support"]
        return told and Support(told["patch"], numpy.array(told["normal"]), told["offset"], told["bottom"], told["top"])

    @property
    def kind(self) -> Literal["plane", "box", "cylinder", "sphere", "other"]:
        """A hint at the shape."""
        kind: Literal["plane", "box", "cylinder", "sphere", "other"] = self.content["kind"]
        return kind

    @property
    def largest_face(self) -> Face | None:
        """The flat surface with the largest area that is seen, for a gripper or a suction cup."""
        told = self.content["largest_face"]
        return told and Face(told["patch"], numpy.array(told["centre"]), numpy.array(told["normal"]), told["area"])

    @property
    def colour(self) -> Colour | None:
        """None for frames without colour."""
        told = self.content["colour"]
        return told and Colour(numpy.array(told["mean"]), numpy.array(told["deviation"]))

    @property
    def confidence(self) -> float:
        """Probability that this is one whole object."""
        return float(self.content["confidence"])

    @property
    def doubtful_joins(self) -> list[Doubt]:
        """Joins within the object of which p is low: it may be two. The lowest first, at most three."""
        return [Doubt(**doubt) for doubt in self.content["doubtful_joins"]]

    @property
    def doubtful_cuts(self) -> list[Doubt]:
        """Cuts to other objects of which p is high: it may be a part. The highest first, at most three."""
        return [Doubt(**doubt) for doubt in self.content["doubtful_cuts"]]

    @cached_property
    def _measured(self) -> NDArray[numpy.bool_]:
        return numpy.asarray(self.mask & (self._points[..., 2] > 0))

    def __repr__(self) -> str:
        size = " x ".join(f"{100 * side:.1f}" for side in self.obb.size)
        return f"<gestalt.Object {self.label}: {self.kind}, {size} cm, {self.pixels} pixels, confidence {self.confidence:.2f}>"


def objects_of(
    content: dict[str, Any],
    labels: NDArray[numpy.uint16],
    points: NDArray[numpy.float32],
    normals: NDArray[numpy.float32],
) -> list[Object]:
    """The objects of a result.json with the images of its frame."""
    patches = {segment["label"]: segment["patches"] for segment in content["segments"]}
    return [Object(told, patches[told["label"]], labels, points, normals) for told in content["objects"]]
