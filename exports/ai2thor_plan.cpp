#include "exports/ai2thor_plan.h"

#include <algorithm>
#include <array>
#include <numbers>

#include <nlohmann/json.hpp>

#include "exports/ai2thor_words.h"
#include "interchange/house_json.h"
#include "interchange/unity.h"
#include "scene/trace.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::variant<bool, std::string_view>& value) {
  return std::visit([](const auto& one) { return Json(one); }, value);
}

/// The liquid that fills a node; "" for none.
std::string liquid_in(const Node* node) {
  if (node == nullptr) return "";
  for (const State& state : node->states.all()) {
    if (state.predicate == Predicate::Filled) return state.symbol;
  }
  return "";
}

/// What a call says but for whom it names.
Json fixed_part(std::string_view action) {
  Json call{{"action", action}};
  if (action == "OpenObject") call["openness"] = 1.0;
  if (action == "PutObject") {
    call["forceAction"] = true;  // also where iTHOR's own scenes would not put it
    call["placeStationary"] = true;
  }
  return call;
}

class ThorPlanner {
 public:
  ThorPlanner(Scene start, ThorNames& names) : scene_(std::move(start)), names_(names) {}

  Result<Json> run(const DemonstrationRecord& demonstration) {
    Json plan = Json::array();
    for (const StepRecord& step : demonstration.steps) {
      const auto type = action_named(step.command.action);
      if (!step.success || !type || *type == ActionType::Stop) continue;
      after_ = apply(scene_, step.changes);
      Json calls = Json::array();
      if (auto added = add(step, *type, calls); !added) return added.error();
      plan.push_back({{"step", to_text(step.command)}, {"calls", std::move(calls)}});
      if (auto named = name_slices(step); !named) return named.error();
      scene_ = std::move(after_);
    }
    return plan;
  }

 private:
  Result<Done> add(const StepRecord& step, ActionType type, Json& calls) {
    argument_ = step.command.args.empty() ? "" : step.command.args.front().id;
    const Node* const tool = find_node(scene_, argument_);
    const auto rows = thor_calls(type, tool == nullptr ? "" : tool->category);
    const bool is_switch = type == ActionType::TurnOn || type == ActionType::TurnOff;
    if (!rows || (is_switch && tool != nullptr && !thor_holding_part(tool->category).empty())) {
      return thor_lacks("AI2-THOR has no " + step.command.action +
                        (tool == nullptr ? std::string() : " of or with " + tool->category));
    }
    const std::string held = scene_.agent.held.empty() ? std::string() : scene_.agent.held.front();
    for (const ThorCall& row : *rows) {
      if (row.target != ThorTarget::Others) {
        if (auto added = add(row, held, calls); !added) return added.error();
        continue;
      }
      for (const Node& node : step.changes.nodes) {
        if (node.id == argument_ || node.id == held || !names_.contains(node.id)) continue;
        if (auto added = add(row, node.id, calls); !added) return added.error();
      }
    }
    return Done{};
  }

  /// `thing`: of what is not the argument.
  Result<Done> add(const ThorCall& row, const std::string& thing, Json& calls) {
    Json call = fixed_part(row.action);
    if (row.target == ThorTarget::Pose) {
      add_pose(call);
    } else if (row.target != ThorTarget::Nothing) {
      const std::string object = row.target == ThorTarget::Argument ? argument_ : thing;
      if (!needed(row.when, object)) return Done{};
      const auto name = names_.find(object);
      if (name == names_.end()) return thor_lacks(object + " is not in the house");
      call["objectId"] = name->second;
      add_details(row.action, object, call);
    }
    calls.push_back(std::move(call));
    return Done{};
  }

  bool needed(ThorWhen when, const std::string& object) const {
    const Node* const before = find_node(scene_, object);
    const Node* const after = find_node(after_, object);
    if (before == nullptr || after == nullptr) return when == ThorWhen::Always;
    switch (when) {
      case ThorWhen::Always:
        return true;
      case ThorWhen::Closed:
        return !before->states.has(Predicate::Open);
      case ThorWhen::Running:
        return before->states.has(Predicate::PowerOn);
      case ThorWhen::Closes:
        return !after->states.has(Predicate::Open);
      case ThorWhen::Cleans:
        return after->states.has(Predicate::Clean) && !before->states.has(Predicate::Clean);
      case ThorWhen::Fills:
        return !liquid_in(after).empty() && liquid_in(after) != liquid_in(before);
    }
    return false;
  }

  void add_details(std::string_view action, const std::string& object, Json& call) const {
    if (action == "FillObjectWithLiquid") call["fillLiquid"] = liquid_in(find_node(after_, object));
    if (action == "PutObject") {
      if (const Node* const node = find_node(scene_, object)) {
        if (const auto part = thor_holding_part(node->category); !part.empty()) call["part"] = part;
      }
    }
  }

  void add_pose(Json& call) const {
    const Json pose = house_metadata(after_)["agent"];
    for (const char* const key : {"position", "rotation", "horizon", "standing"}) call[key] = pose[key];
    call["horizon"] = std::clamp(call["horizon"].get<double>(), -30.0, 60.0);
    if (const auto name = names_.find(argument_); name != names_.end()) call["near"] = name->second;
  }

  /// AI2-THOR numbers the pieces of a thing from 0: `Apple|2|1|AppleSliced_0`.
  Result<Done> name_slices(const StepRecord& step) {
    std::map<std::string, int> numbers;
    for (const Node& node : step.changes.nodes) {
      if (names_.contains(node.id) || find_node(scene_, node.id) != nullptr) continue;
      const auto whole = names_.find(node.slice_of);
      if (whole == names_.end()) return thor_lacks(node.id + " comes of nothing that is in the house");
      names_[node.id] = whole->second + "|" + node.category + "_" + std::to_string(numbers[node.slice_of]++);
    }
    return Done{};
  }

  Scene scene_, after_;  // before and after the step
  ThorNames& names_;
  std::string argument_;
};

}  // namespace

Error thor_lacks(std::string why) { return {Error::Kind::Unsatisfiable, "", {}, std::move(why)}; }

Result<Json> thor_plan(const DemonstrationRecord& demonstration, Scene start, ThorNames& names) {
  return ThorPlanner(std::move(start), names).run(demonstration);
}

Json thor_words() {
  static constexpr std::array kOf{"", "argument", "held", "pose", "others"};
  static constexpr std::array kWhen{"always", "closed", "running", "closes", "cleans", "fills"};
  Json states = Json::array(), actions = Json::array();
  for (const ThorState& row : thor_states()) {
    if (row.state == Predicate::Held) continue;  // which follows from the agent
    Json one{{"state", info(row.state).name}, {"kind", info(row.state).group}, {"key", row.key}};
    if (row.state != Predicate::Filled) one["equals"] = json_of(row.value);
    states.push_back(std::move(one));
  }
  for (const ThorActionRow& row : thor_actions()) {
    Json one{{"action", info(row.action).name}};
    if (!row.tool.empty()) one["tool"] = row.tool;
    one["calls"] = Json::array();
    for (const ThorCall& call : row.calls) {
      Json said = fixed_part(call.action);
      if (call.target != ThorTarget::Nothing) said["of"] = kOf[static_cast<std::size_t>(call.target)];
      if (call.when != ThorWhen::Always) said["when"] = kWhen[static_cast<std::size_t>(call.when)];
      one["calls"].push_back(std::move(said));
    }
    actions.push_back(std::move(one));
  }
  return {{"states", std::move(states)}, {"actions", std::move(actions)}};
}

std::optional<Json> thor_test(const State& state, const std::string& object) {
  const ThorState* const row = thor_state(state.predicate);
  if (row == nullptr) return std::nullopt;
  if (state.predicate != Predicate::Filled) {
    return Json{{"objectId", object}, {"key", row->key}, {"equals", json_of(row->value)}};
  }
  if (state.symbol == "any") return Json{{"objectId", object}, {"key", "isFilledWithLiquid"}, {"equals", true}};
  return Json{{"objectId", object}, {"key", row->key}, {"equals", state.symbol}};
}

Result<Json> thor_start(const Scene& start, const ThorNames& names, const std::set<std::string>& used,
                        std::vector<std::string>& differs) {
  // What is hot stays so here.
  Json calls = Json::array();
  calls.push_back({{"call", {{"action", "SetDecayTemperatureBool"}, {"allowDecayTemperature", false}}}});
  for (const Node& node : start.nodes) {
    const auto name = names.find(node.id);
    if (name == names.end()) continue;
    for (const State& state : node.states.all()) {
      const bool usual = info(state.predicate).by_default, of_use = used.contains(node.id);
      const ThorState* const row = thor_state(state.predicate);
      if (usual && (!of_use || row == nullptr || row->call.empty())) continue;
      if (row == nullptr || row->call.empty()) {
        const std::string what = node.id + " is " + std::string(info(state.predicate).name) + " at the start";
        if (of_use) return thor_lacks("no call of AI2-THOR makes it so that " + what);
        differs.push_back(what);
        continue;
      }
      Json call{{"action", row->call}, {"objectId", name->second}};
      if (state.predicate == Predicate::Open) {
        call["openness"] = node.opening > 0 ? house_number(node.opening, 1000) : 1.0;
      }
      if (state.predicate == Predicate::Filled) call["fillLiquid"] = state.symbol;
      call["forceAction"] = true;
      calls.push_back({{"unless", *thor_test(state, name->second)}, {"call", std::move(call)}});
    }
  }
  for (const std::string& held : start.agent.held) {
    const auto name = names.find(held);
    if (name == names.end()) return thor_lacks(held + " is not in the house");
    const Json test{{"objectId", name->second}, {"key", "isPickedUp"}, {"equals", true}};
    calls.push_back(
        {{"unless", test}, {"call", {{"action", "PickupObject"}, {"objectId", name->second}, {"forceAction", true}}}});
  }
  return calls;
}

}  // namespace unietp
