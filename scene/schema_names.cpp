#include "scene/schema_names.h"

#include <vector>

#include "core/text.h"
#include "scene/action_table.h"
#include "scene/node_json.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

std::string one_of(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const auto& name : names) quoted.push_back("        \"" + name + "\"");
  return "\"enum\": [\n" + join(quoted, ",\n") + "\n      ]";
}

std::string definition(const std::string& name, const std::string& description, const std::string& rule) {
  return "    \"" + name + "\": {\n      \"description\": \"" + description +
         "\",\n      \"type\": \"string\",\n      " + rule + "\n    }";
}

}  // namespace

std::string schema_names() {
  std::vector<std::string> actions, relations, plain, symbolic;
  for (const ActionInfo& action : action_table()) actions.emplace_back(action.name);
  for (const PredicateInfo& predicate : all_predicates()) {
    if (is_edge_relation(predicate.predicate)) relations.emplace_back(predicate.name);
    if (is_node_state(predicate.predicate))
      (has_symbol(predicate.predicate) ? symbolic : plain).emplace_back(predicate.name);
  }
  const auto state = R"("pattern": "^(()" + join(plain, "|") + ")|(" + join(symbolic, "|") + R"()\\([\\s\\S]+\\))$")";
  return R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "names.schema.json",
  "title": "Names of actions, states and relations",
  "description": "Written by `unietp schemas --names` from the tables of the program; the other schemas refer to it.",
  "$defs": {
)" + definition("action", "An action of docs/action-table.md.", one_of(actions)) +
         ",\n" + definition("state", "A state of one object: `clean`, or with a symbol `filled(water)`.", state) +
         ",\n" + definition("relation", "A relation of two objects, or of an object and a room.", one_of(relations)) +
         "\n  }\n}\n";
}

}  // namespace unietp
