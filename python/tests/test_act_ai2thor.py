"""Acting in AI2-THOR, against a stand-in for its controller: the backend of `unietp evaluate`."""

import io
import json
import subprocess
import sys
from pathlib import Path

import act_ai2thor
import acting
import pytest
from simulated_thor import SimulatedThor

import unietp
from unietp.program import run_program

PYTHON = Path(__file__).parents[1]
HOUSES = PYTHON.parent / "tests" / "end_to_end" / "homes" / "houses.procthor.jsonl"
RELATIONS = ("on", "inside", "on_floor")


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """Tasks in two houses of ProcTHOR, and their export."""
    folder = tmp_path_factory.mktemp("act_ai2thor")
    for arguments in (
        ["generate", "--native", "--scenes", HOUSES, "--count", 12, "--seed", 5, "--out", folder / "tasks"],
        ["export", folder / "tasks", "--format", "ai2thor", "--out", folder / "out"],
    ):
        run_program(*map(str, arguments))
    return folder


@pytest.fixture(scope="module")
def dataset(folder) -> unietp.Dataset:
    return unietp.load_dataset(folder / "tasks")


def begin(folder, dataset, task, thor=SimulatedThor):
    start, *_ = dataset.scenes(task, "M1")
    edges = [[edge["relation"], edge["from"], edge["to"]] for edge in start["edges"]]
    states = {node["id"]: node["states"] for node in start["nodes"]}
    facts = {"states": states, "edges": edges, "held": start["agent"]["held"]}
    return act_ai2thor.make(thor)({"folder": str(folder / "out"), "task": task, "rooms": [], "start": facts})


def steps_of(dataset, task):
    return [step for step in dataset.demonstration(task).steps if step.action != "stop"]


def delta(step):
    return json.loads(json.dumps(step.changes))


def test_a_demonstration_ends_there_as_it_does_in_our_physics(folder, dataset):
    compared = 0
    for task in dataset:
        episode = begin(folder, dataset, task.id)
        states, edges, held = {}, set(), []
        for step in steps_of(dataset, task.id):
            answer = episode.act(step.action, list(step.args), delta(step))
            assert answer["success"], (task.id, step, answer)
            for name, now in answer["states"].items():
                states.setdefault(name, set()).update(now)
            edges = (edges - set(answer["edges_removed"])) | set(answer["edges_added"])
            held = answer.get("held", held)
        *_, end = dataset.scenes(task.id, "M1")
        steps = steps_of(dataset, task.id)
        moved = {node["id"] for step in steps for node in step.changes.get("nodes", [])}
        carried = {step.args[0] for step in steps if step.action == "pick_up"}
        ours = {(one["relation"], one["from"], one["to"]) for one in end["edges"] if one["from"] in carried}
        known = set(episode.task["objects"])
        for relation, thing, place in ours:
            if relation in RELATIONS and thing in known and (relation == "on_floor" or place in known):
                assert (relation, thing, place) in episode.facts.edges, (task.id, relation, thing, place)
                compared += 1
        assert held == end["agent"]["held"]
        for node in end["nodes"]:
            told = {state for state in episode.facts.states.get(node["id"], []) if node["id"] in moved}
            assert told <= set(node["states"]), (task.id, node["id"], told, node["states"])
            compared += len(told)
    assert compared > 15


def test_only_changes_are_told(folder, dataset):
    task = next(task.id for task in dataset if any(step.action == "pick_up" for step in steps_of(dataset, task.id)))
    episode = begin(folder, dataset, task)
    for step in steps_of(dataset, task):
        answer = episode.act(step.action, list(step.args), delta(step))
        again = episode.translator.read(episode.episode.now())
        assert again == episode.facts
        if step.action == "pick_up":
            assert answer["held"] == list(step.args)
            assert any(edge[1] == step.args[0] for edge in answer["edges_removed"])
            assert not any(edge[1] == step.args[0] for edge in answer["edges_added"])


class Weak(SimulatedThor):
    """Cannot pick anything up."""

    def _PickupObject(self, objectId, forceAction=False):
        return "too heavy"


def test_what_ai2thor_refuses_is_told_and_changes_nothing(folder, dataset):
    refused = 0
    for task in dataset:
        episode = begin(folder, dataset, task.id, Weak)
        for step in steps_of(dataset, task.id):
            before = episode.facts
            answer = episode.act(step.action, list(step.args), delta(step))
            if step.action == "pick_up":
                assert (answer["success"], answer["message"]) == (False, "too heavy")
                assert answer["states"] == {} and answer["edges_added"] == [] and episode.facts == before
                refused += 1
                break
    assert refused > 3
    assert "AI2-THOR has no sit_on" in episode.act("sit_on", ["Sofa|1|1"], {})["message"]


def test_a_start_that_is_another_there_is_told(folder, dataset):
    """The first answer has what differs from our start."""
    for task in dataset:
        start, *_ = dataset.scenes(task.id, "M1")
        closed = next((node for node in start["nodes"] if "closed" in node["states"]), None)
        if closed is None or not steps_of(dataset, task.id):
            continue
        episode = begin(folder, dataset, task.id)
        name = episode.task["objects"].get(closed["id"])
        step = steps_of(dataset, task.id)[0]
        if name is None or closed["id"] in step.args:
            continue
        episode.episode.controller.objects[name]["isOpen"] = True
        episode.episode.controller._event(None)
        answer = episode.act(step.action, list(step.args), delta(step))
        assert "open" in answer["states"][closed["id"]]
        return
    pytest.fail("no task has something that is closed")


def test_calls_are_answered_line_by_line(folder, dataset):
    task = dataset.ids[0] if hasattr(dataset, "ids") else next(iter(dataset)).id
    start = {"states": {}, "edges": [], "held": []}
    params = {"folder": str(folder / "out"), "task": task, "rooms": [], "start": start}
    calls = [("act", {"action": "drop", "args": [], "ours": {}}), ("begin", params),
             ("act", {"action": "drop", "args": [], "ours": {}}), ("begin", {**params, "task": "none"})]  # fmt: skip
    out = io.StringIO()
    lines = [json.dumps({"jsonrpc": "2.0", "id": i, "method": name, "params": p}) for i, (name, p) in enumerate(calls)]
    acting.answer_calls(act_ai2thor.make(SimulatedThor), lines, out)
    answers = [json.loads(line) for line in out.getvalue().splitlines()]
    assert "no episode has begun" in answers[0]["error"]["message"]
    assert answers[1]["result"] == {}
    assert answers[2]["result"]["message"] == "the hand is empty"
    assert "none.json" in answers[3]["error"]["message"]


def test_what_else_an_action_changes_is_changed_there_too(folder, dataset):
    """A tap cleans what stands in its basin, too."""
    task = next(iter(dataset)).id
    episode = begin(folder, dataset, task)
    names = list(episode.task["objects"])[:2]
    for name in names:
        episode.episode.controller.objects[episode.task["objects"][name]]["isDirty"] = True
    episode.episode.controller._event(None)
    row = {"action": "CleanObject", "of": "others", "when": "cleans"}
    episode.task["words"]["actions"] = [{"action": "wash_with", "calls": [row]}]
    ours = {"nodes": [{"id": names[0], "states": ["clean"]}, {"id": names[1], "states": ["dirty"]}]}
    assert episode.act("wash_with", [], ours)["success"]
    dirty = [episode.episode.controller.objects[episode.task["objects"][name]]["isDirty"] for name in names]
    assert dirty == [False, True]


def test_the_pose_is_unitys():
    pose = act_ai2thor.pose_of({"position": [1.0, 2.0], "yaw_rad": 0.0, "pitch_rad": 2.0, "held": []})
    assert pose["position"] == {"x": 1.0, "y": 0.95, "z": 2.0}
    assert pose["rotation"]["y"] == 90.0, "toward +x"
    assert pose["horizon"] == 60.0


def test_the_programs_agree_with_their_types(tmp_path):
    pytest.importorskip("mypy")
    files = sorted((PYTHON / "adapters").glob("*.py"))
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--config-file", PYTHON.parent / "pyproject.toml", "--cache-dir", tmp_path / "cache", *files],
        cwd=tmp_path, capture_output=True, text=True,
    )  # fmt: skip
    assert len(files) == 6 and done.returncode == 0, done.stdout + done.stderr


