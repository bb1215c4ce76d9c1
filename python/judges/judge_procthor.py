"""ProcTHOR's own databases (PyPI `procthor`) on the houses of a data set, for `checks/judges procthor`.

Of each house: every object has an asset of the database, under the type that this has there; every door and window has one,
in walls and between rooms that are there; every object is in a room, and in the one that its id names, unless it is of a house of
ProcTHOR's own, whose rooms are numbered anew; what has children is a receptacle. Each object that the task names is in the house, but
for pieces that AI2-THOR makes when it cuts, and has an asset that can do what the plan does with it. What lies in or on what is
compared with what may: with the places of ProcTHOR's own houses and of iTHOR's floor plans and, with --types, with AI2-THOR's table of
types. A place that none of these has is told (`unlisted`); with --types it is a fault. The package's own start needs pandas and Unity's
controller, so its files are read.

A floor plan of iTHOR is named only: each object that the plan of the task names is one of it, and what is put is put into its room.
Ids have positions in them, which differ between versions of AI2-THOR: other objects that this one does not have are told (`elsewhere`).

Exit code 1: a house has a fault.
"""

import argparse
import importlib.util
import json
import math
import re
from collections import Counter
from pathlib import Path

from report import finish

EDGE_M = 0.01  # a thing no farther outside a room is in it
OF_PARTS = {"Sink": "SinkBasin", "ShelvingUnit": "Shelf"}  # whose parts, objects of their own, hold things
FIRST_PLAN = {"kitchens": 1, "living_rooms": 201, "bedrooms": 301, "bathrooms": 401}  # as AI2-THOR numbers them
NEEDS = {"open": "CanOpen", "close": "CanOpen", "turn_on": "CanToggleOnOff", "turn_off": "CanToggleOnOff", "slice": "CanBeSliced",
         "place_on": "Receptacle", "place_in": "Receptacle"}  # fmt: skip
STEP = re.compile(r"(\w+)\(([^,)]+)\)")  # of one object


def kind_of(name):
    """The type in the id of an object of a floor plan, or of a part of one: "Sink|+00.48|+00.89|-02.00|SinkBasin"."""
    first, *_, last = name.split("|")
    return last if last.isalpha() else first


class Databases:
    def __init__(self, types=None):
        """`types`: the path of AI2-THOR's table of types; None where it is not at hand."""
        folder = Path(importlib.util.find_spec("procthor").submodule_search_locations[0]) / "databases"
        kinds = json.loads((folder / "asset-database.json").read_text())
        self.assets = {asset["assetId"]: asset for assets in kinds.values() for asset in assets}
        self.holes = set(json.loads((folder / "wall-holes.json").read_text()))
        plans = json.loads((folder / "ai2thor-object-metadata.json").read_text())
        self.plans = {  # the types of the objects of each by their ids
            f"FloorPlan{first + i}": {thing["objectId"]: thing for thing in plan}
            for kind, first in FIRST_PLAN.items()
            for i, plan in enumerate(plans[kind])
        }
        places = json.loads((folder / "receptacles.json").read_text())
        self.places = {(kind, place) for place, kinds in places.items() for kind in kinds}
        for plan in self.plans.values():
            self.places |= {(thing["objectType"], kind_of(place)) for thing in plan.values() for place in thing["parentReceptacles"] or ()}
        self.has_types = types is not None
        if types is not None:
            self.places |= {(kind, place) for kind, row in json.loads(types.read_text()).items() for place in row["compatible_receptacles"]}


def outside_by(x, z, corners):
    """How far a point is outside a polygon; 0 within."""
    odd, nearest = False, math.inf
    for (ax, az), (bx, bz) in zip(corners, [*corners[1:], corners[0]], strict=True):
        if (az > z) != (bz > z) and x < ax + (z - az) * (bx - ax) / (bz - az):
            odd = not odd
        length = (bx - ax) ** 2 + (bz - az) ** 2
        along = max(0.0, min(1.0, ((x - ax) * (bx - ax) + (z - az) * (bz - az)) / length)) if length else 0.0
        nearest = min(nearest, math.hypot(ax + along * (bx - ax) - x, az + along * (bz - az) - z))
    return 0.0 if odd else nearest


def faults_of_object(thing, parent, rooms, own, databases):
    """`own`: the ids of what is of a house of ProcTHOR's own."""
    asset = databases.assets.get(thing["assetId"])
    if asset is None:
        return [f"{thing['id']} has the unknown asset {thing['assetId']}"]
    faults = []
    if thing["objectType"] != asset["objectType"]:
        faults.append(f"{thing['id']} is a {thing['objectType']}, its asset a {asset['objectType']}")
    if parent is not None:
        holder = databases.assets.get(parent["assetId"], {})
        if "Receptacle" not in holder.get("secondaryProperties", ()) and parent["objectType"] not in OF_PARTS:
            faults.append(f"{parent['id']} has children and is no receptacle")
    room = "room|" + thing["id"].split("|")[1]
    if thing["id"] not in own:
        among = {room: rooms[room]} if room in rooms else {}
    else:
        among, room = rooms, "all rooms"
    apart = min((outside_by(thing["position"]["x"], thing["position"]["z"], corners) for corners in among.values()), default=math.inf)
    if apart > EDGE_M:
        faults.append(f"{thing['id']} is {apart:.2f} m outside {room}")
    for child in thing.get("children", ()):
        faults += faults_of_object(child, thing, rooms, own, databases)
    return faults


def faults_of_plan(task, things, databases):
    """What the plan does with assets that cannot do it."""
    faults = []
    for step in task["plan"]:
        found = STEP.fullmatch(step["step"])
        named = task["objects"].get(found[2]) if found else None
        thing = things.get(named)  # none for a piece, or a part of a model
        if thing is None or thing["objectType"] in OF_PARTS:
            continue
        asset = databases.assets.get(thing["assetId"], {})
        if found[1] == "pick_up" and asset.get("primaryProperty") == "Static":
            faults.append(f"{step['step']}: {thing['assetId']} cannot be picked up")
        if found[1] in NEEDS and NEEDS[found[1]] not in asset.get("secondaryProperties", ()):
            faults.append(f"{step['step']}: {thing['assetId']} is not {NEEDS[found[1]]}")
    return faults


def whole_of(named, things):
    """The id of a thing that an id is of, or of a piece or part of; None where there is none."""
    return next((one for one in (named, named.rpartition("|")[0], named.rpartition("___")[0]) if one in things), None)


def places_of(thing):
    """What is in or on what, by types."""
    for child in thing.get("children", ()):
        yield child["objectType"], thing["objectType"]
        yield from places_of(child)


def unlisted(places, known):
    """ "Box in or on Bed: 2", for the places that are not known."""
    counts = Counter(place for place in places if place not in known and (place[0], OF_PARTS.get(place[1])) not in known)
    return "; ".join(f"{kind} in or on {place}: {count}" for (kind, place), count in sorted(counts.items()))


def judge_floor_plan(task, house, databases):
    """The same of a task in a floor plan of iTHOR's own."""
    row = {"task": task["task"], "rooms": len(house["rooms"]), "openings": 0, "objects": 0}
    plan = databases.plans.get(house["scene"])
    if plan is None:
        return row | {"faults": f"no floor plan {house['scene']}"}
    named = {found[2] for step in task["plan"] if (found := STEP.fullmatch(step["step"]))}
    absent = {ours: one for ours, one in task["objects"].items() if whole_of(one, plan) is None}
    faults = [f"{ours}: {house['scene']} has no {one}" for ours, one in absent.items() if ours in named]
    rooms = [[(corner["x"], corner["z"]) for corner in room["floorPolygon"]] for room in house["rooms"]]
    poses = [pose for one in task["start"] for pose in one["call"].get("objectPoses", ())]
    for pose in poses:
        apart = min((outside_by(pose["center"]["x"], pose["center"]["z"], corners) for corners in rooms), default=math.inf)
        if apart > EDGE_M:
            faults.append(f"{pose['objectId']} is put {apart:.2f} m outside the room")
    return row | {"objects": len(poses), "faults": "; ".join(faults), "elsewhere": "; ".join(sorted(set(absent) - named))}


def objects_of(things):
    for thing in things:
        yield thing
        yield from objects_of(thing.get("children", ()))


def judge(path, databases):
    """One row: what a house has, and what is wrong with it."""
    task = json.loads(path.read_text())
    house = json.loads((path.parent / task["house"]).read_text())
    if "scene" in house:
        return judge_floor_plan(task, house, databases)
    rooms = {room["id"]: [(corner["x"], corner["z"]) for corner in room["floorPolygon"]] for room in house["rooms"]}
    own = {one for ours, one in task["objects"].items() if ours == one}
    walls = {wall["id"] for wall in house["walls"]}
    faults = []
    for opening in [*house["doors"], *house["windows"]]:
        if opening["assetId"] not in databases.holes and opening["assetId"] not in databases.assets:
            faults.append(f"{opening['id']} has the unknown asset {opening['assetId']}")
        faults += [f"{opening['id']}: no wall {opening[side]}" for side in ("wall0", "wall1") if opening[side] not in walls]
        faults += [f"{opening['id']}: no room {opening[side]}" for side in ("room0", "room1") if opening[side] not in rooms]
    for thing in house["objects"]:
        faults += faults_of_object(thing, None, rooms, own, databases)
    things = [thing["id"] for thing in objects_of(house["objects"])]
    there = {thing["id"]: thing for thing in objects_of(house["objects"])}
    faults += [f"{one} is there twice" for one in there if things.count(one) > 1]
    faults += [f"{ours} is not in the house" for ours, one in task["objects"].items() if whole_of(one, there) is None]
    faults += faults_of_plan(task, there, databases)
    openings = len(house["doors"]) + len(house["windows"])
    places = [place for thing in house["objects"] for place in places_of(thing)]
    odd = unlisted(places, databases.places)
    faults += [f"where no table has it: {odd}"] if odd and databases.has_types else []
    return {
        "task": task["task"], "rooms": len(rooms), "openings": openings, "objects": len(things), "faults": "; ".join(faults),
        "places": len(places), "unlisted": odd,
    }  # fmt: skip


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=Path, help="what `unietp export --format ai2thor` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write")
    options.add_argument("--types", type=Path, help="AI2-THOR's table of types, object_types.json")
    options = options.parse_args()
    databases = Databases(options.types)
    tasks = [path for path in sorted(options.folder.glob("*.json")) if not path.name.endswith(".house.json")]
    rows = [judge(path, databases) for path in tasks]
    right = sum(not row["faults"] for row in rows)
    objects = sum(row["objects"] for row in rows)
    places = sum(row.get("places", 0) for row in rows)
    odd = Counter()
    for one in (one for row in rows for one in row.get("unlisted", "").split("; ") if one):
        place, _, count = one.rpartition(": ")
        odd[place] += int(count)
    print(f"of {places} things in or on another, {odd.total()} are where no table has such a thing: {dict(odd.most_common())}")
    finish(
        rows,
        options.out,
        f"of {len(rows)} houses with {objects} objects, {right} agree with ProcTHOR's databases",
        lambda row: not row["faults"],
    )


if __name__ == "__main__":
    main()
