# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of types, for annotations."""

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypedDict, Union

import numpy
from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._gestalt import Camera

__all__ = ["CameraLike", "DepthKind", "LabelScheme", "Overrides", "Pairs", "Path", "Paths", "Scores", "Tracks"]

Path = Union[str, os.PathLike[str]]
Paths = Union[Path, Sequence[Path]]

CameraLike = Union["Camera", dict[str, float]]
"""A camera, or a dictionary with width, height, fx, fy, cx and cy."""

Overrides = Union[Sequence[str], Mapping[str, Any]]
"""A list of "path=value", or a dictionary {path: value}."""

DepthKind = Literal["plain", "radial", "rotated"]
"""The meaning of depth values, as for --depth-kind."""

LabelScheme = Literal["osd", "objects", "colours"]
"""The meaning of ground truth, as for --labels."""

Scores = dict[str, dict[str, float]]
"""By category, then by measure."""


class Pairs(TypedDict):
    """Pairs of patches with their values and probabilities, n rows."""

    names: list[str]
    """The k relation values."""
    pairs: NDArray[numpy.int64]
    """(n, 2)"""
    values: NDArray[numpy.float64]
    """(n, k)"""
    probabilities: NDArray[numpy.float64]
    """(n,) that both belong to one object; NaN where not classified."""


class Tracks(TypedDict):
    """What a tracker says of a frame (gestalt.Tracker.update)."""

    numbers: dict[int, int]
    """Of each object, by its label."""
    new: list[int]
    """Given for the first time."""
    hidden: list[int]
    """Of objects that are not seen but kept."""
    lost: list[int]
    """Not kept from this frame on."""
    split: list[tuple[int, int]]
    """A whole and the new part of it."""
    merged: list[tuple[int, int]]
    """A part and the whole that it is in now."""
