#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "environment/floor_plan.h"
#include "scene/action.h"
#include "scene/pixel_box.h"
#include "simulation/picture.h"

namespace unietp {

/// An object or a room that an agent is told of.
struct NamedEntity {
  std::string id, category;  // of a room: its type
  bool operator==(const NamedEntity&) const = default;
};

/// Things of one room.
struct RoomContents {
  NamedEntity room;  // empty id: in no room
  std::vector<NamedEntity> furniture, movables;
  bool operator==(const RoomContents&) const = default;
};

/// What an agent is told of the home at the start, in the order of scene/telling_order.h; as lists, or by room on
/// request. The same throughout an episode.
struct HomeInformation {
  std::vector<NamedEntity> rooms, furniture, movables;
  std::vector<RoomContents> by_room;        // GlobalForm::ByRoom only
  std::optional<ToldFloorPlan> floor_plan;  // nullopt: the settings do not tell it
  bool operator==(const HomeInformation&) const = default;
};

/// An object in view.
struct ObservedObject {
  std::string id, category;
  PixelBox box{};  // pixels of the picture, both ends included
  bool operator==(const ObservedObject&) const = default;
};

/// One executed action as the agent is told of it.
struct ActionReport {
  std::string action;           // as said: "pick_up(mug_1)"; "?" for names that are not repeated, and without feedback
  std::optional<bool> success;  // nullopt: not told (Feedback::None)
  Failure failure = Failure::None;  // None unless Feedback::Full
  std::string feedback;             // a sentence; "" on success, and unless Feedback::Full
  bool operator==(const ActionReport&) const = default;
};

/// Something in the hand.
struct HeldObject {
  std::string id;  // "" where objects have no ids (M3)
  std::string category;
  bool operator==(const HeldObject&) const = default;
};

/// What an agent may know: the public side of an environment, which depends on the settings, the task and the actions
/// alone. Equal tasks, settings and actions give equal observations, bit for bit.
struct Observation {
  std::string instruction;
  std::optional<std::vector<ObservedObject>> boxes;  // sorted by id; nullopt: the settings do not tell them
  std::shared_ptr<const HomeInformation> home;       // never null
  std::optional<OwnPose> pose;                       // with a floor plan, unless Feedback::None
  std::optional<ActionReport> last;                  // the last action; nullopt at the start
  std::vector<ActionReport> results;            // every action since the observation before this one, `last` included
  std::optional<std::vector<HeldObject>> held;  // nullopt: hidden (Feedback::None)
  int step = 0, steps_left = 0;
  std::optional<int> failures_left;       // nullopt: hidden (Feedback::None)
  bool has_picture = false;               // the settings show it; Environment::picture makes it
  int image_width = 0, image_height = 0;  // pixels that boxes refer to
  bool over = false;                      // further actions have no effect
};
/// Whether two are alike in every field; the home by value.
bool operator==(const Observation& a, const Observation& b);

}  // namespace unietp
