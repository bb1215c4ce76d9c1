#include "serve/play_text.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/in_quotes.h"
#include "core/text.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kColumns = 80;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

std::string name_or_category(const Json& thing) {
  const auto id = thing.value("id", "");
  return for_terminal(id.empty() ? thing.value("category", "") : id);
}

}  // namespace

std::string standing_text(const Json& observation) {
  std::string text = "Step " + std::to_string(observation.value("step", 0)) + ", " +
                     std::to_string(observation.value("steps_left", 0)) + " left";
  if (observation.contains("failures_left"))
    text += "; " + std::to_string(observation["failures_left"].get<int>()) + " failures left";
  text += ".";
  if (!observation.contains("held")) return text + "\n";
  std::vector<std::string> held;
  for (const auto& thing : observation["held"]) held.push_back(name_or_category(thing));
  return text + " In the hand: " + (held.empty() ? "nothing" : join(held, ", ")) + ".\n";
}

std::string results_text(const Json& observation) {
  std::string text;
  for (const auto& result : observation.value("results", Json::array())) {
    text += for_terminal(result.value("action", ""));
    const bool has_outcome = result.contains("success");
    if (has_outcome && result["success"].get<bool>()) text += ": done";
    if (has_outcome && !result["success"].get<bool>())
      text += ": failed. " + for_terminal(result.value("feedback", ""));
    text += "\n";
  }
  return text;
}

std::vector<ListedThing> things_of(const Json& observation, const std::string& list, const std::string& word) {
  std::vector<ListedThing> things;
  for (const auto& thing : observation.value(list, Json::array())) {
    ListedThing named{thing.value("id", ""), thing.value("category", "")};
    if (lower(named.id + " " + named.category).find(lower(word)) != std::string::npos) things.push_back(named);
  }
  return things;
}

std::string listing_text(const std::string& title, const std::vector<ListedThing>& things, std::size_t first) {
  if (things.empty()) return "";
  std::size_t width = 0;
  for (const auto& thing : things) width = std::max(width, for_terminal(thing.id).size() + 7);
  std::string text = title + ":\n", line;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const std::string number = std::to_string(first + i);
    const std::string entry = std::string(number.size() < 4 ? 4 - number.size() : 0, ' ') + number + " ";
    if (!line.empty() && line.size() + width > kColumns) {
      text += std::string(line.substr(0, line.find_last_not_of(' ') + 1)) + "\n";
      line.clear();
    }
    line += padded(entry + for_terminal(things[i].id), width);
  }
  return text + line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string actions_text(const Json& actions) {
  std::string text, group;
  for (const auto& action : actions) {
    const auto now = action.value("class", "");
    if (now != group) text += now + "\n";
    group = now;
    const auto argument = action.value("argument", "");
    text += padded("  " + action.value("action", "") + (argument == "none" ? "" : " (" + argument + ")"), 32) +
            action.value("effect", "") + "\n";
  }
  return text;
}

std::string play_help() {
  return "Type an action, and what it is done to: by its number in the last list or by\n"
         "its id. The beginning of an action's name is enough.\n"
         "  go 3                  go_to(the third thing listed)\n"
         "  pick mug_1            pick_up(mug_1)\n"
         "  turn on 2             turn_on(the second thing listed)\n"
         "In M3 objects have no ids: give a point or a box of the picture, in pixels.\n"
         "  pick 120,80           what is there in the picture\n"
         "  pick 100,60,140,110   what that box is around\n"
         "Other lines:\n"
         "  look                  what is in view\n"
         "  home [WORD]           what you know of the home: what has the word in its name\n"
         "  actions               all actions with what they do\n"
         "  task                  the task\n"
         "  again                 this task from the start\n"
         "  next                  the next task\n"
         "  quit                  leave\n"
         "`stop` is an action: it says that the task is done, and ends the episode.\n";
}

}  // namespace unietp
