#include "tests/environment/random_agent.h"

#include <vector>

#include <nlohmann/json.hpp>

namespace unietp::testing {

using Json = nlohmann::ordered_json;

std::string RandomAgent::argument(const Environment& environment, bool may_be_room) {
  const Observation& seen = environment.observe();
  const ModeRules& rules = environment.settings().rules;
  if (may_be_room && !seen.home->rooms.empty() && rng_.chance(0.3)) return Json(rng_.pick(seen.home->rooms).id).dump();
  if (rules.atomic == Naming::Box) {
    const auto& shown = environment.pictured();
    if (shown.empty() || rng_.chance(0.1)) return R"({"bbox": [3, 4, 90, 200]})";
    return Json{{"bbox", rng_.pick(shown).box}}.dump();
  }
  std::vector<std::string> ids;
  for (const ObservedObject& object : seen.boxes.value_or(std::vector<ObservedObject>())) ids.push_back(object.id);
  if (ids.empty() || rng_.chance(0.3)) {
    for (const NamedEntity& thing : seen.home->furniture) ids.push_back(thing.id);
  }
  if (rng_.chance(0.1)) {
    for (const NamedEntity& thing : seen.home->movables) ids.push_back(thing.id);
  }
  return ids.empty() ? R"("nothing_1")" : Json(rng_.pick(ids)).dump();
}

std::string RandomAgent::one_action(const Environment& environment) {
  std::vector<const ActionInfo*> offered;
  for (const ActionInfo& action : all_actions()) {
    if (action.type != ActionType::Stop && environment.task()->data.profile->offers(action.type) &&
        offers(action, environment.settings().rules))
      offered.push_back(&action);
  }
  // What leads to other things comes more often.
  static const std::vector<std::string_view> kUseful{"go_to", "go_to", "pick_up", "open", "place_on", "turn_left"};
  const ActionInfo& action = rng_.chance(0.6) ? info(*action_named(rng_.pick(kUseful))) : *rng_.pick(offered);
  std::string text = R"({"action": ")" + std::string(action.name) + R"(", "args": [)";
  if (action.argument != ActionArgument::None)
    text += argument(environment, action.argument == ActionArgument::ObjectOrRoom);
  return text + "]}";
}

std::string RandomAgent::answer(const Environment& environment) {
  static const std::vector<std::string> kNonsense{"",
                                                  "I do not know.",
                                                  "{\"action\": 7}",
                                                  R"({"action": "fly", "args": ["unicorn_1"]})",
                                                  "[]",
                                                  "{\"actions\": []}",
                                                  R"({"action": "pick_up", "args": ["unicorn_1"]})"};
  if (rng_.chance(0.03)) return rng_.pick(kNonsense);
  if (rng_.chance(0.05)) return "[" + one_action(environment) + ", " + one_action(environment) + "]";
  return one_action(environment);
}

}  // namespace unietp::testing
