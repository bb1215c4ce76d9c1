#include "pddl/process_class.h"

#include <set>

#include "symbolic/perform.h"

namespace unietp::pddl {

std::string name_of(const ProcessClass& process) {
  std::string name(name_of(process.treatment));
  if (process.place == ProcessClass::Place::On) name += "-on";
  if (process.place == ProcessClass::Place::Inside) name += "-inside";
  if (process.closed) name += "-closed";
  if (process.power) name += "-running";
  if (process.tap) name += "-tap";
  if (process.door) name += "-door";
  return name;
}

std::optional<ProcessClass> class_of(Treatment treatment, std::uint8_t needs, bool openable, bool switchable) {
  using namespace symbolic;
  if (sets(treatment).empty() || (needs & kHeld) != 0) return std::nullopt;
  ProcessClass found;
  found.treatment = treatment;
  if ((needs & kInside) != 0) {
    found.place = ProcessClass::Place::Inside;
  } else if ((needs & kOn) != 0) {
    found.place = ProcessClass::Place::On;
  }
  found.closed = (needs & kClosed) != 0 && openable;
  found.power = (needs & kPowerOn) != 0 && switchable;
  found.tap = (needs & kUnderTap) != 0;
  found.door = openable;
  return found;
}

std::optional<ProcessClass> class_of(const symbolic::Setting& setting, symbolic::Id tool,
                                     const symbolic::Reaction& reaction) {
  const auto& kind = setting.kind_of(tool);
  return class_of(reaction.treatment, reaction.needs, kind.openable, kind.switchable);
}

std::vector<ProcessClass> classes_of(const Knowledge& knowledge) {
  std::set<ProcessClass> found;
  for (const auto& row : knowledge.effects()) {
    const auto process = class_of(row.treatment, symbolic::needs_of(row), knowledge.has(row.tool, "openable"),
                                  knowledge.has(row.tool, "switchable"));
    if (process) found.insert(*process);
  }
  return {found.begin(), found.end()};
}

}  // namespace unietp::pddl
