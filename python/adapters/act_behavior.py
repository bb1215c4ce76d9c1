"""BEHAVIOR's simulator OmniGibson (PyPI `omnigibson`, written against 1.1.1) as a backend of `unietp evaluate`.

    unietp evaluate out/mine --backend behavior --policy replay --out out/there

An action becomes OmniGibson's symbolic primitives, which put things where they shall be without moving the arms. Where it
has none for what an action changes (washing at a sink, filling, pouring, spreading), the states are set that our physics
change. Opening and switching need a free hand there, so what is held is let go and taken up again. After each action the
states of the objects that the problem or an action names are translated. An action that fails part of the way is not taken
back. acting.py describes the protocol.
"""

import json
import math
from collections.abc import Callable, Iterator
from functools import cached_property
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from acting import Acting, Facts, Json, answer_of, serve

AGENT = "agent.n.01_1"
ROBOT = {"type": "Fetch", "name": "agent", "obs_modalities": [], "grasping_mode": "sticky", "disable_grasp_handling": True}
WAIT_S = 120  # for what heats or cools
HOT_C = 60.0  # hot begins at 40, and a thing cools down on its way
FRIDGE_C = 10.0  # what is no warmer is cool; OmniGibson knows no such state
PRIMITIVES = {
    "pick_up": "GRASP", "place_on": "PLACE_ON_TOP", "place_in": "PLACE_INSIDE", "drop": "RELEASE", "open": "OPEN",
    "close": "CLOSE", "turn_on": "TOGGLE_ON", "turn_off": "TOGGLE_OFF", "wipe": "WIPE", "slice": "CUT",
}  # fmt: skip
NEEDS_FREE_HAND = ("OPEN", "CLOSE", "TOGGLE_ON", "TOGGLE_OFF")
INSIDE_DEVICE = ("heat_with", "cook_with", "burn_with", "cool_with")  # the held thing is put into the tool for a while
SET = ("wash_with", "fill_with", "pour_to", "spread_to", "fold", "unfold")  # no primitive does this
MOVES = ("turn_to", "turn_left", "turn_right", "look_up", "look_down", "move_forward", "move_backward", "move_left", "move_right")
THERMAL = ("hot", "cool", "cooked", "burnt", "frozen")
TOLD = ("on", "inside", "attached", "on_floor", "in_room")
RELATIONS = {"on": "OnTop", "inside": "Inside", "attached": "AttachedTo"}
# Of each group of ours that OmniGibson knows: the states, and which of them holds by what a thing's states say.
GROUPS: dict[str, tuple[str, ...]] = {
    "Open": ("open", "closed"), "ToggledOn": ("power_on", "power_off"), "Frozen": ("frozen", "thawed"),
    "Cooked": ("cooked", "raw"), "Burnt": ("burnt", "unburnt"), "Heated": ("hot", "room_temperature", "cool"),
    "Folded": ("folded", "unfolded"),
    "Covered": ("dirty", "clean"), "Saturated": ("soaked", "dry"), "Contains": ("filled", "empty"),
}  # fmt: skip
COATS = {"Covered": "stain", "Saturated": "water"}  # what a dirty or soaked thing is covered or saturated with


def start_omnigibson() -> Any:
    """What an episode uses of the package. Errors: RuntimeError where it is not installed."""
    try:
        import omnigibson as og
        from omnigibson import object_states
        from omnigibson.action_primitives import symbolic_semantic_action_primitives as symbolic
        from omnigibson.macros import gm
        from omnigibson.utils import bddl_utils
    except ImportError as error:
        raise RuntimeError(f"OmniGibson cannot be imported ({error}): pip install omnigibson==1.1.1, and Isaac Sim") from error
    gm.ENABLE_OBJECT_STATES = gm.ENABLE_TRANSITION_RULES = gm.USE_GPU_DYNAMICS = True
    return SimpleNamespace(og=og, states=object_states, symbolic=symbolic, bddl=bddl_utils)


class Goal:
    """A goal of a problem, as BEHAVIOR's packages judge it: `bddl` evaluates it on OmniGibson's states."""

    def __init__(self, gibson: Any, entities: dict[str, Any], problem: str):
        """`entities`: of OmniGibson, by their names in the problem."""
        from bddl.activity import Conditions, get_goal_conditions

        conditions = Conditions("task", 0, "omnigibson", predefined_problem=problem)
        self.compiled = get_goal_conditions(conditions, self._backend(gibson), entities, generate_ground_options=False)

    @staticmethod
    def _backend(gibson: Any) -> Any:
        from bddl.logic_base import BinaryAtomicFormula

        class Grasped(BinaryAtomicFormula):
            """`bddl` has the predicate, and OmniGibson the state, but no class that joins them."""

            STATE_NAME = "grasped"

            def _evaluate(self, agent: Any, thing: Any) -> bool:
                return thing.exists and bool(agent.get_state(gibson.states.IsGrasping, thing.wrapped_obj))

            def _sample(self, *_: Any) -> None:
                raise NotImplementedError

        class Backend(gibson.bddl.OmniGibsonBDDLBackend):
            def get_predicate_class(self, predicate_name: str) -> Any:
                return Grasped if predicate_name == "grasped" else super().get_predicate_class(predicate_name)

        return Backend()

    def holds(self) -> bool:
        from bddl.activity import evaluate_goal_conditions

        return bool(evaluate_goal_conditions(self.compiled)[0])


class Episode:
    """One task in OmniGibson."""

    def __init__(self, folder: Path, task: str, start: Facts, gibson: Any):
        self.gibson, self.facts = gibson, start
        self.task: Json = json.loads((folder / f"{task}.json").read_text())
        self.problem = (folder / "activity_definitions" / task / "problem0.bddl").read_text()
        scene = folder / "scenes" / task / "json" / f"{task}_task_{task}_0_0_template.json"
        if gibson.og.sim:
            gibson.og.clear()
        self.env = gibson.og.Environment(
            configs={
                "scene": {"type": "Scene", "scene_file": str(scene)},
                "robots": [ROBOT],
                "task": {"type": "DummyTask"},
            }
        )
        self.env.reset()
        self.robot = self.env.robots[0]
        self.primitives = gibson.symbolic.SymbolicSemanticActionPrimitives(self.env)
        registry = self.env.scene.object_registry
        self.objects = {ours: registry("name", name) for ours, name in self.task["scene_objects"].items()}
        self.rooms = {thing: ours for ours, thing in self.objects.items() if thing.category == "floors"}
        self.named = [name for name in self.task["objects"] if name in self.objects]  # those that are translated
        self.before = {name: set(states) for name, states in start.states.items()}  # in our physics
        self.between: list[Facts] = []  # the states that the last action led through
        self.watch: Callable[[], None] = lambda: None  # called at each of these
        self.cut: set[str] = set()  # wholes that are two halves now
        self.groups = {name: self._groups_of(states) for name, states in start.states.items()}
        for name, states in start.states.items():
            if name in self.objects:
                self._set_states(name, states)
        scope = {theirs: self.objects.get(ours) for ours, theirs in self.task["objects"].items()}
        scope |= {theirs: self._system(ours) for ours, theirs in self.task["substances"].items()}
        self.entities = {name: gibson.bddl.BDDLEntity(name, thing) for name, thing in {**scope, AGENT: self.robot}.items()}

    @cached_property
    def goal(self) -> Goal:
        return self.goal_of(self.problem)

    def goal_of(self, problem: str) -> Goal:
        """The goal of a problem with the objects of this one."""
        return Goal(self.gibson, self.entities, problem)

    def _system(self, substance: str) -> Any:
        return self.env.scene.get_system(substance)

    @staticmethod
    def _groups_of(states: list[str]) -> list[str]:
        names = {state.split("(")[0] for state in states}
        return [group for group, members in GROUPS.items() if names & set(members)]

    # Acting

    def act(self, action: str, args: list[str], ours: Json) -> Json:
        target = self.objects.get(args[-1]) if args else None
        self.between = []
        self.named += [one for one in args if one in self.objects and one not in self.named and self.objects[one] not in self.rooms]
        try:
            if message := self._act(action, args, target, ours):
                return self._answer(message)
        except self.gibson.symbolic.ActionPrimitiveErrorGroup as error:
            return self._answer(str(error.exceptions[0]))
        self.before |= {node["id"]: set(node["states"]) for node in ours.get("nodes", [])}
        return self._answer("")

    def _act(self, action: str, args: list[str], target: Any, ours: Json) -> str:
        """Does an action; why OmniGibson cannot, "" where it can."""
        if action in ("go_to", *MOVES) and (action != "go_to" or target is None or target in self.rooms):
            self._stand_as(ours)
        elif action == "go_to":
            self._do("NAVIGATE_TO", target)
        elif args and target is None:
            return f"OmniGibson has no {args[-1]}"
        elif action == "soak_with":
            ran = self._value(target, "ToggledOn")
            for primitive in ("TOGGLE_ON", "SOAK_UNDER"):
                self._do(primitive, target)
                self._pass()
            self._do("TOGGLE_ON" if ran else "TOGGLE_OFF", target)
        elif action in INSIDE_DEVICE:
            self._put_for_a_while(target, ours)
        elif action in SET:
            for node in ours.get("nodes", []):
                self._set_states(node["id"], node["states"])
        elif action in PRIMITIVES:
            self._do(PRIMITIVES[action], target)
            if action == "slice":
                self._name_halves(args[-1], target.name, ours)
            self._wait(ours)
        else:
            return f"OmniGibson has no {action}"
        return ""

    def _stand_as(self, ours: Json) -> None:
        if agent := ours.get("agent"):
            (x, y), half = agent["position"], agent["yaw_rad"] / 2
            self.robot.set_position_orientation([x, y, 0.0], [0.0, 0.0, math.sin(half), math.cos(half)])

    def _held(self) -> Any:
        return self.primitives._get_obj_in_hand()

    def _do(self, primitive: str, target: Any = None) -> None:
        """Executes a primitive. Errors: ActionPrimitiveErrorGroup."""
        held = self._held() if primitive in NEEDS_FREE_HAND else None
        steps = [("RELEASE", None)] if held else []
        for name, thing in [*steps, (primitive, target), *([("GRASP", held)] if held else [])]:
            which = self.gibson.symbolic.SymbolicSemanticActionPrimitiveSet[name]
            for command in self.primitives.apply_ref(which, *([] if thing is None else [thing]), attempts=1):
                self.env.step(command)

    def _put_for_a_while(self, device: Any, ours: Json) -> None:
        """Puts the held thing into a device until it is as it shall be, takes it out and leaves the device as it was."""

        def do(primitive: str, thing: Any = device) -> None:
            self._do(primitive, thing)
            self._pass()

        held, was_open, ran = self._held(), self._value(device, "Open"), self._value(device, "ToggledOn")
        heat = device.states.get(self.gibson.states.HeatSourceOrSink)
        if held is None or heat is None:
            self._do("PLACE_NEAR_HEATING_ELEMENT", device)  # which says what is wrong
            return
        if heat.requires_inside:
            if was_open is False:
                do("OPEN")
            do("PLACE_INSIDE")
            if was_open is not None:
                do("CLOSE")
        else:
            do("PLACE_NEAR_HEATING_ELEMENT")
        if ran is False:
            do("TOGGLE_ON")
        self._wait(ours)
        self._pass()
        if ran is False:
            do("TOGGLE_OFF")
        if was_open is not None:
            do("OPEN")
        do("GRASP", held)
        if was_open is False:
            do("CLOSE")

    def _pass(self) -> None:
        self.between.append(self._read())
        self.watch()

    def _wait(self, ours: Json) -> None:
        """Lets time pass until what becomes hot, cold or done in our physics is so here, too."""
        awaited = [
            (self.objects[node["id"]], node["id"], state)
            for node in ours.get("nodes", [])
            if node["id"] in self.named
            for state in set(node["states"]) & set(THERMAL) - self.before.get(node["id"], set())
        ]
        for _ in range(WAIT_S * 30):  # a step of OmniGibson is 1/30 s
            if all(self._is_done(name, thing, state) for thing, name, state in awaited):
                return
            self.env.step(self.primitives._empty_action())

    def _is_done(self, name: str, thing: Any, state: str) -> bool:
        if state == "hot" and self.gibson.states.Temperature in thing.states:
            return bool(thing.states[self.gibson.states.Temperature].get_value() >= HOT_C)
        return state in self._states_of(name, thing)

    def _name_halves(self, whole: str, name: str, ours: Json) -> None:
        """OmniGibson names the halves of a thing `half_<name>_0` and `_1`. What remains of the whole is the first here."""
        halves = [self.env.scene.object_registry("name", f"half_{name}_{i}") for i in range(2)]
        pieces = [node["id"] for node in ours.get("nodes", []) if node.get("slice_of") == whole]
        self.cut.add(whole)
        for ours_named, thing in zip([whole, *pieces], halves, strict=False):
            self.objects[ours_named] = thing
            self.groups.setdefault(ours_named, self.groups[whole])
        self.named += [one for one in [whole, *pieces[:1]] if one not in self.named]
        for number, thing in enumerate(halves, 1):
            if entity := self.entities.get(self.task["objects"].get(f"{whole}/{number}", "")):
                entity.set_entity(thing)
        if entity := self.entities.get(self.task["objects"].get(whole, "")):
            entity.clear_entity()

    # States

    def _value(self, thing: Any, state: str, *of: Any) -> bool | None:
        """The value of a state by its name; None where the thing has none."""
        its = thing.states.get(getattr(self.gibson.states, state))
        return None if its is None else bool(its.get_value(*of))

    def _set_states(self, name: str, states: list[str]) -> None:
        """Sets what OmniGibson knows otherwise of the states of a thing."""
        thing, kinds = self.objects[name], self.gibson.states
        for group in self._groups_of(states):
            word = next(one for one in states if one.split("(")[0] in GROUPS[group])
            told = self._group_value(group, thing)
            if told is None or told == word:
                continue
            its = thing.states[getattr(kinds, group)]
            if group in COATS:
                its.set_value(self._system(COATS[group]), word == GROUPS[group][0])
            elif group == "Contains":
                for system in self._liquids(thing):
                    its.set_value(system, False)
                if word.startswith("filled("):
                    thing.states[kinds.Filled].set_value(self._system(word[len("filled(") : -1]), True)
            elif word == "burnt":
                thing.states[kinds.Burnt].set_value(True)
            elif word == "cool":
                thing.states[kinds.Temperature].set_value(FRIDGE_C)
            else:
                its.set_value(word == GROUPS[group][0])
        wanted = {one[len("covered(") : -1] for one in states if one.startswith("covered(")}
        for system in {one.name for one in self._coats(thing)} ^ wanted:
            thing.states[kinds.Covered].set_value(self._system(system), system in wanted)

    def _systems_with(self, thing: Any, state: str) -> Iterator[Any]:
        its = thing.states.get(getattr(self.gibson.states, state))
        return (one for one in self.env.scene.system_registry.objects if its is not None and its.get_value(one))

    def _liquids(self, thing: Any) -> list[Any]:
        return list(self._systems_with(thing, "Contains"))

    def _coats(self, thing: Any) -> list[Any]:
        return [one for one in self._systems_with(thing, "Covered") if one.name != COATS["Covered"]]

    def _states_of(self, name: str, thing: Any) -> list[str]:
        """Those of our states that hold; of a group that OmniGibson does not know of it, what was told before."""
        told = set(self.facts.states.get(name, []))
        for group in self.groups.get(name, []):
            members, value = GROUPS[group], self._group_value(group, thing)
            if value is None:
                continue
            told = {one for one in told if one.split("(")[0] not in members} | {value}
        told = {one for one in told if not one.startswith("covered(")} | {f"covered({one.name})" for one in self._coats(thing)}
        if name in self.cut:
            told = told - {"whole"} | {"sliced"}
        return sorted(told)

    def _group_value(self, group: str, thing: Any) -> str | None:
        states = self.gibson.states
        if group == "Contains":
            if states.Contains not in thing.states:
                return None
            return next((f"filled({one.name})" for one in self._liquids(thing)), "empty")
        value = self._value(thing, group, *([self._system(COATS[group])] if group in COATS else []))
        if value is None:
            return None
        if group == "Heated" and not value:
            return "cool" if thing.states[states.Temperature].get_value() <= FRIDGE_C else "room_temperature"
        return GROUPS[group][0 if value else 1]

    def _read(self) -> Facts:
        named = {name: self.objects[name] for name in self.named if self.objects[name] not in self.rooms}
        movable = {name: thing for name, thing in named.items() if not thing.fixed_base}
        facts = Facts(dict(self.facts.states))
        facts.edges = {one for one in self.facts.edges if one[1] not in movable or one[0] not in TOLD}
        for name, thing in named.items():
            facts.states[name] = self._states_of(name, thing)
        held = self._held()
        for name, thing in movable.items():
            if thing is held:
                facts.held.append(name)
            else:
                facts.edges.update(self._edges_of(name, thing))
        for name, thing in movable.items():
            if thing is not held and (room := self._room_of(name, facts)):
                facts.edges.add(("in_room", name, room))
        return facts

    def _edges_of(self, name: str, thing: Any) -> Iterator[tuple[str, str, str]]:
        for other_name in self.named:
            other = self.objects[other_name]
            for relation, state in RELATIONS.items():
                if other is not thing and other not in self.rooms and self._value(thing, state, other):
                    yield relation, name, other_name
        for floor, room in self.rooms.items():
            if self._value(thing, "OnTop", floor):
                yield "on_floor", name, room

    def _room_of(self, name: str, facts: Facts) -> str:
        """The room of the lowest thing that a thing rests on or in; "" where none is told."""
        seen: set[str] = set()
        while name not in seen:
            seen.add(name)
            below = sorted(one for one in facts.edges if one[1] == name and one[0] in ("on_floor", "in_room", "on", "inside"))
            for relation, _, place in below:
                if relation in ("on_floor", "in_room"):
                    return place
            name = below[0][2] if below else name
        return ""

    def _answer(self, message: str) -> Json:
        """`message`: why the action failed; "" when it did not."""
        moments = [self.facts] if message else [*self.between, self._read()]
        answer = answer_of(message, self.facts, moments)
        self.facts = moments[-1]
        return answer


def make(start: Callable[[], Any] = start_omnigibson) -> Callable[[Json], Acting]:
    gibson = start()
    return lambda params: Episode(Path(params["folder"]), params["task"], Facts.from_json(params["start"]), gibson)


if __name__ == "__main__":
    serve(make)
