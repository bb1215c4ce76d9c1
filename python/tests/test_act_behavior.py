"""Acting in OmniGibson: the backend of `unietp evaluate` with the stand-in's object states, and primitives and a scene of a
few lines. checks/judges runs it with the primitives and the BDDL backend of the real package."""

import importlib.util
import json
from pathlib import Path
from types import SimpleNamespace

import act_behavior
import pytest
from acting import Facts

STAND_INS = Path(__file__).parent / "stand_ins" / "omnigibson" / "object_states" / "__init__.py"
spec = importlib.util.spec_from_file_location("stand_in_states", STAND_INS)
states = importlib.util.module_from_spec(spec)
spec.loader.exec_module(states)

ABILITIES = {
    "apple": [states.Temperature, states.MaxTemperature, states.Cooked, states.Burnt, states.Heated],
    "microwave": [states.Open, states.ToggledOn, states.HeatSourceOrSink], "mug": [states.Filled, states.Contains],
    "fridge": [states.Open], "table": [], "floors": [],
}  # fmt: skip
SOURCE = {"temperature": 100.0, "heating_rate": 0.1, "requires_inside": 1, "requires_closed": 1, "requires_toggled_on": 1}
OBJECTS = {name: name for name in ("apple_1", "microwave_1", "mug_1", "fridge_1", "table_1", "kitchen_1")}
START = {
    "apple_1": ["raw", "room_temperature", "unburnt", "whole"], "microwave_1": ["closed", "power_off"], "mug_1": ["clean", "empty"],
    "fridge_1": ["closed"], "table_1": ["dirty"],
}  # fmt: skip


class Thing:
    def __init__(self, name):
        self.name = name
        self.category = "floors" if name == "kitchen_1" else name.split("_")[-2]
        self.fixed_base = self.category in ("microwave", "fridge", "table", "floors")
        self.place = None
        kinds = [states.OnTop, states.Inside, states.AttachedTo, states.Covered, *ABILITIES[self.category]]
        self.states = {kind: kind(self, **(SOURCE if kind is states.HeatSourceOrSink else {})) for kind in kinds}


class Refused(Exception):
    def __init__(self, why):
        self.exceptions = (why,)


class Primitives:
    def __init__(self, env):
        self.env, self.held, self.done = env, None, []

    def _get_obj_in_hand(self):
        return self.held

    def _empty_action(self):
        return None

    def apply_ref(self, primitive, *args, attempts):
        self.done.append(" ".join([primitive, *(thing.name for thing in args)]))
        if primitive in ("OPEN", "CLOSE", "TOGGLE_ON") and self.held:
            raise Refused("the hand is full")
        if primitive in ("OPEN", "CLOSE"):
            args[0].states[states.Open].set_value(primitive == "OPEN")
        elif primitive in ("TOGGLE_ON", "TOGGLE_OFF"):
            args[0].states[states.ToggledOn].set_value(primitive == "TOGGLE_ON")
        elif primitive == "GRASP":
            self.held, args[0].place = args[0], None
        elif primitive == "RELEASE":
            self.held.place, self.held = (states.OnTop, self.env.things["kitchen_1"]), None
        elif primitive in ("PLACE_INSIDE", "PLACE_ON_TOP"):
            kind = states.Inside if primitive == "PLACE_INSIDE" else states.OnTop
            self.held.place, self.held = (kind, args[0]), None
        elif primitive == "CUT":
            for number in range(2):
                half = Thing("half_apple_1")
                half.place, half.name = args[0].place, f"half_{args[0].name}_{number}"
                self.env.things[half.name] = half
        yield None


class Environment:
    def __init__(self, configs):
        self.things = {name: Thing(name) for name in OBJECTS}
        systems = {name: SimpleNamespace(name=name) for name in ("stain", "water")}
        registry = SimpleNamespace(objects=list(systems.values()))
        self.robots = [SimpleNamespace(set_position_orientation=lambda *_: None)]
        self.scene = SimpleNamespace(
            object_registry=lambda _, name: self.things.get(name), get_system=systems.get, system_registry=registry
        )
        self.steps = 0

    def reset(self): ...

    def step(self, _):
        self.steps += 1
        apple = self.things["apple_1"]
        kind, place = apple.place or (None, None)
        if kind is states.Inside and states.HeatSourceOrSink in place.states and place.states[states.HeatSourceOrSink].is_on():
            warm = apple.states[states.Temperature]
            warm.set_value(warm.value + (SOURCE["temperature"] - warm.value) * SOURCE["heating_rate"] / 30)


class Entity:
    def __init__(self, name, thing):
        self.thing = thing

    def set_entity(self, thing):
        self.thing = thing

    def clear_entity(self):
        self.thing = None


NAMES = ("GRASP", "RELEASE", "PLACE_INSIDE", "PLACE_ON_TOP", "OPEN", "CLOSE", "TOGGLE_ON", "TOGGLE_OFF", "CUT", "NAVIGATE_TO")
GIBSON = SimpleNamespace(
    og=SimpleNamespace(sim=None, Environment=Environment),
    states=states,
    symbolic=SimpleNamespace(
        SymbolicSemanticActionPrimitives=Primitives,
        SymbolicSemanticActionPrimitiveSet={name: name for name in NAMES},
        ActionPrimitiveErrorGroup=Refused,
    ),
    bddl=SimpleNamespace(BDDLEntity=Entity),
)


@pytest.fixture
def episode(tmp_path):
    names = {"apple_1": "apple.n.01_1", "apple_1/1": "half__apple.n.01_1", "apple_1/2": "half__apple.n.01_2"}
    task = {"scene_objects": OBJECTS, "objects": names, "substances": {"stain": "stain.n.01_1"}}
    (tmp_path / "task.json").write_text(json.dumps(task))
    problem = tmp_path / "activity_definitions" / "task" / "problem0.bddl"
    problem.parent.mkdir(parents=True)
    problem.write_text("")
    edges = {("on_floor", "table_1", "kitchen_1"), ("in_room", "table_1", "kitchen_1"), ("on", "apple_1", "table_1")}
    return act_behavior.Episode(tmp_path, "task", Facts(dict(START), edges), GIBSON)


def node(name, *now, **more):
    return {"id": name, "states": list(now), "category": name.split("_")[0], **more}


def test_a_start_is_brought_about(episode):
    stain = episode.env.scene.get_system("stain")
    assert episode.objects["table_1"].states[states.Covered].get_value(stain)
    assert not episode.objects["mug_1"].states[states.Covered].get_value(stain)


def test_what_is_carried_is_held_and_then_lies_where_it_was_put(episode):
    answer = episode.act("pick_up", ["apple_1"], {})
    assert answer["success"] and answer["held"] == ["apple_1"]
    assert answer["edges_removed"] == [("on", "apple_1", "table_1")]
    answer = episode.act("place_on", ["table_1"], {})
    assert answer["held"] == []
    assert answer["edges_added"] == [("in_room", "apple_1", "kitchen_1"), ("on", "apple_1", "table_1")]


def test_a_full_hand_is_emptied_to_open_and_filled_again(episode):
    episode.act("pick_up", ["mug_1"], {})
    answer = episode.act("open", ["fridge_1"], {"nodes": [node("fridge_1", "open")]})
    assert episode.primitives.done[1:] == ["RELEASE", "OPEN fridge_1", "GRASP mug_1"]
    assert answer["states"] == {"fridge_1": ["open"]} and episode.facts.held == ["mug_1"]


def test_time_passes_until_what_is_hot_in_our_physics_is_hot(episode):
    episode.act("pick_up", ["apple_1"], {})
    episode.act("place_in", ["microwave_1"], {})
    answer = episode.act("turn_on", ["microwave_1"], {"nodes": [node("apple_1", "hot", "raw", "unburnt", "whole")]})
    assert answer["states"]["apple_1"] == ["hot", "raw", "unburnt", "whole"]
    assert episode.objects["apple_1"].states[states.Temperature].value >= act_behavior.HOT_C
    steps = episode.env.steps
    episode.act("turn_off", ["microwave_1"], {"nodes": [node("apple_1", "hot", "raw", "unburnt", "whole")]})
    assert episode.env.steps < steps + 5, "what was hot before is not waited for"


def test_cooking_in_a_device_leaves_it_as_it_was(episode):
    episode.act("pick_up", ["apple_1"], {})
    episode.act("cook_with", ["microwave_1"], {"nodes": [node("apple_1", "cooked", "hot", "unburnt", "whole")]})
    assert [one.split()[0] for one in episode.primitives.done] == [
        "GRASP", "RELEASE", "OPEN", "GRASP", "PLACE_INSIDE", "CLOSE", "TOGGLE_ON", "TOGGLE_OFF", "OPEN", "GRASP", "RELEASE",
        "CLOSE", "GRASP",
    ]  # fmt: skip
    assert "cooked" in episode.facts.states["apple_1"] and episode.facts.held == ["apple_1"]
    assert episode.facts.states["microwave_1"] == ["closed", "power_off"]


def test_what_is_burnt_is_cooked_too(episode):
    """OmniGibson burns at 200 degrees Celsius what it takes pastry dough 204 to be cooked at."""
    apple = episode.objects["apple_1"]
    apple.states[episode.gibson.states.Burnt].set_value(True)
    answer = episode.act("pick_up", ["apple_1"], {})
    assert {"cooked", "burnt"} <= set(answer["states"]["apple_1"])
    assert not {"raw", "unburnt"} & set(answer["states"]["apple_1"])


def test_cooking_in_a_device_shows_each_moment(episode):
    episode.act("pick_up", ["apple_1"], {})
    answer = episode.act("cook_with", ["microwave_1"], {"nodes": [node("apple_1", "cooked", "hot", "unburnt", "whole")]})
    doors = [moment["states"]["microwave_1"] for moment in answer["moments"] if "microwave_1" in moment["states"]]
    assert doors == [["open", "power_off"], ["closed", "power_off"], ["closed", "power_on"], ["closed", "power_off"],
                     ["open", "power_off"], ["closed", "power_off"]]  # fmt: skip
    assert any(("inside", "apple_1", "microwave_1") in moment["edges_added"] for moment in answer["moments"])
    assert "microwave_1" not in answer["states"], "which as a whole is as before"


def test_what_no_primitive_does_is_set(episode):
    answer = episode.act("fill_with", ["microwave_1"], {"nodes": [node("mug_1", "clean", "filled(water)")]})
    assert answer["success"]
    episode.act("go_to", ["mug_1"], {})
    assert episode.facts.states["mug_1"] == ["clean", "filled(water)"]
    episode.act("pour_to", ["microwave_1"], {"nodes": [node("mug_1", "clean", "empty")]})
    assert episode.facts.states["mug_1"] == ["clean", "empty"]


def test_a_thing_that_is_cut_is_two_halves(episode):
    piece = node("apple_1_slice_1", "raw", "room_temperature", "unburnt", slice_of="apple_1")
    answer = episode.act("slice", ["apple_1"], {"nodes": [node("apple_1", "raw", "sliced"), piece]})
    assert "sliced" in answer["states"]["apple_1"] and "apple_1_slice_1" in answer["states"]
    assert episode.objects["apple_1_slice_1"].name == "half_apple_1_1"
    assert episode.entities["apple.n.01_1"].thing is None
    assert episode.entities["half__apple.n.01_1"].thing is episode.objects["apple_1"]


def test_what_omnigibson_refuses_is_told_and_changes_nothing(episode, monkeypatch):
    monkeypatch.setattr(act_behavior, "NEEDS_FREE_HAND", ())
    episode.act("pick_up", ["mug_1"], {})
    before = episode.facts
    answer = episode.act("open", ["fridge_1"], {})
    assert (answer["success"], answer["message"], answer["states"]) == (False, "the hand is full", {})
    assert episode.facts is before
    assert episode.act("sit_on", ["table_1"], {})["message"] == "OmniGibson has no sit_on"
    assert episode.act("open", ["door_9"], {})["message"] == "OmniGibson has no door_9"
