#pragma once

#include <string>
#include <vector>

#include "scene/geometry.h"
#include "scene/scene.h"

namespace unietp {

/// A relation that a simulator's file states. Some formats only say that a thing is held by a receptacle, on or in it.
struct SourceRelation {
  enum class Kind { On, Inside, OnOrInside };
  Kind kind = Kind::OnOrInside;
  std::string receptacle;  // SourceObject::id
};

/// One object as a simulator's own file describes it, turned into our frames: W right-handed, z up, meters; the object
/// frame with its origin at the center of the box, x to its right, y to its back.
struct SourceObject {
  std::string id;            // the file's own
  std::string category;      // the simulator's own name for the kind of thing; "" when the file has none
  std::string asset;         // the model, "" when the file names none
  Pose pose;                 // of the box's center
  Vec3 size = Vec3::Zero();  // full extents of the box in the object frame; zero when neither file nor model has one
  double mass = 0;           // kilograms, 0 when not said
  double opening = 0;        // 0 closed … 1 open
  std::vector<State> states;
  std::string room;  // SourceScene::rooms id, "" when not said
  std::vector<SourceRelation> held_by;
};

/// What one file says of one home, before the knowledge base is asked.
struct SourceScene {
  std::string id;
  Simulator simulator = Simulator::Ai2thor;
  std::vector<Room> rooms;        // may be empty: then drawn around the objects
  std::vector<Opening> openings;  // may be empty
  double wall_height = 2.6;
  double wall_thickness = 0.1;  // centered on the edges of the rooms' polygons
  std::vector<SourceObject> objects;
  bool has_agent = false;
  Agent agent;
  std::vector<std::string> warnings;  // what the file says that this does not hold, for people
};

}  // namespace unietp
