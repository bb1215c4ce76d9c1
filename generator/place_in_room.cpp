#include "generator/place_in_room.h"

#include <algorithm>
#include <utility>

#include "generator/goal_variable.h"
#include "generator/reference.h"
#include "generator/refinement.h"

namespace unietp {
namespace {

using Op = Formula::Op;

bool is_furniture(const GoalVariable& variable, const Knowledge& knowledge) {
  const auto* category = knowledge.find(variable.category);
  return category != nullptr && !category->movable && category->countable;
}

/// Whether references that the generator added may be rooms themselves.
bool refers_by_room(Referring kind) {
  return kind == Referring::ByRoom || kind == Referring::ByTwo || kind == Referring::EachItsOwn;
}

/// The type of room of "(exists (?p - kitchen) (in_room ?b ?p))"; "" for another test.
std::string room_of(const Formula& test, const std::string& variable) {
  if (test.op != Op::Exists || test.domain.members.size() != 1 || !test.domain.where.empty()) return "";
  const Formula& fact = test.children.front();
  const bool in_it = fact.op == Op::Atom && fact.predicate == Predicate::InRoom &&
                     fact == atom(Predicate::InRoom, {variable, test.variable});
  return in_it ? test.domain.members.front().category : "";
}

/// The start with only those pieces of a category covered with something that are in the room, where all were: nobody
/// has two tables covered with sauce.
void cover_only_there(std::vector<Formula>& init, const GoalVariable& variable, const Formula& test) {
  for (Formula& start : init) {
    if (start.op != Op::Forall || start.variable != variable.variable || start.domain != of_category(variable.category))
      continue;
    const Formula fact = start.children.front();
    if (fact.op != Op::Atom || fact.predicate != Predicate::Covered) continue;
    Formula there_only;  // a start is one state, whose domains have no descriptions
    there_only.op = Op::Or;
    there_only.children = {negation(test), fact};
    start.children = {there_only};
  }
}

const Domain* domain_of(const Formula& formula, const std::string& variable) {
  if (formula.op == Op::Exists && formula.variable == variable) return &formula.domain;
  for (const Formula& child : formula.children)
    if (const Domain* found = domain_of(child, variable)) return found;
  return nullptr;
}

}  // namespace

std::optional<Specification> with_place_in_room(const Specification& plain, const PlaceInRoom& place) {
  for (const GoalVariable& variable : singular_variables(plain.goal)) {
    if (variable.variable != place.variable) continue;
    Specification named = plain;
    Domain domain = of_category(variable.category);
    domain.where = {place.test};
    named.goal = with_domain(plain.goal, variable, domain);
    cover_only_there(named.init, variable, place.test);
    if (!demand_referents(named, variable, {place.test}, Comparison::AtLeast, 1)) return std::nullopt;
    const GoalVariable room{place.test.variable, place.test.domain.members.front().category, Op::Exists, 1};
    const Formula one = counted(room, Comparison::Equal, 1, Formula{});
    if (std::find(named.init.begin(), named.init.end(), one) == named.init.end()) named.init.push_back(one);
    return named;
  }
  return std::nullopt;
}

std::vector<PlaceInRoom> places_in_rooms(const Formula& goal, Referring refinement, const Formula& plain,
                                         const Knowledge& knowledge) {
  std::vector<PlaceInRoom> places;
  if (refers_by_room(refinement)) return places;
  for (const GoalVariable& variable : singular_variables(plain)) {
    if (!is_furniture(variable, knowledge)) continue;
    const Domain* domain = domain_of(goal, variable.variable);
    if (domain == nullptr || domain->where.size() != 1) continue;
    if (room_of(domain->where.front(), variable.variable).empty()) continue;
    places.push_back({variable.variable, domain->where.front()});
  }
  return places;
}

Specification with_places_in_rooms(const Specification& plain, const Knowledge& knowledge, const SceneOffer& offer,
                                   const RoomSuits& suits, const Rng& rng) {
  Specification named = plain;
  if (refers_by_room(plain.refinement) || offer.now.states.empty()) return named;
  for (const GoalVariable& variable : singular_variables(plain.goal)) {
    if (!is_furniture(variable, knowledge) || number_of(offer, variable.category) < 2) continue;
    std::vector<PlaceInRoom> alone, among_others;
    for (const Reference& one :
         references_to_others(Referring::ByRoom, variable, named, knowledge, offer, rng.fork(variable.variable, 0))) {
      const Picked picked = picked_by(one.test, variable, offer);
      if (picked.in == 0 || picked.out == 0 || !suits(variable.category, room_of(one.test, variable.variable)))
        continue;
      (picked.in == 1 ? alone : among_others).push_back({variable.variable, one.test});
    }
    const auto& choices = alone.empty() ? among_others : alone;
    if (choices.empty()) continue;
    const auto drawn = rng.fork(variable.variable, 1).below(choices.size());
    if (auto found = with_place_in_room(named, choices[drawn])) named = *std::move(found);
  }
  return named;
}

}  // namespace unietp
