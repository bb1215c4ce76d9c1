#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace unietp {

// Files of a Habitat scene data set that stand in for the simulator's own models, so that a generated home can be
// loaded: what physics here has of each object and what the camera shows, as meshes and joints. Formats: the attribute
// files of habitat-sim 0.3 (object_config, ao_config, stage_config, scene_dataset_config), URDF, and binary glTF.

/// A file by its path in the data set's folder.
struct AssetFile {
  std::string path, content;
};

/// What a node's stand-in is called: its category, size in millimeters, color and material, and a digest of its boards
/// where it has boards of its own. Nodes with equal names have equal stand-ins, but for less than a millimeter.
std::string habitat_stand_in_name(const Node& node);

/// The template of a node that is an object of the simulator's own scene ("frl_apartment_cup_:0003"); nullopt for
/// others.
std::optional<std::string> habitat_own_template(const Node& node);
/// The template of a node in an exported scene: its own, or its stand-in.
std::string habitat_template_name(const Node& node);

/// The stand-in of a node: `objects/<name>.object_config.json`, `.glb` (what it collides with) and `.render.glb` (what
/// the camera shows of it without states, in at most 3,000 triangles, or with 6 sides of all that is round; none where
/// it looks as physics has it), or, for a node that opens, `urdf/<name>/<name>.ao_config.json` and `.urdf`, with one
/// link for each door, lid or drawer. Each level surface is a receptacle for habitat-lab's samplers. In Habitat's
/// frame, fronts along -z, the origin in the middle of the box.
std::vector<AssetFile> habitat_stand_in(const Node& node);

/// Floors and walls of a home: `stages/<id>.stage_config.json` and `.glb`.
std::vector<AssetFile> habitat_stage(const Scene& scene);

/// `unietp.scene_dataset_config.json`: where a data set of such files has them. `scenes`: the folder of the scene
/// instances. `with_own`: and where Habitat's downloads put the models of ReplicaCAD and HSSD, beside the data set's
/// folder.
AssetFile habitat_dataset_config(const std::string& scenes, bool with_own);

}  // namespace unietp
