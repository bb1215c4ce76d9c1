"""Habitat (habitat-sim 0.3 with habitat-lab, PyPI `habitat-lab` 0.3.3) as a backend of `unietp evaluate`.

    unietp evaluate out/mine --backend habitat --policy replay --out out/there

The episode's scene is loaded as habitat-lab loads it, kinematically: nothing falls, and actions set the simulator's state, as
the actions of habitat-lab's PDDL domains do. What is put down goes where it is put in our physics and is snapped down by
habitat-lab, which refuses where nothing that it may rest on is below or something else is in the way. What is on, in and open
is read with habitat-lab's own functions: of all movable things at the start, which the first answer tells, then of what was
moved. acting.py describes the protocol.
"""

import gzip
import json
import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from acting import Acting, Facts, Json, serve

ROOT = "data/unietp/"  # where episodes expect the folder
HAND_M = 1.1  # height above the floor of what is carried
REST_M = 0.02  # what is no farther below a thing holds it up
MOVES = ("turn_to", "turn_left", "turn_right", "look_up", "look_down", "move_forward", "move_backward", "move_left", "move_right",
         "turn_base_to_look", "reset_head")  # fmt: skip
PUTS = ("place_on", "place_in", "drop")
TOLD = ("on", "inside", "on_floor", "in_room")


def start_habitat() -> Any:
    """What an episode uses of the packages. Errors: RuntimeError where one is not installed."""
    try:
        import habitat_sim
        import magnum
        import numpy
        from habitat.sims.habitat_simulator import sim_utilities
    except ImportError as error:
        wanted = "conda install habitat-sim withbullet -c conda-forge -c aihabitat, and pip install habitat-lab"
        raise RuntimeError(f"Habitat cannot be imported ({error}): {wanted}") from error
    return SimpleNamespace(sim=habitat_sim, mn=magnum, utilities=sim_utilities, array=numpy.array)


@lru_cache(maxsize=1)
def episodes_of(folder: Path) -> dict[str, Json]:
    text = gzip.decompress((folder / "episodes.json.gz").read_bytes())
    return {one["episode_id"]: one for one in json.loads(text)["episodes"]}


def is_within(x: float, z: float, corners: list[list[float]]) -> bool:
    """Whether a point of the floor is in a polygon, whose corners are points of Habitat's world."""
    odd = False
    for (ax, _, az), (bx, _, bz) in zip(corners, [*corners[1:], corners[0]], strict=True):
        if (az > z) != (bz > z) and x < ax + (z - az) * (bx - ax) / (bz - az):
            odd = not odd
    return odd


class Episode:
    """One task in Habitat."""

    def __init__(self, folder: Path, task: str, start: Facts, habitat: Any, simulator: Any = None):
        """`simulator`: of the episode before, to load this one into; None to make one."""
        self.habitat, self.facts = habitat, start
        self.episode = episodes_of(folder)[task]
        self.sim = self._load(folder, simulator)
        scene = json.loads(self._path(folder, self.episode["scene_id"]).read_text())
        self.regions = {one["name"]: one["poly_loop"] for one in scene["user_defined"]["regions"]}
        self.objects = self._objects(folder)
        self.ours: dict[int, str] = {}  # our id by each object id of the simulator, those of links among them
        for name, thing in self.objects.items():
            self.ours[thing.object_id] = name
            if self._is_articulated(thing):
                self.ours |= dict.fromkeys(thing.link_object_ids, name)
        self.movable = [name for name, thing in self.objects.items() if not self._is_fixed(thing)]
        self.hollow = {edge[2] for edge in start.edges if edge[0] == "inside"}  # things that others are in
        self.hollow |= {name for name, thing in self.objects.items() if self._is_articulated(thing)}
        self.within: dict[str, set[int]] = {}  # object ids that a thing is within
        self.held = list(start.held)
        self.unread = set(self.movable)  # what was moved since it was read
        self._stand(self.episode["start_position"], None)

    # Loading

    @staticmethod
    def _path(folder: Path, name: str) -> Path:
        return folder / name.removeprefix(ROOT)

    def _load(self, folder: Path, simulator: Any) -> Any:
        settings = self.habitat.sim.SimulatorConfiguration()
        settings.scene_dataset_config_file = str(self._path(folder, self.episode["scene_dataset_config"]))
        settings.scene_id = str(self._path(folder, self.episode["scene_id"]))
        settings.enable_physics, settings.create_renderer = True, False
        agent = self.habitat.sim.agent.AgentConfiguration(sensor_specifications=[])
        configuration = self.habitat.sim.Configuration(settings, [agent])
        if simulator is None:
            return self.habitat.sim.Simulator(configuration)
        simulator.close()  # so that no object of the scene before stays
        simulator.reconfigure(configuration)
        return simulator

    def _objects(self, folder: Path) -> dict[str, Any]:
        """The simulator's objects by our ids: furniture that the scene has, and the episode's rigid objects, added here."""
        templates, rigid = self.sim.get_object_template_manager(), self.sim.get_rigid_object_manager()
        for path in self.episode["additional_obj_config_paths"]:
            templates.load_configs(str(self._path(folder, path)))
        added: dict[str, Any] = {}
        count: dict[str, int] = {}
        for config, rows in self.episode["rigid_objs"]:
            name = config.split(".")[0]
            handles = [one for one in templates.get_template_handles(config) if Path(one).name == config]
            if not handles:
                raise ValueError(f"no template {config}")
            thing = rigid.add_object_by_template_handle(handles[0])
            thing.transformation = self.habitat.mn.Matrix4([[rows[j][i] for j in range(4)] for i in range(4)])
            thing.motion_type = self.habitat.sim.physics.MotionType.KINEMATIC
            number = count[name] = count.get(name, -1) + 1
            added[f"{name}_:{number:04d}"] = thing
        objects = {}
        for ours, handle in self.episode["info"]["unietp"]["names"].items():
            thing = added.get(handle) or self.habitat.utilities.get_obj_from_handle(self.sim, handle)
            if thing is None:
                raise ValueError(f"the scene has no {handle}")
            objects[ours] = thing
            for link, position in self.episode["ao_states"].get(handle, {}).items():
                self._set_joint(thing, int(link), position)
        return objects

    @staticmethod
    def _set_joint(thing: Any, link: int, position: float) -> None:
        positions = thing.joint_positions
        positions[thing.get_link_joint_pos_offset(link)] = position
        thing.joint_positions = positions

    @staticmethod
    def _is_articulated(thing: Any) -> bool:
        return hasattr(thing, "link_object_ids")

    def _is_fixed(self, thing: Any) -> bool:
        if self._is_articulated(thing):
            return bool(thing.fixed_base)
        return bool(thing.motion_type == self.habitat.sim.physics.MotionType.STATIC)

    def _joints(self, thing: Any) -> list[int]:
        """The links of what opens that turn or slide."""
        kinds = self.habitat.sim.physics.JointType
        return [link for link in thing.get_link_ids() if thing.get_link_joint_type(link) in (kinds.Revolute, kinds.Prismatic)]

    # Acting

    def act(self, action: str, args: list[str], ours: Json) -> Json:
        target = args[-1] if args else ""
        if target and target not in self.objects and target not in self.regions:
            return self._answer(f"Habitat has no {target}")
        if action == "go_to" or action in MOVES:
            message = ""
        elif action == "pick_up":
            message = self._pick_up(target)
        elif action in PUTS:
            message = self._put(action, target, ours)
        elif action in ("open", "close"):
            message = self._turn_joints(target, ours)
        else:
            message = f"Habitat has no {action}"
        if not message:
            self._stand_as(ours)
        return self._answer(message)

    def _stand_as(self, ours: Json) -> None:
        if pose := ours.get("agent"):
            x, y = pose["position"]
            self._stand([x, 0.0, -y], pose["yaw_rad"] - math.pi / 2)
            for name in self.held:
                self._move(name, self._in_hand(name))

    def _stand(self, position: list[float], turn: float | None) -> None:
        """Puts the agent somewhere in Habitat's world, turned about the upright from looking along -z."""
        agent, array = self.sim.get_agent(0), self.habitat.array
        state = agent.get_state()
        state.position = array(position)
        if turn is not None:
            state.rotation = self.habitat.sim.utils.common.quat_from_angle_axis(turn, array([0.0, 1.0, 0.0]))
        agent.set_state(state)

    def _in_hand(self, name: str) -> Any:
        """The transformation of a thing in the agent's hand."""
        x, y, z = self.sim.get_agent(0).get_state().position
        return self.habitat.mn.Matrix4.from_(
            self.objects[name].transformation.rotation(), self.habitat.mn.Vector3(float(x), float(y) + HAND_M, float(z))
        )

    def _load_of(self, name: str) -> list[str]:
        """What is on or in a thing, and on or in that."""
        places = [name]
        for place in places:
            for relation, thing, holder in sorted(self.facts.edges):
                if holder == place and relation in ("on", "inside") and thing not in places:
                    places.append(thing)
        return places[1:]

    def _move(self, name: str, to: Any) -> None:
        """Moves a thing with all that is on or in it."""
        turn = to @ self.objects[name].transformation.inverted()
        for one in self._load_of(name):
            self._turn(one, turn)
        self.objects[name].transformation = to
        self.unread.add(name)

    def _turn(self, name: str, turn: Any) -> None:
        if name in self.movable:
            self.objects[name].transformation = turn @ self.objects[name].transformation
            self.unread.add(name)

    def _pick_up(self, target: str) -> str:
        if self.held:
            return f"the hand holds {self.held[0]}"
        if target not in self.movable:
            return f"{target} cannot be moved in Habitat"
        self.held = [target]
        self._move(target, self._in_hand(target))
        return ""

    def _put(self, action: str, target: str, ours: Json) -> str:
        if not self.held:
            return "the hand is empty"
        name = self.held[0]
        node = next((one for one in ours.get("nodes", []) if one["id"] == name), None)
        if node is None:
            return f"nothing says where {name} is put"
        mn, thing, before = self.habitat.mn, self.objects[name], self.objects[name].transformation
        x, y, z = node["position"]
        w, i, j, k = node["rotation"]
        turn = mn.Quaternion(mn.Vector3(-j, -w, -i), k)  # fronts look along -y in our frame, along -z in Habitat's
        self._move(name, mn.Matrix4.from_(turn.to_matrix(), mn.Vector3(x, z, -y)))
        below = [one for one, ours_named in self.ours.items() if ours_named == target] or [self.habitat.sim.stage_id]
        load = [self.objects[one].object_id for one in self._load_of(name)]
        if not self._is_articulated(thing):
            placed = thing.transformation
            if not self.habitat.utilities.snap_down(self.sim, thing, below, load):
                self._move(name, before)
                return f"habitat-lab finds nothing below {name} to put it down on"
            snapped, thing.transformation = thing.transformation, placed
            self._move(name, snapped)
        if action == "place_in":
            self.hollow.add(target)
        self.held = []
        return ""

    def _turn_joints(self, target: str, ours: Json) -> str:
        thing = self.objects.get(target)
        if thing is None or not self._is_articulated(thing) or not self._joints(thing):
            return f"{target} has no joints in Habitat"
        node = next((one for one in ours.get("nodes", []) if one["id"] == target), None)
        if node is None:
            return f"nothing says how far {target} opens"
        links = {number: link for number, link in thing.link_object_ids.items() if link in self._joints(thing)}
        before = {number: thing.get_link_scene_node(link).absolute_transformation() for number, link in links.items()}
        for link in links.values():
            self.habitat.utilities.set_link_normalized_joint_position(thing, link, node["opening"])
        for number, link in links.items():  # what is in a drawer goes with it
            turn = thing.get_link_scene_node(link).absolute_transformation() @ before[number].inverted()
            for name in self._load_of(target):
                if number in self.within.get(name, ()):
                    self._turn(name, turn)
        return ""

    # Telling

    def _edges_of(self, name: str) -> Iterator[tuple[str, str, str]]:
        """What a thing that is not held is on and in, by habitat-lab's rays."""
        thing, utilities = self.objects[name], self.habitat.utilities
        self.within[name] = set(utilities.within(self.sim, thing))
        inside = {self.ours[one] for one in self.within[name] if one in self.ours} & self.hollow - {name}
        casts = utilities.object_keypoint_cast(self.sim, thing)
        bottom = min(float(cast.ray.origin[1]) for cast in casts)
        above = {name, *self._load_of(name)}  # the rays begin above what is in a box
        below: set[int] = set()
        for cast in casts:
            others = (hit for hit in cast.hits if self.ours.get(hit.object_id) not in above)
            first = next(others, None)
            if first is not None and bottom - float(first.point[1]) <= REST_M:
                below.add(first.object_id)
        on = {self.ours[one] for one in below if one in self.ours} - inside
        yield from (("inside", name, place) for place in inside)
        yield from (("on", name, place) for place in on)
        if room := self._room_of(thing):
            if self.habitat.sim.stage_id in below and not on and not inside:
                yield "on_floor", name, room
            yield "in_room", name, room

    def _room_of(self, thing: Any) -> str:
        x, _, z = (float(one) for one in thing.transformation.translation)
        return next((name for name, corners in self.regions.items() if is_within(x, z, corners)), "")

    def _states_of(self, name: str) -> list[str]:
        told, thing = self.facts.states.get(name, []), self.objects[name]
        if not self._is_articulated(thing) or not {"open", "closed"} & set(told):
            return told
        is_open = any(self.habitat.utilities.link_is_open(thing, link) for link in self._joints(thing))
        return sorted({*told} - {"open", "closed"} | {"open" if is_open else "closed"})

    def _read(self) -> Facts:
        carried = {*self.held, *(one for held in self.held for one in self._load_of(held))}
        facts = Facts({name: self._states_of(name) if name in self.objects else states for name, states in self.facts.states.items()})
        facts.held = list(self.held)
        facts.edges = {edge for edge in self.facts.edges if edge[0] not in TOLD or edge[1] not in {*self.unread, "agent"}}
        for name in sorted(self.unread - set(self.held)):
            edges = set(self._edges_of(name))
            facts.edges |= {edge for edge in edges if edge[0] in ("on", "inside")} if name in carried else edges
        self.unread.clear()
        x, _, z = (float(one) for one in self.sim.get_agent(0).get_state().position)
        facts.edges |= {("in_room", "agent", name) for name, corners in self.regions.items() if is_within(x, z, corners)}
        return facts

    def _answer(self, message: str) -> Json:
        """`message`: why the action failed; "" when it did not."""
        now = self.facts if message else self._read()
        answer = {"success": not message, "message": message, **self.facts.changes_to(now)}
        self.facts = now
        return answer


def make(start: Callable[[], Any] = start_habitat) -> Callable[[Json], Acting]:
    habitat = start()
    simulator: list[Any] = [None]

    def begin(params: Json) -> Acting:
        episode = Episode(Path(params["folder"]), params["task"], Facts.from_json(params["start"]), habitat, simulator[0])
        simulator[0] = episode.sim
        return episode

    return begin


if __name__ == "__main__":
    serve(make)
