#pragma once

#include <string>
#include <vector>

#include "scene/geometry.h"
#include "scene/json_reader.h"

namespace unietp {

/// A node of a VirtualHome environment graph, in Unity's axes: meters, y up, z forward, left-handed.
struct VirtualhomeNode {
  long long id = 0;
  std::string class_name, category, prefab;
  std::vector<std::string> states;
  bool has_box = false;
  Vec3 center = Vec3::Zero(), extents = Vec3::Zero();  // along the world's axes
  bool has_transform = false;
  Quat rotation = Quat::Identity();
  Vec3 scale = Vec3::Ones();
};

/// A relation between two nodes, by their ids.
struct VirtualhomeEdge {
  long long from = 0, to = 0;
  std::string relation;  // "ON", "INSIDE", …
};

/// A VirtualHome scene: nodes and relations.
struct VirtualhomeGraph {
  std::vector<VirtualhomeNode> nodes;
  std::vector<VirtualhomeEdge> edges;
};

/// Boxes as upstream has them, `bounding_box: {center, size}` and `obj_transform`, or flat, `bbox_center`, `bbox_size`;
/// edges as `{from_id, relation_type, to_id}` or `[from, relation, to]`. A node without a box is read. Errors go to the
/// reader: wrong types, numbers that are not finite, an id twice, sizes below 0.
VirtualhomeGraph read_virtualhome_graph(JsonReader& reader, const JsonAt& home);

}  // namespace unietp
