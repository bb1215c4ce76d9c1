"""Runs tasks of `unietp export --format ai2thor` in AI2-THOR (PyPI `ai2thor`, written against 5.0.0).

For each task: loads its house, brings its start about, makes the calls of its demonstration, and evaluates its goal on
the metadata of the start and after each step. A step is an action of ours, of one or more calls.

    python3 run_ai2thor.py FOLDER [TASK ...] --out results.jsonl

A line of the output is a task: `task`, `success`, `steps` (how many were made), `failed` (the first call that failed, with
AI2-THOR's message; else null), `moved` (for each call that was repeated from another pose, its number among the calls),
`differences` (for each state in which a proposition of the goal is other than in our physics: `step`, `proposition`, `value`).
Exit code 1: a task did not succeed.

An agent of your own: `Episode(task, house, controller)`, then `start()`, any calls of the controller with
`observe(controller.last_event.metadata)` after each action, and `success()`. act_ai2thor.py acts out actions of ours.

The environment variable AI2THOR_EXECUTABLE names a build of AI2-THOR to run in place of the one that the package downloads.
"""

import argparse
import json
import math
import os
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Protocol

Json = dict[str, Any]
Trace = list[dict[str, bool]]
Formula = Callable[[Trace, int], bool]

# As in our physics: 1.5 m of reach, standing anywhere, any angle of view.
SETTINGS: Json = {
    "width": 500, "height": 500, "fieldOfView": 90, "visibilityDistance": 1.5, "gridSize": 0.25, "snapToGrid": False,
    "rotateStepDegrees": 30,
}
OURS = ("near", "part")  # what our calls say that AI2-THOR's do not
NEAR_M, NEAR_TURN = 0.02, 0.01  # an object of a floor plan that is no farther from where it is wanted is left there


class Event(Protocol):
    metadata: Json


class Controller(Protocol):
    """What is used of `ai2thor.controller.Controller`."""

    last_event: Any

    def reset(self, scene: Any = None) -> Any: ...

    def step(self, action: Any = None, **arguments: Any) -> Any: ...


def read_formula(text: str) -> Formula:
    """A formula of linear temporal logic on finite traces: ! & | F G U, every operand in parentheses."""
    tokens = re.findall(r"[a-z_][a-z0-9_]*|[()!&|FGU]", text)
    if "".join(tokens) != text.replace(" ", ""):
        raise ValueError(f"not a formula: {text}")
    at = 0

    def unary() -> Formula:
        nonlocal at
        token = tokens[at]
        at += 1
        if token == "(":
            inner = binary()
            at += 1
            return inner
        if token == "!":
            negated = unary()
            return lambda trace, i: not negated(trace, i)
        if token == "F":
            later = unary()
            return lambda trace, i: any(later(trace, j) for j in range(i, len(trace)))
        if token == "G":
            always = unary()
            return lambda trace, i: all(always(trace, j) for j in range(i, len(trace)))
        return lambda trace, i: token == "true" or (token != "false" and trace[i][token])

    def binary() -> Formula:
        nonlocal at
        whole = unary()
        while at < len(tokens) and tokens[at] in "&|U":
            sign, at = tokens[at], at + 1
            whole = JOINED[sign](whole, unary())
        return whole

    return binary()


def _until(first: Formula, second: Formula) -> Formula:
    def holds(trace: Trace, i: int) -> bool:
        for j in range(i, len(trace)):
            if second(trace, j):
                return True
            if not first(trace, j):
                return False
        return False

    return holds


JOINED: dict[str, Callable[[Formula, Formula], Formula]] = {
    "&": lambda a, b: lambda trace, i: a(trace, i) and b(trace, i),
    "|": lambda a, b: lambda trace, i: a(trace, i) or b(trace, i),
    "U": _until,
}


def is_part(object_id: str, whole: str) -> bool:
    """AI2-THOR names the parts of an object `whole___0`, `whole___1`, …"""
    return object_id == whole or object_id.startswith(whole + "___")


def inside_polygon(x: float, z: float, polygon: list[Json]) -> bool:
    inside = False
    for a, b in zip(polygon, polygon[1:] + polygon[:1], strict=True):
        if (a["z"] > z) != (b["z"] > z) and x < (b["x"] - a["x"]) * (z - a["z"]) / (b["z"] - a["z"]) + a["x"]:
            inside = not inside
    return inside


def object_poses(objects: list[Json], wanted: list[Json]) -> list[Json]:
    """The argument of SetObjectPoses: all that can move, since it takes away what it does not name. Where a box is not
    where it is wanted, its model is moved and turned about the vertical so that it comes there."""
    floor = max((top(one) for one in objects if one["objectType"] == "Floor"), default=0.0)
    places = {one["objectId"]: one for one in wanted}
    poses = []
    for thing in objects:
        if not (thing["pickupable"] or thing["moveable"]):
            continue
        at, rotation = thing["position"], thing["rotation"]
        if place := places.get(thing["objectId"]):
            middle = thing["axisAlignedBoundingBox"]["center"]
            target = {**place["center"], "y": place["center"]["y"] + floor}
            turn = math.radians(place["rotation"]["y"] - rotation["y"])
            if max(abs(target[axis] - middle[axis]) for axis in "xyz") > NEAR_M or abs(math.sin(turn / 2)) > NEAR_TURN:
                x, z = at["x"] - middle["x"], at["z"] - middle["z"]
                at = {
                    "x": target["x"] + x * math.cos(turn) + z * math.sin(turn),
                    "y": target["y"] + at["y"] - middle["y"],
                    "z": target["z"] - x * math.sin(turn) + z * math.cos(turn),
                }
                rotation = {**rotation, "y": place["rotation"]["y"]}
        poses.append({"objectName": thing["name"], "position": at, "rotation": rotation})
    return poses


def top(thing: Json) -> float:
    """Height of the upper side of a thing's box."""
    box = thing["axisAlignedBoundingBox"]
    return float(box["center"]["y"] + box["size"]["y"] / 2)


class Metadata:
    """The metadata of one event, as the tests of a task ask for it."""

    def __init__(self, metadata: Json, house: Json):
        self.objects: dict[str, Json] = {one["objectId"]: one for one in metadata["objects"]}
        self.agent: Json = metadata["agent"]
        self.rooms: dict[str, list[Json]] = {room["id"]: room["floorPolygon"] for room in house["rooms"]}

    def passes(self, test: Json) -> bool:
        """An object that is not there passes no test."""
        if "always" in test:
            return bool(test["always"])
        if "all" in test:
            return all(self.passes(one) for one in test["all"])
        thing = self.agent if test.get("agent") else self.objects.get(test["objectId"])
        if thing is None:
            return False
        if "room" in test:
            return self.room_at(thing["position"]) == test["room"]
        value = thing[test["key"]]
        if "contains" in test:
            holds = any(is_part(one, test["contains"]) for one in value or [])
            return holds and ("above" not in test or self.is_above(thing, test["contains"]) == test["above"])
        if "containsType" in test:
            return any(self.objects.get(one, {}).get("objectType") == test["containsType"] for one in value or [])
        return bool(value == test["equals"])

    def room_at(self, position: Json) -> str | None:
        """The house's id of the room that a place is in."""
        return next((room for room, floor in self.rooms.items() if inside_polygon(position["x"], position["z"], floor)), None)

    def is_above(self, thing: Json, place: str) -> bool:
        """Whether the middle of a thing is over the top of a place."""
        return bool(thing["axisAlignedBoundingBox"]["center"]["y"] > top(self.objects[place]))

    def part_of(self, whole: str, kind: str) -> str:
        """The part of an object that is of this type; the object itself when it has none."""
        parts = (one for one, thing in self.objects.items() if thing["objectType"] == kind and is_part(one, whole))
        return next(parts, whole)


class Episode:
    """One task in a controller. `trace` has the truth of each proposition at the start and after each step, and after
    each call of a step that consists of several, such as `heat_with`; `ends` has the places of the former in it."""

    def __init__(self, task: Json, house: Json, controller: Controller):
        self.task, self.house, self.controller = task, house, controller
        self.formula = read_formula(task["goal"]["formula"])
        self.trace: Trace = []
        self.ends: list[int] = []
        self.failed: Json | None = None
        self.moved: list[int] = []
        self._calls = 0
        self._height: float | None = None  # of the agent in a floor plan, where it is other than in houses

    def start(self) -> bool:
        """Builds the house and brings the start about; False when a call failed."""
        self.controller.reset(scene=self.house.get("scene", self.house))
        built = self._succeeded()
        if not built:
            self._fail("start", {"action": "CreateHouse"}, self._message())
        self._height = self.controller.last_event.metadata["agent"]["position"]["y"] if "scene" in self.house else None
        agent = {"action": "Teleport", **self.house["metadata"]["agent"]}
        for one in [{"call": agent}, *self.task["start"]] if built else []:
            if "unless" in one and self.now().passes(one["unless"]):
                continue
            if not self.call("start", one["call"]):
                break
        if self.failed is None:
            self.observe(self.controller.last_event.metadata)
            self.ends.append(0)
        return self.failed is None

    def follow_plan(self) -> Iterator[str]:
        """Makes the calls of the demonstration, and gives each step that was made. Ends at a call that fails."""
        for step in self.task["plan"]:
            consists_of_several = step["step"].split("(")[0].endswith("_with")
            for i, call in enumerate(step["calls"]):
                if not self.call(step["step"], call):
                    return
                if consists_of_several and i + 1 < len(step["calls"]):
                    self.observe(self.controller.last_event.metadata)
            self.observe(self.controller.last_event.metadata)
            self.ends.append(len(self.trace) - 1)
            yield step["step"]

    def observe(self, metadata: Json) -> None:
        """Adds a state to the trace."""
        now = Metadata(metadata, self.house)
        self.trace.append({one["name"]: now.passes(one["test"]) for one in self.task["goal"]["propositions"]})

    def success(self) -> bool:
        """Whether the goal holds of the trace so far."""
        return bool(self.trace) and self.formula(self.trace, 0)

    def differences(self) -> list[Json]:
        """Where the trace of the demonstration is other than in our physics, but for how many pieces a cut makes."""
        pieces = {one["name"] for one in self.task["goal"]["propositions"] if one["predicate"] == "exists"}
        ours = [self.task["goal"]["holds"], *(step["holds"] for step in self.task["plan"])]
        return [
            {"step": i, "proposition": name, "value": value}
            for i, (state, holding) in enumerate(zip((self.trace[end] for end in self.ends), ours, strict=False))
            for name, value in state.items()
            if value != (name in holding) and name not in pieces
        ]

    def now(self) -> Metadata:
        return Metadata(self.controller.last_event.metadata, self.house)

    def _succeeded(self) -> bool:
        return bool(self.controller.last_event.metadata["lastActionSuccess"])

    def _message(self) -> str:
        return str(self.controller.last_event.metadata["errorMessage"])

    def _fail(self, step: str, call: Json, message: str) -> None:
        self.failed = {"step": step, "call": call, "message": message}

    def _step(self, arguments: Json) -> str | None:
        """AI2-THOR's message when a call fails; the controller raises ValueError for one that it does not know."""
        try:
            self.controller.step(**arguments)
        except ValueError as error:
            return str(error)
        return None if self._succeeded() else self._message()

    def call(self, step: str, call: Json) -> bool:
        """Makes a call; where it fails for an object, once more from the nearest pose at which AI2-THOR lets the agent
        handle that object. A Teleport that fails is replaced by that pose."""
        self._calls += 1
        arguments = {key: value for key, value in call.items() if key not in OURS}
        if "objectPoses" in call:
            arguments["objectPoses"] = object_poses(self.controller.last_event.metadata["objects"], call["objectPoses"])
        if self._height is not None and "position" in call:
            arguments["position"] = {**call["position"], "y": self._height}
        if "part" in call:
            arguments["objectId"] = self.now().part_of(call["objectId"], call["part"])
        message = self._step(arguments)
        if message is not None:
            if step != "start" and self._stand_elsewhere(arguments, call.get("near", arguments.get("objectId"))):
                self.moved.append(self._calls)
                message = None if call["action"] == "Teleport" else self._step(arguments)
        if message is not None:
            self._fail(step, call, message)
        return message is None

    def _stand_elsewhere(self, call: Json, target: str | None) -> bool:
        """Goes to the nearest pose at which the target can be handled; without a target, to where a Teleport can go."""
        wanted = call.get("position", self.controller.last_event.metadata["agent"]["position"])
        if target is not None:
            asked = {"action": "GetInteractablePoses", "objectId": target, "standings": [True]}
        elif call["action"] == "Teleport":
            asked = {"action": "GetReachablePositions"}
        else:
            return False
        if self._step(asked) is not None:
            return False
        places: list[Json] = list(self.controller.last_event.metadata["actionReturn"] or [])
        places.sort(key=lambda place: (place["x"] - wanted["x"]) ** 2 + (place["z"] - wanted["z"]) ** 2)
        return any(
            self._step({"action": "TeleportFull", **place} if target is not None else {**call, "position": place}) is None
            for place in places[:5]
        )


def start_controller() -> Controller:
    """AI2-THOR's own, with the process of Unity that it starts."""
    from ai2thor.controller import Controller as Theirs

    executable = os.environ.get("AI2THOR_EXECUTABLE")
    controller: Controller = Theirs(**SETTINGS, **({"local_executable_path": executable} if executable else {}))
    return controller


def run(task: Json, house: Json, controller: Controller) -> Json:
    """One task's line of the output."""
    episode = Episode(task, house, controller)
    steps = sum(1 for _ in episode.follow_plan()) if episode.start() else 0
    return {
        "task": task["task"],
        "success": episode.failed is None and episode.success(),
        "steps": steps,
        "failed": episode.failed,
        "moved": episode.moved,
        "differences": episode.differences(),
    }


def read_task(folder: Path, name: str) -> tuple[Json, Json]:
    """A task and its house."""
    task: Json = json.loads((folder / f"{name}.json").read_text())
    if task.get("format") != "unietp-ai2thor/1":
        raise ValueError(f"{name}.json: expected the format unietp-ai2thor/1")
    house: Json = json.loads((folder / task["house"]).read_text())
    return task, house


def main(arguments: list[str] | None = None, make: Callable[[], Controller] = start_controller) -> int:
    """`make` makes the controller."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("folder", type=Path, help="of unietp export --format ai2thor")
    parser.add_argument("task", nargs="*", help="ids of tasks (default: all)")
    parser.add_argument("--out", type=Path, required=True, help="JSON lines, one a task")
    chosen = parser.parse_args(arguments)
    names = chosen.task or sorted(
        one.stem for one in chosen.folder.glob("*.json") if not one.name.endswith(".house.json")
    )
    controller = make()
    succeeded = 0
    with chosen.out.open("w") as out:
        for name in names:
            result = run(*read_task(chosen.folder, name), controller)
            succeeded += result["success"]
            out.write(json.dumps(result) + "\n")
            out.flush()
    print(f"{succeeded} of {len(names)} tasks succeed")
    return 0 if succeeded == len(names) else 1


if __name__ == "__main__":
    sys.exit(main())
