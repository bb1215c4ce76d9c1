#include "generator/style_fit.h"

#include <algorithm>
#include <initializer_list>

#include "generator/goal_variable.h"
#include "generator/phrase_kind.h"
#include "scene/states.h"
#include "templates/constraint_kinds.h"

namespace unietp {
namespace {

using Op = Formula::Op;

bool any_part(const Formula& goal, const auto& fits) {
  return fits(goal) || std::any_of(goal.children.begin(), goal.children.end(),
                                   [&](const Formula& child) { return any_part(child, fits); });
}

bool asks_for_one_state(const Formula& goal) {
  if (goal.op != Op::Exists || goal.children[0].op != Op::AtEnd) return false;
  const Formula& asked = goal.children[0].children[0];
  return asked.op == Op::Atom && asked.terms.size() == 1;
}

/// What a template speaks of.
struct Matter {
  bool of_one_thing = false;  // of something that stands once in its goal and is no room
  bool of_things = false;     // not of rooms alone
  bool carries_one = false;   // of one thing that can be picked up, and no other
  bool of_any_kind = false;   // of one thing that can be carried, of which people leave open what kind it is
  bool got_ready = false;     // of one thing that can be carried and is brought, washed or switched on
};

/// Whether a goal asks no more of a variable than these.
bool asks_only(const Formula& goal, const std::string& variable, std::initializer_list<Predicate> accepted) {
  const auto asked = predicates_of(goal, variable);
  return std::all_of(asked.begin(), asked.end(), [&](Predicate predicate) {
    return std::find(accepted.begin(), accepted.end(), predicate) != accepted.end();
  });
}

bool has_form_for(Style style, const Formula& goal, const Matter& matter) {
  switch (style) {
    case Style::Alias:  // see may_be_carried
      return matter.of_things;
    case Style::Request:
      return asks_for_one_state(goal);
    case Style::Condition:
      return asks_for_one_state(goal) && opposite_of(goal.children[0].children[0].predicate).has_value();
    case Style::Exception:
      return any_part(goal, [](const Formula& f) { return f.op == Op::Forall && f.children[0].op == Op::AtEnd; });
    case Style::InvertedOrder:
      // "Before you open the microwave, turn it off" does not ask to open it.
      return any_part(goal, [](const Formula& f) { return f.op == Op::Before; }) &&
             !any_part(goal, [](const Formula& f) { return f.op == Op::Atom && f.predicate == Predicate::PowerOff; });
    case Style::VagueQuantity:  // but not where others tell how many
      return any_part(goal,
                      [](const Formula& f) {
                        return f.op == Op::Count && f.comparison == Comparison::AtLeast &&
                               (f.number == 2 || f.number == 3);
                      }) &&
             !any_part(goal, [](const Formula& f) { return f.op == Op::CountCompare; });
    case Style::Function:
    case Style::Hypernym:
      return matter.of_any_kind;
    case Style::Ellipsis:
    case Style::Anaphora:
    case Style::Compound:
      return matter.of_one_thing;
    case Style::Context:  // "I want to wash my hands" has nothing to do with what else is brought
      return matter.got_ready && matter.carries_one;
    default:
      // Only templates that are written so. Asides ("the egg can stay where it is") seem to come from nowhere, people
      // do not tell a thing by where it is not, and descriptions ("where the trash goes") read like riddles.
      return false;
  }
}

/// Only what can be carried is called by another name (refine_linguistic).
bool may_be_carried(const Parameter& parameter) {
  return !is_room(parameter) && !is_value(parameter) && !asks_for(parameter, ParameterWord::Furniture);
}

}  // namespace

std::vector<Style> styles_fitting(const Template& source) {
  if (!source.refinement.empty()) {
    const auto own = style_named(source.refinement);
    return own ? std::vector<Style>{*own} : std::vector<Style>();
  }
  const auto single = singular_variables(source.goal);
  Matter matter;
  matter.of_one_thing = std::any_of(single.begin(), single.end(), [&](const GoalVariable& variable) {
    return std::none_of(source.parameters.begin(), source.parameters.end(), [&](const Parameter& parameter) {
      return parameter.name == variable.category && is_room(parameter);
    });
  });
  // What refine_by_phrase.cpp needs of a variable, as far as the template tells.
  for (const GoalVariable& variable : single) {
    if (std::none_of(source.parameters.begin(), source.parameters.end(), [&](const Parameter& parameter) {
          return parameter.name == variable.category && may_be_carried(parameter);
        }))
      continue;
    using enum Predicate;
    matter.of_any_kind |= asks_only(source.goal, variable.variable, {Held, On, InRoom, Inside, Filled});
    matter.got_ready |= asks_only(source.goal, variable.variable, {Held, On, InRoom, Inside, OnFloor, Clean, PowerOn});
  }
  matter.of_things = !std::all_of(source.parameters.begin(), source.parameters.end(), is_room);
  const bool carries = std::any_of(source.parameters.begin(), source.parameters.end(), may_be_carried);
  const auto picked_up = [](const Parameter& parameter) {
    const auto& all = parameter.affordances;
    return std::find(all.begin(), all.end(), "pickupable") != all.end();
  };
  matter.carries_one = std::count_if(source.parameters.begin(), source.parameters.end(), picked_up) == 1;
  std::vector<Style> fitting;
  for (std::size_t i = 0; i < kStyleCount; ++i) {
    const auto style = static_cast<Style>(i);
    if (has_form_for(style, source.goal, matter) && (style != Style::Alias || carries)) fitting.push_back(style);
  }
  return fitting;
}

bool has_words_for(Style style, const Binding& binding, const Knowledge& knowledge) {
  if (style != Style::Alias && !names_by_phrase(style)) return true;
  const AliasKind kind = style == Style::Alias ? AliasKind::Synonym : phrases_of(style);
  return std::any_of(binding.begin(), binding.end(),
                     [&](const auto& bound) { return !knowledge.aliases_of(bound.second, kind).empty(); });
}

}  // namespace unietp
