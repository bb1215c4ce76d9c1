#include "tests/generator/naive_scene.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "tests/generator/naive_draw.h"

namespace unietp {
namespace {

using namespace symbolic;

constexpr int kMany = 1000;
constexpr int kDraws = 200;

std::set<std::string> names_of(const Specification& specification, const Knowledge& knowledge) {
  std::set<std::string> names;
  for (const auto& [placeholder, category] : specification.binding) {
    if (knowledge.find(category) != nullptr) names.insert(category);  // not a color or a material
  }
  for (const auto& name : categories_of(specification.goal)) names.insert(name);
  for (const auto& start : specification.init) {
    for (const auto& name : categories_of(start)) names.insert(name);
  }
  return names;
}

/// Categories of the variables around a formula, by name.
using Ranges = std::map<std::string, std::vector<std::string>>;
/// A category that can be carried, and one beside which the goal wants it.
using Visits = std::vector<std::pair<std::string, std::string>>;

void read_visits(const Formula& formula, Ranges ranges, const Knowledge& knowledge, Visits& visits) {
  if (!formula.variable.empty()) {
    auto& own = ranges[formula.variable];
    own.clear();
    for (const auto& member : formula.domain.members) own.push_back(member.category);
  }
  for (const auto& child : formula.children) read_visits(child, ranges, knowledge, visits);
  if (formula.op != Formula::Op::Atom || formula.predicate != Predicate::NextTo) return;
  for (const auto& [visitor, visited] : {std::pair(0U, 1U), std::pair(1U, 0U)}) {
    for (const auto& one : ranges[formula.terms[visitor].name]) {
      for (const auto& other : ranges[formula.terms[visited].name]) {
        if (knowledge.has(one, "pickupable")) visits.emplace_back(one, other);
      }
    }
  }
}

Visits visits_of(const Specification& specification, const Knowledge& knowledge) {
  Visits visits;
  read_visits(specification.goal, {}, knowledge, visits);
  return visits;
}

/// Furniture on which a category can be put aside.
std::vector<std::string> places_of(const std::string& name, const Knowledge& knowledge) {
  std::vector<std::string> places;
  for (const auto* row : knowledge.placements_of(name, Predicate::On)) {
    const auto* place = knowledge.find(row->receptacle);
    if (place != nullptr && !place->movable && !knowledge.has(row->receptacle, "openable"))
      places.push_back(row->receptacle);
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Furniture on which things can be put aside, and a movable category more.
std::vector<std::string> bystanders(const std::set<std::string>& names, const Visits& visits,
                                    const Knowledge& knowledge, Rng& rng) {
  std::vector<std::string> more;
  const auto is_new = [&](const std::string& name) {
    return names.count(name) == 0 && std::find(more.begin(), more.end(), name) == more.end();
  };
  const auto provide_one_of = [&](std::vector<std::string> places) {
    const bool has_one = std::any_of(places.begin(), places.end(), [&](const auto& place) { return !is_new(place); });
    if (!places.empty() && !has_one) more.push_back(rng.pick(places));
  };
  for (const auto& [visitor, visited] : visits) {  // somewhere to meet
    const auto own = places_of(visitor, knowledge), other = places_of(visited, knowledge);
    std::vector<std::string> both;
    std::set_intersection(own.begin(), own.end(), other.begin(), other.end(), std::back_inserter(both));
    provide_one_of(std::move(both));
  }
  for (const auto& name : names) {
    auto places = places_of(name, knowledge);
    std::erase_if(places, [&](const std::string& place) { return names.count(place) > 0; });
    provide_one_of(std::move(places));
  }
  const auto movables = knowledge.with_affordance("pickupable");
  for (int i = 0; i < 2 && !movables.empty(); ++i) {
    const auto& name = rng.pick(movables);
    if (is_new(name) && !knowledge.placements_of(name, Predicate::On).empty()) more.push_back(name);
  }
  return more;
}

void read_substances(const Formula& formula, Rules& rules, bool& nearest) {
  for (const auto& term : formula.terms) {
    const bool substance = formula.predicate == Predicate::Filled || formula.predicate == Predicate::Covered;
    if (substance && term.kind == Term::Kind::Symbol && term.name != "any") rules.symbol_number(term.name);
  }
  nearest = nearest || (formula.op == Formula::Op::Atom && formula.predicate == Predicate::Nearest);
  for (const auto& where : formula.domain.where) read_substances(where, rules, nearest);
  for (const auto& child : formula.children) read_substances(child, rules, nearest);
}

/// Substances that a formula speaks of as covering something.
void read_coats(const Formula& formula, const Rules& rules, std::vector<SubstanceId>& coats) {
  if (formula.op == Formula::Op::Atom && formula.predicate == Predicate::Covered) {
    if (const auto number = rules.symbol_named(formula.terms[1].name)) coats.push_back(*number);
  }
  for (const auto& child : formula.children) read_coats(child, rules, coats);
}

bool is_about_all(const Formula& formula, const std::string& category) {
  const auto& members = formula.domain.members;
  const bool speaks =
      std::any_of(members.begin(), members.end(), [&](const auto& m) { return m.category == category; });
  return (formula.op == Formula::Op::Forall && speaks) ||
         std::any_of(formula.children.begin(), formula.children.end(),
                     [&](const Formula& child) { return is_about_all(child, category); });
}

/// How many of a category fit into the smallest place that any of them has.
int room_for(const Rules& rules, const std::string& category) {
  int least = kMany;
  for (std::size_t place = 0; place < rules.kinds().size(); ++place) {
    for (const auto relation : {Predicate::On, Predicate::Inside}) {
      const int fits = rules.capacity(*rules.kind_named(category), relation, KindId(place));
      if (fits > 0) least = std::min(least, fits);
    }
  }
  return least;
}

std::vector<std::string> sorted_names(const Specification& specification, const Knowledge& knowledge, Rng& rng,
                                      bool rooms) {
  const auto names = names_of(specification, knowledge);
  std::vector<std::string> found;
  for (const auto& name : names) {
    if ((knowledge.find(name) == nullptr) == rooms) found.push_back(name);
  }
  if (!rooms) {
    for (auto& name : bystanders(names, visits_of(specification, knowledge), knowledge, rng))
      found.push_back(std::move(name));
  }
  return found;
}

void read_atoms(const Formula& formula, std::vector<Formula>& atoms) {
  if (formula.op == Formula::Op::Atom) atoms.push_back(formula);
  for (const auto& child : formula.children) read_atoms(child, atoms);
}

}  // namespace

NaiveScenes::NaiveScenes(const Specification& specification, const Knowledge& knowledge, Rng rng, ActionProfile profile)
    : specification_(specification),
      categories_(sorted_names(specification, knowledge, rng, false)),
      room_types_(sorted_names(specification, knowledge, rng, true)),
      rules_(knowledge, capabilities_of(knowledge.simulator(), profile), categories_) {
  const auto names = names_of(specification, knowledge);
  while (named_ < categories_.size() && names.count(categories_[named_]) > 0) ++named_;
  for (const char* type : kOtherRooms) room_types_.emplace_back(type);
  read_substances(specification.goal, rules_, with_nearest_);
  for (const auto& start : specification.init) read_substances(start, rules_, with_nearest_);
  if (rules_.symbols().empty()) rules_.symbol_number("water");
  read_coats(specification.goal, rules_, coats_);
  for (const auto& [visitor, visited] : visits_of(specification, knowledge)) {
    if (!knowledge.has(visited, "pickupable"))
      visited_.emplace_back(*rules_.kind_named(visitor), *rules_.kind_named(visited));
  }
  for (const auto& start : specification.init) read_coats(start, rules_, coats_);
  for (const auto& start : specification.init) {
    Constraint constraint{&start, {}, {}};
    read_atoms(start, constraint.atoms);
    for (const auto& name : categories_of(start)) {
      if (const auto kind = rules_.kind_named(name)) constraint.kinds.push_back(*kind);
    }
    constraints_.push_back(std::move(constraint));
  }
  for (const auto& category : categories_) {
    int most = 0, different = 0;
    for (const auto& start : specification.init) {
      const bool speaks = start.domain.members.size() == 1 && start.domain.members[0].category == category;
      if (!speaks) continue;
      if (start.op == Formula::Op::Count) most = std::max(most, start.number);
      if (start.op == Formula::Op::Exists) ++different;  // two closed and one open, perhaps
      if (start.op == Formula::Op::Count && start.children.front().op == Formula::Op::Atom) different += start.number;
    }
    demanded_.push_back(most);
    const bool all = is_about_all(specification.goal, category);
    limits_.push_back(all ? std::max(different, room_for(rules_, category)) : kMany);
  }
}

std::optional<NaiveScene> NaiveScenes::draw(Rng rng) const {
  for (int i = 0; i < kDraws; ++i) {
    NaiveDraw draw(*this, rng);
    if (!draw.repair()) continue;
    return draw.take();
  }
  return std::nullopt;
}

}  // namespace unietp
