#include "generator/reference.h"

#include <algorithm>

#include "akb/attributes.h"
#include "scene/states.h"
#include "templates/init_shape.h"

namespace unietp {
namespace {

bool in_group(const StateGroup& group, Predicate predicate) {
  return std::find(group.predicates.begin(), group.predicates.end(), predicate) != group.predicates.end();
}

/// A group of states is free when neither the goal nor the start speaks of it for this category.
bool is_free(const StateGroup& group, const GoalVariable& variable, const Specification& plain) {
  for (const auto predicate : predicates_of(plain.goal, variable.variable)) {
    if (in_group(group, predicate)) return false;
  }
  return std::none_of(plain.init.begin(), plain.init.end(), [&](const Formula& start) {
    if (!concerns(start, variable.category)) return false;
    const auto literals = start_literals(start);
    return std::any_of(literals.begin(), literals.end(),
                       [&](const StartLiteral& l) { return in_group(group, l.predicate); });
  });
}

/// Whether one sees, and says, that such a thing is on: not of what may be shut and is carried about: a laptop that is
/// on looks like any other when all are shut.
bool is_seen_running(const Category& category, const Knowledge& knowledge) {
  return has_trait(category, KindTrait::SeenRunning) && !(category.movable && knowledge.has(category.name, "openable"));
}

/// Whether the goal puts something on what a variable stands for.
bool is_set_down_on(const Formula& goal, const std::string& variable) {
  const bool here = goal.op == Formula::Op::Atom && goal.predicate == Predicate::On && goal.terms.size() == 2 &&
                    goal.terms[1].name == variable;
  return here || std::any_of(goal.children.begin(), goal.children.end(),
                             [&](const Formula& child) { return is_set_down_on(child, variable); });
}

/// Whether people tell a thing from others by its being open or closed; furniture that something is set down on may be
/// either.
bool is_told_by_opening(const Category& category, const GoalVariable& variable, const Specification& plain) {
  return !has_trait(category, KindTrait::NotByOpening) &&
         !(is_set_down_on(plain.goal, variable.variable) && !category.movable);
}

std::vector<Reference> by_state(const GoalVariable& variable, const Specification& plain, const Knowledge& knowledge) {
  std::vector<Reference> found;
  const auto* category = knowledge.find(variable.category);
  for (const auto& group : state_groups()) {
    if (!knowledge.has(variable.category, group.affordance) || !is_free(group, variable, plain)) continue;
    for (const PredicateInfo& state : all_predicates()) {
      if (!state.telling || !in_group(group, state.predicate) || !shows(plain.simulator, state.predicate)) continue;
      if (state.predicate == Predicate::PowerOn && category != nullptr && !category->kinds.empty() &&
          !is_seen_running(*category, knowledge))
        continue;
      if ((state.predicate == Predicate::Open || state.predicate == Predicate::Closed) && category != nullptr &&
          !is_told_by_opening(*category, variable, plain))
        continue;
      // "The tomato in the fridge", not "the cold tomato".
      if (state.predicate == Predicate::Hot || state.predicate == Predicate::Cool) continue;
      const bool cooking = state.predicate == Predicate::Cooked || state.predicate == Predicate::Raw ||
                           state.predicate == Predicate::Burnt;
      if (cooking && category != nullptr && !category->kinds.empty() && !has_trait(*category, KindTrait::RawOrCooked))
        continue;
      found.push_back({Referring::ByState, atom(state.predicate, {variable.variable}), {}});
    }
  }
  return found;
}

std::vector<Reference> by_size(const GoalVariable& variable, const Knowledge& knowledge) {
  const auto* category = knowledge.find(variable.category);
  std::vector<Reference> found;
  if (category == nullptr || !category->countable || !comes_in_sizes(*category, knowledge)) return found;
  if (has_trait(*category, KindTrait::NotBySize)) return found;
  for (const char* size : {"large", "small"}) {
    found.push_back({Referring::BySize, atom_with_symbol(Predicate::Size, variable.variable, size), {}});
  }
  return found;
}

/// A color is said of objects that all have one, and none of which has one that could be taken for it.
void add_values(const GoalVariable& variable, Predicate predicate, const std::vector<std::string>& values,
                std::vector<Reference>& found) {
  const auto of_all = [&](Formula body) {
    return forall(variable.variable, of_category(variable.category), std::move(body));
  };
  for (const auto& value : values) {
    const bool another =
        std::any_of(values.begin(), values.end(), [&](const auto& other) { return distinguishable(value, other); });
    if (!another) continue;
    Reference reference{Referring::ByAttribute, atom_with_symbol(predicate, variable.variable, value), {}};
    reference.start.push_back(of_all(atom_with_symbol(predicate, variable.variable, "any")));
    for (const auto& other : values) {
      if (other == value || distinguishable(value, other)) continue;
      reference.start.push_back(of_all(negation(atom_with_symbol(predicate, variable.variable, other))));
    }
    found.push_back(std::move(reference));
  }
}

std::vector<Reference> by_attribute(const GoalVariable& variable, const Knowledge& knowledge) {
  std::vector<Reference> found;
  const auto* category = knowledge.find(variable.category);
  if (category == nullptr || has_trait(*category, KindTrait::ToldByRoom)) return found;
  add_values(variable, Predicate::Color, category->colors, found);
  add_values(variable, Predicate::Material, category->materials, found);
  return found;
}

}  // namespace

bool concerns(const Formula& start, const std::string& category) {
  return std::any_of(start.domain.members.begin(), start.domain.members.end(),
                     [&](const Domain::Member& member) { return !member.slice && member.category == category; });
}

Picked picked_by(const Formula& test, const GoalVariable& variable, const SceneOffer& offer) {
  auto domain = of_category(variable.category);
  const int all = number_in(offer, domain, variable.variable);
  domain.where = {test};
  const int in = number_in(offer, domain, variable.variable);
  return {in, all - in};
}

std::vector<Reference> references(Referring kind, const GoalVariable& variable, const Specification& plain,
                                  const Knowledge& knowledge, const SceneOffer& offer, Rng rng) {
  std::vector<Reference> found;
  if (kind == Referring::ByState) {
    found = by_state(variable, plain, knowledge);
  } else if (kind == Referring::BySize) {
    found = by_size(variable, knowledge);
  } else if (kind == Referring::ByAttribute) {
    found = by_attribute(variable, knowledge);
  } else {
    found = references_to_others(kind, variable, plain, knowledge, offer, rng.fork("others", 0));
  }
  const auto* category = knowledge.find(variable.category);
  const bool fixed = category == nullptr || !category->movable;
  const bool known = !offer.now.states.empty();
  // What stands where it stands: there is no giving it another place or size.
  if (fixed && known) {
    const bool of_body = kind == Referring::ByState || kind == Referring::ByAttribute;
    std::erase_if(found, [&](const Reference& reference) {
      const auto picked = picked_by(reference.test, variable, offer);
      if (of_body) return picked.in + picked.out < 2;
      // "The kitchen cabinet" is said where the kitchen has one.
      return picked.out == 0 || (variable.quantifier == Formula::Op::Exists ? picked.in != 1 : picked.in == 0);
    });
  } else if (fixed) {
    if (kind != Referring::ByState && kind != Referring::ByAttribute) found.clear();
  }
  rng.shuffle(found);
  return found;
}

}  // namespace unietp
