#include "run/fit_of_home.h"

#include <algorithm>
#include <set>
#include <utility>

#include "annotator/everyday_names.h"
#include "annotator/plural.h"
#include "core/text.h"
#include "generator/fixed_start.h"
#include "generator/goal_variable.h"
#include "generator/propose.h"
#include "generator/style_fit.h"
#include "grounding/goal_places.h"
#include "grounding/household.h"
#include "run/sense_of_binding.h"
#include "sense/wants.h"
#include "templates/rooms_needed.h"

namespace unietp {
namespace {

/// "The coffee machine" in a kitchen, "the dining table" not in an office. A room of a type that the knowledge base
/// does not speak of, as files without rooms have, may be any.
bool is_usual_room_of(const std::string& place, const std::string& room, const Knowledge& knowledge) {
  const auto is_usual = [&](const Category& category) {
    return std::find(category.rooms.begin(), category.rooms.end(), room) != category.rooms.end();
  };
  const auto& all = knowledge.categories();
  return is_usual(*knowledge.find(place)) || std::none_of(all.begin(), all.end(), is_usual);
}

/// What people say for a category, even where another category has that name already and NounTable writes a longer one;
/// "" when it has no name.
std::string spoken_name(const std::string& category, const NounTable& nouns) {
  const auto* name = nouns.display(category);
  if (name == nullptr) return "";
  const auto everyday = nouns.everyday()->of(name->singular, English::Us);
  return everyday.empty() ? name->singular : std::string(everyday);
}

/// Whether furniture of another name has things of this one: a chest of drawers has drawers.
bool has_such(const std::string& other, const std::string& own) { return other.ends_with(" of " + plural_of(own)); }

/// Whether the home has furniture of another category that the category's name could mean: of the same name, of one
/// that ends in it or has such things, of a kind that is called so ("the shelf" beside a shelving unit), or that people
/// call so ("the lower cabinet" of a storage cabinet).
bool has_namesake(const std::string& category, const Home& home, const Household& household, const NounTable& nouns) {
  const std::string own = spoken_name(category, nouns);
  if (own.empty()) return false;
  const auto& nodes = home.scene.nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](const Node& node) {
    if (node.movable || node.category == category) return false;
    const std::string other = spoken_name(node.category, nouns);
    return other == own || other.ends_with(" " + own) || has_such(other, own) ||
           household.kind_of(node.category) == own || household.may_mean(category, node.category);
  });
}

/// Whether furniture of another category, but of the same name, stands in a room with some of this one; where no more
/// than its room is said of it, also furniture that people call so.
bool has_twin(const Domain& asked, const Home& home, const Household& household, const NounTable& nouns) {
  const std::string& category = asked.members.front().category;
  const bool said = std::any_of(asked.where.begin(), asked.where.end(), [](const Formula& test) {
    return predicates_in(test) != std::set<Predicate>{Predicate::InRoom};
  });
  const auto& there = home.places.of(category);
  if (there.empty() || home.scene.nodes[there.front()].movable) return false;
  const std::string own = spoken_name(category, nouns);
  for (std::size_t other = 0; other < home.scene.nodes.size(); ++other) {
    const Node& node = home.scene.nodes[other];
    if (node.movable || node.category == category) continue;
    const std::string name = spoken_name(node.category, nouns);
    if (name != own && !has_such(name, own) && (said || !household.may_mean(category, node.category))) continue;
    if (std::any_of(there.begin(), there.end(), [&](std::size_t one) { return home.rooms[one] == home.rooms[other]; }))
      return true;
  }
  return false;
}

/// "bottle" of "soap bottle" and of "bottle of hand soap"
std::string head_of(const std::string& name) {
  const auto words = split(name.substr(0, name.find(" of ")), ' ');
  return words.empty() ? "" : words.back();
}

/// Whether one of the two names has all the words of the other and the same head: "soap bottle", "bottle of hand soap".
bool includes_name(const std::string& one, const std::string& other) {
  if (head_of(one) != head_of(other)) return false;
  const auto words = [](const std::string& name) {
    std::set<std::string> all;
    for (const std::string& word : split(name, ' ')) all.insert(word);
    all.erase("of");
    return all;
  };
  const auto a = words(one), b = words(other);
  return std::includes(a.begin(), a.end(), b.begin(), b.end()) || std::includes(b.begin(), b.end(), a.begin(), a.end());
}

/// Whether the home has something of another category that a listener could bring for what can be carried: "the bowl"
/// beside a mixing bowl, "the fruit" beside an apple.
bool has_likeness(const std::string& category, const Home& home, const Household& household, const NounTable& nouns) {
  const std::string own = spoken_name(category, nouns);
  if (own.empty()) return false;
  const auto& nodes = home.scene.nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](const Node& node) {
    if (!node.movable || node.category == category) return false;
    const std::string other = spoken_name(node.category, nouns);
    // "Bottle of hand soap" has all the words of "soap bottle", and people call the one by the other; a box of tissues
    // is called no box.
    const bool has_of = own.find(" of ") != std::string::npos || other.find(" of ") != std::string::npos;
    const bool same_words = has_of && own.find(' ') != std::string::npos && includes_name(own, other);
    return household.may_mean(category, node.category) || other.ends_with(" " + own) || same_words;
  });
}

/// Whether all that the goal says of a variable is that it is open, closed, empty or switched off, or not covered, in
/// the end: of several, nobody wants just one put right.
bool is_put_right(const Formula& goal, const std::string& variable) {
  std::vector<const Formula*> said;
  bool right = false;
  const auto read = [&](const auto& self, const Formula& formula, bool denied) -> void {
    if (formula.op == Formula::Op::Atom) {
      if (std::none_of(formula.terms.begin(), formula.terms.end(),
                       [&](const Term& term) { return term.name == variable; }))
        return;
      said.push_back(&formula);
      right = denied ? formula.predicate == Predicate::Covered
                     : formula.predicate == Predicate::Open || formula.predicate == Predicate::Closed ||
                           formula.predicate == Predicate::PowerOff || formula.predicate == Predicate::Empty;
    }
    for (const Formula& child : formula.children) self(self, child, denied != (formula.op == Formula::Op::Not));
  };
  read(read, goal, false);
  return said.size() == 1 && right;
}

/// Whether the goal speaks of two categories by names of which one could mean the other.
bool mixes_names(const std::vector<QuantifiedDomain>& domains, const NounTable& nouns) {
  std::set<std::string> categories;
  for (const QuantifiedDomain& one : domains)
    if (one.domain.members.size() == 1) categories.insert(one.domain.members.front().category);
  std::vector<std::string> names;
  for (const std::string& category : categories) names.push_back(spoken_name(category, nouns));
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!names[i].empty() && !names[j].empty() && includes_name(names[i], names[j])) return true;
  return false;
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
           household.is_usual_in(category, type);
  };
  for (const auto& [category, places] : goal_places(goal)) {
    for (const std::string& place : places) {
      const auto& there = home.places.of(place);
      if (there.empty() || home.scene.nodes[there.front()].movable) continue;
      if (std::none_of(there.begin(), there.end(),
                       [&, &category = category](std::size_t node) { return suits(category, node); }))
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
    if (asked.members.empty()) return false;
    if (asked.members.size() == 1 && has_likeness(asked.members.front().category, home, household, nouns)) return true;
    if (asked.members.size() == 1 && has_twin(asked, home, household, nouns)) return true;
    if (!asked.where.empty()) return false;
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
    if (fixed && asked.members.size() == 1 && has_namesake(category, home, household, nouns)) return true;
    if (there.size() < 2) return false;
    if (is_put_right(goal, one.variable)) return true;
    if (!fixed) return asked.members.size() == 1 && household.is_personal(category);
    return std::any_of(there.begin(), there.end(),
                       [&](std::size_t node) { return home.rooms[node] != home.rooms[there.front()]; });
  };
  const auto domains = quantified_domains(goal);
  return mixes_names(domains, nouns) || std::any_of(domains.begin(), domains.end(), is_open);
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
                       const Layout& layout, Grade least, std::optional<Style> style) {
  const Simulator simulator = layout.home.scene.simulator;
  BindingCheck makes_sense = at_least(least, source, resources, simulator);
  if (!configuration.binding.empty()) return makes_sense;
  const Household* household = least == Grade::Senseless ? nullptr : resources.recipe(simulator).household.get();
  return [&source, &layout, &knowledge = resources.backend(simulator).knowledge, household, style,
          makes_sense = std::move(makes_sense)](const Binding& bound, const Parameter& parameter,
                                                const std::string& category) {
    if (layout.home.scene.rooms.size() < 2 && needs_several_rooms(source)) return false;
    if (makes_sense && !makes_sense(bound, parameter, category)) return false;
    if (bound.size() + 1 < source.parameters.size()) return true;
    Binding all = bound;
    all.emplace_back(parameter.name, category);
    // What costs least comes first: the last gates draw starts.
    if (style && !has_words_for(*style, all, knowledge)) return false;
    const auto filled = fill_in(source, knowledge, all);
    const auto* specification = std::get_if<Specification>(&filled);
    if (specification == nullptr || misfit(specification->init, knowledge, layout.offer.now) != nullptr) return false;
    if (household != nullptr && !rooms_suit(specification->goal, layout, *household, knowledge)) return false;
    return !refused_by(*specification, knowledge);
  };
}

}  // namespace unietp
