"""The runner for VirtualHome's graph simulator: with stand-ins for its modules, and with the real ones where installed."""

import copy
import importlib.util
import io
import json
import sys
from pathlib import Path
from types import SimpleNamespace

import act_virtualhome as runner
import pytest

PYTHON = Path(__file__).parents[1]

ROOMS = ["hall_1", "kitchen_1"]  # in another order than by name
IDS = {"mug_1": "mug_20", "apple_1": "apple_21", "plate_1": "plate_22", "table_1": "table_10", "fridge_1": "fridge_11"}


def node(number, name, category="Props", states=(), properties=()):
    return {
        "id": number, "class_name": name, "category": category, "properties": list(properties), "states": list(states),
        "prefab_name": "", "bounding_box": None,
    }


def edge(start, relation, end):
    return {"from_id": start, "relation_type": relation, "to_id": end}


GRAPH = {
    "nodes": [
        node(1, "livingroom", "Rooms"), node(2, "kitchen", "Rooms"), node(3, "floor", "Floor"), node(4, "character"),
        node(10, "table", "Furniture"), node(11, "fridge", "Appliances", ["CLOSED", "ON", "PLUGGED_IN"]), node(20, "mug"),
        node(21, "apple"), node(22, "plate"),
    ],
    "edges": [
        edge(3, "INSIDE", 2), edge(4, "INSIDE", 1), edge(10, "INSIDE", 2), edge(11, "INSIDE", 2), edge(20, "INSIDE", 2),
        edge(21, "INSIDE", 2), edge(22, "INSIDE", 2), edge(10, "ON", 3), edge(22, "ON", 10), edge(21, "ON", 22),
        edge(20, "ON", 3),
    ],
}
NUMBERS = {int(name.split("_")[1]): ours for ours, name in IDS.items()}


def facts(graph):
    return runner.facts_of(graph, NUMBERS, {1: "hall_1", 2: "kitchen_1"})


def test_a_graph_is_told_in_our_words():
    told = facts(GRAPH)
    assert told.states["fridge_1"] == ["closed", "plugged_in", "power_on"]
    assert told.held == []
    assert told.edges == {
        ("on_floor", "table_1", "kitchen_1"), ("on_floor", "mug_1", "kitchen_1"), ("on", "plate_1", "table_1"),
        ("on", "apple_1", "plate_1"), ("in_room", "agent", "hall_1"), ("in_room", "table_1", "kitchen_1"),
        ("in_room", "fridge_1", "kitchen_1"), ("in_room", "mug_1", "kitchen_1"), ("in_room", "apple_1", "kitchen_1"),
        ("in_room", "plate_1", "kitchen_1"),
    }


def test_what_is_carried_in_the_hand_is_in_no_room():
    after = copy.deepcopy(GRAPH)
    after["edges"] = [one for one in after["edges"] if (one["from_id"], one["relation_type"]) != (22, "ON")]
    after["edges"].append(edge(4, "HOLDS_RH", 22))
    changes = facts(GRAPH).changes_to(facts(after))
    assert changes["held"] == ["plate_1"]
    assert changes["edges_added"] == []
    assert changes["edges_removed"] == [
        ("in_room", "apple_1", "kitchen_1"), ("in_room", "plate_1", "kitchen_1"), ("on", "plate_1", "table_1"),
    ]


class State:
    """A graph that notes what it is told to do."""

    def __init__(self, graph, *_, **__):
        self.graph, self.lines = copy.deepcopy(graph), []

    def to_dict(self):
        return self.graph


class Executor:
    def __init__(self, *_):
        self.info = SimpleNamespace(get_error_string=lambda: "<fridge> (11) is\n locked")

    def execute_one_step(self, lines, state):
        after = copy.deepcopy(state)
        after.lines += lines
        if lines[0] == "[Open] <fridge> (11)":
            return False, state
        if lines[0].startswith("[SwitchOff]"):
            after.graph["nodes"][5]["states"] = ["CLOSED", "OFF", "PLUGGED_OUT"]
        return True, after


SIMULATOR = SimpleNamespace(Graph=lambda graph: graph, State=State, Executor=Executor, script=lambda lines: lines)


@pytest.fixture
def folder(tmp_path) -> Path:
    (tmp_path / "task.json").write_text(json.dumps(GRAPH))
    (tmp_path / "task.names.json").write_text(json.dumps(IDS))
    return tmp_path


def test_actions_become_lines_with_a_walk_and_a_plug_where_they_are_needed(folder):
    episode = runner.Episode(folder, "task", ROOMS, SIMULATOR)
    for action, args in (
        ("go_to", ["kitchen_1"]), ("turn_off", ["fridge_1"]), ("turn_on", ["fridge_1"]), ("look_up", []),
        ("pick_up", ["mug_1"]),
    ):
        assert episode.act(action, args, {})["success"], action
    assert episode.state.lines == [
        "[Walk] <kitchen> (2)", "[Walk] <fridge> (11)", "[SwitchOff] <fridge> (11)", "[PlugIn] <fridge> (11)",
        "[SwitchOn] <fridge> (11)", "[Walk] <mug> (20)", "[Grab] <mug> (20)",
    ]


def test_what_lay_on_a_thing_is_put_there_again_after_the_grab(folder):
    episode = runner.Episode(folder, "task", ROOMS, SIMULATOR)
    assert episode.act("pick_up", ["plate_1"], {})["success"]
    assert episode.state.lines == [
        "[Walk] <plate> (22)", "[Grab] <plate> (22)", "[Walk] <apple> (21)", "[Grab] <apple> (21)", "[PutBack] <apple> (21) <plate> (22)",
    ]
    assert episode.walked_to == "apple_1"


def test_things_that_rest_on_each_other_are_taken_up_once(folder):
    graph = copy.deepcopy(GRAPH)
    graph["edges"] += [edge(20, "ON", 21), edge(21, "ON", 20)]
    (folder / "task.json").write_text(json.dumps(graph))
    episode = runner.Episode(folder, "task", ROOMS, SIMULATOR)
    assert episode.act("pick_up", ["plate_1"], {})["success"]
    assert [line for line in episode.state.lines if "Grab" in line] == ["[Grab] <plate> (22)", "[Grab] <apple> (21)", "[Grab] <mug> (20)"]


def test_what_is_inside_is_put_there_once_more_after_the_walk(folder):
    graph = copy.deepcopy(GRAPH)
    for one in graph["edges"]:
        if (one["from_id"], one["to_id"]) == (21, 22):
            one["relation_type"] = "INSIDE"
    (folder / "task.json").write_text(json.dumps(graph))
    episode = runner.Episode(folder, "task", ROOMS, SIMULATOR)
    episode.act("pick_up", ["plate_1"], {})
    episode.facts.held = ["plate_1"]
    before = len(episode.state.lines)
    episode.act("place_on", ["table_1"], {})
    assert episode.state.lines[before:] == [
        "[Walk] <table> (10)", "[PutBack] <plate> (22) <table> (10)", "[Walk] <apple> (21)", "[Grab] <apple> (21)",
        "[Walk] <plate> (22)", "[PutIn] <apple> (21) <plate> (22)",
    ]


def test_what_lies_on_a_plate_in_a_fridge_is_in_the_fridge():
    graph = copy.deepcopy(GRAPH)
    next(one for one in graph["edges"] if one["from_id"] == 22 and one["to_id"] == 10).update(relation_type="INSIDE", to_id=11)
    inside = {edge for edge in facts(graph).edges if edge[0] == "inside"}
    assert inside == {("inside", "plate_1", "fridge_1"), ("inside", "apple_1", "fridge_1")}


def test_what_the_simulator_refuses_changes_nothing(folder):
    episode = runner.Episode(folder, "task", ROOMS, SIMULATOR)
    answer = episode.act("open", ["fridge_1"], {})
    assert answer == {
        "success": False, "message": "<fridge> (11) is locked", "states": {}, "edges_added": [], "edges_removed": [],
    }
    assert episode.state.lines == [], "the walk before it is taken back"
    assert "has no move_forward" in episode.act("move_forward", [], {})["message"]


class Connection:
    """Unity's end of the connection: a scene that is expanded, and a script of which the refrigerator refuses to open."""

    def __init__(self):
        self.calls = []

    def reset(self, environment):
        self.calls.append(f"reset {environment}")
        return environment < 50

    def expand_scene(self, graph, transfer_transform):
        self.graph = copy.deepcopy(graph)
        self.calls.append(f"expand {len(graph['nodes'])}")
        return not any(one["class_name"] == "broken" for one in graph["nodes"]), "cannot place broken"

    def add_character(self, position):
        self.graph["nodes"].append(node(4, "character"))
        self.graph["edges"].append(edge(4, "INSIDE", 1))
        return True

    def environment_graph(self):
        return True, copy.deepcopy(self.graph)

    def render_script(self, lines, recording, skip_animation, image_synthesis):
        self.calls += lines
        if "[open]" in lines[0]:
            return False, {"0": "fridge is locked"}
        if "[grab]" in lines[0]:
            self.graph["edges"] = [one for one in self.graph["edges"] if one["from_id"] != 20] + [edge(4, "HOLDS_RH", 20)]
        return True, ""


def test_unity_is_expanded_to_the_start_and_executes_the_lines(folder):
    connection = Connection()
    episode = runner.Episode(folder, "task", ROOMS, runner.unity_simulator(connection, 3))
    assert connection.calls == ["reset 3", "expand 8"], "all but the character"
    assert ("on", "plate_1", "table_1") in episode.facts.edges and ("in_room", "agent", "hall_1") in episode.facts.edges
    answer = episode.act("pick_up", ["mug_1"], {})
    assert answer["held"] == ["mug_1"]
    assert connection.calls[2:] == ["<char0> [walk] <mug> (20)", "<char0> [grab] <mug> (20)"]
    answer = episode.act("open", ["fridge_1"], {})
    assert not answer["success"] and "fridge is locked" in answer["message"]


def test_what_unity_cannot_bring_about_is_told(folder):
    with pytest.raises(RuntimeError, match="no environment 50"):
        runner.Episode(folder, "task", ROOMS, runner.unity_simulator(Connection(), 50))
    graph = copy.deepcopy(GRAPH)
    graph["nodes"].append(node(30, "broken"))
    (folder / "task.json").write_text(json.dumps(graph))
    with pytest.raises(RuntimeError, match="expand_scene: cannot place broken"):
        runner.Episode(folder, "task", ROOMS, runner.unity_simulator(Connection(), 0))


def test_unity_has_other_names():
    assert runner.unity_line("[PutIn] <dish_bowl> (4) <coffee_table> (9)") == "<char0> [putin] <dishbowl> (4) <coffeetable> (9)"


def test_each_call_is_answered_with_a_line(folder, monkeypatch):
    calls = [
        ("act", {"action": "open", "args": [], "ours": {}}), ("begin", {"task": "task", "folder": str(folder), "rooms": ROOMS}),
        ("act", {"action": "turn_off", "args": ["fridge_1"], "ours": {}}), ("begin", {"task": "task", "folder": str(folder), "rooms": []}),
    ]
    lines = [json.dumps({"jsonrpc": "2.0", "id": i, "method": name, "params": params}) for i, (name, params) in enumerate(calls)]
    monkeypatch.setattr(runner, "load_simulator", lambda: SIMULATOR)
    monkeypatch.setattr(sys, "stdin", io.StringIO("\n".join(lines) + "\n"))
    out = io.StringIO()
    monkeypatch.setattr(sys, "stdout", out)
    runner.serve(runner.make)
    answers = [json.loads(line) for line in out.getvalue().splitlines()]
    assert [answer["id"] for answer in answers] == [0, 1, 2, 3]
    assert "no episode has begun" in answers[0]["error"]["message"]
    assert answers[1]["result"] == {}
    assert answers[2]["result"]["states"] == {"fridge_1": ["closed", "power_off", "unplugged"]}
    assert "2 rooms" in answers[3]["error"]["message"]


def test_the_package_itself_executes_them(folder):
    """Needs the package virtualhome 2.3.0, which is no requirement of the tests; checks/judges runs more of it."""
    if importlib.util.find_spec("virtualhome") is None:
        pytest.skip("virtualhome is not installed")
    graph = copy.deepcopy(GRAPH)
    for one in graph["nodes"]:
        one["properties"] = {"mug": ["GRABBABLE"], "table": ["SURFACES"]}.get(one["class_name"], [])
    (folder / "task.json").write_text(json.dumps(graph))
    episode = runner.Episode(folder, "task", ROOMS)
    assert not episode.act("pick_up", ["table_1"], {})["success"]
    assert episode.act("pick_up", ["mug_1"], {})["held"] == ["mug_1"]
    answer = episode.act("place_on", ["table_1"], {})
    assert answer["success"] and answer["held"] == [] and ["on", "mug_1", "table_1"] in [list(one) for one in answer["edges_added"]]


def test_the_package_itself_carries_what_lies_on_a_plate(folder):
    if importlib.util.find_spec("virtualhome") is None:
        pytest.skip("virtualhome is not installed")
    graph = copy.deepcopy(GRAPH)
    for one in graph["nodes"]:
        one["properties"] = {"mug": ["GRABBABLE"], "apple": ["GRABBABLE"], "plate": ["GRABBABLE"]}.get(one["class_name"], ["SURFACES"])
    graph["nodes"].append(node(12, "desk", "Furniture", properties=["SURFACES"]))
    graph["edges"] += [edge(12, "INSIDE", 2), edge(12, "ON", 3)]
    (folder / "task.json").write_text(json.dumps(graph))
    (folder / "task.names.json").write_text(json.dumps(IDS | {"desk_1": "desk_12"}))
    episode = runner.Episode(folder, "task", ROOMS)
    for action, target in (("pick_up", "plate_1"), ("go_to", "desk_1"), ("place_on", "desk_1")):
        assert episode.act(action, [target], {})["success"], action
        assert ("on", "apple_1", "plate_1") in episode.facts.edges, action
    assert ("on", "plate_1", "desk_1") in episode.facts.edges
