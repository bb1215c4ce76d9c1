#include "release_reader.h"

#include <algorithm>

namespace unietp::testing {
namespace {

using Json = nlohmann::ordered_json;
using Values = std::map<std::string, std::string>;

void need(bool sound, const std::string& why) {
  if (!sound) throw ReleaseError(why);
}

class Evaluator {
 public:
  Evaluator(const std::vector<ReleaseGraph>& trace, const Json& references) : trace_(trace), references_(references) {}

  /// Index -1 is the last step. All parts are computed, so that an error in any of them shows.
  bool holds(const Json& node, int step, const Values& values) {
    const std::string type = node.at("type");
    if (type == "And" || type == "Or") return junction(node, step, values);
    if (type == "Not") return !holds(node.at("child"), step, values);
    if (type == "Implies") {
      const bool premise = holds(node.at("premise"), step, values);
      const bool conclusion = holds(node.at("conclusion"), step, values);
      return !premise || conclusion;
    }
    if (type == "AtEnd") return holds(node.at("child"), -1, values);
    if (type == "Always" || type == "Sometime") return somewhere(node, step, values, type == "Always");
    if (type == "Until") return until(node, step, values);
    if (type == "ForAll" || type == "Exists") return quantified(node, step, values, type == "Exists");
    if (type == "Compare") return compared(node, step, values);
    if (type == "Predicate") return predicate(node, step, values);
    throw ReleaseError("no node type " + type);
  }

 private:
  int from(int step) const { return step < 0 ? last() : step; }
  int last() const { return static_cast<int>(trace_.size()) - 1; }
  const ReleaseGraph& at(int step) const { return trace_[static_cast<std::size_t>(from(step))]; }

  bool junction(const Json& node, int step, const Values& values) {
    const bool all = node.at("type") == "And";
    need(!node.at("children").empty(), "min or max of nothing");
    bool result = all;
    for (const Json& child : node.at("children")) {
      const bool value = holds(child, step, values);
      result = all ? result && value : result || value;
    }
    return result;
  }

  bool somewhere(const Json& node, int step, const Values& values, bool everywhere) {
    bool result = everywhere;
    for (int t = from(step); t <= last(); ++t) {
      const bool value = holds(node.at("child"), t, values);
      result = everywhere ? result && value : result || value;
    }
    return result;
  }

  bool until(const Json& node, int step, const Values& values) {
    for (int t = from(step); t <= last(); ++t) {
      if (holds(node.at("cond_b"), t, values)) return true;
      if (!holds(node.at("cond_a"), t, values)) return false;
    }
    return false;
  }

  static bool among(const Json& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  std::set<std::string> in_step(const Json& categories, int step) const {
    std::set<std::string> ids;
    for (const auto& [id, node] : at(step).nodes) {
      if (categories.is_null() || among(categories, node.category)) ids.insert(id);
    }
    return ids;
  }

  std::set<std::string> in_any_step(const Json& categories) const {
    std::set<std::string> ids;
    for (const auto& graph : trace_) {
      for (const auto& [id, node] : graph.nodes) {
        if (!among(categories, node.category)) continue;
        need(categories.size() == 1, "Exists over several categories");
        const bool left_out = references_.contains(node.category) && !among(references_[node.category], id);
        if (!left_out) ids.insert(id);
      }
    }
    return ids;
  }

  bool quantified(const Json& node, int step, const Values& values, bool exists) {
    const Json& categories = node.at("var_categories");
    need(references_.empty() || exists, "ForAll beside a reference");
    need(references_.empty() || !categories.is_null(), "Exists over everything beside a reference");
    bool result = !exists;
    for (const auto& id : exists ? in_any_step(categories) : in_step(categories, step)) {
      Values inner = values;
      inner[node.at("var_name")] = id;
      const bool value = holds(node.at("child"), step, inner);
      result = exists ? result || value : result && value;
    }
    return result;
  }

  double number(const Json& node, int step, const Values& values) {
    if (node.is_number()) return node;
    need(node.at("type") == "CountSatisfying", "no such value");
    double count = 0;
    for (const auto& id : in_step(node.at("var_categories"), step)) {
      Values inner = values;
      inner[node.at("var_name")] = id;
      count += holds(node.at("condition"), step, inner) ? 1 : 0;
    }
    return count;
  }

  bool compared(const Json& node, int step, const Values& values) {
    need(references_.empty(), "Compare beside a reference");
    const double left = number(node.at("left"), step, values), right = number(node.at("right"), step, values);
    const std::string op = node.at("op");
    if (op == "==") return left == right;
    if (op == ">") return left > right;
    if (op == "<") return left < right;
    if (op == "<=") return left <= right;
    if (op == ">=") return left >= right;
    throw ReleaseError("no operator " + op);
  }

  static std::string id_of(const std::string& term, const Values& values) {
    if (!term.starts_with("?")) return term;
    const auto found = values.find(term.substr(1));
    need(found != values.end(), "unbound " + term);
    return found->second;
  }

  bool predicate(const Json& node, int step, const Values& values) {
    const Json& details = node.at("predicate_kwargs");
    const auto& graph = at(step);
    if (node.at("predicate_type") == "relation") {
      static const std::set<std::string> kRelations{"on_receptacle", "inside_receptacle", "on_room_floor",
                                                    "inside_room",   "inside_house",      "grasping"};
      need(details.size() == 2 && details.at("relation_details").is_null(), "unknown keys");
      const std::string relation = details.at("relation");
      need(kRelations.contains(relation), "no relation " + relation);
      const auto first = id_of(node.at("args").at(0), values), second = id_of(node.at("args").at(1), values);
      need(graph.nodes.contains(first), "KeyError: " + first);
      return graph.edges.contains({first, relation, second});
    }
    need(node.at("predicate_type") == "state" && details.size() == 2, "no such predicate");
    static const std::set<std::string> kStates{
        "closed",     "open",   "power_off", "power_on",    "clean",         "dirty",         "no_liquid",
        "not_broken", "broken", "cooked",    "not_used_up", "used_up",       "not_cooked",    "filled_with_liquid",
        "not_burnt",  "burnt",  "unfrozen",  "frozen",      "saturated",     "not_saturated", "normal_temperature",
        "hot",        "cool",   "covered",   "not_covered", "contain_liquid"};
    const std::string state = details.at("state");
    need(kStates.contains(state), "no state " + state);
    const auto found = graph.nodes.find(id_of(node.at("args"), values));
    if (found == graph.nodes.end()) return false;
    const auto held = found->second.states.find(state);
    if (held == found->second.states.end()) return false;
    return details.at("state_params").is_null() || held->second == details.at("state_params");
  }

  const std::vector<ReleaseGraph>& trace_;
  const Json& references_;
};

}  // namespace

bool release_goal_holds(const Json& goal, const std::vector<ReleaseGraph>& trace, const Json& references) {
  return Evaluator(trace, references).holds(goal, 0, {});
}

}  // namespace unietp::testing
