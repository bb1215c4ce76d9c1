#include "generator/consistency.h"

#include <algorithm>
#include <climits>
#include <map>

#include "generator/domain_constraints.h"
#include "generator/goal_parts.h"
#include "scene/states.h"
#include "symbolic/perform.h"
#include "templates/init_shape.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr char kMark = '#';  // between a variable and the number of its quantifier

/// A formula as the goal has it, without the numbers of renamed variables.
std::string text_of(const Formula& formula) {
  std::string text;
  bool number = false;
  for (const char c : to_text(formula)) {
    number = c == kMark || (number && c >= '0' && c <= '9');
    if (!number) text += c;
  }
  return text;
}

bool is_place(const Formula& literal) {
  return literal.op == Op::Atom && (literal.predicate == Predicate::On || literal.predicate == Predicate::Inside);
}

/// A literal that must hold in the end, with what is known of its variables. Those are renamed so that equal names mean
/// equal objects: two `forall` over one domain speak of the same ones, two `exists` may not.
struct Demand {
  Formula literal;
  int count = 1;                          // how many objects must satisfy it with the same second argument
  std::map<std::string, Domain> domains;  // of the variables in scope
};

class GoalReader {
 public:
  GoalReader(const Specification& specification, const Knowledge& knowledge)
      : specification_(specification), knowledge_(knowledge) {}

  std::optional<GateRefusal> contradiction() {
    collect(specification_.goal, false, 1);
    for (std::size_t i = 0; i < demands_.size(); ++i) {
      if (auto problem = impossible_alone(demands_[i])) return problem;
      for (std::size_t j = 0; j < i; ++j) {
        if (auto problem = impossible_together(demands_[j], demands_[i])) return problem;
      }
    }
    return impossible_counts_;
  }

 private:
  void collect(const Formula& formula, bool at_the_end, int count) {
    switch (formula.op) {
      case Op::And:
        for (const auto& child : formula.children) collect(child, at_the_end, count);
        break;
      case Op::AtEnd:
        collect(formula.children.front(), true, count);
        break;
      case Op::Exists:
        collect(body_of(formula, new_name(formula.variable)), at_the_end, count);
        break;
      case Op::Forall: {
        const auto domain = to_text(normal_form(forall(formula.variable, formula.domain, Formula{})));
        const auto& name = all_of_.emplace(domain, new_name(formula.variable)).first->second;
        collect(body_of(formula, name), at_the_end, std::max(count, least_number(formula.domain)));
        break;
      }
      case Op::Count:
        collect_count(formula, at_the_end);
        break;
      case Op::Atom:
      case Op::Not:
        if (at_the_end) demands_.push_back({formula, count, domains_});
        break;
      default:
        break;
    }
  }

  std::string new_name(const std::string& variable) { return variable + kMark + std::to_string(++scopes_); }

  /// The body of a quantifier with its variable renamed.
  Formula body_of(const Formula& quantifier, const std::string& name) {
    domains_[name] = quantifier.domain;
    return rename_variable(quantifier.children.front(), quantifier.variable, name);
  }

  void collect_count(const Formula& formula, bool at_the_end) {
    if (!at_the_end) return;
    int low = 0;
    int high = INT_MAX;
    const int n = formula.number;
    if (formula.comparison == Comparison::Equal) low = high = n;
    if (formula.comparison == Comparison::AtLeast) low = n;
    if (formula.comparison == Comparison::Greater) low = n + 1;
    if (formula.comparison == Comparison::AtMost) high = n;
    if (formula.comparison == Comparison::Less) high = n - 1;
    const auto key = to_text(normal_form(exists(formula.variable, formula.domain, formula.children.front())));
    auto [bounds, added] = bounds_.emplace(key, std::pair(low, high));
    bounds->second.first = std::max(bounds->second.first, low);
    bounds->second.second = std::min(bounds->second.second, high);
    if (bounds->second.first > bounds->second.second) {
      impossible_counts_ = GateRefusal{Gate::Counts, text_of(formula),
                                       "the goal asks for two different numbers of the same thing: " + text_of(formula),
                                       "counts in the template's goal that agree"};
    }
    if (low >= 1) collect(body_of(formula, new_name(formula.variable)), at_the_end, low);
  }

  /// How many objects of a domain every start has.
  int least_number(const Domain& domain) const {
    int least = 1;
    for (const auto& start : specification_.init) {
      if (start.domain == domain) least = std::max(least, demanded_count(start));
    }
    return least;
  }

  std::vector<std::string> categories(const Demand& demand, const Term& term) const {
    std::vector<std::string> names;
    const auto found = demand.domains.find(term.name);
    if (term.kind != Term::Kind::Variable || found == demand.domains.end()) return names;
    for (const auto& member : found->second.members) {
      if (!member.slice) {
        names.push_back(member.category);
      } else {
        for (auto& piece : slices_of(member.category, knowledge_)) names.push_back(std::move(piece));
      }
    }
    return names;
  }

  std::optional<GateRefusal> impossible_alone(const Demand& demand) const {
    if (is_place(demand.literal)) return no_room(demand);
    if (demand.literal.op != Op::Atom || demand.literal.terms.empty()) return std::nullopt;
    for (const auto& group : state_groups()) {
      if (std::find(group.predicates.begin(), group.predicates.end(), demand.literal.predicate) ==
          group.predicates.end())
        continue;
      const auto names = categories(demand, demand.literal.terms[0]);
      const bool possible = names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                              return knowledge_.has(name, group.affordance);  // a room has no states
                            });
      if (possible) return std::nullopt;
      const auto text = text_of(demand.literal);
      return GateRefusal{Gate::StateOfCategory, text,
                         "the goal asks for " + text + ", but " + names.front() + " is not " + group.affordance,
                         "a category that is " + group.affordance + ", or an override that makes " + names.front() +
                             " " + group.affordance};
    }
    return std::nullopt;
  }

  std::optional<GateRefusal> no_room(const Demand& demand) const {
    const auto objects = categories(demand, demand.literal.terms[0]);
    const auto places = categories(demand, demand.literal.terms[1]);
    if (objects.empty() || places.empty()) return std::nullopt;
    const Predicate relation = demand.literal.predicate;
    int best = 0;
    for (const auto& object : objects) {
      for (const auto& place : places) {
        const auto* row = knowledge_.placement(object, relation, place);
        if (row != nullptr) best = std::max(best, row->capacity);
      }
    }
    if (best >= demand.count) return std::nullopt;
    const auto what = objects.front() + " " + std::string(info(relation).name) + " " + places.front();
    const auto text = text_of(demand.literal);
    if (best == 0) {
      return GateRefusal{Gate::Capacity, text,
                         "the goal asks for " + what + ", which the knowledge base does not allow",
                         "another place, or a placement " + what + " in the knowledge base"};
    }
    return GateRefusal{Gate::Capacity, text,
                       "the goal asks for " + std::to_string(demand.count) + " " + what + ", but at most " +
                           std::to_string(best) + " fit",
                       "a place where " + std::to_string(demand.count) + " fit, or a constraint (fits-" +
                           std::string(info(relation).name) + " ... " + std::to_string(demand.count) +
                           ") in the template"};
  }

  bool is_furniture(const Demand& demand, const Term& term) const {
    const auto names = categories(demand, term);
    return !names.empty() && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
      const auto* category = knowledge_.find(name);
      return category != nullptr && !category->movable;
    });
  }

  /// Whether the places of two literals may be one and the same object.
  bool may_be_equal(const Demand& one, const Demand& other) const {
    const auto names = categories(one, one.literal.terms[1]);
    const auto others = categories(other, other.literal.terms[1]);
    if (names.empty() || others.empty()) return true;
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return std::find(others.begin(), others.end(), name) != others.end();
    });
  }

  std::optional<GateRefusal> impossible_together(const Demand& one, const Demand& other) const {
    const auto& first = one.literal;
    const auto& second = other.literal;
    const auto both = text_of(first) + " and " + text_of(second);
    if (exclude_each_other(first, second)) {
      return GateRefusal{Gate::ExclusiveStates, both, "the goal asks for exclusive states: " + both,
                         "a goal that asks for one of them, or for both of different objects or at different times"};
    }
    if ((first.op == Op::Not && first.children.front() == second) ||
        (second.op == Op::Not && second.children.front() == first)) {
      return GateRefusal{Gate::ExclusiveStates, both, "the goal asks for a thing and its opposite: " + both,
                         "a goal that asks for one of them"};
    }
    if (auto problem = undone_there(one, other)) return problem;
    if (auto problem = undone_there(other, one)) return problem;
    if (!is_place(first) || !is_place(second) || !(first.terms[0] == second.terms[0])) return std::nullopt;
    const bool same_place = first.terms[1] == second.terms[1];
    if (same_place ? first.predicate == second.predicate : may_be_equal(one, other)) return std::nullopt;
    const bool fixed = is_furniture(one, first.terms[1]) && is_furniture(other, second.terms[1]);
    const bool on_both = first.predicate == Predicate::On && second.predicate == Predicate::On;
    if (!same_place && !fixed && !on_both) return std::nullopt;
    return GateRefusal{Gate::OnePlace, both, "the goal asks for one object in two places: " + both,
                       "a goal that asks for one of them, or for two objects"};
  }

  /// A hot thing inside a freezer: what the place does by itself, without power and open or not, ends the state.
  std::optional<GateRefusal> undone_there(const Demand& state, const Demand& place) const {
    if (!is_place(place.literal) || state.literal.op != Op::Atom || state.literal.terms.empty()) return std::nullopt;
    if (!(place.literal.terms[0] == state.literal.terms[0])) return std::nullopt;
    const auto objects = categories(place, place.literal.terms[0]);
    const auto places = categories(place, place.literal.terms[1]);
    if (objects.empty() || places.empty()) return std::nullopt;
    for (const auto& object : objects) {
      for (const auto& tool : places) {
        if (!ends_by_itself(state.literal.predicate, object, place.literal.predicate, tool)) return std::nullopt;
      }
    }
    const auto both = text_of(state.literal) + " and " + text_of(place.literal);
    return GateRefusal{Gate::ExclusiveStates, both,
                       objects.front() + " " + std::string(info(place.literal.predicate).name) + " " + places.front() +
                           " does not stay " + std::string(info(state.literal.predicate).name),
                       "another place, or a constraint in the template that keeps such places out"};
  }

  bool ends_by_itself(Predicate state, const std::string& object, Predicate relation, const std::string& tool) const {
    const std::vector by_itself{relation == Predicate::On ? EffectNeed::On : EffectNeed::Inside};
    for (const TreatmentInfo& treatment : all_treatments()) {
      const auto rows = knowledge_.effects_on(object, treatment.treatment);
      const auto row =
          std::find_if(rows.begin(), rows.end(), [&](const Effect* effect) { return effect->tool == tool; });
      if (row == rows.end() || (*row)->needs != by_itself) continue;
      for (const Predicate set : treatment.states) {
        if (exclude_each_other(atom(state, {"x"}), atom(set, {"x"}))) return true;
      }
    }
    return false;
  }

  const Specification& specification_;
  const Knowledge& knowledge_;
  std::map<std::string, Domain> domains_;      // of the variables met so far
  std::map<std::string, std::string> all_of_;  // domain of a `forall` -> name of its variable
  int scopes_ = 0;
  std::vector<Demand> demands_;
  std::map<std::string, std::pair<int, int>> bounds_;  // counted thing -> least and most
  std::optional<GateRefusal> impossible_counts_;
};

}  // namespace

std::optional<GateRefusal> contradiction(const Specification& specification, const Knowledge& knowledge) {
  return GoalReader(specification, knowledge).contradiction();
}

}  // namespace unietp
