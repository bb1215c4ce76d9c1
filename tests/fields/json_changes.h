#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace unietp {

/// One value of a JSON text changed. `field`: its place with `[]` for any item of a list: "start.changes.nodes[].mass".
struct JsonChange {
  std::string field, how;  // how: "plus one", "twice", "other sign", "another value", …
  nlohmann::ordered_json::json_pointer place;
  std::function<void(nlohmann::ordered_json&)> apply;  // to the text that it was made for
};

/// Values that a field has in some file, by field.
using KnownValues = std::map<std::string, std::vector<nlohmann::ordered_json>>;
void collect_values(const nlohmann::ordered_json& json, const std::string& field, KnownValues& values);

/// Every change of every value: numbers plus one, twice, with the other sign; texts as another one that the field has
/// elsewhere, or with a letter more; truth values turned round; items of lists dropped, doubled and swapped with the
/// next; fields dropped, and one added to each object. Changes that change nothing are left out.
std::vector<JsonChange> changes_of_json(const nlohmann::ordered_json& json, const KnownValues& values);

}  // namespace unietp
