#include "simulation/mode_rules.h"

#include "scene/telling_order.h"

namespace unietp {

ModeRules rules_of(Mode mode) {
  ModeRules rules;
  rules.mode = mode;
  if (mode == Mode::M1) return rules;
  rules.movables = false;
  rules.teleport = Teleport::Furniture;
  rules.composite = Naming::None;
  if (mode == Mode::M2) return rules;
  rules.boxes = rules.furniture = false;
  rules.teleport = Teleport::Rooms;
  rules.reach = rules.atomic = Naming::Box;
  rules.limits = {150, 30};
  return rules;
}

Naming naming_of(const ActionInfo& action, const ModeRules& rules) {
  switch (action.group) {
    case ActionClass::Reach:
      return rules.reach;
    case ActionClass::Manipulation:
      return rules.atomic;
    case ActionClass::Composite:
      return rules.composite;
    case ActionClass::Movement:
    case ActionClass::Control:
      break;
  }
  return Naming::None;
}

bool offers(const ActionInfo& action, const ModeRules& rules) {
  if (action.group == ActionClass::Control) return true;
  if (action.group == ActionClass::Movement) return rules.move;
  const bool teleports = action.argument == ActionArgument::ObjectOrRoom && rules.teleport != Teleport::Nothing;
  const Naming naming = naming_of(action, rules);
  // What names the object in the hand has no box for it: such actions are the ones that M2 has and M3 lacks.
  const bool has_no_box = action.m2 && !action.m3;
  return teleports || naming == Naming::Id || (naming == Naming::Box && !has_no_box);
}

GlobalInformation global_information(const Scene& start, const ModeRules& rules) {
  GlobalInformation known;
  const TellingOrder order = telling_order(start);
  if (rules.rooms) {
    for (const std::size_t room : order.rooms) known.rooms.push_back(start.rooms[room].id);
  }
  for (const std::size_t place : order.nodes) {
    const Node& node = start.nodes[place];
    if (node.movable && rules.movables) known.movables.push_back(node.id);
    if (!node.movable && rules.furniture) known.furniture.push_back(node.id);
  }
  return known;
}

}  // namespace unietp
