#include "sense/swap_pool.h"

#include <array>

#include "akb/fit.h"

namespace unietp {
namespace {

constexpr std::string_view kNotOfHomes = "outside";

/// The affordance that something to be done needs; with `part`, also physically.
struct Need {
  std::string_view family, affordance;
  bool part;
};
constexpr std::array<Need, 17> kNeeds{{{"heat", "heatable", false},
                                       {"cool", "heatable", false},
                                       {"cook", "cookable", false},
                                       {"freeze", "freezable", false},
                                       {"slice", "sliceable", false},
                                       {"wash", "dirtyable", false},
                                       {"dust", "coverable", false},
                                       {"soak", "soakable", false},
                                       {"cover", "coverable", false},
                                       {"fold", "foldable", true},
                                       {"fill", "fillable", true},
                                       {"empty", "fillable", true},
                                       {"open", "openable", true},
                                       {"close", "openable", true},
                                       {"switch_on", "switchable", true},
                                       {"switch_off", "switchable", true},
                                       {"read", "pickupable", false}}};

std::string chosen(const std::set<std::string>& all, const std::string& but, std::uint64_t draw) {
  std::set<std::string> others = all;
  others.erase(but);
  if (others.empty()) return "";
  auto at = others.begin();
  std::advance(at, static_cast<std::ptrdiff_t>(draw % others.size()));
  return *at;
}

}  // namespace

void SwapPool::add(By by, const std::string& thing, const Role& role) {
  const auto at = static_cast<std::size_t>(by);
  things_at_[at][role].insert(thing);
  roles_of_[at][thing].insert(role);
}

SwapPool::SwapPool(const CommonSense& sense, const Knowledge& knowledge) {
  const auto simulator = knowledge.simulator();
  const auto kind_of = [&](const std::string& category) {
    const auto* fact = sense.kind_of(simulator, category);
    return fact == nullptr || fact->kind == kNotOfHomes ? std::string() : fact->kind;
  };
  for (const auto& thing : knowledge.categories()) {
    const auto kind = kind_of(thing.name);
    if (kind.empty()) continue;
    for (const auto& affordance : knowledge.affordances_of(thing.name)) having_[affordance].insert(kind);
    if (!thing.movable) continue;
    carried_.insert(kind);
    for (const auto& place : knowledge.categories()) {
      const auto at = kind_of(place.name);
      if (at.empty() || !sense.kinds().is_a(at, "place")) continue;
      for (const auto& [relation, word] : {std::pair(Predicate::On, "on"), std::pair(Predicate::Inside, "in")}) {
        if (fits(thing, relation, place)) add(By::Physics, kind, sense.kinds().place_role(word, at));
      }
    }
  }
  for (const auto& row : knowledge.placements()) {
    if (row.relation != Predicate::On && row.relation != Predicate::Inside) continue;
    const auto thing = kind_of(row.object), place = kind_of(row.receptacle);
    if (!thing.empty() && !place.empty())
      add(By::Listing, thing, sense.kinds().place_role(row.relation == Predicate::On ? "on" : "in", place));
  }
}

std::optional<Evidence> SwapPool::swapped(const Evidence& item, By by, std::uint64_t draw) const {
  Evidence other = item;
  const auto at = static_cast<std::size_t>(by);
  const auto family = family_of(item.role);
  if (family == "place") {
    const auto things = things_at_[at].find(item.role);
    const auto roles = roles_of_[at].find(item.thing);
    const bool swap_thing = draw % 2 == 0 && things != things_at_[at].end();
    if (swap_thing) {
      other.thing = chosen(things->second, item.thing, draw / 2);
    } else if (roles != roles_of_[at].end()) {
      other.role = chosen(roles->second, item.role, draw / 2);
    } else {
      return std::nullopt;
    }
  } else {
    const auto action = family == "do" ? item.role : family;
    for (const auto& need : kNeeds) {
      if (need.family != action) continue;
      const auto having = having_.find(std::string(need.affordance));
      const bool any = by == By::Physics && !need.part;
      other.thing = any                       ? chosen(carried_, item.thing, draw)
                    : having == having_.end() ? ""
                                              : chosen(having->second, item.thing, draw);
    }
    if (other.thing == item.thing) return std::nullopt;
  }
  if (other.thing.empty() || other.role.empty()) return std::nullopt;
  return other;
}

}  // namespace unietp
