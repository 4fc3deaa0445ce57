# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relations, classifiers and solvers that are written in Python and named in configs."""

import inspect
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar, TypeVar

import numpy
from numpy.typing import ArrayLike, NDArray

from ._gestalt import SceneView, require_new_name

__all__ = ["Classifier", "Component", "Parameter", "Relation", "Solver", "Value", "register", "registered"]


@dataclass(frozen=True)
class Parameter:
    """A parameter that configs can set; its type is that of its default: bool, int, float or str.

    low, high: the range of a number. choices: what a text may be.
    """

    default: bool | int | float | str
    low: float = -math.inf
    high: float = math.inf
    unit: str = ""
    text: str = ""
    choices: tuple[str, ...] = ()


@dataclass(frozen=True)
class Value:
    """A number that a relation gives for a pair of patches, in [low, high]."""

    name: str
    low: float
    high: float
    text: str = ""


class Component:
    """What relations, classifiers and solvers have in common.

    A component is made with its parameters as keyword arguments, by default kept as attributes. Its methods may be called
    from several threads at once; what they raise ends the frame, not the process.
    """

    kind: ClassVar[str] = ""
    version: ClassVar[str] = "1.0.0"
    parameters: ClassVar[dict[str, Parameter]] = {}

    def __init__(self, **parameters: Any) -> None:
        vars(self).update(parameters)

    @classmethod
    def description(cls) -> str:
        """The first line of the class's docstring."""
        return (inspect.getdoc(cls) or cls.__name__).splitlines()[0]


class Relation(Component):
    """A Gestalt relation between two surfaces.

    values: what it gives for a pair, in this order. needs_colour: frames without colour are refused.
    needs_border: it looks at the pixels where two patches touch, so that it cannot be used at the assembly level.
    """

    kind = "relation"
    values: ClassVar[tuple[Value, ...]] = ()
    needs_colour: ClassVar[bool] = False
    needs_border: ClassVar[bool] = False

    def bind(self, scene: SceneView) -> Callable[[NDArray[numpy.int64]], ArrayLike]:
        """Prepares for one frame. Returns a function that gets pairs, (n, 2) numbers of patches, and returns their values,
        (n, len(self.values)): symmetric in the pair and within the declared ranges."""
        raise NotImplementedError(f"{type(self).__name__}.bind()")


class Classifier(Component):
    """Learns p(same object) from scaled relation values."""

    kind = "classifier"

    def train(self, values: NDArray[numpy.float64], positive: NDArray[numpy.bool_]) -> Any:
        """values: (n, k) in [-1, 1]. positive: (n,). Returns the state: dictionaries, lists, numbers and texts, as JSON can
        hold them; it goes into the model file."""
        raise NotImplementedError(f"{type(self).__name__}.train()")

    def restore(self, state: Any, columns: int) -> Callable[[NDArray[numpy.float64]], ArrayLike]:
        """From what train() returned and the number k of values: a function that gets (n, k) values and returns
        probabilities, (n,) in [0, 1]."""
        raise NotImplementedError(f"{type(self).__name__}.restore()")


class Solver(Component):
    """The global decision: which patches form one object."""

    kind = "solver"
    takes_all_pairs: ClassVar[bool] = False
    """Which pairs of the assembly level are edges: those of different groups of the structural level, or all."""

    def solve(
        self,
        sizes: NDArray[numpy.int64],
        pairs: NDArray[numpy.int64],
        probabilities: NDArray[numpy.float64],
        assembly: NDArray[numpy.bool_],
    ) -> ArrayLike:
        """sizes: (n,) pixels of each patch. pairs: (m, 2), probabilities: (m,) that the two are of one object.
        assembly: (m,), whether the pair is of the assembly level. Returns the group of each patch, (n,) numbers."""
        raise NotImplementedError(f"{type(self).__name__}.solve()")


registered: dict[str, type[Component]] = {}
"""The classes that register() has seen, by the names that configs use."""

AnyComponent = TypeVar("AnyComponent", bound=type[Component])


def _is_component(candidate: object) -> bool:
    return isinstance(candidate, type) and issubclass(candidate, Component) and bool(candidate.kind)


def register(name: str) -> Callable[[AnyComponent], AnyComponent]:
    """A decorator: every Segmenter that is made later knows the class by this name.

    >>> @gestalt.register("height_gap")
    ... class HeightGap(gestalt.Relation): ...
    """

    def add(cls: AnyComponent) -> AnyComponent:
        if not _is_component(cls):
            raise TypeError(f"{cls!r} is not a class derived from gestalt.Relation, Classifier or Solver")
        require_new_name(cls.kind, name)
        known = registered.get(name)
        if known and (known.__module__, known.__qualname__) != (cls.__module__, cls.__qualname__):
            raise ValueError(f"'{name}' is registered already, by {known.__module__}.{known.__qualname__}")
        registered[name] = cls
        return cls

    return add
