"""VirtualHome's evolving-graph simulator (PyPI `virtualhome`, written against 2.3.0) as a backend of `unietp evaluate`.

    unietp evaluate out/mine --backend virtualhome --policy replay --out out/there

With the variable VIRTUALHOME_EXECUTABLE, the path of a build for Unity, it is VirtualHome's Unity simulator instead: an apartment,
the one that VIRTUALHOME_ENVIRONMENT numbers (0 if not given), is changed by `expand_scene` into the start of each task.

When a thing is grabbed, VirtualHome forgets what is on it or in it, and when the agent walks, what is in the thing in its
hand. So what was there is taken with the other hand and put there again, after the thing is grabbed and after it is put down.

`Episode` is the same for programs in Python; acting.py describes the protocol.
"""

import importlib
import importlib.util
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from acting import Acting, Facts, Json, serve

WORDS = {
    "go_to": "Walk", "turn_to": "TurnTo", "pick_up": "Grab", "place_on": "PutBack", "place_in": "PutIn", "open": "Open",
    "close": "Close", "turn_on": "SwitchOn", "turn_off": "SwitchOff", "sit_on": "Sit", "lie_on": "Lie",
    "stand_up": "StandUp", "plug_in": "PlugIn", "unplug": "PlugOut", "read": "Read",
}
HEADS = ("turn_left", "turn_right", "look_up", "look_down", "turn_base_to_look", "reset_head")  # a graph has no view
STATES = {
    "OPEN": "open", "CLOSED": "closed", "ON": "power_on", "OFF": "power_off", "CLEAN": "clean", "DIRTY": "dirty",
    "PLUGGED_IN": "plugged_in", "PLUGGED_OUT": "unplugged",
}
HANDS = ("HOLDS_RH", "HOLDS_LH")


class UnityState:
    """A scene of VirtualHome's Unity simulator, with the names of a state of its graph simulator."""

    def __init__(self, connection: Any, environment: int, graph: Json):
        """Brings the graph about in an apartment. Errors: RuntimeError with what Unity says."""
        self.connection = connection
        if not connection.reset(environment):
            raise RuntimeError(f"VirtualHome has no environment {environment}")
        agent = next(node for node in graph["nodes"] if node["class_name"] == "character")
        things = [node | {"class_name": unity_class(node["class_name"])} for node in graph["nodes"] if node is not agent]
        edges = [edge for edge in graph["edges"] if agent["id"] not in (edge["from_id"], edge["to_id"])]
        done, message = connection.expand_scene({"nodes": things, "edges": edges}, transfer_transform=True)
        if not done:
            raise RuntimeError(f"expand_scene: {message}")
        box = agent.get("bounding_box")
        if not connection.add_character(position=box["center"] if box else None):
            raise RuntimeError("the character cannot stand where the agent does")

    def to_dict(self) -> Json:
        done, graph = self.connection.environment_graph()
        if not done:
            raise RuntimeError(f"environment_graph: {graph}")
        scene: Json = graph
        return scene


class UnityExecutor:
    """Executes lines in Unity, which does not take back what it did. Its message is the error of the last line."""

    def __init__(self) -> None:
        self.message = ""
        self.info = SimpleNamespace(get_error_string=lambda: self.message)

    def execute_one_step(self, lines: list[str], state: UnityState) -> tuple[bool, UnityState]:
        done, message = state.connection.render_script(
            [unity_line(line) for line in lines], recording=False, skip_animation=True, image_synthesis=[]
        )
        self.message = "" if done else str(message)
        return bool(done), state


def unity_class(name: str) -> str:
    """Unity's name of a class: "coffeetable"."""
    return name.replace("_", "")


def unity_line(line: str) -> str:
    """ "[PutIn] <dish_bowl> (4) <fridge> (9)" as Unity takes it: "<char0> [putin] <dishbowl> (4) <fridge> (9)"."""
    action, _, objects = line.partition(" ")
    return f"<char0> {action.lower()} {unity_class(objects)}"


def unity_simulator(connection: Any, environment: int) -> Any:
    return SimpleNamespace(
        Graph=lambda graph: graph,
        State=lambda graph, _, instance_selection: UnityState(connection, environment, graph),
        Executor=lambda *_: UnityExecutor(),
        script=lambda lines: lines,
    )


def load_simulator() -> Any:
    """The modules of the graph, or Unity. The package's own start needs Unity, so they are imported without it."""
    spec = importlib.util.find_spec("virtualhome")
    if spec is None or not spec.submodule_search_locations:
        raise RuntimeError("the package virtualhome is not installed: pip install virtualhome==2.3.0")
    folder = str(Path(spec.submodule_search_locations[0]) / "simulation")
    if folder not in sys.path:
        sys.path.append(folder)
    if executable := os.environ.get("VIRTUALHOME_EXECUTABLE"):
        communication = importlib.import_module("unity_simulator.comm_unity")
        connection = communication.UnityCommunication(file_name=executable, no_graphics=True)
        return unity_simulator(connection, int(os.environ.get("VIRTUALHOME_ENVIRONMENT", "0")))
    environment, execution, scripts = (
        importlib.import_module(f"evolving_graph.{name}") for name in ("environment", "execution", "scripts")
    )
    return SimpleNamespace(
        Graph=environment.EnvironmentGraph, State=environment.EnvironmentState, Executor=execution.ScriptExecutor,
        script=scripts.read_script_from_list_string,
    )


def _places_of(thing: int, below: dict[int, list[tuple[str, int]]]) -> list[tuple[str, int]]:
    """What a thing is on or in; also what those are in, which a graph need not say."""
    places = list(below.get(thing, []))
    reached = list(places)
    for _, place in reached:
        further = [one for one in below.get(place, []) if one not in reached and one[1] != thing]
        reached += further
        places += [one for one in further if one[0] == "inside"]
    return places


def facts_of(graph: Json, ids: dict[int, str], rooms: dict[int, str]) -> Facts:
    """What a graph says, in our words. `ids`, `rooms`: ours, by the numbers of their nodes."""
    kind = {node["id"]: node["category"] for node in graph["nodes"]}
    agent = next(node["id"] for node in graph["nodes"] if node["class_name"] == "character")
    below: dict[int, list[tuple[str, int]]] = {}  # of each thing those that it is on or in
    room_of: dict[int, int] = {}
    facts = Facts()
    held: set[int] = set()
    for edge in graph["edges"]:
        start, relation, end = edge["from_id"], edge["relation_type"], edge["to_id"]
        if relation in HANDS and end in ids:
            facts.held.append(ids[end])
            held.add(end)
        elif relation == "INSIDE" and kind[end] == "Rooms":
            room_of[start] = end
        elif relation in ("ON", "INSIDE") and (end in ids or kind[end] == "Floor") and start != agent:
            below.setdefault(start, []).append(("on" if relation == "ON" else "inside", end))
    facts.states = {
        ids[node["id"]]: sorted(STATES[word] for word in node["states"] if word in STATES)
        for node in graph["nodes"]
        if node["id"] in ids
    }
    for thing, name in ids.items():
        for relation, place in _places_of(thing, below) if thing not in held else []:
            if place in ids:
                facts.edges.add((relation, name, ids[place]))
            elif room_of.get(place) in rooms:
                facts.edges.add(("on_floor", name, rooms[room_of[place]]))
        bottom, seen = thing, {thing}  # whose room it is in; what is in the hand is in none
        while bottom not in held:
            further = [place for _, place in below.get(bottom, []) if place in ids and place not in seen]
            if not further:
                break
            bottom = further[0]
            seen.add(bottom)
        if bottom not in held and room_of.get(bottom) in rooms:
            facts.edges.add(("in_room", name, rooms[room_of[bottom]]))
    if room_of.get(agent) in rooms:
        facts.edges.add(("in_room", "agent", rooms[room_of[agent]]))
    return facts


class Episode:
    """One task in the simulator."""

    def __init__(self, folder: Path, task: str, rooms: list[str], simulator: Any = None):
        self.simulator = load_simulator() if simulator is None else simulator
        graph: Json = json.loads((folder / f"{task}.json").read_text())
        self.names: dict[str, str] = json.loads((folder / f"{task}.names.json").read_text())
        self.ids = {int(name.rsplit("_", 1)[1]): ours for ours, name in self.names.items()}
        numbers = [node["id"] for node in graph["nodes"] if node["category"] == "Rooms"]
        if len(numbers) != len(rooms):
            raise ValueError(f"{task}.json has {len(numbers)} rooms, the task {len(rooms)}")
        self.rooms: dict[int, str] = dict(zip(numbers, rooms, strict=True))
        self.room_names = {
            self.rooms[node["id"]]: f"{node['class_name']}_{node['id']}" for node in graph["nodes"] if node["id"] in self.rooms
        }
        self.state = self.simulator.State(self.simulator.Graph(graph), {}, instance_selection=True)
        self.facts = facts_of(self.state.to_dict(), self.ids, self.rooms)
        self.walked_to = ""  # the last that the agent walked to
        self.carried: dict[str, list[tuple[str, str]]] = {}  # what was on or in each thing when the last was picked up

    def act(self, action: str, args: list[str], ours: Json) -> Json:
        """Executes an action; a walk to its object and the plug of a device come before it, as in exported programs."""
        if action in HEADS:
            return self._answer(True, "")
        if action not in WORDS:
            return self._answer(False, f"VirtualHome's graph has no {action}")
        lines, before = self._lines(action, args), self.state
        for line in lines:
            executor = self.simulator.Executor(self.simulator.Graph(before.to_dict()), {})
            done, state = executor.execute_one_step(self.simulator.script([line]), self.state)
            if not done:
                self.state = before
                return self._answer(False, executor.info.get_error_string().strip() or f"{line} cannot be executed")
            self.state = state
        walks = [line for line in lines if line.startswith("[Walk]")]
        if walks:
            self.walked_to = self._object_of(walks[-1])
        return self._answer(True, "")

    def _lines(self, action: str, args: list[str]) -> list[str]:
        lines = []
        target = args[-1] if args else ""
        if target and action != "go_to" and target != self.walked_to and target not in self.facts.held:
            lines.append(self._line("Walk", [target]))
        if action == "turn_on" and "unplugged" in self.facts.states.get(target, []):
            lines.append(self._line("PlugIn", [target]))
        held = self.facts.held[:1] if action in ("place_on", "place_in") else []
        lines.append(self._line(WORDS[action], [*held, *args]))
        if action == "pick_up":
            self.carried = {name: self._load_of(name) for name in self.facts.states}
            lines += self._load_again(target, self.carried.get(target, []), True, {target})
        elif held:
            inside = [one for one in self.carried.get(held[0], []) if one[0] == "inside"]
            lines += self._load_again(held[0], inside, False, {held[0]})
        return lines

    def _load_of(self, thing: str) -> list[tuple[str, str]]:
        """What is on or in a thing, without what is so only by something else that is: (relation, id)."""
        over = sorted((one, relation) for relation, one, place in self.facts.edges if place == thing and relation in ("on", "inside"))
        names = {one for one, _ in over}
        indirect = {one for relation, one, place in self.facts.edges if relation in ("on", "inside") and place in names}
        return [(relation, one) for one, relation in over if one not in indirect]

    def _load_again(self, thing: str, load: list[tuple[str, str]], in_hand: bool, again: set[str]) -> list[str]:
        """Lines that put what was on or in a thing there again, and what was on or in that. `again`: things that have their
        lines; in a home two may rest on each other."""
        shut = any(relation == "inside" for relation, _ in load) and "closed" in self.facts.states.get(thing, [])
        lines = [self._line("Open", [thing])] if shut else []
        for relation, one in load:
            if one in again:
                continue
            again.add(one)
            lines += [self._line("Walk", [one]), self._line("Grab", [one])]
            if not in_hand:
                lines.append(self._line("Walk", [thing]))
            lines.append(self._line("PutBack" if relation == "on" else "PutIn", [one, thing]))
            lines += self._load_again(one, self.carried.get(one, []), False, again)
        return [*lines, self._line("Close", [thing])] if shut else lines

    def _object_of(self, line: str) -> str:
        """Our id of the last object or room that a line names."""
        number = int(line[line.rindex("(") + 1 : line.rindex(")")])
        return self.ids[number] if number in self.ids else self.rooms[number]

    def _line(self, word: str, objects: list[str]) -> str:
        parts = [self.names.get(one) or self.room_names[one] for one in objects]
        return " ".join([f"[{word}]", *(f"<{part.rsplit('_', 1)[0]}> ({part.rsplit('_', 1)[1]})" for part in parts)])

    def _answer(self, success: bool, message: str) -> Json:
        now = facts_of(self.state.to_dict(), self.ids, self.rooms) if success else self.facts
        answer = {"success": success, "message": " ".join(message.split()), **self.facts.changes_to(now)}
        self.facts = now
        return answer


def make() -> Callable[[Json], Acting]:
    simulator = load_simulator()
    return lambda params: Episode(Path(params["folder"]), params["task"], params["rooms"], simulator)


if __name__ == "__main__":
    serve(make)
