#include "authoring/purpose_fit.h"

#include <algorithm>
#include <optional>

#include "core/text.h"
#include "sense/wants.h"
#include "templates/init_shape.h"
#include "templates/purpose_reading.h"
#include "templates/purposes.h"

namespace unietp {
namespace {

using Op = Formula::Op;

std::string words_of(const PurposeSign& sign) {
  return (sign.negated ? "not " : "") + replace_all(std::string(info(sign.predicate).name), "_", " ");
}

/// The goal without what need not hold at its end.
Formula at_the_end(const Formula& part) {
  Formula kept = part;
  if (part.op == Op::AtEnd) return kept;
  if (part.op == Op::Before || part.op == Op::Until || part.op == Op::Sometime || part.op == Op::Always) {
    kept.op = Op::And;
    kept.children.clear();
    return kept;
  }
  for (Formula& child : kept.children) child = at_the_end(child);
  return kept;
}

std::optional<std::string> only_category(const Domain& domain) {
  const bool one = domain.kind == Domain::Kind::Categories && domain.members.size() == 1 && !domain.members[0].slice;
  return one ? std::optional(domain.members[0].category) : std::nullopt;
}

/// Whether the start says of all objects of the want's category what is wanted of one.
bool holds_at_start(const Want& want, const Wants& wants, const std::vector<Formula>& init) {
  const auto category = only_category(wants.things[want.thing]);
  if (!category || want.other || !wants.things[want.thing].where.empty()) return false;
  return std::any_of(init.begin(), init.end(), [&](const Formula& start) {
    if (start.op != Op::Forall || only_category(start.domain) != category) return false;
    const auto literals = start_literals(start);
    return std::any_of(literals.begin(), literals.end(), [&](const StartLiteral& literal) {
      return !literal.relation && literal.predicate == want.predicate && literal.symbol == want.symbol &&
             literal.positive != want.negated;
    });
  });
}

}  // namespace

std::vector<std::string> doubtful_purpose(const Template& source) {
  std::vector<std::string> doubts;
  const auto* kind = purpose_kind(source.purpose.name);
  if (kind == nullptr) {
    doubts.push_back("no section (purpose ...) says what the task is for in a home");
  } else {
    const auto wants = wants_of(source.goal);
    const bool fits = wants.moves_agent || std::any_of(wants.wants.begin(), wants.wants.end(), [&](const Want& want) {
                        return std::find(kind->signs.begin(), kind->signs.end(),
                                         PurposeSign{want.predicate, want.negated}) != kind->signs.end();
                      });
    if (!fits) {
      std::vector<std::string> signs;
      for (const auto& sign : kind->signs) signs.push_back(words_of(sign));
      doubts.push_back("the purpose '" + source.purpose.name +
                       "' does not fit the goal, which asks for none of: " + join(signs, ", "));
    }
    // Nothing need be wrong with a thing that is taken in the hand, nor with where the agent is.
    const bool needless = std::all_of(wants.wants.begin(), wants.wants.end(), [](const Want& want) {
      using enum Predicate;
      return want.predicate == Held || want.predicate == SatOn || want.predicate == LainOn ||
             want.predicate == Predicate::Read;
    });
    if (source.purpose.needs.empty() && !needless)
      doubts.push_back("the purpose gives no reason; add (because ...) with what the start says, such as (dirty A)");
  }
  const auto end = wants_of(at_the_end(source.goal));
  const bool pointless = (kind == nullptr || !kind->meanwhile) && !end.wants.empty() &&
                         std::all_of(end.wants.begin(), end.wants.end(),
                                     [&](const Want& want) { return holds_at_start(want, end, source.init); });
  if (pointless)
    doubts.push_back("the start already is what the goal asks for at the end, so nothing will have changed");
  return doubts;
}

std::string need_in_words(const Need& need) {
  return need_in_words(need, [](const std::string& placeholder) { return "<" + placeholder + ">"; });
}

}  // namespace unietp
