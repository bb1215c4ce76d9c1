"""What checks/judges says of a house of ours by ProcTHOR's databases: nothing of a sound one, and each planted fault."""

import json
import sys
from copy import deepcopy
from pathlib import Path
from types import SimpleNamespace

import pytest

sys.path.insert(0, str(Path(__file__).parent.parent / "judges"))

from judge_procthor import judge, kind_of  # noqa: E402

DATABASES = SimpleNamespace(
    assets={
        "Table_1": {"objectType": "DiningTable", "primaryProperty": "Static", "secondaryProperties": ["Receptacle"]},
        "Mug_1": {"objectType": "Mug", "primaryProperty": "CanPickup", "secondaryProperties": []},
        "Mug_still": {"objectType": "Mug", "primaryProperty": "Static", "secondaryProperties": []},
    },
    holes={"Doorway_1"},
    places={("Mug", "DiningTable"), ("Mug", "SinkBasin")},
    has_types=False,
    plans={"FloorPlan9": {"Mug|+00.10|+00.90|+00.20": {"objectType": "Mug"}}},
)


def thing(name, asset, kind, x, **more):
    return {"id": name, "assetId": asset, "objectType": kind, "position": {"x": x, "y": 0.4, "z": 1.0}, **more}


def corners(low, high):
    return [{"x": x, "y": 0, "z": z} for x, z in ((low, 0), (high, 0), (high, 2), (low, 2))]


def sound():
    mug = thing("Mug|2|1", "Mug_1", "Mug", 1.0)
    return {
        "rooms": [{"id": "room|2", "floorPolygon": corners(0, 2)}, {"id": "room|3", "floorPolygon": corners(2, 4)}],
        "walls": [{"id": "wall|2|0"}, {"id": "wall|3|0"}],
        "doors": [
            {"id": "door|2|3", "assetId": "Doorway_1", "wall0": "wall|2|0", "wall1": "wall|3|0", "room0": "room|2", "room1": "room|3"}
        ],
        "windows": [],
        "objects": [thing("DiningTable|2|0", "Table_1", "DiningTable", 1.0, children=[mug])],
    }


TASK = {
    "task": "ai2thor-00001",
    "house": "ai2thor-00001.house.json",
    "objects": {"table_1": "DiningTable|2|0", "mug_1": "Mug|2|1"},
    "plan": [{"step": "pick_up(mug_1)"}, {"step": "place_on(table_1)"}, {"step": "stop()"}],
}


def faults(folder, house, task=TASK):
    (folder / TASK["house"]).write_text(json.dumps(house))
    (folder / "ai2thor-00001.json").write_text(json.dumps(task))
    return judge(folder / "ai2thor-00001.json", DATABASES)["faults"]


def test_a_sound_house_has_no_fault(tmp_path):
    assert faults(tmp_path, sound()) == ""


def table(house):
    return house["objects"][0]


def mug(house):
    return table(house)["children"][0]


PLANTED = {
    "an unknown asset": (lambda house: mug(house).update(assetId="Mug_9"), "Mug|2|1 has the unknown asset Mug_9"),
    "another type": (lambda house: mug(house).update(objectType="Cup"), "Mug|2|1 is a Cup, its asset a Mug"),
    "outside": (lambda house: mug(house)["position"].update(x=2.5), "Mug|2|1 is 0.50 m outside room|2"),
    "no receptacle": (
        lambda house: mug(house).update(children=[thing("Mug|2|2", "Mug_1", "Mug", 1.0)]),
        "Mug|2|1 has children and is no receptacle",
    ),
    "cannot be moved": (lambda house: mug(house).update(assetId="Mug_still"), "pick_up(mug_1): Mug_still cannot be picked up"),
    "not there": (lambda house: table(house).update(children=[]), "mug_1 is not in the house"),
    "twice": (lambda house: table(house)["children"].append(deepcopy(mug(house))), "Mug|2|1 is there twice"),
    "no wall": (lambda house: house["walls"].pop(), "door|2|3: no wall wall|3|0"),
    "no room": (lambda house: house["doors"][0].update(room1="room|9"), "door|2|3: no room room|9"),
    "an unknown door": (lambda house: house["doors"][0].update(assetId="Doorway_9"), "door|2|3 has the unknown asset Doorway_9"),
}


@pytest.mark.parametrize("name", PLANTED)
def test_a_planted_fault_is_named(tmp_path, name):
    plant, said = PLANTED[name]
    house = sound()
    plant(house)
    assert faults(tmp_path, house) == said


def test_a_plan_that_opens_what_does_not_open_is_named(tmp_path):
    plan = [{"step": "open(table_1)"}]
    assert faults(tmp_path, sound(), TASK | {"plan": plan}) == "open(table_1): Table_1 is not CanOpen"


def test_in_a_house_of_procthors_own_ids_need_not_name_rooms(tmp_path):
    house = json.loads(json.dumps(sound()).replace("Mug|2|1", "mug-table|9|0|1"))
    names = {"table_1": "DiningTable|2|0", "mug-table|9|0|1": "mug-table|9|0|1"}
    assert faults(tmp_path, house, TASK | {"objects": names, "plan": []}) == ""
    mug(house)["position"].update(x=9.0)
    assert faults(tmp_path, house, TASK | {"objects": names, "plan": []}) == "mug-table|9|0|1 is 5.00 m outside all rooms"


def test_a_thing_where_no_table_has_one_is_told_and_is_a_fault_by_all_tables(tmp_path):
    house = sound()
    for kind, asset in (("Sink", "Sink_1"), ("Bed", "Bed_1")):
        mug_there = thing(f"Mug|2|{kind}", "Mug_1", "Mug", 1.0)
        house["objects"].append(thing(f"{kind}|2|9", asset, kind, 1.0, children=[mug_there]))
    (tmp_path / TASK["house"]).write_text(json.dumps(house))
    (tmp_path / "ai2thor-00001.json").write_text(json.dumps(TASK))
    receptacle = {"primaryProperty": "Static", "secondaryProperties": ["Receptacle"]}
    more = {"Sink_1": receptacle | {"objectType": "Sink"}, "Bed_1": receptacle | {"objectType": "Bed"}}
    odd = "Mug in or on Bed: 1"
    for has_types, fault in ((False, ""), (True, f"where no table has it: {odd}")):
        databases = SimpleNamespace(**vars(DATABASES) | {"assets": DATABASES.assets | more, "has_types": has_types})
        row = judge(tmp_path / "ai2thor-00001.json", databases)
        assert (row["faults"], row["places"], row["unlisted"]) == (fault, 3, odd)


def test_the_type_of_a_part_is_its_last_word():
    assert kind_of("Mug|+00.10|+00.90|+00.20") == "Mug"
    assert kind_of("Sink|+00.48|+00.89|-02.00|SinkBasin") == "SinkBasin"


MUG = "Mug|+00.10|+00.90|+00.20"
PLAN = {"scene": "FloorPlan9", "rooms": [{"id": "room|2", "floorPolygon": corners(0, 2)}], "metadata": {}}
POSES = [{"objectId": MUG, "center": {"x": 0.1, "y": 0.9, "z": 0.2}}]


def planned(poses=POSES, **objects):
    start = [{"call": {"action": "SetObjectPoses", "objectPoses": poses}}, {"unless": {}, "call": {"action": "CleanObject"}}]
    return TASK | {"objects": {"mug_1": MUG, **objects}, "start": start}


def test_a_task_in_a_floor_plan_names_and_puts_what_the_plan_has(tmp_path):
    assert faults(tmp_path, PLAN, planned()) == ""
    assert faults(tmp_path, PLAN, planned(slice=MUG + "|MugSliced_1")) == "", "a piece"
    assert faults(tmp_path, PLAN, planned(table_1="Table|1")) == "table_1: FloorPlan9 has no Table|1"
    assert faults(tmp_path, PLAN, planned(pan_1="Pan|1")) == "", "of another version, and the plan does nothing with it"
    assert faults(tmp_path, PLAN | {"scene": "FloorPlan500"}, planned()) == "no floor plan FloorPlan500"
    far = [POSES[0] | {"center": {"x": -0.5, "y": 0.9, "z": 0.2}}]
    assert faults(tmp_path, PLAN, planned(far)) == f"{MUG} is put 0.50 m outside the room"
