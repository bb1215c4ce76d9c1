#include <algorithm>

#include "generator/consistency.h"
#include "generator/goal_variable.h"
#include "generator/reference.h"
#include "generator/refinement.h"
#include "templates/init_shape.h"
#include "templates/refinement_kinds.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr int kMostReferences = 24;

std::vector<Formula> tests_of(const std::vector<Reference>& references) {
  std::vector<Formula> tests;
  for (const auto& reference : references) tests.push_back(reference.test);
  return tests;
}

/// How many objects the reference is to pick out: one for "a mug", two for "both mugs" and "two mugs": nobody asks for
/// two dirty mugs of three.
struct Wanted {
  Comparison comparison = Comparison::Equal;
  int number = 1;
};

Wanted wanted_for(const GoalVariable& variable, const Specification& plain, Rng& rng) {
  if (variable.quantifier == Op::Exists) return {};
  if (variable.quantifier == Op::Count) return {Comparison::Equal, variable.number};
  int least = 2;
  for (const auto& start : plain.init) {
    if (concerns(start, variable.category)) least = std::max(least, demanded_count(start));
  }
  return {least == 2 && rng.chance(0.5) ? Comparison::Equal : Comparison::AtLeast, least};
}

std::optional<Specification> refined_by(const Specification& plain, const Knowledge& knowledge,
                                        const GoalVariable& variable, const std::vector<Reference>& references,
                                        Referring kind, const Wanted& wanted) {
  auto refined = plain;
  auto domain = of_category(variable.category);
  domain.where = {conjunction(tests_of(references))};
  refined.goal = with_domain(plain.goal, variable, domain);
  refined.split = Split::InstanceGrounding;
  refined.refinement = kind;
  const auto tests = tests_of(references);
  if (!demand_referents(refined, variable, tests, wanted.comparison, wanted.number)) return std::nullopt;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    // Each test excludes something that passes the others: without it the words would pick out more.
    auto others = tests;
    others[i] = negation(others[i]);
    refined.init.push_back(counted(variable, Comparison::AtLeast, 1, conjunction(std::move(others))));
  }
  for (const auto& reference : references) {
    for (const auto& start : reference.start) {
      if (std::find(refined.init.begin(), refined.init.end(), start) == refined.init.end())
        refined.init.push_back(start);
    }
  }
  if (contradiction(refined, knowledge) || bad_start(refined, knowledge, kStartsDrawn)) return std::nullopt;
  return refined;
}

const std::vector<Referring>& single_kinds() {
  static const std::vector<Referring> kKinds = {Referring::ByState,    Referring::ByRelation, Referring::ByRoom,
                                                Referring::ByNearness, Referring::BySize,     Referring::ByAttribute};
  return kKinds;
}

/// Only these say of several objects which are meant: one alone is the nearest or the largest.
bool picks_several(Referring kind) { return kind != Referring::ByNearness && kind != Referring::BySize; }

class Refiner {
 public:
  Refiner(const Specification& plain, const Knowledge& knowledge, const SceneOffer& offer, Rng rng)
      : plain_(plain), knowledge_(knowledge), offer_(offer), rng_(rng) {
    variables_ = singular_variables(plain.goal);
    for (auto& variable : counted_variables(plain.goal)) variables_.push_back(std::move(variable));
    rng_.shuffle(variables_);
    // Movable objects first: a scene can be given one more of them as distractor, seldom one more fridge.
    std::stable_partition(variables_.begin(), variables_.end(),
                          [&](const GoalVariable& variable) { return is_movable(variable); });
  }

  std::optional<Specification> refined(Referring kind) {
    if (kind == Referring::EachItsOwn) return refine_each_its_own(plain_, knowledge_, offer_, rng_.fork("each", 0));
    for (const auto& variable : variables_) {
      if (auto found = kind == Referring::ByTwo ? by_two(variable) : by_one(variable, kind)) return found;
    }
    return std::nullopt;
  }

 private:
  bool is_movable(const GoalVariable& variable) const {
    const auto* category = knowledge_.find(variable.category);
    return category != nullptr && category->movable;
  }

  std::vector<Reference> offered(const GoalVariable& variable, Referring kind) const {
    if (variable.quantifier != Op::Exists && !picks_several(kind)) return {};
    auto found = references(kind, variable, plain_, knowledge_, offer_, rng_.fork(name_of(kind), 0));
    if (variable.quantifier == Op::Exists || is_movable(variable) || offer_.now.states.empty()) return found;
    // Of what cannot be moved the home must have enough already.
    std::erase_if(found, [&](const Reference& one) {
      const bool of_body = one.kind == Referring::ByState || one.kind == Referring::ByAttribute;
      return !of_body && picked_by(one.test, variable, offer_).in < std::max(2, variable.number);
    });
    return found;
  }

  bool spent() { return ++tried_ > kMostReferences; }

  std::optional<Specification> by_one(const GoalVariable& variable, Referring kind) {
    for (const auto& reference : offered(variable, kind)) {
      if (spent()) break;
      if (auto found = refined_by(plain_, knowledge_, variable, {reference}, kind, wanted_for(variable, plain_, rng_)))
        return found;
    }
    return std::nullopt;
  }

  /// Of different kinds; only for what can be moved, since the start needs three of them.
  std::optional<Specification> by_two(const GoalVariable& variable) {
    if (!is_movable(variable) || variable.quantifier != Op::Exists) return std::nullopt;
    auto kinds = single_kinds();
    std::erase_if(kinds, [](Referring kind) { return !picks_several(kind); });
    rng_.shuffle(kinds);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto first = offered(variable, kinds[i]), second = offered(variable, kinds[j]);
        if (first.empty() || second.empty() || places(kinds[i]) + places(kinds[j]) > 1) continue;
        if (spent()) return std::nullopt;
        // A state or attribute comes before a place: "the dirty mug on the desk".
        const bool turned = places(kinds[i]) > 0;
        const std::vector<Reference> both{turned ? second.front() : first.front(),
                                          turned ? first.front() : second.front()};
        if (auto found = refined_by(plain_, knowledge_, variable, both, Referring::ByTwo, {})) return found;
      }
    }
    return std::nullopt;
  }

  static int places(Referring kind) { return kind == Referring::ByRelation || kind == Referring::ByRoom ? 1 : 0; }

  const Specification& plain_;
  const Knowledge& knowledge_;
  const SceneOffer& offer_;
  Rng rng_;
  std::vector<GoalVariable> variables_;
  int tried_ = 0;
};

}  // namespace

Formula counted(const GoalVariable& variable, Comparison comparison, int number, Formula body) {
  Formula count;
  count.op = Op::Count;
  count.comparison = comparison;
  count.number = number;
  count.variable = variable.variable;
  count.domain = of_category(variable.category);
  count.children = {std::move(body)};
  return count;
}

bool demand_referents(Specification& refined, const GoalVariable& variable, const std::vector<Formula>& tests,
                      Comparison comparison, int number) {
  std::vector<Formula> kept;
  for (auto& start : refined.init) {
    if (start.domain != of_category(variable.category) || demanded_count(start) < 1) {
      kept.push_back(std::move(start));
      continue;
    }
    const auto literals = start_literals(start).size();
    const bool exactly = start.op == Op::Count && start.comparison == Comparison::Equal;
    // What says that there are no more leaves no room for a distractor.
    if (exactly && literals == 0 && start.number <= number) return false;
    if (!exactly && literals == 0 && demanded_count(start) <= number + 1) continue;  // implied by what follows
    if (!exactly && literals > 0) {  // what the task is about is what is referred to
      std::vector<Formula> body = tests;
      for (auto& test : body) test = rename_variable(test, variable.variable, start.variable);
      const auto own = start.children.front();
      body.insert(body.begin(), own.op == Op::And ? own.children.begin() : start.children.begin(),
                  own.op == Op::And ? own.children.end() : start.children.end());
      start.children = {conjunction(std::move(body))};
    }
    kept.push_back(std::move(start));
  }
  kept.push_back(counted(variable, comparison, number, conjunction(tests)));
  refined.init = std::move(kept);
  return true;
}

std::optional<Specification> refine_referring(const Specification& plain, const Knowledge& knowledge,
                                              const SceneOffer& offer, std::string_view kind, Rng rng) {
  const auto asked = referring_named(kind);
  if (!asked || plain.refinement != Referring::None || plain.split == Split::Linguistic) return std::nullopt;
  std::vector<Referring> kinds = single_kinds();
  kinds.push_back(Referring::ByTwo);
  kinds.push_back(Referring::EachItsOwn);
  if (*asked != Referring::None) kinds = {*asked};
  rng.shuffle(kinds);
  for (const auto one : kinds) {
    if (auto refined = Refiner(plain, knowledge, offer, rng.fork(name_of(one), 0)).refined(one)) return refined;
  }
  return std::nullopt;
}

}  // namespace unietp
