#include "run/fit_of_home.h"

#include <algorithm>
#include <utility>

#include "generator/fixed_start.h"
#include "generator/propose.h"
#include "grounding/goal_places.h"
#include "grounding/household.h"
#include "run/sense_of_binding.h"
#include "sense/wants.h"

namespace unietp {
namespace {

/// "The coffee machine" in a kitchen, "the dining table" not in an office.
bool is_usual_room_of(const std::string& place, const std::string& room, const Knowledge& knowledge) {
  const auto& usual = knowledge.find(place)->rooms;
  return std::find(usual.begin(), usual.end(), room) != usual.end();
}

/// Whether the home has furniture of another category that the category's name could mean: of the same name, or of one
/// that ends in it.
bool has_namesake(const std::string& category, const Home& home, const NounTable& nouns) {
  const auto* own = nouns.display(category);
  if (own == nullptr) return false;
  const auto& nodes = home.scene.nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](const Node& node) {
    if (node.movable || node.category == category) return false;
    const auto* name = nouns.display(node.category);
    return name != nullptr && (name->singular == own->singular || name->singular.ends_with(" " + own->singular));
  });
}

/// Whether each place that the goal names for a thing stands somewhere in a room where people have such places and keep
/// such things: no kitchen knife goes into a drawer where all drawers are in bedrooms, and what stands in an office is
/// not called a dining table. What the home lacks is not looked at.
bool rooms_suit(const Formula& goal, const Layout& layout, const Household& household, const Knowledge& knowledge) {
  const Home& home = layout.home;
  const auto suits = [&](const std::string& category, std::size_t node) {
    const auto room = home.rooms[node];
    if (room < 0) return true;
    const std::string& type = home.scene.rooms[static_cast<std::size_t>(room)].type;
    const std::string& place = home.scene.nodes[node].category;
    return is_usual_room_of(place, type, knowledge) && household.keeps(category, place, type) &&
           (!household.passes(place) || household.is_usual_in(category, type));
  };
  for (const auto& [category, places] : goal_places(goal)) {
    for (const std::string& place : places) {
      const auto& there = home.places.of(place);
      if (there.empty() || home.scene.nodes[there.front()].movable) continue;
      if (std::none_of(there.begin(), there.end(), [&](std::size_t node) { return suits(category, node); }))
        return false;
    }
  }
  return true;
}

}  // namespace

bool all_sinks_suit(const Formula& goal, const Layout& layout, const Household& household) {
  const Home& home = layout.home;
  const Wants wants = wants_of(goal);
  const auto suits = [&](const std::string& category, const std::string& place) {
    const auto& there = home.places.of(place);
    return std::all_of(there.begin(), there.end(), [&](std::size_t node) {
      const auto room = home.rooms[node];
      return room < 0 || household.keeps(category, place, home.scene.rooms[static_cast<std::size_t>(room)].type);
    });
  };
  return std::none_of(wants.wants.begin(), wants.wants.end(), [&](const Want& want) {
    if (want.predicate != Predicate::Inside || want.negated || !want.other) return false;
    const Domain& places = wants.things[*want.other];
    if (!places.where.empty()) return false;  // it says which
    return std::any_of(places.members.begin(), places.members.end(), [&](const Domain::Member& place) {
      const auto& things = wants.things[want.thing].members;
      return household.passes(place.category) &&
             !std::all_of(things.begin(), things.end(),
                          [&](const Domain::Member& thing) { return suits(thing.category, place.category); });
    });
  });
}

bool leaves_open(const Formula& goal, const Layout& layout, const Household& household, const NounTable& nouns) {
  const Home& home = layout.home;
  const auto is_open = [&](const QuantifiedDomain& one) {
    const Domain& asked = one.domain;
    if (asked.members.empty() || !asked.where.empty()) return false;
    const std::string& category = asked.members.front().category;
    if (one.op == Formula::Op::Count) return household.is_personal(category) && asked.members.size() == 1;
    if (one.op != Formula::Op::Exists) return false;
    const auto& rooms = home.scene.rooms;
    if (std::count_if(rooms.begin(), rooms.end(), [&](const Room& room) { return room.type == category; }) > 1)
      return true;
    std::vector<std::size_t> there;
    for (const Domain::Member& member : asked.members) {
      const auto& of_member = home.places.of(member.category);
      there.insert(there.end(), of_member.begin(), of_member.end());
    }
    if (there.empty()) return false;
    const bool fixed = !home.scene.nodes[there.front()].movable;
    if (fixed && asked.members.size() == 1 && has_namesake(category, home, nouns)) return true;
    if (there.size() < 2) return false;
    if (!fixed) return asked.members.size() == 1 && household.is_personal(category);
    return std::any_of(there.begin(), there.end(),
                       [&](std::size_t node) { return home.rooms[node] != home.rooms[there.front()]; });
  };
  const auto domains = quantified_domains(goal);
  return std::any_of(domains.begin(), domains.end(), is_open);
}

RoomSuits rooms_for(const Formula& goal, const Household& household, const Knowledge& knowledge) {
  return [things = goal_places(goal), &household, &knowledge](const std::string& place, const std::string& room) {
    return is_usual_room_of(place, room, knowledge) && std::all_of(things.begin(), things.end(), [&](const auto& of) {
             return !of.second.contains(place) ||
                    (household.keeps(of.first, place, room) && household.is_usual_in(of.first, room));
           });
  };
}

BindingCheck fits_home(const RunConfiguration& configuration, const Resources& resources, const Template& source,
                       const Layout& layout, Grade least) {
  const Simulator simulator = layout.home.scene.simulator;
  BindingCheck makes_sense = at_least(least, source, resources, simulator);
  if (!configuration.binding.empty()) return makes_sense;
  const Household* household = least == Grade::Senseless ? nullptr : resources.recipe(simulator).household.get();
  return [&source, &layout, &knowledge = resources.backend(simulator).knowledge, household,
          makes_sense = std::move(makes_sense)](const Binding& bound, const Parameter& parameter,
                                                const std::string& category) {
    if (makes_sense && !makes_sense(bound, parameter, category)) return false;
    if (bound.size() + 1 < source.parameters.size()) return true;
    Binding all = bound;
    all.emplace_back(parameter.name, category);
    // What costs least comes first: the last gates draw starts.
    const auto filled = fill_in(source, knowledge, all);
    const auto* specification = std::get_if<Specification>(&filled);
    if (specification == nullptr || misfit(specification->init, knowledge, layout.offer.now) != nullptr) return false;
    if (household != nullptr && !rooms_suit(specification->goal, layout, *household, knowledge)) return false;
    return !refused_by(*specification, knowledge);
  };
}

}  // namespace unietp
