"""The files of a data set as Python objects (docs/files.md)."""

import json
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast, overload

from unietp import _native
from unietp._native import Error

if TYPE_CHECKING:
    import datasets

SceneGraph = dict[str, Any]  # data/schemas/scene.schema.json: "nodes", "edges", "rooms", "agent", ...


@dataclass(frozen=True)
class DemonstrationStep:
    """A step of a demonstration."""

    action: str  #: its name, "pick_up"
    args: list[Any]  #: ids; in M3 an object is {"bbox": [x0, y0, x1, y1]}, pixels, both ends included
    success: bool
    failure: str  #: "" or why it failed, "too_far"
    feedback: str  #: the sentence for the agent
    visible: list[dict[str, Any]]  #: in the picture before the step: {"id", "box"}
    changes: dict[str, Any]  #: of the scene graph (`changed`)
    search: bool = False  #: only served to see something; a trainer may weigh it less
    tidying: bool = False  #: only closes what was opened or turns off what was turned on before; the goal does not need it
    moments: list[dict[str, Any]] = field(default_factory=list)  #: the changes from moment to moment, of a composite action

    def command(self) -> dict[str, Any]:
        """The action as an environment takes it: {"action", "args"}."""
        return {"action": self.action, "args": self.args}


@dataclass(frozen=True)
class Demonstration:
    """A plan that was executed in physics and reaches the goal."""

    task: str  #: id
    mode: str  #: "M1", "M2" or "M3"
    steps: list[DemonstrationStep]


@dataclass(frozen=True)
class TaskLine:
    """A task of a data set: a line of tasks.jsonl. `fields` has all of it."""

    id: str
    template: str
    split: str
    simulator: str
    layout: str  #: name of its home
    instruction: str
    goal: str  #: the formula (docs/logic.md)
    bindings: dict[str, str]  #: category of each placeholder
    fields: dict[str, Any] = field(repr=False, compare=False)


def changed(scene: SceneGraph, change: dict[str, Any]) -> SceneGraph:
    """The scene graph after a change (data/schemas/delta.schema.json): of a task's start or of a step."""
    new = {node["id"]: node for node in change.get("nodes", [])}
    gone, lost = set(change.get("removed", [])), change.get("edges_removed", [])
    nodes = [new.pop(node["id"], node) for node in scene["nodes"] if node["id"] not in gone]
    edges = [edge for edge in scene["edges"] if edge not in lost]
    return {
        **scene,
        "nodes": nodes + list(new.values()),
        "edges": edges + change.get("edges_added", []),
        "agent": change.get("agent", scene["agent"]),
    }


class _Lines(Sequence[dict[str, Any]]):
    """The objects in the lines of a file, read when asked for."""

    def __init__(self, lines: _native.RecordLines):
        self._lines = lines

    def __len__(self) -> int:
        return len(self._lines)

    @overload
    def __getitem__(self, index: int) -> dict[str, Any]: ...
    @overload
    def __getitem__(self, index: slice) -> list[dict[str, Any]]: ...
    def __getitem__(self, index: int | slice) -> Any:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        if not -len(self) <= index < len(self):
            raise IndexError(f"{self._lines.name} has {len(self)} lines; there is none at {index}")
        return self._lines.line(index % len(self))

    def place(self, index: int) -> str:
        """A line for messages: "tasks.jsonl:3"."""
        return f"{self._lines.name}:{index % len(self) + 1}"


class Dataset(Sequence[TaskLine]):
    """The tasks of a data set's folder, in the order of the file. Nothing but an index is kept in memory.

    `dataset[3]` and `dataset["ai2thor-00012"]` are tasks; `demonstration(task, "M2")`, `home(task)` and `start(task)`
    are what belongs to one. The folder may be a stranger's: its files are read as the program reads them (docs/trust.md),
    and what the program would refuse raises Error with file and line. That a demonstration reaches its goal, and the
    like, only `unietp.validate` checks.
    """

    def __init__(self, folder: str | os.PathLike[str]):
        """Raises Error for a folder without tasks.jsonl."""
        self.folder = Path(folder)
        self._tasks = _Lines(_native.RecordLines.tasks(self.folder))
        self._demonstrations: dict[str, _Lines] = {}
        self._positions: dict[str, int] | None = None
        self._home = lru_cache(maxsize=8)(self._read_home)

    def __len__(self) -> int:
        return len(self._tasks)

    def __iter__(self) -> Iterator[TaskLine]:
        return map(_task, self._tasks)

    @overload
    def __getitem__(self, key: int | str) -> TaskLine: ...
    @overload
    def __getitem__(self, key: slice) -> list[TaskLine]: ...
    def __getitem__(self, key: int | str | slice) -> Any:
        if isinstance(key, slice):
            return [_task(line) for line in self._tasks[key]]
        return _task(self._tasks[self.position(key) if isinstance(key, str) else key])

    def position(self, id: str) -> int:
        """Where a task stands, from 0. Raises Error when no task has the id, or two have the same."""
        if self._positions is None:
            positions: dict[str, int] = {}
            for i, line in enumerate(self._tasks):
                if positions.setdefault(line["id"], i) != i:
                    raise Error(f"{self._tasks.place(i)}: another task has the id {line['id']!r} too")
            self._positions = positions
        try:
            return self._positions[id]
        except KeyError:
            raise Error(f"{self.folder}: no task has the id {id!r}") from None

    @property
    def modes(self) -> list[str]:
        """The modes that there are demonstrations of."""
        return _native.shown_modes(self.folder)

    @property
    def manifest(self) -> dict[str, Any]:
        """manifest.json: version, configuration, counts, checksums and sources."""
        manifest = _native.manifest(self.folder)
        if not isinstance(manifest, dict):
            raise Error(f"{self.folder / 'manifest.json'}: expected an object")
        return manifest

    def demonstration(self, task: TaskLine | str | int, mode: str = "M1") -> Demonstration:
        """The stored demonstration of a task. Raises Error when the data set has none in that mode."""
        line = self._line(task)
        if mode not in self.modes:
            raise Error(f"{self.folder} has demonstrations of {', '.join(self.modes)}, not of {mode!r}")
        if mode not in self._demonstrations:
            self._demonstrations[mode] = self._shown_lines(mode)
        lines = self._demonstrations[mode]
        position = task if isinstance(task, int) else self.position(line.id)
        shown = _demonstration(lines[position])
        if (shown.task, shown.mode) != (line.id, mode):
            raise Error(f"{lines.place(position)}: is of {shown.task!r} in {shown.mode}, not of {line.id!r} in {mode}")
        return shown

    def demonstrations(self, mode: str = "M1") -> Iterator[Demonstration]:
        """All demonstrations of a mode, in the order of the tasks."""
        return map(_demonstration, self._shown_lines(mode))

    def home(self, task: TaskLine | str | int) -> SceneGraph:
        """The scene graph of a task's home."""
        return self._home(self._line(task).layout)

    def start(self, task: TaskLine | str | int) -> SceneGraph:
        """The scene graph that a task starts in: its home with the changes of the task."""
        line = self._line(task)
        return {**changed(self.home(line), line.fields["start"]["changes"]), "id": line.fields["scene"]}

    def scenes(self, task: TaskLine | str | int, mode: str = "M1") -> Iterator[SceneGraph]:
        """The scene graph at the start and after each step of a demonstration."""
        scene = self.start(task)
        yield scene
        for step in self.demonstration(task, mode).steps:
            scene = changed(scene, step.changes)
            yield scene

    def to_dataset(self, mode: str = "M1") -> "datasets.Dataset":
        """The tasks with their plans as a `datasets.Dataset` of Hugging Face (pip install unietp[datasets]).

        Columns: id, split, template, simulator, layout, instruction, goal, mode, and plan, a list of
        {"action", "args" (JSON texts), "success", "feedback"}.
        """
        import datasets

        rows = [_row(task, shown) for task, shown in zip(self, self.demonstrations(mode), strict=True)]
        return datasets.Dataset.from_list(rows)

    def _shown_lines(self, mode: str) -> _Lines:
        return _Lines(_native.RecordLines.demonstrations(self.folder, mode))

    def _line(self, task: TaskLine | str | int) -> TaskLine:
        return task if isinstance(task, TaskLine) else self[task]

    def _read_home(self, layout: str) -> SceneGraph:
        return cast(SceneGraph, _native.home(self.folder, layout))


def load_dataset(folder: str | os.PathLike[str]) -> Dataset:
    """The tasks, demonstrations and homes of a data set. Raises Error for a folder without tasks.jsonl."""
    return Dataset(folder)


def _task(line: dict[str, Any]) -> TaskLine:
    return TaskLine(
        id=line["id"],
        template=line["template"],
        split=line["split"],
        simulator=line["simulator"],
        layout=line["layout"],
        instruction=line["instruction"]["text"],
        goal=line["goal"]["text"],
        bindings=line["bindings"],
        fields=line,
    )


def _demonstration(line: dict[str, Any]) -> Demonstration:
    steps = [
        DemonstrationStep(
            action=step["action"],
            args=step["args"],
            success=step["success"],
            failure=step["failure"],
            feedback=step["feedback"],
            visible=step["visible"],
            changes=step["changes"],
            search=step["search"],
            tidying=step.get("tidying", False),
            moments=step.get("moments", []),
        )
        for step in line["steps"]
    ]
    return Demonstration(line["task"], line["mode"], steps)


def _row(task: TaskLine, shown: Demonstration) -> dict[str, Any]:
    plan = [
        {
            "action": step.action,
            "args": [json.dumps(arg) for arg in step.args],
            "success": step.success,
            "feedback": step.feedback,
        }
        for step in shown.steps
    ]
    return {
        "id": task.id,
        "split": task.split,
        "template": task.template,
        "simulator": task.simulator,
        "layout": task.layout,
        "instruction": task.instruction,
        "goal": task.goal,
        "mode": shown.mode,
        "plan": plan,
    }
