"""Making environments, and their names in Gymnasium."""

import functools
import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import gymnasium

from unietp import _native
from unietp._native import Error
from unietp.environment import TaskEnv
from unietp.places import catalog
from unietp.spaces import EnvironmentSpaces
from unietp.task_source import TaskSource
from unietp.vector import VectorTaskEnv

MODES = ("M1", "M2", "M3")
CHANNELS = ("depth", "normals")


def complete_settings(mode: str = "M1", **settings: Any) -> dict[str, Any]:
    """All settings of an environment: the preset of the mode, with those that are given in their place.

    docs/environment.md lists them: conventions, picture, boxes, rooms, furniture, movables, teleport, reach, move,
    atomic, composite, steps, failures, invalid, feedback, reward, on_fail, global, floor_plan, box_form, image_width, image_height.
    `global` is a word of Python, so it is written `global_`. Raises Error for an unknown name or value.
    """
    return json.loads(_native.complete_settings(_settings_text(mode, settings)))


def make(
    tasks: str | os.PathLike[str] | None = None,
    mode: str = "M1",
    *,
    procedural: dict[str, Any] | None = None,
    render_mode: str | None = None,
    render_camera: str = "agent",
    channels: Sequence[str] = (),
    max_things: int = 512,
    privileged: bool = False,
    **settings: Any,
) -> TaskEnv:
    """An environment of one task, of the tasks of a data set, or of new tasks without end.

    Args:
        tasks: "FOLDER/TASK-ID" or "FOLDER", of a data set.
        mode: "M1", "M2" or "M3": what the agent is told and how it names objects (docs/modes.md).
        procedural: instead of `tasks`: what new tasks to make, any of simulators, splits, templates, modes (lists of
            names), sense ("usual", "tolerable" or "any"; docs/sense.md), homes (how many of each simulator, 16), homes_seed (1) and attempts (200); `{}` for all kinds.
        render_mode: what `render` gives: "rgb_array", "ansi" or None.
        render_camera: what takes its picture: "agent"; "behind", which follows the agent; or "above" the whole home.
        channels: what observations have besides the picture, in its size: "depth", "normals" (`TaskEnv.channels`).
        max_things: rows of the array `things`, and so the number of things that actions can name by number.
        privileged: put what the agent must not know into `info["privileged"]`.
        settings: see `complete_settings`; `picture=False` makes steps some times faster.

    Raises:
        Error: the folder, the task or a setting is wrong.
    """
    return gymnasium.make(
        _name_of(mode), dataset=_plain(tasks), procedural=procedural, render_mode=render_mode,
        render_camera=render_camera, channels=channels, max_things=max_things, privileged=privileged,
        disable_env_checker=True, **settings,
    )  # type: ignore[return-value]


def make_vec(
    num_envs: int,
    tasks: str | os.PathLike[str] | None = None,
    mode: str = "M1",
    *,
    threads: int | None = None,
    procedural: dict[str, Any] | None = None,
    channels: Sequence[str] = (),
    max_things: int = 512,
    **settings: Any,
) -> VectorTaskEnv:
    """Environments that are stepped together, on `threads` threads (as many as there are processors by default).

    The other arguments are those of `make`. Autoreset mode: next step. Raises Error as `make` does.
    """
    return gymnasium.make_vec(
        _name_of(mode), num_envs, vectorization_mode="vector_entry_point", dataset=_plain(tasks), procedural=procedural,
        threads=threads, channels=channels, max_things=max_things, **settings,
    )  # type: ignore[return-value]


def register() -> None:
    """Registers "unietp/M1-v0", "unietp/M2-v0" and "unietp/M3-v0" with Gymnasium; importing the package does it."""
    for mode in MODES:
        gymnasium.register(
            f"unietp/{mode}-v0",
            entry_point="unietp.making:make_single",
            vector_entry_point="unietp.making:make_batch",
            order_enforce=False,
            kwargs={"mode": mode},
        )


# What Gymnasium calls: `dataset` is `tasks` of make; the other arguments are those of make and make_vec.
def make_single(
    *,
    mode: str,
    dataset: str | None = None,
    procedural: dict[str, Any] | None = None,
    render_mode: str | None = None,
    render_camera: str = "agent",
    channels: Sequence[str] = (),
    max_things: int = 512,
    privileged: bool = False,
    **settings: Any,
) -> TaskEnv:
    source = _task_source(dataset, procedural)
    return TaskEnv(
        source, _env_spaces(source, mode, settings, max_things, channels), render_mode=render_mode, render_camera=render_camera,
        privileged=privileged,
    )


def make_batch(
    *,
    mode: str,
    num_envs: int = 1,
    dataset: str | None = None,
    procedural: dict[str, Any] | None = None,
    threads: int | None = None,
    channels: Sequence[str] = (),
    max_things: int = 512,
    **settings: Any,
) -> VectorTaskEnv:
    source = _task_source(dataset, procedural)
    return VectorTaskEnv(num_envs, source, _env_spaces(source, mode, settings, max_things, channels), threads=threads)


def _name_of(mode: str) -> str:
    if mode not in MODES:
        raise Error(f"no mode is named {mode!r}; accepted are M1, M2 and M3")
    return f"unietp/{mode}-v0"


def _plain(path: str | os.PathLike[str] | None) -> str | None:
    if path is None:
        return None
    if not isinstance(path, (str, os.PathLike)):
        raise Error(f"expected the folder of a data set, not {path!r}")
    return os.fspath(path)


def _settings_text(mode: str, settings: dict[str, Any]) -> str:
    names = {name.removesuffix("_"): value for name, value in settings.items()}
    try:
        return json.dumps({"mode": mode, **names})
    except (TypeError, ValueError) as error:
        raise Error(f"settings: {error}") from error


def _env_spaces(
    source: TaskSource, mode: str, settings: dict[str, Any], max_things: int, channels: Sequence[str] = ()
) -> EnvironmentSpaces:
    if isinstance(channels, str) or not set(channels) <= set(CHANNELS):
        raise Error(f"channels: expected a list of {' and '.join(CHANNELS)}, not {channels!r}")
    if type(max_things) is not int or max_things < 1:
        raise Error(f"max_things: expected a whole number of at least 1, not {max_things!r}")
    complete = json.loads(_native.complete_settings(_settings_text(mode, settings)))
    return EnvironmentSpaces(source, complete, max_things, tuple(channels))


def _task_source(dataset: str | None, procedural: dict[str, Any] | None) -> TaskSource:
    if (dataset is None) == (procedural is None):
        raise Error("give either a data set or what new tasks to make")
    if dataset is None:
        if not isinstance(procedural, dict):
            raise Error(f"procedural: expected a dict of what new tasks to make, not {procedural!r}")
        try:
            return _new_tasks(json.dumps(procedural, sort_keys=True))
        except TypeError as error:
            raise Error(f"procedural: {error}") from error
    path = Path(dataset)
    if (path / "tasks.jsonl").is_file():
        return _stored_tasks(path.resolve(), (path / "tasks.jsonl").stat().st_mtime_ns)
    if (path.parent / "tasks.jsonl").is_file():
        return _stored_tasks(path.parent.resolve(), (path.parent / "tasks.jsonl").stat().st_mtime_ns).only(path.name)
    raise Error(f"{path} is neither the folder of a data set nor FOLDER/TASK-ID in one")


# Opened once for a process, so that environments share homes and tasks.
@functools.lru_cache(maxsize=8)
def _stored_tasks(folder: Path, changed: int) -> TaskSource:  # `changed`: another file is another entry
    extended = _native.records_extended_library(folder)
    shared = catalog(extended)
    return TaskSource(_native.EpisodeTasks.open(folder, shared), shared, extended)


@functools.lru_cache(maxsize=8)
def _new_tasks(options: str) -> TaskSource:
    wanted = json.loads(options)
    defaults = {
        "simulators": ["ai2thor", "virtualhome", "habitat", "behavior"], "splits": [], "templates": [], "modes": ["M1"],
        "sense": "usual", "homes": 16, "homes_seed": 1, "attempts": 200,
    }
    if unknown := sorted(wanted.keys() - defaults.keys()):
        raise Error(f"procedural has no option {unknown[0]!r}; accepted are {', '.join(defaults)}")
    try:
        made = _native.EpisodeTasks.procedural(catalog(), **(defaults | wanted))
    except TypeError as error:
        raise Error(f"procedural: an option has a value of another type than {defaults}") from error
    return TaskSource(made, catalog(), False)
