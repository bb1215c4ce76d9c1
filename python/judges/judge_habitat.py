"""habitat-lab's data set class, trimesh and yourdfpy on the episodes of a data set, for `checks/judges habitat`.

habitat-lab must load every episode. Each scene and each model that an episode names must be there: trimesh reads the meshes,
which must have the size that the scene states, yourdfpy the articulated furniture, whose joints must be those that the
episode sets. Every target must be a movable object of the episode. No package index has a wheel of the simulator itself
(habitat-sim) that runs on Debian 12, so nothing is simulated.

Exit code 1: an episode is not loaded, or names something that is not there or has another size.
"""

import argparse
import gzip
import importlib.util
import json
import os
import sys
import tempfile
import types
from functools import cache
from pathlib import Path

import numpy
import trimesh
import yourdfpy
from empty_modules import EmptyModules
from report import finish

# What habitat-lab imports for simulation and pictures, which its data set classes do not use.
NOT_INSTALLED = ("magnum", "corrade", "habitat_sim", "habitat.tasks", "habitat.sims", "habitat.config", "quaternion", "numba",
                 "cv2", "gym", "omegaconf")  # fmt: skip
TOLERANCE_M = 0.002  # names of stand-ins have whole millimeters
SEEN_SHARE = 0.15  # by which what is round has corners, and handles stand out of what opens


def rearrange_dataset():
    """habitat-lab's class for rearrangement episodes, imported without its simulator."""
    sys.meta_path.insert(0, EmptyModules(NOT_INSTALLED))
    habitat = types.ModuleType("habitat")  # without the package's own start, which needs the simulator
    habitat.__path__ = list(importlib.util.find_spec("habitat").submodule_search_locations)
    sys.modules["habitat"] = habitat
    from habitat.datasets.rearrange.rearrange_dataset import RearrangeDatasetV0

    return RearrangeDatasetV0(None)


@cache
def extents(mesh):
    """The size of a mesh, in Habitat's axes."""
    return trimesh.load(mesh, force="scene").extents


@cache
def robot(urdf):
    return yourdfpy.URDF.load(urdf, load_meshes=False, build_scene_graph=False)


class Folder:
    """The scene data set by the names that its configuration files have for habitat-sim."""

    def __init__(self, root):
        self.root = root
        self.objects = {path.name.split(".")[0]: path for path in root.glob("objects/*.object_config.json")}
        self.articulated = {path.name.split(".")[0]: path for path in root.glob("urdf/*/*.ao_config.json")}

    def faults_of_object(self, name, size):
        if name not in self.objects:
            return [f"no model {name}"]
        config = json.loads(self.objects[name].read_text())
        solid, seen = (self.objects[name].parent / config[asset] for asset in ("collision_asset", "render_asset"))
        for mesh in (solid, seen):
            if not mesh.exists():
                return [f"no mesh {mesh.name}"]
        faults = []
        if size is not None and not numpy.allclose(extents(solid), [size[0], size[2], size[1]], atol=TOLERANCE_M):
            faults.append(f"{name} has the size {extents(solid)}, not {size}")
        if not numpy.allclose(extents(seen), extents(solid), rtol=SEEN_SHARE, atol=TOLERANCE_M):
            faults.append(f"{name} looks {extents(seen)} large and is {extents(solid)}")
        return faults

    def joints_of(self, name):
        """The joints of articulated furniture, in order; None where its files are not there."""
        if name not in self.articulated:
            return None
        config = json.loads(self.articulated[name].read_text())
        urdf = self.articulated[name].parent / config["urdf_filepath"]
        return list(robot(urdf).actuated_joints) if urdf.exists() else None


def faults_of_scene(folder, scene):
    """What the scene of an episode names that is not there."""
    stage = folder.root / (scene["stage_instance"]["template_name"] + ".stage_config.json")
    if not stage.exists():
        return ["no stage"]
    faults = [] if (stage.parent / json.loads(stage.read_text())["render_asset"]).exists() else ["no mesh of the stage"]
    templates = scene["user_defined"]["templates"]
    for instance in scene["object_instances"]:
        name = instance["template_name"]
        faults += folder.faults_of_object(name, templates[name]["size"])
    for instance in scene["articulated_object_instances"]:
        if folder.joints_of(instance["template_name"]) is None:
            faults.append(f"no articulated model {instance['template_name']}")
    return faults


def judge(folder, episode):
    """One row: what an episode has, and what is wrong with it."""
    faults = []
    for path in (episode.scene_id, episode.scene_dataset_config, *episode.additional_obj_config_paths):
        if not Path(path).exists():
            return {"task": episode.info["unietp"]["task"], "faults": f"no file {path}"}
    faults += faults_of_scene(folder, json.loads(Path(episode.scene_id).read_text()))
    for config, transform in episode.rigid_objs:
        faults += folder.faults_of_object(config.split(".")[0], None)
        turn = numpy.array(transform)[:3, :3]
        if not numpy.allclose(turn @ turn.T, numpy.eye(3), atol=1e-4) or numpy.linalg.det(turn) < 0:
            faults.append(f"{config} is not rotated by a rotation")
    for handle, positions in episode.ao_states.items():
        joints = folder.joints_of(handle.rsplit("_:", 1)[0]) or []
        for link, position in positions.items():
            if int(link) >= len(joints) or not 0 <= position <= joints[int(link)].limit.upper + 1e-6:
                faults.append(f"{handle} has no joint {link} at {position}")
    names = episode.info["unietp"]["names"]
    movable = {f"{config.split('.')[0]}" for config, _ in episode.rigid_objs}
    faults += [f"{target} does not move" for target in episode.targets if target.rsplit("_:", 1)[0] not in movable]
    faults += [f"{thing} has no name" for thing, handle in names.items() if not handle]
    return {
        "task": episode.info["unietp"]["task"],
        "rigid objects": len(episode.rigid_objs),
        "opened": len(episode.ao_states),
        "targets": len(episode.targets),
        "faults": "; ".join(faults),
    }


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=Path, help="what `unietp export --format habitat` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write")
    options = options.parse_args()
    exported, out = options.folder.resolve(), options.out.resolve()
    dataset = rearrange_dataset_at(exported)
    rows = [judge(Folder(exported), episode) for episode in dataset.episodes]
    right = sum(not row["faults"] for row in rows)
    finish(
        rows,
        out,
        f"habitat-lab loads {len(rows)} episodes; {right} of them name only scenes and models that are there",
        lambda row: not row["faults"],
    )


def rearrange_dataset_at(exported):
    """The episodes of a folder, which becomes `data/unietp` of a new working folder, where episodes expect it."""
    work = Path(tempfile.mkdtemp())
    (work / "data").mkdir()
    (work / "data" / "unietp").symlink_to(exported)
    os.chdir(work)
    dataset = rearrange_dataset()
    dataset.from_json(gzip.decompress((exported / "episodes.json.gz").read_bytes()).decode())
    return dataset


if __name__ == "__main__":
    main()
