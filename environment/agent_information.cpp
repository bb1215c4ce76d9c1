#include "environment/agent_information.h"

#include <unordered_map>
#include <utility>

#include "core/text.h"
#include "environment/agent_text.h"
#include "scene/telling_order.h"

namespace unietp {
namespace {

NamedEntity named(const Room& room) { return {room.id, room.type}; }
NamedEntity named(const Node& node) { return {node.id, node.category}; }

std::string argument_text(const Argument& argument, const World& world, const Settings& settings,
                          const AnswerFrame& frame) {
  if (argument.box) {
    std::vector<std::string> numbers;
    for (const double number : box_in_form(*argument.box, settings.box_form, frame.width, frame.height))
      numbers.push_back(number_text(number));
    return "[" + join(numbers, ", ") + "]";
  }
  const bool repeated = tells_ids(settings.rules) || world.find_room(argument.id) != nullptr;
  return repeated ? argument.id : "?";
}

}  // namespace

bool tells_ids(const ModeRules& rules) {
  const bool by_id = rules.reach == Naming::Id || rules.atomic == Naming::Id || rules.composite == Naming::Id;
  return by_id || rules.boxes || rules.furniture || rules.movables;
}

std::shared_ptr<const HomeInformation> home_information(const World& start, const Settings& settings) {
  const ModeRules& rules = settings.rules;
  const Scene& scene = start.scene();
  auto home = std::make_shared<HomeInformation>();
  std::unordered_map<std::string, std::size_t> place_of;  // of a room's contents; never iterated
  const bool by_room = settings.global == GlobalForm::ByRoom;
  const TellingOrder order = telling_order(scene);
  for (const std::size_t place : order.rooms) {
    const Room& room = scene.rooms[place];
    if (rules.rooms) home->rooms.push_back(named(room));
    if (!by_room) continue;
    place_of.emplace(room.id, home->by_room.size());
    home->by_room.push_back({named(room), {}, {}});
  }
  RoomContents nowhere;
  for (const std::size_t thing : order.nodes) {
    const Node& node = scene.nodes[thing];
    if (!(node.movable ? rules.movables : rules.furniture)) continue;
    (node.movable ? home->movables : home->furniture).push_back(named(node));
    if (!by_room) continue;
    const auto place = place_of.find(start.room_of(node.id));
    RoomContents& contents = place == place_of.end() ? nowhere : home->by_room[place->second];
    (node.movable ? contents.movables : contents.furniture).push_back(named(node));
  }
  if (settings.floor_plan) home->floor_plan = floor_plan_of(scene, rules);
  if (!nowhere.furniture.empty() || !nowhere.movables.empty()) home->by_room.push_back(std::move(nowhere));
  return home;
}

std::vector<ObservedObject> visible_objects(const ModeEpisode& episode) {
  std::vector<ObservedObject> seen;
  for (const VisibleObject& object : episode.visible())
    seen.push_back({object.id, episode.world().find(object.id)->category, object.box});
  return seen;
}

std::vector<HeldObject> held_objects(const World& world, const ModeRules& rules) {
  std::vector<HeldObject> held;
  for (const std::string& id : world.agent().held) {
    const Node* node = world.find(id);
    held.push_back({tells_ids(rules) ? id : "", node == nullptr ? "" : node->category});
  }
  return held;
}

ActionReport report_of(const Command& command, const Outcome& outcome, const World& world, const Settings& settings,
                       const AnswerFrame& frame) {
  ActionReport report{"?", {}, Failure::None, ""};
  if (settings.feedback == Feedback::None) return report;  // what is repeated and what not would tell of success
  if (action_named(command.action)) report.action = command.action;
  std::vector<std::string> args;
  for (const Argument& argument : command.args) args.push_back(argument_text(argument, world, settings, frame));
  if (!args.empty()) report.action += "(" + join(args, ", ") + ")";
  report.success = outcome.success;
  if (settings.feedback != Feedback::Full) return report;
  report.failure = outcome.failure;
  report.feedback = outcome.feedback;
  return report;
}

}  // namespace unietp
