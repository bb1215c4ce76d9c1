#pragma once

#include <string>
#include <vector>

#include "environment/agent_text.h"
#include "environment/observation.h"
#include "environment/settings.h"

namespace unietp {

/// An observation as a tree of named values, the same wherever one comes out (data/schemas/observation.schema.json):
/// {"instruction", "image", "boxes", "rooms", "furniture", "movables", "by_room", "floor_plan", "pose", "last",
/// "results", "held", "step", "steps_left", "failures_left", "over"}, in this order. What the settings do not tell is
/// left out. "image" is
/// {"width", "height"}; whoever sends the pixels adds them. Boxes are in the settings' form. `Maker` makes the values;
/// it has
///   Value text(const std::string&), number(int), real(double), flag(bool), nothing(), object(), list();
///   void set(Value& object, const char* name, Value), append(Value& list, Value).
template <class Maker>
class ObservationTree {
 public:
  using Value = typename Maker::Value;
  ObservationTree(const Observation& observation, const Settings& settings) : o_(observation), settings_(settings) {}

  /// The whole tree.
  Value value() const {
    const ModeRules& rules = settings_.rules;
    const HomeInformation& home = *o_.home;
    Value all = Maker::object();
    Maker::set(all, "instruction", Maker::text(o_.instruction));
    if (o_.has_picture) Maker::set(all, "image", image());
    if (o_.boxes) Maker::set(all, "boxes", list_of(*o_.boxes));
    if (settings_.global == GlobalForm::ByRoom) {
      Maker::set(all, "by_room", list_of(home.by_room));
    } else {
      if (rules.rooms) Maker::set(all, "rooms", list_of(home.rooms));
      if (rules.furniture) Maker::set(all, "furniture", list_of(home.furniture));
      if (rules.movables) Maker::set(all, "movables", list_of(home.movables));
    }
    if (home.floor_plan) Maker::set(all, "floor_plan", value_of(*home.floor_plan));
    if (o_.pose) Maker::set(all, "pose", value_of(*o_.pose));
    Maker::set(all, "last", o_.last ? value_of(*o_.last) : Maker::nothing());
    Maker::set(all, "results", list_of(o_.results));
    if (o_.held) Maker::set(all, "held", list_of(*o_.held));
    Maker::set(all, "step", Maker::number(o_.step));
    Maker::set(all, "steps_left", Maker::number(o_.steps_left));
    if (o_.failures_left) Maker::set(all, "failures_left", Maker::number(*o_.failures_left));
    Maker::set(all, "over", Maker::flag(o_.over));
    return all;
  }

 private:
  template <class Thing>
  Value list_of(const std::vector<Thing>& things) const {
    Value list = Maker::list();
    for (const Thing& thing : things) Maker::append(list, value_of(thing));
    return list;
  }

  Value value_of(const NamedEntity& thing) const {
    Value value = Maker::object();
    Maker::set(value, "id", Maker::text(thing.id));
    Maker::set(value, "category", Maker::text(thing.category));
    return value;
  }

  Value value_of(const HeldObject& thing) const {
    Value value = Maker::object();
    if (!thing.id.empty()) Maker::set(value, "id", Maker::text(thing.id));
    Maker::set(value, "category", Maker::text(thing.category));
    return value;
  }

  Value value_of(const RoomContents& contents) const {
    Value value = Maker::object();
    if (!contents.room.id.empty()) Maker::set(value, "room", value_of(contents.room));
    if (!contents.furniture.empty()) Maker::set(value, "furniture", list_of(contents.furniture));
    if (!contents.movables.empty()) Maker::set(value, "movables", list_of(contents.movables));
    return value;
  }

  template <class Vector>
  static Value numbers(const Vector& vector) {
    Value list = Maker::list();
    for (const double number : vector) Maker::append(list, Maker::real(number));
    return list;
  }

  Value value_of(const PlannedRoom& room) const {
    Value value = Maker::object(), outline = Maker::list();
    for (const Vec2& corner : room.outline) Maker::append(outline, numbers(corner));
    Maker::set(value, "id", Maker::text(room.id));
    Maker::set(value, "outline", std::move(outline));
    return value;
  }

  Value value_of(const PlannedDoor& door) const {
    Value value = Maker::object(), rooms = Maker::list();
    for (const std::string& room : {door.room_a, door.room_b}) Maker::append(rooms, Maker::text(room));
    Maker::set(value, "rooms", std::move(rooms));
    Maker::set(value, "from", numbers(door.from));
    Maker::set(value, "to", numbers(door.to));
    return value;
  }

  Value value_of(const PlannedFurniture& one) const {
    Value value = Maker::object();
    Maker::set(value, "id", Maker::text(one.id));
    Maker::set(value, "middle", numbers(one.middle));
    Maker::set(value, "size", numbers(one.size));
    Maker::set(value, "turned", Maker::real(one.turned_deg));
    return value;
  }

  Value value_of(const ToldFloorPlan& plan) const {
    Value value = Maker::object();
    Maker::set(value, "rooms", list_of(plan.rooms));
    Maker::set(value, "doors", list_of(plan.doors));
    Maker::set(value, "furniture", list_of(plan.furniture));
    return value;
  }

  Value value_of(const OwnPose& pose) const {
    Value value = Maker::object();
    Maker::set(value, "position", numbers(pose.position));
    Maker::set(value, "facing", Maker::real(pose.facing_deg));
    Maker::set(value, "down", Maker::real(pose.down_deg));
    return value;
  }

  Value value_of(const ActionReport& report) const {
    Value value = Maker::object();
    Maker::set(value, "action", Maker::text(report.action));
    if (!report.success) return value;
    Maker::set(value, "success", Maker::flag(*report.success));
    if (report.failure == Failure::None) return value;
    Maker::set(value, "failure", Maker::text(std::string(name_of(report.failure))));
    Maker::set(value, "feedback", Maker::text(report.feedback));
    return value;
  }

  Value value_of(const ObservedObject& object) const {
    Value box = Maker::list();
    if (settings_.box_form == BoxForm::Pixels) {
      for (const int pixel : object.box) Maker::append(box, Maker::number(pixel));
    } else {
      for (const double part : box_in_form(object.box, settings_.box_form, o_.image_width, o_.image_height)) {
        const bool whole = settings_.box_form != BoxForm::Unit;
        Maker::append(box, whole ? Maker::number(static_cast<int>(part)) : Maker::real(part));
      }
    }
    Value value = Maker::object();
    Maker::set(value, "id", Maker::text(object.id));
    Maker::set(value, "category", Maker::text(object.category));
    Maker::set(value, "box", std::move(box));
    return value;
  }

  Value image() const {
    Value value = Maker::object();
    Maker::set(value, "width", Maker::number(o_.image_width));
    Maker::set(value, "height", Maker::number(o_.image_height));
    return value;
  }

  const Observation& o_;
  const Settings& settings_;
};

}  // namespace unietp
