# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of types, for annotations."""

import os
from collections.abc import Sequence
from typing import Literal, TypedDict, Union

import numpy
from numpy.typing import NDArray

__all__ = ["DepthKind", "LabelScheme", "Pairs", "Path", "Paths", "Scores"]

Path = Union[str, os.PathLike[str]]
Paths = Union[Path, Sequence[Path]]

DepthKind = Literal["plain", "radial", "rotated"]
"""What the numbers of depth say, as --depth-kind."""

LabelScheme = Literal["osd", "objects", "colours"]
"""What ground truth counts, as --labels."""

Scores = dict[str, dict[str, float]]
"""By category, then by measure."""


class Pairs(TypedDict):
    """Pairs of patches with what is known of them, n rows."""

    names: list[str]
    """The k relation values."""
    pairs: NDArray[numpy.int64]
    """(n, 2)"""
    values: NDArray[numpy.float64]
    """(n, k)"""
    probabilities: NDArray[numpy.float64]
    """(n,) that the two are of one object; NaN where that was not asked."""
