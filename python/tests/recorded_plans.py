"""iTHOR's floor plans as AI2-THOR's metadata told of them when they were recorded (`ithor_scenes.json.gz` of the simulators' own
files), in the form of that metadata."""

import gzip
import json
from pathlib import Path
from typing import Any

Json = dict[str, Any]
PROPERTIES = ("toggleable", "openable", "receptacle", "pickupable", "moveable", "sliceable", "cookable", "breakable", "dirtyable")


def vector(values: list[float]) -> Json:
    return dict(zip("xyz", values, strict=True))


def metadata_of(thing: Json) -> Json:
    """An object of a recording. It has no names, for which its ids stand."""
    properties = thing.get("properties", ())
    return {
        "objectId": thing["objectId"], "name": thing["objectId"], "objectType": thing["objectType"],
        "position": vector(thing["position"]), "rotation": vector(thing["rotation"]),
        "axisAlignedBoundingBox": {"center": vector(thing["aabbCenter"]), "size": vector(thing["aabbSize"])},
        "parentReceptacles": list(thing.get("parentReceptacles", [])), "mass": thing["mass"],
        "temperature": thing["temperature"], **{word: word in properties for word in PROPERTIES}, **thing.get("states", {}),
    }  # fmt: skip


def recorded_plans(file: Path) -> dict[str, Json]:
    """The metadata of each plan at its start, by its name."""
    scenes = json.loads(gzip.decompress(file.read_bytes()))["scenes"]
    return {name: {"objects": [metadata_of(one) for one in scene["objects"]]} for name, scene in scenes.items()}
