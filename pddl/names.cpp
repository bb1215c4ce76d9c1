#include "pddl/names.h"

#include <set>

namespace unietp::pddl {
namespace {

/// Words of PDDL 3, and the types of our domains, each between blanks.
constexpr std::string_view kReserved =
    " and or not imply forall exists when either object number define domain action problem init goal metric "
    "minimize maximize increase decrease assign scale-up scale-down at start end over all total-time "
    "total-cost always sometime within at-most-once sometime-after sometime-before always-within hold-during "
    "hold-after preference thing movable room substance monitor ";

/// "m12": what the monitors of a problem are called.
bool names_a_monitor(std::string_view name) {
  return name.size() > 1 && name[0] == 'm' && name.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

}  // namespace

std::string name_for(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    name += upper ? static_cast<char>(c - 'A' + 'a') : plain ? c : '_';
  }
  if (name.empty() || name[0] < 'a' || name[0] > 'z') name.insert(0, "x_");
  const bool taken = names_a_monitor(name) || kReserved.find(" " + name + " ") != std::string_view::npos;
  return taken ? name + "_1" : name;
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
