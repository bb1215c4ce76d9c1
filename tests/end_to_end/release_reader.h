#pragma once

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <nlohmann/json.hpp>

namespace unietp::testing {

/// A scene graph as the evaluator that the paper's authors released reads one.
struct ReleaseGraph {
  struct Node {
    std::string category;
    std::map<std::string, nlohmann::ordered_json> states;  // with their parameters
  };
  std::map<std::string, Node> nodes;
  std::set<std::tuple<std::string, std::string, std::string>> edges;  // from, relation, to
};

/// What stops their evaluator: an assertion, a missing key, a wrong value.
struct ReleaseError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Truth of a `logic_dict` at step 0 of a trace, by the rules of that evaluator, its oddities among them. `references`
/// is the record's `object_reference`. Shares no code with the export.
bool release_goal_holds(const nlohmann::ordered_json& goal, const std::vector<ReleaseGraph>& trace,
                        const nlohmann::ordered_json& references);

}  // namespace unietp::testing
