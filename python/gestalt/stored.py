# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a pickled gestalt.Result becomes: the same attributes without the compiled core's data."""

import copy
from dataclasses import dataclass
from typing import Any

import numpy
from numpy.typing import NDArray

from ._gestalt import OutputError
from .objects import Object, objects_of
from .types import Pairs, Path

__all__ = ["StoredResult"]


@dataclass(frozen=True, eq=False, repr=False)
class StoredResult:
    """A result that has come out of a pickle; the attributes are those of gestalt.Result."""

    name: str
    labels: NDArray[numpy.uint16]
    object_labels: NDArray[numpy.uint16]
    patch_labels: NDArray[numpy.int32]
    normals: NDArray[numpy.float32]
    points: NDArray[numpy.float32]
    structural: Pairs
    assembly: Pairs
    milliseconds: dict[str, float]
    content: dict[str, Any]
    """The content of result.json."""

    @property
    def segments(self) -> list[dict[str, Any]]:
        """Label, role, pixels and patches of each segment, largest first."""
        return copy.deepcopy(self.content["segments"])

    @property
    def objects(self) -> list[Object]:
        """The segments that are objects, largest first."""
        return objects_of(copy.deepcopy(self.content), self.labels, self.points, self.normals)

    @property
    def patches(self) -> list[dict[str, Any]]:
        """Pixels and parametric surface of each patch."""
        return copy.deepcopy(self.content["patches"])

    def to_dict(self) -> dict[str, Any]:
        """The content of result.json."""
        return copy.deepcopy(self.content)

    def save(self, folder: Path, name: str | None = None) -> None:
        """Raises OutputError: a pickle does not hold what overlay.png is drawn from."""
        raise OutputError(f"result of '{self.name}': a pickled result cannot be saved; save it before it is pickled")

    def __repr__(self) -> str:
        objects, patches = len(self.objects), len(self.content["patches"])
        return (
            f"<gestalt.StoredResult of '{self.name}': {objects} {'object' if objects == 1 else 'objects'}, "
            f"{patches} {'patch' if patches == 1 else 'patches'}>"
        )
