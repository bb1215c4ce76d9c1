"""A stand-in for habitat-sim: a scene of habitat-lab's rearrangement episodes without gravity, contacts or pictures.

It reads the scene instances, models and stages that `unietp export --format habitat` writes, with trimesh and yourdfpy, and
answers rays with their triangles. Nothing collides: there are no contact points. The names are habitat-sim's.

habitat-lab's sim_utilities can be imported after this: what it draws pictures with is empty.
"""

import enum
import importlib.util
import json
import math
import sys
import types
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import magnum as mn
import numpy
import trimesh
import yourdfpy
from empty_modules import EmptyModules, Nothing
from placed_agent import Agent

stage_id = 0
FIRST_ID = 1


class MotionType(enum.Enum):
    STATIC, KINEMATIC, DYNAMIC = range(3)


class JointType(enum.Enum):
    Revolute, Prismatic, Spherical, Fixed = range(4)


class _Module(types.ModuleType):
    def __getattr__(self, name):  # classes that only annotations name
        return Nothing


physics, geo, nav, scene = (_Module(f"habitat_sim.{name}") for name in ("physics", "geo", "nav", "scene"))
physics.MotionType, physics.JointType = MotionType, JointType
agent = SimpleNamespace(AgentConfiguration=lambda sensor_specifications: SimpleNamespace())
SimulatorConfiguration = SimpleNamespace
utils = SimpleNamespace(common=SimpleNamespace(quat_from_angle_axis=lambda angle, axis: (angle, axis)))


class Configuration:
    def __init__(self, sim_cfg, agents):
        self.sim_cfg, self.agents = sim_cfg, agents


class Ray:
    def __init__(self, origin, direction):
        self.origin, self.direction = mn.Vector3(origin), mn.Vector3(direction)


geo.Ray = Ray


class Shape:
    """Triangles in the frame of an object or link."""

    def __init__(self, triangles):
        self.triangles = numpy.asarray(triangles, dtype=float).reshape(-1, 3, 3)
        corners = self.triangles.reshape(-1, 3)
        self.box = (corners.min(axis=0), corners.max(axis=0))


class Triangles:
    """Triangles in the world, and whose each is."""

    def __init__(self, corners, owners):
        self.owners = owners
        self.low, self.high = (numpy.ascontiguousarray(one(corners, axis=1).T) for one in (numpy.min, numpy.max))
        edges = numpy.roll(corners, -1, axis=1) - corners
        self.normals = numpy.cross(edges[:, 0], edges[:, 1])
        self.offsets = numpy.einsum("ij,ij->i", self.normals, corners[:, 0])
        self.inward = numpy.cross(self.normals[:, None], edges)  # from each side
        self.sides = numpy.einsum("ijk,ijk->ij", self.inward, corners)

    def hits(self, origin, direction, farthest):
        """(owner, distance) of the triangles that a ray along an axis hits."""
        end = origin + direction * farthest
        low, high = numpy.minimum(origin, end), numpy.maximum(origin, end)
        near = slice(None)
        for axis in numpy.argsort(high - low):  # those that leave few first
            kept = numpy.flatnonzero((self.low[axis][near] <= high[axis]) & (self.high[axis][near] >= low[axis]))
            near = kept if isinstance(near, slice) else near[kept]
        normals = self.normals[near]
        slope = normals @ direction
        facing = abs(slope) > 1e-12
        distance = (self.offsets[near] - normals @ origin) / numpy.where(facing, slope, 1)
        point = origin + distance[:, None] * direction
        inside = (numpy.einsum("ijk,ik->ij", self.inward[near], point) >= self.sides[near] - 1e-12).all(axis=1)
        hit = facing & inside & (distance >= 0) & (distance <= farthest)
        return zip(self.owners[near][hit].tolist(), distance[hit].tolist(), strict=True)


class Managed:
    changes = 0  # of where anything is, by which the simulator knows that it has to look again

    def __init__(self, handle, number, transformation):
        self.handle, self.object_id, self.transformation = handle, number, transformation

    @property
    def transformation(self):
        return self._transformation

    @transformation.setter
    def transformation(self, to):
        self._transformation = to
        Managed.changes += 1

    @property
    def translation(self):
        return self.transformation.translation

    @translation.setter
    def translation(self, to):
        self.transformation = mn.Matrix4.from_(self.transformation.rotation(), to)


class RigidObject(Managed):
    def __init__(self, handle, number, transformation, shape, motion):
        super().__init__(handle, number, transformation)
        self.shape, self.motion_type = shape, motion
        self.aabb = self.collision_shape_aabb = mn.Range3D(*shape.box)

    def parts(self):
        yield self.object_id, self.shape, self.transformation


class ArticulatedObject(Managed):
    """Of its joints, which are of one degree of freedom, each moves one link."""

    def __init__(self, handle, number, transformation, description, fixed_base):
        super().__init__(handle, number, transformation)
        self.fixed_base, self.description = fixed_base, description
        self.joints = list(description.actuated_joints)
        self.links = [joint.child for joint in self.joints]
        self.link_object_ids = {number + 1 + i: i for i in range(len(self.links))}
        self.shapes = {name: shape_of_link(link) for name, link in description.link_map.items()}
        self.joint_positions = [0.0] * len(self.joints)
        self.joint_position_limits = [[joint.limit.lower for joint in self.joints], [joint.limit.upper for joint in self.joints]]

    @property
    def joint_positions(self):
        return list(self._joint_positions)

    @joint_positions.setter
    def joint_positions(self, to):
        self._joint_positions = list(to)
        Managed.changes += 1

    def get_link_ids(self):
        return list(range(len(self.links)))

    def get_link_joint_type(self, link):
        return JointType.Prismatic if self.joints[link].type == "prismatic" else JointType.Revolute

    def get_link_joint_pos_offset(self, link):
        return link

    def _pose(self, name):
        self.description.update_cfg(dict(zip(self.description.actuated_joint_names, self.joint_positions, strict=True)))
        return mn.Matrix4.of_rows(self.transformation.rows @ self.description.get_transform(name))

    def get_link_scene_node(self, link):
        name = self.links[link]
        return SimpleNamespace(cumulative_bb=mn.Range3D(*self.shapes[name].box), absolute_transformation=lambda: self._pose(name))

    @property
    def aabb(self):
        base = self.description.base_link
        return mn.Range3D(*self.shapes[base].box)

    def parts(self):
        base = self.description.base_link
        numbers = {base: self.object_id, **{self.links[i]: number for number, i in self.link_object_ids.items()}}
        for name, shape in self.shapes.items():
            if shape is not None:
                yield numbers[name], shape, self._pose(name)


def shape_of_link(link):
    triangles = []
    for piece in link.collisions:
        box = trimesh.creation.box(extents=piece.geometry.box.size, transform=piece.origin)
        triangles.append(box.triangles)
    return Shape(numpy.concatenate(triangles)) if triangles else None


@cache  # scenes have many models in common
def shape_of_file(path):
    return Shape(trimesh.load(path, force="mesh").triangles)


class Manager:
    def __init__(self):
        self.things = []

    def get_objects_by_handle_substring(self, part=""):
        return {thing.handle: thing for thing in self.things if part in thing.handle}

    def get_library_has_handle(self, handle):
        return any(thing.handle == handle for thing in self.things)

    def get_library_has_id(self, number):
        return any(thing.object_id == number for thing in self.things)

    def get_object_by_handle(self, handle):
        return next(thing for thing in self.things if thing.handle == handle)

    def get_object_by_id(self, number):
        return next(thing for thing in self.things if thing.object_id == number)


class RigidManager(Manager):
    def __init__(self, simulator):
        super().__init__()
        self.simulator = simulator

    def add_object_by_template_handle(self, template):
        return self.simulator.add_rigid(Path(template), mn.Matrix4.identity_init(), MotionType.DYNAMIC)


class Templates:
    def __init__(self):
        self.files = []

    def load_configs(self, folder):
        self.files += sorted(str(path) for path in Path(folder).glob("*.object_config.json"))

    def get_template_handles(self, part):
        return [file for file in self.files if part in file]


class Simulator:
    def __init__(self, configuration):
        self.reconfigure(configuration)

    def close(self):
        pass

    def reconfigure(self, configuration):
        settings = configuration.sim_cfg
        self.root = Path(settings.scene_dataset_config_file).parent
        self.next_id, self.count, self.seen = FIRST_ID, {}, None
        self.rigid, self.articulated, self.templates, self.agent = RigidManager(self), Manager(), Templates(), Agent()
        scene = json.loads(Path(settings.scene_id).read_text())
        stage = self.root / (scene["stage_instance"]["template_name"] + ".stage_config.json")
        self.stage = shape_of_file(stage.parent / json.loads(stage.read_text())["render_asset"])
        for one in scene["object_instances"]:
            file = self.root / "objects" / (one["template_name"] + ".object_config.json")
            self.add_rigid(file, self._pose(one), MotionType[one["motion_type"]])
        for one in scene["articulated_object_instances"]:
            self._add_articulated(one)

    @staticmethod
    def _pose(instance):
        w, x, y, z = instance["rotation"]
        return mn.Matrix4.from_(mn.Quaternion([x, y, z], w).to_matrix(), instance["translation"])

    def _handle(self, name):
        number = self.count[name] = self.count.get(name, -1) + 1
        return f"{name}_:{number:04d}"

    def add_rigid(self, file, pose, motion):
        shape = shape_of_file(file.parent / json.loads(file.read_text())["collision_asset"])
        thing = RigidObject(self._handle(file.name.split(".")[0]), self.next_id, pose, shape, motion)
        self.next_id += 1
        self.rigid.things.append(thing)
        return thing

    def _add_articulated(self, one):
        name = one["template_name"]
        description = yourdfpy.URDF.load(str(self.root / "urdf" / name / f"{name}.urdf"), load_meshes=False, build_scene_graph=True)
        thing = ArticulatedObject(self._handle(name), self.next_id, self._pose(one), description, one["fixed_base"])
        self.next_id += 1 + len(thing.links)
        self.articulated.things.append(thing)

    def get_rigid_object_manager(self):
        return self.rigid

    def get_articulated_object_manager(self):
        return self.articulated

    def get_object_template_manager(self):
        return self.templates

    def get_agent(self, number):
        return self.agent

    def get_gravity(self):
        return mn.Vector3(0, -9.8, 0)

    def get_stage_initialization_template(self):
        return SimpleNamespace(margin=0.0)

    def perform_discrete_collision_detection(self):
        pass

    def get_physics_contact_points(self):
        return []

    def _see(self):
        if self.seen == Managed.changes:
            return
        self.seen = Managed.changes
        parts = [(stage_id, self.stage, mn.Matrix4.identity_init())]
        parts += (part for thing in [*self.rigid.things, *self.articulated.things] for part in thing.parts())
        corners = [shape.triangles @ pose.rotation().T + numpy.asarray(pose.translation) for _, shape, pose in parts]
        owners = [numpy.full(len(shape.triangles), number) for number, shape, _ in parts]
        self.triangles = Triangles(numpy.concatenate(corners), numpy.concatenate(owners))

    def cast_ray(self, ray, max_distance=100.0):
        self._see()
        origin, direction = numpy.asarray(ray.origin), numpy.asarray(ray.direction)
        first = {}
        for number, distance in self.triangles.hits(origin, direction, max_distance):
            first[number] = min(distance, first.get(number, math.inf))
        hits = [
            SimpleNamespace(object_id=number, ray_distance=distance, point=mn.Vector3(origin + direction * distance))
            for number, distance in sorted(first.items(), key=lambda one: one[1])
        ]
        return SimpleNamespace(hits=hits, ray=ray)


def _prepare_habitat_lab():
    spec = importlib.util.find_spec("habitat")
    if spec is None or not spec.submodule_search_locations:
        return
    sys.meta_path.insert(0, EmptyModules(("habitat.sims.habitat_simulator.debug_visualizer",)))
    for name in ("habitat", "habitat.sims", "habitat.sims.habitat_simulator"):  # without their own starts
        module = types.ModuleType(name)
        module.__path__ = [str(Path(spec.submodule_search_locations[0]).joinpath(*name.split(".")[1:]))]
        sys.modules[name] = module


_prepare_habitat_lab()
