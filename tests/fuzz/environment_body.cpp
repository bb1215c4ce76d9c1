#include <nlohmann/json.hpp>

#include "bodies.h"
#include "core/limits.h"
#include "environment/answer.h"
#include "environment/settings.h"
#include "fuzz_bodies.h"
#include "scene/json_parse.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

/// The answer as JSON, its boxes in pixels.
std::string said_again(const Answer& answer) {
  auto actions = nlohmann::ordered_json::array();
  for (const AnsweredAction& one : answer.actions) {
    auto action = command_to_json(one.command);
    if (one.point) action["args"].push_back({{"point", {one.point->x, one.point->y}}});
    actions.push_back(std::move(action));
  }
  return nlohmann::ordered_json{{"reasoning", answer.reasoning}, {"actions", std::move(actions)}}.dump();
}

}  // namespace

bool said_body(std::string_view text) {
  bool sound = false;
  for (const BoxForm form : kBoxForms) {
    const auto answer = parse_answer(text, {form, 500, 400});
    sound = check_result(answer);
    if (!sound) continue;
    require(!answer->actions.empty() && answer->actions.size() <= limits::kAgentActions);
    for (const AnsweredAction& one : answer->actions)
      require(!one.command.action.empty() && one.command.args.size() + (one.point ? 1 : 0) <= 1);
    const auto again = parse_answer(said_again(*answer), {BoxForm::Pixels, 500, 400});
    require(again && *again == *answer);
  }
  return sound;
}

bool settings_body(std::string_view text) {
  const auto json = parse_json("fuzz", text);
  if (!check_result(json)) return false;
  const auto settings = settings_from_json("fuzz", *json);
  if (!check_result(settings)) return false;
  const auto again = settings_from_json("fuzz", settings_to_json(*settings));
  require(again && *again == *settings);
  return true;
}

}  // namespace unietp::fuzz
