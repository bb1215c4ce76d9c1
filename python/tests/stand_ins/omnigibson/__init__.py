"""A stand-in for OmniGibson where Isaac Sim cannot run; PYTHONPATH puts it before the package from PyPI (`omnigibson` 1.1.1).

The package lends what needs no simulator: the symbolic primitives with all that they require and check, and the BDDL
backend. The things of a scene have the abilities of their synsets in `bddl`, and states of those names
(object_states). They have no shapes: a thing is in the relation that `:init` or a primitive says. Particles come out of
nothing, and nothing cleans but what a primitive or a setter does. A step is 1/30 s, in which heat flows as in OmniGibson.
"""

import importlib.abc
import importlib.machinery
import importlib.util
import json
import sys
import types
from functools import cache
from pathlib import Path

from bddl.activity import Conditions
from bddl.object_taxonomy import ObjectTaxonomy

HERE = Path(__file__).parent
STEP_S = 1 / 30
COOLING = 0.02  # of the difference to the room's temperature, per second
LENT = (
    "omnigibson.action_primitives.symbolic_semantic_action_primitives",
    "omnigibson.action_primitives.action_primitive_set_base",
    "omnigibson.utils.bddl_utils",
    "omnigibson.utils.python_utils",
)
OWN = ("omnigibson.object_states", "omnigibson.action_primitives.starter_semantic_action_primitives", "omnigibson.transition_rules")
FOREIGN = ("torch", "omnigibson", "cv2", "h5py")  # the rest of these is a module that has every name


class _AnyName(type):
    def __getattr__(cls, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Anything

    def __iter__(cls):
        return iter(())


class Anything(metaclass=_AnyName):
    """The class of everything in a module that is not there."""

    def __init__(self, *_, **__): ...

    def __class_getitem__(cls, _):
        return cls

    def __setattr__(self, *_): ...

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Anything()

    def __call__(self, *_, **__):
        return Anything()


class _Finder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    def find_spec(self, name, path, target=None):
        if name in LENT or name in OWN or not any(name == one or name.startswith(one + ".") for one in FOREIGN):
            return None
        return importlib.machinery.ModuleSpec(name, self, is_package=True)

    def create_module(self, spec):
        module = types.ModuleType(spec.name)
        module.__path__ = [str(Path(folder, *spec.name.split(".")[1:])) for folder in __path__]
        module.__getattr__ = lambda name: _attribute(spec.name, name)
        return module

    def exec_module(self, module): ...


def _attribute(module, name):
    if name.startswith("__"):
        raise AttributeError(name)
    return importlib.import_module(f"{module}.{name}") if f"{module}.{name}" in (*LENT, *OWN) else Anything


def _package():
    """The folder of the package from PyPI."""
    for entry in sys.path:
        folder = Path(entry, "omnigibson")
        if folder.is_dir() and folder.resolve() != HERE:
            return str(folder)
    raise ImportError("the package omnigibson is not installed")


__path__ = [str(HERE), _package()]
sys.meta_path.insert(0, _Finder())
TAXONOMY = ObjectTaxonomy()
sim = None


def clear(): ...


SYNSETS = {category: synset for synset in TAXONOMY.get_all_synsets() for category in TAXONOMY.get_categories(synset)}


@cache
def _abilities_of(category):
    return TAXONOMY.get_abilities(SYNSETS[category]) if category in SYNSETS else {}


@cache
def _substance_of(synset):
    return TAXONOMY.get_subtree_substances(synset)[0]


class System:
    def __init__(self, name):
        self.name, self.initialized = name, True


class Registry:
    def __init__(self, scene):
        self.scene = scene

    def __call__(self, key, name):
        return self.scene.things.get(name)

    @property
    def objects(self):
        return list(self.scene.systems.values())


class Thing:
    """An object of a scene."""

    initialized, root_link = True, "base_link"

    def __init__(self, scene, name, category, fixed_base=False, in_rooms=(), scale=None, **_):
        from omnigibson import object_states as kinds

        self.scene, self.name, self.category, self.fixed_base, self.in_rooms = scene, name, category, fixed_base, list(in_rooms)
        self.scale, self.position = scale, None  # in m, of a floor: that of a cube of 1 m, and its middle
        self._place = None
        self._abilities = _abilities_of(category)
        self.states = {kind: kind(self) for kind in kinds.OF_ALL}
        for ability, parameters in self._abilities.items():
            for kind in kinds.OF_ABILITY.get(ability, ()):
                self.states[kind] = kind(self, **parameters)

    @property
    def place(self):
        """The relation that it is in and to what; None where it is not known."""
        return self._place

    @place.setter
    def place(self, place):
        self._place = place
        (self.scene.placed.discard if place is None else self.scene.placed.add)(self)

    def room(self):
        """The room of what a thing is put on or in, or stands in."""
        if self.place is not None:
            return self.place[1].room()
        return self.in_rooms[0] if self.in_rooms else None

    def is_under(self, position):
        """Whether a position (m) is above it; False where its size is not told."""
        if self.position is None or self.scale is None:
            return False
        return all(abs(position[axis] - self.position[axis]) <= self.scale[axis] / 2 for axis in (0, 1))

    def set_position_orientation(self, position=None, orientation=None):
        self.place = position if isinstance(position, tuple) else None

    def get_position_orientation(self):
        return None, None


class Robot:
    """Holds one thing, and lets it fall to the floor that it stands on."""

    exists, initialized, states = True, True, {}

    def __init__(self, scene, name):
        from omnigibson import object_states

        self.scene, self.name, self.room, self.floor = scene, name, None, None
        self._ag_obj_in_hand = {"0": None}
        self.states = {object_states.IsGrasping: object_states.IsGrasping(self)}

    def set_position_orientation(self, position, orientation):
        self.floor = next((one for one in self._floors() if one.is_under(position)), None)

    def _floors(self):
        return [one for one in self.scene.things.values() if one.category == "floors"]

    def get_eef_position(self, arm):
        return None

    def _establish_grasp(self, arm, ag_data, contact_pos):
        self._ag_obj_in_hand[arm] = ag_data[0]

    def release_grasp_immediately(self):
        from omnigibson import object_states

        thing, self._ag_obj_in_hand["0"] = self._ag_obj_in_hand["0"], None
        floors = self._floors()
        here = [self.floor] if self.floor else [one for one in floors if self.room in one.in_rooms]
        thing.place = (object_states.OnTop, (here or floors)[0])


class Scene:
    def __init__(self, file):
        path = Path(file)
        info = json.loads(path.read_text())
        self.things, self.systems, self.placed = {}, {}, set()
        for one in info["objects_info"]["init_info"].values():
            self.things[one["args"]["name"]] = Thing(self, **one["args"])
        for name, one in info.get("state", {}).get("object_registry", {}).items():
            if name in self.things:
                self.things[name].position = one.get("root_link", {}).get("pos")
        self.object_registry = self.system_registry = Registry(self)
        self.transition_rule_api = self
        self.names = info["metadata"]["task"]["inst_to_name"]
        self._put_as_in(path.parents[3] / "activity_definitions" / path.parents[1].name / "problem0.bddl")

    def _put_as_in(self, problem):
        """The file has poses, and where the things are by them is what the problem says."""
        from omnigibson import object_states as kinds

        conditions = Conditions("task", 0, "omnigibson", predefined_problem=problem.read_text())
        for word, *objects in sorted(conditions.parsed_initial_conditions):  # inside the fridge before on top of its plate
            kind = {"ontop": kinds.OnTop, "inside": kinds.Inside, "attached": kinds.AttachedTo}.get(word)
            things = [self.things.get(self.names.get(one)) for one in objects]
            if kind is not None and all(things):
                things[0].place = (kind, things[1])

    @staticmethod
    def named(synset):
        """The substance of a synset."""
        return _substance_of(synset)

    def get_system(self, name, force_init=True):
        return self.systems.setdefault(name, System(name))

    @property
    def active_rules(self):
        from omnigibson.transition_rules import SlicingRule

        return [SlicingRule()]

    def execute_transition(self, added_obj_attrs, removed_objs):
        for whole in removed_objs:
            del self.things[whole.name]
            self.placed.discard(whole)
        for half in added_obj_attrs:
            self.things[half.name] = half


class Environment:
    def __init__(self, configs):
        self.scene = Scene(configs["scene"]["scene_file"])
        self.robots = [Robot(self.scene, configs["robots"][0]["name"])]
        self.scene.get_system("water")

    def reset(self): ...

    def step(self, action):
        from omnigibson import object_states as kinds

        for thing in self.scene.placed:
            temperature = thing.states.get(kinds.Temperature)
            if temperature is None:
                continue
            kind, place = thing.place
            change = (kinds.ROOM_C - temperature.value) * COOLING
            source = place.states.get(kinds.HeatSourceOrSink)
            if source and source.is_on() and source.requires_inside == (kind is kinds.Inside):
                change += (source.temperature - temperature.value) * source.heating_rate
            if change:
                temperature.set_value(temperature.value + change * STEP_S)
