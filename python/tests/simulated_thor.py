"""A small stand-in for AI2-THOR behind its controller: the house's objects as a table of metadata, changed by each call as
AI2-THOR's documentation says. It has no geometry but the children of the house file and the poses of Teleport."""

from __future__ import annotations

import copy
from typing import Any, ClassVar

Json = dict[str, Any]

FLAGS = {
    "isOpen": False, "openness": 0.0, "isToggled": False, "isDirty": False, "isFilledWithLiquid": False, "fillLiquid": None,
    "isCooked": False, "isSliced": False, "isBroken": False, "isUsedUp": False, "temperature": "RoomTemp", "isPickedUp": False,
}
SET: dict[str, Json] = {
    "OpenObject": {"isOpen": True}, "CloseObject": {"isOpen": False}, "ToggleObjectOn": {"isToggled": True},
    "ToggleObjectOff": {"isToggled": False}, "DirtyObject": {"isDirty": True}, "CleanObject": {"isDirty": False},
    "CookObject": {"isCooked": True}, "BreakObject": {"isBroken": True}, "UseUpObject": {"isUsedUp": True},
    "EmptyLiquidFromObject": {"isFilledWithLiquid": False, "fillLiquid": None}, "SliceObject": {"isSliced": True},
}
NEEDS_CHANGE = {"OpenObject", "CloseObject", "ToggleObjectOn", "ToggleObjectOff", "DirtyObject", "SliceObject"}


class Event:
    def __init__(self, metadata: Json):
        self.metadata = metadata


class SimulatedThor:
    """`reset` with a house or a floor plan, then `step`, as `ai2thor.controller.Controller` has them."""

    recorded: ClassVar[dict[str, Json]] = {}  # metadata of floor plans by name

    def __init__(self, **settings: Any):
        self.settings = settings
        self.objects: dict[str, Json] = {}
        self.calls: list[Json] = []
        self.agent: Json = {}
        self.held: str | None = None
        self.floor = "room|2"  # where there is no other place
        self.last_event = Event({})

    def reset(self, scene: Any = None) -> Event:
        self.objects, self.held, self.agent = {}, None, {"position": {"x": 0.0, "y": 0.9, "z": 0.0}}
        if isinstance(scene, str):
            for one in copy.deepcopy(self.recorded[scene])["objects"]:
                kept = {"pickupable": one["mass"] > 0, "moveable": False, **FLAGS}
                self.objects[one["objectId"]] = {**kept, **one, "parentReceptacles": one["parentReceptacles"] or []}
            return self._event(None)
        self.floor = scene["rooms"][0]["id"]
        for room in scene["rooms"]:
            self._add(room["id"], "Floor", {"x": 0.0, "y": 0.0, "z": 0.0}, [])
        for one in scene["objects"]:
            self._add_tree(one, [])
        return self._event(None)

    def step(self, action: Any = None, **arguments: Any) -> Event:
        self.calls.append({"action": action, **arguments})
        unknown = set(arguments) - {
            "objectId", "forceAction", "placeStationary", "openness", "fillLiquid", "position", "rotation", "horizon",
            "standing", "allowDecayTemperature", "standings", "x", "y", "z", "objectPoses",
        }
        if unknown:
            raise ValueError(f"{action}: unknown arguments {sorted(unknown)}")
        if "objectId" in arguments and arguments["objectId"] not in self.objects:
            return self._event(f"no object {arguments['objectId']}")
        method = getattr(self, f"_{action}", None)
        if method is not None:
            return self._event(method(**arguments))
        if action not in SET:
            raise ValueError(f"unknown action {action}")
        return self._event(self._set(action, arguments["objectId"]))

    def _event(self, message: str | None, returned: Any = None) -> Event:
        for one in self.objects.values():
            one["isPickedUp"] = one["objectId"] == self.held
        metadata = {
            "objects": list(self.objects.values()), "agent": self.agent, "lastActionSuccess": message is None,
            "errorMessage": message or "", "actionReturn": returned,
        }
        self.last_event = Event(copy.deepcopy(metadata))
        return self.last_event

    def _add(self, name: str, kind: str, position: Json, parents: list[str]) -> None:
        box = {"center": dict(position), "size": {"x": 0.1, "y": 0.1, "z": 0.1}}
        self.objects[name] = {
            "objectId": name, "objectType": kind, "position": dict(position), "axisAlignedBoundingBox": box,
            "parentReceptacles": parents, **FLAGS,
        }

    def _add_tree(self, one: Json, parents: list[str]) -> None:
        self._add(one["id"], one["objectType"], one["position"], parents or [self.floor])
        if one["objectType"] == "Sink":
            self._add(one["id"] + "___0", "SinkBasin", one["position"], [one["id"]])
        for child in one.get("children", []):
            self._add_tree(child, [one["id"]])

    def _set(self, action: str, name: str) -> str | None:
        thing, change = self.objects[name], SET[action]
        if action in NEEDS_CHANGE and all(thing[key] == value for key, value in change.items()):
            return f"{name} is so already"
        thing.update(change)
        if action == "SliceObject":
            for i in range(6):
                self._add(f"{name}|{thing['objectType']}Sliced_{i}", thing["objectType"] + "Sliced", thing["position"],
                          list(thing["parentReceptacles"]))
        if action == "CloseObject" and thing["objectType"] == "Fridge":
            for inner in self._inside(name):
                inner["temperature"] = "Cold"
        if action == "ToggleObjectOn":
            self._run(thing)
        return None

    def _run(self, appliance: Json) -> None:
        kind = appliance["objectType"]
        for inner in self._inside(appliance["objectId"]):
            if kind in ("Microwave", "Toaster"):
                inner["temperature"] = "Hot"
                inner["isCooked"] = True
            if kind == "CoffeeMachine" and not inner["isFilledWithLiquid"]:
                inner.update(isFilledWithLiquid=True, fillLiquid="coffee", temperature="Hot")

    def _inside(self, name: str) -> list[Json]:
        return [one for one in self.objects.values() if name in one["parentReceptacles"]]

    def _CreateHouse(self, **_: Any) -> None: ...

    def _SetDecayTemperatureBool(self, allowDecayTemperature: bool) -> None: ...

    def _SetObjectPoses(self, objectPoses: list[Json]) -> str | None:
        poses = {one["objectName"]: one for one in objectPoses}
        for name, thing in list(self.objects.items()):
            if not (thing["pickupable"] or thing["moveable"]):
                continue
            if thing["name"] not in poses:
                del self.objects[name]  # as AI2-THOR does
                continue
            pose = poses[thing["name"]]
            center = thing["axisAlignedBoundingBox"]["center"]
            for axis in "xyz":  # the box goes along with the model; turned ones are of equal width and depth here
                center[axis] += pose["position"][axis] - thing["position"][axis]
            thing["position"], thing["rotation"] = dict(pose["position"]), dict(pose["rotation"])
            thing["parentReceptacles"] = self._under(thing)
        return None

    def _under(self, thing: Json) -> list[str]:
        """What a thing has come to rest on: the highest box whose upper side is at its lower one."""
        box = thing["axisAlignedBoundingBox"]
        bottom = box["center"]["y"] - box["size"]["y"] / 2
        places = []
        for other in self.objects.values():
            at, size = (other["axisAlignedBoundingBox"][key] for key in ("center", "size"))
            inside = all(abs(box["center"][axis] - at[axis]) <= size[axis] / 2 for axis in "xz")
            if other is not thing and inside and abs(at["y"] + size["y"] / 2 - bottom) < 0.05:
                places.append(other["objectId"])
        return places or list(thing["parentReceptacles"])

    def _Teleport(self, position: Json, rotation: Json, horizon: float, standing: bool) -> str | None:
        self.agent = {"position": dict(position), "rotation": dict(rotation), "cameraHorizon": horizon}
        return None if standing and -30 <= horizon <= 60 else "no such pose"

    def _FillObjectWithLiquid(self, objectId: str, fillLiquid: str, forceAction: bool = False) -> str | None:
        if fillLiquid not in ("water", "coffee", "wine"):
            return f"unknown liquid {fillLiquid}"
        self.objects[objectId].update(isFilledWithLiquid=True, fillLiquid=fillLiquid)
        return None

    def _OpenObject(self, objectId: str, openness: float = 1.0, forceAction: bool = False) -> str | None:
        self.objects[objectId]["openness"] = openness
        return self._set("OpenObject", objectId)

    def _PickupObject(self, objectId: str, forceAction: bool = False) -> str | None:
        if self.held is not None:
            return "the hand is full"
        self.held = objectId
        self.objects[objectId]["parentReceptacles"] = []
        for inner in self._inside(objectId):
            inner["parentReceptacles"] = [objectId]
        return None

    def _PutObject(self, objectId: str, forceAction: bool = False, placeStationary: bool = False) -> str | None:
        if self.held is None:
            return "the hand is empty"
        place = self.objects[objectId]
        if place["objectType"] in ("Fridge", "Microwave") and not place["isOpen"]:
            return f"{objectId} is closed"
        self.objects[self.held]["parentReceptacles"] = [objectId]
        self.objects[self.held]["position"] = dict(place["position"])
        if place["objectType"] in ("Fridge", "Microwave"):  # around what is in a bowl, too
            for inner in self._inside(self.held):
                inner["parentReceptacles"] = [self.held, objectId]
        self.held = None
        if place["objectType"] in ("CoffeeMachine", "Toaster") and place["isToggled"]:
            self._run(place)  # which works on what is put into it while it is on, too
        return None

    def _DropHandObject(self) -> str | None:
        if self.held is None:
            return "the hand is empty"
        self.objects[self.held]["parentReceptacles"] = [self.floor]
        self.objects[self.held]["position"] = dict(self.agent["position"])
        self.held = None
        return None
