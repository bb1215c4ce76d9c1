"""AI2-THOR (PyPI `ai2thor`, written against 5.0.0) as a backend of `unietp evaluate`.

    unietp evaluate out/mine --backend ai2thor --policy replay --out out/there

An action becomes the calls that demonstrations of `unietp export --format ai2thor` have for it; the agent is put where it
stands in our physics, or to the nearest pose from which AI2-THOR lets it act. After each action the metadata of the objects
is translated. A call that fails part of the way is not taken back. acting.py describes the protocol, run_ai2thor.py what the
environment may say.
"""

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from acting import Acting, Facts, Json, answer_of, serve
from run_ai2thor import Controller, Episode, Metadata, is_part, read_task, start_controller

RELATIONS = ("on", "inside", "on_floor", "in_room")  # what is translated
STANDING_M = 0.95  # height of the agent's middle in every house of ProcTHOR


def pose_of(agent: Json) -> Json:
    """Arguments of Teleport for an agent of ours. Unity: y up, degrees, clockwise from +z."""
    x, z = agent["position"]
    yaw, pitch = math.degrees(agent["yaw_rad"]), math.degrees(agent["pitch_rad"])
    return {
        "position": {"x": x, "y": STANDING_M, "z": z},
        "rotation": {"x": 0.0, "y": (90 - yaw) % 360, "z": 0.0},
        "horizon": min(max(pitch, -30.0), 60.0),
        "standing": True,
    }


def liquid_in(states: list[str]) -> str:
    return next((state[len("filled(") : -1] for state in states if state.startswith("filled(")), "")


class ThorTranslator:
    """Reads the metadata of a task's objects in our words."""

    def __init__(self, task: Json, start: Facts):
        self.words: Json = task["words"]
        self.names: dict[str, str] = task["objects"]
        self.rooms = {theirs: ours for ours, theirs in task["rooms"].items()}
        self.places: dict[str, list[str]] = task["places"]
        self.kinds = {name: self.kinds_of(states) for name, states in start.states.items()}

    def kinds_of(self, states: list[str]) -> set[str]:
        """The kinds of states that an object with these has."""
        names = {state.split("(")[0] for state in states}
        return {row["kind"] for row in self.words["states"] if row["state"] in names}

    def read(self, now: Metadata) -> Facts:
        facts = Facts()
        for name, object_id in self.names.items():
            thing = now.objects.get(object_id)
            if thing is None:
                continue  # a piece of what is not cut yet
            facts.states[name] = sorted(self._states_of(name, thing))
            if thing["isPickedUp"]:
                facts.held.append(name)
                continue
            facts.edges.update(self._edges_of(name, thing, now))
            if room := self._room_at(thing["position"], now):
                facts.edges.add(("in_room", name, room))
        if room := self._room_at(now.agent["position"], now):
            facts.edges.add(("in_room", "agent", room))
        return facts

    def _states_of(self, name: str, thing: Json) -> Iterator[str]:
        for row in self.words["states"]:
            if row["kind"] not in self.kinds.get(name, ()):
                continue
            value = thing.get(row["key"])
            if "equals" in row and value == row["equals"]:
                yield row["state"]
            elif "equals" not in row and value and thing["isFilledWithLiquid"]:
                yield f"{row['state']}({value})"

    def _edges_of(self, name: str, thing: Json, now: Metadata) -> Iterator[tuple[str, str, str]]:
        for parent in thing["parentReceptacles"] or []:
            if now.objects.get(parent, {}).get("objectType") == "Floor":
                if room := self._room_at(thing["position"], now):
                    yield "on_floor", name, room
                continue
            for place, object_id in self.names.items():
                if not is_part(parent, object_id) or place not in self.places:
                    continue
                ways = self.places[place]  # where there are two, heights tell which
                yield ways[0] if len(ways) == 1 else "on" if now.is_above(thing, object_id) else "inside", name, place

    def _room_at(self, position: Json, now: Metadata) -> str | None:
        return self.rooms.get(now.room_at(position) or "")


class ThorActing:
    """One task in a controller."""

    def __init__(self, folder: Path, task: str, start: Facts, controller: Controller):
        self.task, house = read_task(folder, task)
        self.episode = Episode(self.task, house, controller)
        if not self.episode.start():
            raise RuntimeError(f"AI2-THOR does not make the start: {self.episode.failed}")
        self.translator = ThorTranslator(self.task, start)
        told = {edge for edge in start.edges if edge[0] in RELATIONS}
        self.facts = Facts(start.states, told, start.held)  # so that the first answer says in what AI2-THOR's start is another

    def act(self, action: str, args: list[str], ours: Json) -> Json:
        self.between: list[Facts] = []  # the states that it leads through
        calls = self._calls_of(action, args)
        if calls is None:
            return self._answer(f"AI2-THOR has no {action} of {', '.join(args)}")
        self._name_pieces(ours)
        before = self.episode.now()
        held = next(iter(self.translator.read(before).held), "")
        known = (node["id"] for node in ours.get("nodes", []) if node["id"] in self.task["objects"])
        changed = [one for one in known if one not in (held, *args[-1:])]
        named = {"pose": args[-1:] or [""], "argument": args[-1:], "held": [held], "others": changed}
        for row in calls:
            for name in named.get(row.get("of", ""), [""]):
                call = self._call(row, name, ours, before)
                if call is None:
                    continue
                if not self.episode.call(action, call):
                    return self._answer((self.episode.failed or {})["message"])
                if action.endswith("_with"):  # it consists of several steps
                    self.between.append(self.translator.read(self.episode.now()))
        return self._answer("")

    def _name_pieces(self, ours: Json) -> None:
        """AI2-THOR numbers the pieces of a thing from 0: `Apple|2|1|AppleSliced_0`."""
        names = self.task["objects"]
        for node in ours.get("nodes", []):
            whole = names.get(node.get("slice_of", ""))
            if whole is not None and node["id"] not in names:
                stem = f"{whole}|{node['category']}_"
                names[node["id"]] = stem + str(sum(one.startswith(stem) for one in names.values()))
            if node["id"] not in self.translator.kinds:
                self.translator.kinds[node["id"]] = self.translator.kinds_of(node["states"])

    def _calls_of(self, action: str, args: list[str]) -> list[Json] | None:
        """The rows of an action with this tool."""
        thing = self.episode.now().objects.get(self.task["objects"].get(args[-1], "")) if args else None
        kind = thing["objectType"] if thing else ""
        rows = (row for row in self.task["words"]["actions"] if row["action"] == action and row.get("tool", kind) == kind)
        return next((row["calls"] for row in rows), None)

    def _call(self, row: Json, name: str, ours: Json, before: Metadata) -> Json | None:
        """The call of a row for an object of ours; None where this step does not need it."""
        call = {key: value for key, value in row.items() if key not in ("of", "when")}
        if row.get("of") == "pose":
            near = {"near": self.task["objects"][name]} if name in self.task["objects"] else {}
            return {**call, **pose_of(ours["agent"]), **near} if "agent" in ours else None
        if "of" not in row:
            return call
        object_id = self.task["objects"].get(name, "")
        after: list[str] = next((node["states"] for node in ours.get("nodes", []) if node["id"] == name), [])
        now = self.episode.now().objects.get(object_id, {})
        liquid = liquid_in(after)
        needed = {
            "always": True,
            "closed": not now.get("isOpen"),
            "running": bool(now.get("isToggled")),
            "closes": not before.objects.get(object_id, {}).get("isOpen") if not after else "open" not in after,
            "cleans": "clean" in after and bool(now.get("isDirty")),
            "fills": liquid not in ("", now.get("fillLiquid") if now.get("isFilledWithLiquid") else ""),
        }
        if not needed[row.get("when", "always")]:
            return None
        return {**call, "objectId": object_id, **({"fillLiquid": liquid} if row["action"] == "FillObjectWithLiquid" else {}),
                **({"part": part} if row["action"] == "PutObject" and (part := self.task["parts"].get(name)) else {})}

    def _answer(self, message: str) -> Json:
        """`message`: why the action failed; "" when it did not."""
        self.episode.failed = None
        moments = [self.facts] if message else [*self.between, self.translator.read(self.episode.now())]
        answer = answer_of(message, self.facts, moments)
        self.facts = moments[-1]
        return answer


def make(start: Callable[[], Any] = start_controller) -> Callable[[Json], Acting]:
    controller = start()
    return lambda params: ThorActing(Path(params["folder"]), params["task"], Facts.from_json(params["start"]), controller)


if __name__ == "__main__":
    serve(make)
