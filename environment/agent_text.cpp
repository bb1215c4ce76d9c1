#include "environment/agent_text.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "scene/telling_order.h"

namespace unietp {
namespace {

/// What an action needs that fails so when it is missing; "" for what an agent cannot look after.
std::string need_behind(Failure failure, const Profile& profile) {
  const std::string need = replace_all(std::string(info(failure).need), "{reach_m}", number_text(profile.reach_m));
  return replace_all(need, "{mass_kg}", number_text(profile.max_pick_mass_kg));
}

std::string action_line(const ActionInfo& action, const Profile& profile) {
  std::vector<std::string> needs;
  for (const Failure failure : failures_of(action)) {
    auto need = need_behind(failure, profile);
    if (!need.empty() && std::find(needs.begin(), needs.end(), need) == needs.end()) needs.push_back(std::move(need));
  }
  std::string line = "- " + std::string(action.name);
  if (action.argument != ActionArgument::None) line += "(" + std::string(name_of(action.argument)) + ")";
  line += ": " + std::string(action.effect);
  return line + (needs.empty() ? "" : "; needs " + join(needs, ", ")) + ".\n";
}

/// Whether objects of some action are named so.
bool names_by(const ModeRules& rules, Naming naming) {
  return rules.reach == naming || rules.atomic == naming || rules.composite == naming;
}

/// Where the agent may go at once, and what it may name.
std::string id_rules(const ModeRules& rules) {
  std::string text = "Name objects and rooms by their ids. ";
  const bool knows_all = rules.furniture && rules.movables;
  if (rules.teleport == Teleport::Anything)
    return text + (knows_all ? "You may go to any of them.\n" : "You may go to any of which you have been told.\n");
  std::vector<std::string> goals;
  if (rules.teleport >= Teleport::Rooms) goals.emplace_back("rooms");
  if (rules.teleport >= Teleport::Furniture) goals.emplace_back("furniture");
  const bool in_view = rules.reach == Naming::Id && rules.boxes;
  if (in_view)
    goals.emplace_back(rules.teleport >= Teleport::Furniture ? "small things that are in view now"
                                                             : "objects that are in view now");
  const std::string last = goals.empty() ? "" : goals.back();
  if (!goals.empty()) goals.pop_back();
  text += last.empty() ? "You cannot go to any in one step"
                       : "You may go to " + (goals.empty() ? last : join(goals, ", ") + " and " + last);
  if (knows_all || rules.atomic != Naming::Id) return text + ".\n";
  return text + "; everything else can be done to furniture and to small things that you have seen.\n";
}

std::string box_words(BoxForm form, const Profile& profile) {
  const std::string from = " from the upper left corner of ";
  const std::string size =
      std::to_string(profile.image_width) + " wide and " + std::to_string(profile.image_height) + " high";
  switch (form) {
    case BoxForm::Pixels:
      return "{\"bbox\": [x0, y0, x1, y1]}: pixels" + from + "a picture " + size + ", both ends included";
    case BoxForm::Unit:
      return "{\"bbox\": [x0, y0, x1, y1]}: parts of the picture's width and height" + from + "it, 0 to 1";
    case BoxForm::Thousand:
      return "{\"bbox\": [x0, y0, x1, y1]}: thousandths of the picture's width and height" + from + "it, 0 to 1000";
    case BoxForm::ThousandYFirst:
      return "{\"bbox\": [y0, x0, y1, x1]}: thousandths of the picture's height and width" + from + "it, 0 to 1000";
  }
  return "";
}

std::string box_rules(const ModeRules& rules, BoxForm form, const Profile& profile) {
  std::string text = "Name an object by the box around it in the picture, " + box_words(form, profile) + ".";
  if (!names_by(rules, Naming::Id)) {
    if (rules.teleport == Teleport::Rooms) text += " Rooms have ids; you may go to one.";
    if (rules.teleport == Teleport::Furniture) text += " Rooms and furniture have ids; you may go to one.";
    if (rules.teleport == Teleport::Anything) text += " Rooms and objects have ids; you may go to one.";
  }
  return text + " What you hold has no box and needs none.\n";
}

std::string list(const std::string& title, const std::vector<std::string>& ids) {
  return ids.empty() ? "" : title + ": " + join(ids, ", ") + ".\n";
}

/// "kitchen_1: fridge_3, mug_9.\n" for each room, and last what is in no room; furniture before small things.
std::string home_by_room(const Scene& start, const ModeRules& rules) {
  std::map<std::string, std::string> room_of;
  for (const Edge& edge : start.edges) {
    if (edge.relation == Predicate::InRoom) room_of[edge.from] = edge.to;
  }
  const TellingOrder order = telling_order(start);
  const auto things_in = [&](const std::string& room) {
    std::vector<std::string> ids;
    for (const bool movable : {false, true}) {
      for (const std::size_t place : order.nodes) {
        const Node& node = start.nodes[place];
        const auto found = room_of.find(node.id);
        if (node.movable == movable && (movable ? rules.movables : rules.furniture) &&
            (found == room_of.end() ? "" : found->second) == room)
          ids.push_back(node.id);
      }
    }
    return ids;
  };
  std::string text;
  for (const std::size_t place : order.rooms) {
    const std::string& room = start.rooms[place].id;
    const auto ids = things_in(room);
    text += ids.empty() ? room + ".\n" : list(room, ids);
  }
  return text + list("In no room", things_in(""));
}

/// Before each action: what became of the one before, what the camera shows.
std::string shown_before_each_action(const Settings& settings) {
  const bool outcome = settings.feedback != Feedback::None;
  const bool view = settings.rules.picture || settings.rules.boxes;
  if (!outcome && !view) return "";
  return std::string("Before each action you are told ") + (outcome ? "what became of the one before" : "") +
         (outcome && view ? " and " : "") + (view ? "what your camera shows" : "") + ". ";
}

std::string became(bool success, const std::string& feedback) {
  return success ? "succeeded" : feedback.empty() ? "failed" : "failed. " + feedback;
}

/// Numbers as JSON has them: [1,2,3,4]
std::string list_of(const PixelBox& box) {
  std::string text = "[";
  for (const int side : box) (text += std::to_string(side)) += ',';
  text.back() = ']';
  return text;
}
std::string list_of(const std::vector<double>& numbers) { return nlohmann::ordered_json(numbers).dump(); }

/// "id numbers; id numbers"
template <class Numbers>
std::string objects_in_view(const std::vector<std::pair<std::string, Numbers>>& things) {
  if (things.empty()) return "Nothing is in view.";
  std::string text = "In view:";
  for (const auto& [id, numbers] : things) {
    text += text.back() == ':' ? " " : "; ";
    text += id + " " + list_of(numbers);
  }
  return text + ".";
}

}  // namespace

std::string action_space_text(const ModeRules& rules, const Profile& profile) {
  std::string text;
  for (const auto& actions : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : actions) {
      if (profile.offers(action.type) && offers(action, rules)) text += action_line(action, profile);
    }
  }
  return text;
}

std::string naming_text(const Settings& settings, const Profile& profile) {
  const ModeRules& rules = settings.rules;
  const bool by_id = names_by(rules, Naming::Id), by_box = names_by(rules, Naming::Box);
  if (by_id && by_box) {
    std::string classes;
    const auto add = [&](Naming naming, const char* name) {
      if (naming == Naming::Box) classes += (classes.empty() ? "" : ", ") + std::string(name);
    };
    add(rules.reach, "going and turning to objects");
    add(rules.atomic, "handling objects");
    add(rules.composite, "using appliances on what you hold");
    return id_rules(rules) + "But for " + classes + ": " + box_rules(rules, settings.box_form, profile);
  }
  if (by_box) return box_rules(rules, settings.box_form, profile);
  return by_id || rules.teleport != Teleport::Nothing ? id_rules(rules) : "";
}

std::string system_prompt(const Scene& start, const Settings& settings, const Profile& profile, bool reasoning) {
  const StepLimits& limits = settings.rules.limits;
  std::string text = "You are a robot in a home and carry out a task, one action at a time. ";
  text += shown_before_each_action(settings);
  text += "When the task is done, answer with stop. You have at most " + std::to_string(limits.steps) +
          " actions, of which at most " + std::to_string(limits.failures) + " may fail.\n\n";
  text += "Answer with nothing but a JSON object: {";
  if (reasoning) text += "\"reasoning\": \"one to three sentences\", ";
  text += "\"action\": \"NAME\", \"args\": [ARGUMENT]}, with \"args\": [] for an action that takes none.\n";
  text += naming_text(settings, profile) + "\nActions:\n" + action_space_text(settings.rules, profile);
  text += "\nWhat you know of the home:\n" + home_text(start, settings);
  return text.substr(0, text.find_last_not_of('\n') + 1);
}

std::string home_text(const Scene& start, const Settings& settings) {
  const ModeRules& rules = settings.rules;
  const std::string plan = settings.floor_plan ? floor_plan_text(floor_plan_of(start, rules)) : "";
  if (settings.global == GlobalForm::ByRoom) return home_by_room(start, rules) + plan;
  const GlobalInformation known = global_information(start, rules);
  return list("Rooms", known.rooms) + list("Furniture", known.furniture) + list("Small things", known.movables) + plan;
}

std::string task_text(const std::string& instruction) { return "Task: " + instruction; }

std::string view_text(const std::vector<VisibleObject>& visible) {
  std::vector<std::pair<std::string, PixelBox>> things;
  for (const VisibleObject& object : visible) things.emplace_back(object.id, object.box);
  return objects_in_view(things);
}

std::string outcome_text(bool success, const std::string& feedback) {
  return "The last action " + became(success, feedback) + (success || feedback.empty() ? "." : "");
}

std::string history_text(const std::string& action, bool success, const std::string& feedback) {
  return action + ": " + became(success, feedback);
}

std::string actions_text(const std::vector<std::string>& actions, bool only_last) {
  if (actions.empty()) return "";
  std::string text = only_last ? "Your last actions:" : "Your actions so far:";
  for (std::size_t i = 0; i < actions.size(); ++i) text += "\n" + std::to_string(i + 1) + ". " + actions[i];
  return text;
}

std::string results_text(const std::vector<ActionReport>& results) {
  const auto has_outcome = [](const ActionReport& one) { return one.success.has_value(); };
  if (results.empty() || !has_outcome(results.front())) return "";
  if (results.size() == 1) return outcome_text(*results.front().success, results.front().feedback);
  std::string text = "The last actions:";
  for (std::size_t i = 0; i < results.size(); ++i) {
    const ActionReport& one = results[i];
    text += "\n" + std::to_string(i + 1) + ". " + history_text(one.action, *one.success, one.feedback);
  }
  return text;
}

std::string boxes_text(const Observation& observation, const Settings& settings) {
  if (!observation.boxes) return "";
  if (settings.box_form == BoxForm::Pixels) {
    std::vector<std::pair<std::string, PixelBox>> things;
    for (const ObservedObject& object : *observation.boxes) things.emplace_back(object.id, object.box);
    return objects_in_view(things);
  }
  std::vector<std::pair<std::string, std::vector<double>>> things;
  for (const ObservedObject& object : *observation.boxes)
    things.emplace_back(object.id,
                        box_in_form(object.box, settings.box_form, observation.image_width, observation.image_height));
  return objects_in_view(things);
}

std::string view_text(const Observation& observation, const Settings& settings) {
  std::vector<std::string> lines{observation.pose ? pose_text(*observation.pose) : "",
                                 boxes_text(observation, settings)};
  std::erase(lines, "");
  return join(lines, "\n");
}

std::string observation_text(const Observation& observation, const Settings& settings) {
  std::vector<std::string> lines{
      observation.last ? results_text(observation.results) : task_text(observation.instruction),
      view_text(observation, settings)};
  std::erase(lines, "");
  return join(lines, "\n");
}

std::vector<double> box_in_form(const PixelBox& box, BoxForm form, int width, int height) {
  if (form == BoxForm::Pixels) return {box.begin(), box.end()};
  const auto part = [&](int pixel, int size) {
    const double thousandths = std::round(1000.0 * pixel / size);
    return form == BoxForm::Unit ? thousandths / 1000 : thousandths;
  };
  std::vector<double> numbers{part(box[0], width), part(box[1], height), part(box[2], width), part(box[3], height)};
  if (form == BoxForm::ThousandYFirst) {
    std::swap(numbers[0], numbers[1]);
    std::swap(numbers[2], numbers[3]);
  }
  return numbers;
}

}  // namespace unietp
