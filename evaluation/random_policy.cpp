#include "evaluation/random_policy.h"

#include <algorithm>
#include <vector>

#include <nlohmann/json.hpp>

#include "environment/agent_text.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kStops = 0.02;

std::vector<const ActionInfo*> offered_actions(const Environment& environment) {
  std::vector<const ActionInfo*> offered;
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      if (action.type != ActionType::Stop && environment.task()->data.profile->offers(action.type) &&
          offers(action, environment.settings().rules))
        offered.push_back(&action);
    }
  }
  return offered;
}

Json random_box(const Environment& environment, Rng& rng) {
  const Observation& seen = environment.observe();
  const auto ends = [&](int size) {
    const int a = static_cast<int>(rng.below(static_cast<std::uint64_t>(size)));
    const int b = static_cast<int>(rng.below(static_cast<std::uint64_t>(size)));
    return std::minmax({a, b});
  };
  const auto [left, right] = ends(seen.image_width);
  const auto [top, bottom] = ends(seen.image_height);
  return {{"bbox", box_in_form({left, top, right, bottom}, environment.settings().box_form, seen.image_width,
                               seen.image_height)}};
}

Json random_argument(const Environment& environment, const ActionInfo& action, Rng& rng) {
  const Observation& seen = environment.observe();
  std::vector<std::string> ids;
  if (action.argument == ActionArgument::ObjectOrRoom) {
    for (const NamedEntity& room : seen.home->rooms) ids.push_back(room.id);
  }
  const bool by_box = naming_of(action, environment.settings().rules) == Naming::Box;
  if (by_box && (ids.empty() || rng.chance(0.5))) return random_box(environment, rng);
  if (!by_box) {
    for (const auto* list : {&seen.home->furniture, &seen.home->movables}) {
      for (const NamedEntity& thing : *list) ids.push_back(thing.id);
    }
    for (const ObservedObject& object : seen.boxes.value_or(std::vector<ObservedObject>())) ids.push_back(object.id);
  }
  return ids.empty() ? Json("nothing") : Json(rng.pick(ids));
}

}  // namespace

std::optional<NoReply> RandomPolicy::begin(const PlannedEpisode& episode, const Environment& /*start*/) {
  rng_ = episode_rng(seed_, episode.key);
  return std::nullopt;
}

PolicyAnswer RandomPolicy::next(const Environment& environment) {
  const auto offered = offered_actions(environment);
  Json json{{"action", "stop"}, {"args", Json::array()}};
  if (!offered.empty() && !rng_.chance(kStops)) {
    const ActionInfo& action = *rng_.pick(offered);
    json["action"] = action.name;
    if (action.argument != ActionArgument::None) json["args"].push_back(random_argument(environment, action, rng_));
  }
  PolicyReply reply;
  reply.text = json.dump();
  return reply;
}

}  // namespace unietp
