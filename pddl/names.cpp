#include "pddl/names.h"

#include <array>
#include <set>

namespace unietp::pddl {
namespace {

constexpr std::array<std::string_view, 24> kReserved{
    "and",    "or",       "not",      "imply",    "forall",   "exists",  "when", "either",
    "object", "number",   "define",   "domain",   "action",   "problem", "init", "goal",
    "metric", "minimize", "maximize", "increase", "decrease", "assign",  "at",   "total-time"};

}  // namespace

std::string name_for(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    name += upper ? static_cast<char>(c - 'A' + 'a') : plain ? c : '_';
  }
  if (name.empty() || name[0] < 'a' || name[0] > 'z') name.insert(0, "x_");
  for (const auto word : kReserved) {
    if (name == word) name += "_1";
  }
  return name;
}

std::vector<std::string> names_for(const std::vector<std::string>& texts) {
  std::set<std::string> used;
  std::vector<std::string> names;
  for (const auto& text : texts) {
    const auto plain = name_for(text);
    auto name = plain;
    for (int i = 2; !used.insert(name).second; ++i) name = plain + "-" + std::to_string(i);
    names.push_back(name);
  }
  return names;
}

}  // namespace unietp::pddl
