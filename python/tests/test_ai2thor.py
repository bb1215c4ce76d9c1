"""The runner of tasks for AI2-THOR, against a stand-in for its controller."""

import copy
import json
import os
import sys
from pathlib import Path

import pytest
import run_ai2thor as runner
from simulated_thor import SimulatedThor

from unietp.program import run_program

PYTHON = Path(__file__).parents[1]
HOUSES = PYTHON.parent / "tests" / "end_to_end" / "homes" / "houses.procthor.jsonl"


@pytest.fixture(scope="module")
def tasks(tmp_path_factory) -> Path:
    """Tasks in two houses of ProcTHOR, exported."""
    folder = tmp_path_factory.mktemp("ai2thor")
    for arguments in (
        ["scene", "import", "auto", HOUSES, "--out", folder / "homes"],
        ["generate", "--count", 16, "--seed", 9, "--simulators", "ai2thor", "--scenes", folder / "homes", "--modes", "M1",
         "--out", folder / "tasks"],
        ["export", folder / "tasks", "--format", "ai2thor", "--out", folder / "out"],
    ):
        run_program(*map(str, arguments))
    return folder / "out"


def names_in(tasks: Path) -> list[str]:
    return sorted(one.stem for one in tasks.glob("*.json") if not one.name.endswith(".house.json"))


def test_every_demonstration_reaches_its_goal(tasks, tmp_path):
    out = tmp_path / "results.jsonl"
    assert runner.main([str(tasks), "--out", str(out)], SimulatedThor) == 0
    lines = [json.loads(line) for line in out.read_text().splitlines()]
    assert [line["task"] for line in lines] == names_in(tasks)
    assert len(lines) >= 12
    for line in lines:
        assert line["success"] and line["failed"] is None and line["moved"] == [] and line["differences"] == [], line


def test_without_the_plan_no_goal_holds(tasks):
    for name in names_in(tasks):
        episode = runner.Episode(*runner.read_task(tasks, name), SimulatedThor())
        assert episode.start()
        assert not episode.success(), name


def test_a_call_that_fails_ends_the_episode_with_its_message(tasks):
    task, house = runner.read_task(tasks, names_in(tasks)[0])
    task["plan"][-1]["calls"] = [{"action": "OpenObject", "objectId": "Nothing|1"}]
    line = runner.run(task, house, SimulatedThor())
    assert not line["success"]
    assert line["failed"]["call"] == {"action": "OpenObject", "objectId": "Nothing|1"}
    assert line["failed"]["message"] == "no object Nothing|1"
    assert line["steps"] == len(task["plan"]) - 1
    task["plan"][0]["calls"] = [{"action": "FlyToTheMoon"}]
    assert runner.run(task, house, SimulatedThor())["failed"]["message"] == "unknown action FlyToTheMoon"


def test_a_coffee_machine_that_is_on_fills_an_empty_mug_that_is_put_into_it():
    def thing(name, kind):
        return {"id": name, "objectType": kind, "position": {"x": 1.0, "y": 0.9, "z": 1.0}}

    thor = SimulatedThor()
    thor.reset({"rooms": [{"id": "room|4"}], "objects": [thing("CoffeeMachine|4|0", "CoffeeMachine"), thing("Mug|4|1", "Mug")]})
    assert thor.objects["Mug|4|1"]["parentReceptacles"] == ["room|4"]
    thor.step("ToggleObjectOn", objectId="CoffeeMachine|4|0")
    assert thor.objects["Mug|4|1"]["fillLiquid"] is None
    for action, name in (("PickupObject", "Mug|4|1"), ("PutObject", "CoffeeMachine|4|0")):
        assert thor.step(action, objectId=name).metadata["lastActionSuccess"]
    assert (thor.objects["Mug|4|1"]["fillLiquid"], thor.objects["Mug|4|1"]["temperature"]) == ("coffee", "Hot")


class Narrow(SimulatedThor):
    """The agent can stand only at the start and at one other place."""

    FREE = {"x": 9.0, "y": 0.9, "z": 9.0}

    def _event(self, message, returned=None):
        asked = self.calls[-1]["action"] if self.calls else ""
        if asked == "GetInteractablePoses":
            returned = [{**self.FREE, "rotation": 0.0, "standing": True, "horizon": 0.0}]
        return super()._event(message, [self.FREE] if asked == "GetReachablePositions" else returned)

    def _Teleport(self, position, **_):
        self.agent = {"position": position}
        at_start = sum(call["action"] == "Teleport" for call in self.calls) == 1
        return None if at_start or position == self.FREE else "no room to stand"

    def _TeleportFull(self, x, y, z, rotation, standing, horizon):
        return self._Teleport({"x": x, "y": y, "z": z})

    def _GetInteractablePoses(self, objectId, standings): ...

    def _GetReachablePositions(self): ...


class Nowhere(Narrow):
    def _Teleport(self, position, **_):
        return "no room to stand"


def test_where_there_is_no_room_the_agent_stands_at_another_place(tasks):
    moved = {"GetInteractablePoses": 0, "GetReachablePositions": 0}
    for number, name in enumerate(names_in(tasks)):
        task, house = runner.read_task(tasks, name)
        if any(one["predicate"] in ("in_room", "on_floor") for one in task["goal"]["propositions"]):
            continue  # of which the other place is none
        for step in task["plan"] if number % 2 else []:
            for call in step["calls"]:
                call.pop("near", None)
        controller = Narrow()
        line = runner.run(task, house, controller)
        assert line["success"], line
        assert len(line["moved"]) == sum(call["action"] in moved for call in controller.calls)
        for call in controller.calls:
            if call["action"] in moved:
                moved[call["action"]] += 1
    assert all(moved.values()), moved
    line = runner.run(task, house, Nowhere())
    assert line["failed"]["step"] == "start" and line["failed"]["message"] == "no room to stand"


def test_a_difference_from_our_physics_is_told(tasks):
    for name in names_in(tasks):
        task, house = runner.read_task(tasks, name)
        for at in range(1, len(task["plan"])):
            new = set(task["plan"][at]["holds"]) - set(task["plan"][at - 1]["holds"])
            if not new or "place_" not in task["plan"][at]["step"]:
                continue
            changed = copy.deepcopy(task)
            changed["plan"][at]["calls"] = [{"action": "DropHandObject"}]
            line = runner.run(changed, house, SimulatedThor())
            if line["success"]:
                continue  # a goal that the place does not decide
            told = {one["proposition"] for one in line["differences"] if one["step"] == at + 1 and not one["value"]}
            assert new & told
            return
    pytest.fail("no plan puts something where it is asked for")


def test_the_controller_of_the_package_takes_the_calls(tasks, tmp_path, monkeypatch):
    """Needs the package ai2thor 5.0.0, which is no requirement of the tests. It starts the stand-in in the place of Unity."""
    pytest.importorskip("ai2thor.controller")
    monkeypatch.setenv("AI2THOR_EXECUTABLE", str(Path(__file__).with_name("thor_process.py")))
    monkeypatch.setenv("DISPLAY", ":0")  # which is only handed on
    monkeypatch.setenv("PATH", f"{Path(sys.executable).parent}:{os.environ['PATH']}")
    out = tmp_path / "results.jsonl"
    assert runner.main([str(tasks), "--out", str(out)]) == 0
    assert all(json.loads(line)["success"] for line in out.read_text().splitlines())


@pytest.mark.parametrize(
    ("formula", "trace", "expected"),
    [
        ("G(F(a))", [[], ["a"]], True),
        ("G(F(a))", [["a"], []], False),
        ("(!(b)) U ((a) & (!(b)))", [[], ["a"], ["b"]], True),
        ("((!(b)) U ((a) & (!(b)))) & (F(b))", [["b"], ["a"]], False),
        ("(a) | (b) | (F(true))", [[]], True),
        ("(false) | (!(a))", [["a"]], False),
    ],
)
def test_formulas(formula, trace, expected):
    states = [{name: name in state for name in "ab"} for state in trace]
    assert runner.read_formula(formula)(states, 0) is expected


def test_what_is_no_formula_is_refused():
    with pytest.raises(ValueError, match="not a formula"):
        runner.read_formula("a -> b")


KITCHEN = HOUSES.with_name("kitchen.ithor.json")


@pytest.fixture(scope="module")
def floor_plans(tmp_path_factory) -> Path:
    """Tasks in a floor plan of iTHOR, exported; their objects do not all start where they are in the floor plan."""
    folder = tmp_path_factory.mktemp("floor_plans")
    for arguments in (
        ["generate", "--native", "--scenes", KITCHEN, "--count", 6, "--seed", 12, "--out", folder / "tasks"],
        ["export", folder / "tasks", "--format", "ai2thor", "--out", folder / "out"],
    ):
        run_program(*map(str, arguments))
    return folder / "out"


class FloorPlans(SimulatedThor):
    recorded = {"FloorPlan9": json.loads(KITCHEN.read_text())}


def test_a_floor_plan_is_loaded_by_its_name_and_nothing_is_lost(floor_plans, tmp_path):
    out = tmp_path / "results.jsonl"
    assert runner.main([str(floor_plans), "--out", str(out)], FloorPlans) == 0
    lines = [json.loads(line) for line in out.read_text().splitlines()]
    assert len(lines) == 6
    assert all(line["success"] and not line["differences"] for line in lines), lines
    moved = 0
    for name in names_in(floor_plans):
        task, house = runner.read_task(floor_plans, name)
        thor = FloorPlans()
        assert house["scene"] == "FloorPlan9" and runner.Episode(task, house, thor).start()
        recorded = {one["objectId"]: one for one in FloorPlans.recorded["FloorPlan9"]["objects"]}
        assert set(thor.objects) == set(recorded)
        wanted = next(one["call"]["objectPoses"] for one in task["start"] if "objectPoses" in one["call"])
        assert len(wanted) == 5
        for one in wanted:
            now = thor.objects[one["objectId"]]["axisAlignedBoundingBox"]["center"]
            assert all(abs(now[axis] - one["center"][axis]) <= runner.NEAR_M for axis in "xyz")
            moved += thor.objects[one["objectId"]]["position"] != recorded[one["objectId"]]["position"]
    assert moved > 0, "some are elsewhere than in the floor plan"


def test_a_model_turns_about_the_middle_of_its_box():
    thing = {
        "objectId": "Mug|1", "objectType": "Mug", "name": "Mug_1", "pickupable": True, "moveable": False,
        "position": {"x": 1.1, "y": 0.9, "z": 0.0}, "rotation": {"x": 0.0, "y": 0.0, "z": 0.0},
        "axisAlignedBoundingBox": {"center": {"x": 1.0, "y": 1.0, "z": 0.0}, "size": {"x": 0.1, "y": 0.2, "z": 0.1}},
    }  # fmt: skip
    place = {"objectId": "Mug|1", "center": {"x": 3.0, "y": 1.0, "z": 2.0}, "rotation": {"x": 0.0, "y": 90.0, "z": 0.0}}
    (pose,) = runner.object_poses([thing], [place])
    assert pose["objectName"] == "Mug_1" and pose["rotation"]["y"] == 90.0
    assert pose["position"] == pytest.approx({"x": 3.0, "y": 0.9, "z": 1.9}), "its handle, once to +x, is now to -z"
    (kept,) = runner.object_poses([thing], [{**place, "center": {"x": 1.0, "y": 1.0, "z": 0.0}, "rotation": thing["rotation"]}])
    assert kept["position"] is thing["position"]
