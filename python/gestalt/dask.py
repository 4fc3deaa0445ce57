# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many frames and many configs on a cluster, through Dask's distributed.

>>> with distributed.Client() as client:
...     outcomes = gestalt.dask.segment(client, scenes, "out")

Every frame, and every variant of an ablation, is a task of one thread: give workers one thread each. Paths must mean the
same to all workers. A task whose worker is lost runs again elsewhere; its files replace those of the first time, whole.
"""

import functools
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple, TypeVar

import distributed

from . import _gestalt
from .components import Component, registered
from .types import Overrides, Path, Scores

__all__ = ["Outcome", "ablate", "segment"]


class Outcome(NamedTuple):
    """What became of a scene."""

    scene: str
    folder: str | None
    """Of the results; None when there are none."""
    objects: int
    milliseconds: float
    """Of all levels together."""
    error: str | None


# Arguments of a segmenter as tasks take them: hashable.
Texts = tuple[str, ...]
Components = tuple[tuple[str, type[Component]], ...]
Answer = TypeVar("Answer")


@functools.lru_cache(maxsize=4)
def _segmenter(identity: str, config: str | None, overrides: Texts, components: Components) -> _gestalt.Segmenter:
    """Made again when a file at a path has changed, which changes the identity."""
    _gestalt.keep_freed_memory()
    segmenter = _gestalt.Segmenter(config, list(overrides), components=dict(components), threads=1)
    if _gestalt.run_identity(config, list(overrides), components=dict(components)) != identity:
        raise _gestalt.ConfigError(
            "this worker has another config, model, plugin or version than segment() was called with: leave files alone "
            "while scenes are being segmented; after a plugin or gestalt was rebuilt, restart the workers"
        )
    return segmenter


def _segment(
    scene: str, output: str, identity: str, config: str | None, overrides: Texts, components: Components
) -> Outcome:
    segmenter = _segmenter(identity, config, overrides, components)
    try:
        result = segmenter.segment(scene)
    except (_gestalt.InputError, _gestalt.PluginError, _gestalt.TimeError) as error:
        return Outcome(scene, None, 0, 0.0, str(error))
    result.save(output, result.name)
    return Outcome(scene, os.path.join(output, result.name), len(result.objects), sum(result.milliseconds.values()), None)


def _cross_validate(
    scenes: tuple[str, ...], folds: int, seed: int, config: str | None, overrides: Texts, components: Components
) -> Scores:
    return _gestalt.cross_validate(
        list(scenes), folds, seed, config, list(overrides), components=dict(components), threads=1
    )


def _given(
    config: Path | None, overrides: Overrides, components: Mapping[str, type[Component]] | None
) -> tuple[str | None, Texts, Components]:
    known = registered if components is None else components
    return None if config is None else os.fspath(config), tuple(_gestalt.override_texts(overrides)), tuple(sorted(known.items()))


def _spread(
    client: distributed.Client, task: Callable[..., Answer], arguments: Iterable[tuple[Any, ...]]
) -> list[Answer]:
    futures = [client.submit(task, *each, pure=False) for each in arguments]
    try:
        answers: list[Answer] = client.gather(futures)
        return answers
    finally:
        client.cancel(futures)


def segment(
    client: distributed.Client,
    scenes: Sequence[Path],
    output: Path,
    config: Path | None = None,
    overrides: Overrides = (),
    *,
    components: Mapping[str, type[Component]] | None = None,
) -> list[Outcome]:
    """Segments scenes and writes the results of each into a folder of its name under output.

    Returns their outcomes in order. A scene that cannot be used, or takes longer than the config's time_budget, does not
    stop the others. The other arguments are those of Segmenter; raises what that raises, InputError for scenes of one
    name, and OutputError. Workers that have read the config and model before read them again where they have changed.
    """
    given = _given(config, overrides, components)
    identity = _gestalt.run_identity(given[0], list(given[1]), components=dict(given[2]))
    paths = [os.fspath(scene) for scene in scenes]
    _gestalt.check_scene_names(paths)
    return _spread(client, _segment, [(path, os.fspath(output), identity, *given) for path in paths])


def ablate(
    client: distributed.Client,
    scenes: Sequence[Path],
    variants: Mapping[str, Overrides],
    folds: int = 5,
    seed: int = 0,
    config: Path | None = None,
    *,
    components: Mapping[str, type[Component]] | None = None,
) -> dict[str, Scores]:
    """Cross-validates configs that differ in overrides; returns of each variant what cross_validate() returns.

    >>> gestalt.dask.ablate(client, scenes, {"all": [], "no gabor": ["structural.relations.gabor=off"]})
    """
    paths = tuple(os.fspath(scene) for scene in scenes)
    arguments = [(paths, folds, seed, *_given(config, overrides, components)) for overrides in variants.values()]
    return dict(zip(variants, _spread(client, _cross_validate, arguments)))
