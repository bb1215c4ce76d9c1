#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/geometry.h"
#include "scene/json_reader.h"

namespace unietp {

/// One object of a BEHAVIOR scene as its file has it: meters, z up, the model's own axes (fronts along x).
struct BehaviorObject {
  std::string name, category, model;
  Vec3 scale = Vec3::Ones();
  Vec3 box = Vec3::Zero();  // full extents that the file asks for; zero: the model's own times `scale`
  bool fixed = false, robot = false;
  std::vector<std::string> rooms;
  Pose root;         // of the root link, W
  double joint = 0;  // the largest joint position, radians or meters
  bool has_switch_state = false, switched_on = false;
};

/// A list `objects` of flat rows (`pos`, `ori_xyzw`), or OmniGibson's own form: what there is in
/// `objects_info.init_info` and where it is in `state` (its `object_registry`, or `registry.object_registry`).
/// `missing` gets the names that have no pose. Errors go to the reader.
std::vector<BehaviorObject> read_behavior_objects(JsonReader& reader, const JsonAt& home,
                                                  std::vector<std::string>& missing);

}  // namespace unietp
