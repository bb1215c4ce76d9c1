#include "exports/virtualhome_unity.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "akb/csv.h"
#include "core/files.h"

namespace unietp {
namespace {

struct UnityNeed {
  std::string_view action, property;
};
constexpr std::array kUnityNeeds{UnityNeed{"Grab", "GRABBABLE"},       UnityNeed{"PutBack", "SURFACES"},
                                 UnityNeed{"PutIn", "CONTAINERS"},     UnityNeed{"Open", "CAN_OPEN"},
                                 UnityNeed{"Close", "CAN_OPEN"},       UnityNeed{"SwitchOn", "HAS_SWITCH"},
                                 UnityNeed{"SwitchOff", "HAS_SWITCH"}, UnityNeed{"Sit", "SITTABLE"}};

/// What stands between the last `open` of a text and the `close` after it.
std::string_view last_between(std::string_view text, char open, char close) {
  const auto begin = text.rfind(open);
  return begin == std::string_view::npos ? "" : text.substr(begin + 1, text.find(close, begin) - begin - 1);
}

bool has_property(const UnityProperties& properties, const std::string& name, std::string_view property) {
  const auto its = properties.find(name);
  return its != properties.end() && its->second.contains(std::string(property));
}

}  // namespace

Result<UnityProperties> read_unity_properties(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  const CsvFile rows = read_csv(file.string(), *text);
  if (!rows.errors.empty()) return rows.errors.front();
  const auto& header = rows.header;
  if (header.size() != 3 || header[0].text != "class" || header[1].text != "property" || header[2].text != "source")
    return Error{Error::Kind::Schema, file.string(), {1, 1}, "expected the columns class, property and source"};
  UnityProperties properties;
  for (const CsvRow& row : rows.rows) properties[row[0].text].insert(row[1].text);
  return properties;
}

std::string denied_by_unity(const std::vector<std::string>& program, const UnityProperties& properties) {
  for (const std::string& line : program) {
    const std::string_view action = last_between(line, '[', ']');
    const auto* const need = std::find_if(kUnityNeeds.begin(), kUnityNeeds.end(),
                                          [&](const UnityNeed& one) { return one.action == action; });
    if (need == kUnityNeeds.end()) continue;
    std::string name(last_between(line, '<', '>'));  // that of scripts: "washing_machine"
    name.erase(std::remove(name.begin(), name.end(), '_'), name.end());
    if (!has_property(properties, name, need->property))
      return "Unity's table denies " + std::string(action) + " of " + name;
  }
  return "";
}

}  // namespace unietp
