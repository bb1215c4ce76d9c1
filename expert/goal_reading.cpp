#include "expert/goal_reading.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "core/least_first.h"
#include "expert/achievers.h"
#include "expert/alternatives.h"
#include "logic/comparison.h"

namespace unietp {
namespace {

using List = Choices::List;
using Op = Formula::Op;

int deepest_exists(const Formula& formula) {
  int deepest = 0;
  for (const Formula& child : formula.children) deepest = std::max(deepest, deepest_exists(child));
  return deepest + (formula.op == Op::Exists ? 1 : 0);
}

/// Reads `formula` (or, with `want` false, its negation) under an assignment. What it lists in Alternative::end has to
/// hold at the position being read; the temporal operators turn that into the end, or into a moment.
class Reader {
 public:
  Reader(const Formula& goal, const Situation& situation, const CostPenalties& experience,
         const ReadingOptions& options)
      : situation_(situation), experience_(experience), choices_(situation, experience, options.beam) {
    const int depth = std::max(1, deepest_exists(goal));
    const auto candidates = std::pow(static_cast<double>(options.assignments), 1.0 / depth);
    candidates_ = std::clamp<std::size_t>(static_cast<std::size_t>(candidates), 4, options.witnesses);
  }

  /// What a quantifier says is read once for the objects that it speaks of, whatever else was chosen around it.
  List read(const Formula& formula, bool want) {
    const bool quantifies = formula.op == Op::Forall || formula.op == Op::Exists || formula.op == Op::Count;
    if (!quantifies || assignment_.empty()) return read_anew(formula, want);
    const Known& known = known_.try_emplace(&formula, formula).first->second;
    if (known.of_moments) return read_anew(formula, want);
    ReadAs as{&formula, want, {}};
    for (const std::string& name : known.variables) std::get<2>(as).push_back(value_of(name));
    const auto found = read_.find(as);
    if (found != read_.end()) return found->second;
    return read_.emplace(std::move(as), read_anew(formula, want)).first->second;
  }

 private:
  /// Of a part of the goal: on which variables it depends, and whether it speaks of more than one moment.
  struct Known {
    explicit Known(const Formula& formula)
        : variables(free_variables(formula)),
          of_moments(has_operator(formula, {Op::Sometime, Op::Always, Op::Until, Op::Before})) {}
    std::vector<std::string> variables;
    bool of_moments;
  };
  using ReadAs = std::tuple<const Formula*, bool, std::vector<EntityIndex>>;  // compared alone, never gone through

  List read_anew(const Formula& formula, bool want) {
    switch (formula.op) {
      case Op::Atom:
        return literal(formula, want);
      case Op::Equal:
        return (entity_of(formula.terms[0]) == entity_of(formula.terms[1])) == want ? choices_.nothing_to_do()
                                                                                    : choices_.none();
      case Op::And:
        return want ? all(formula.children, true) : any(formula.children, false);
      case Op::Or:
        return want ? any(formula.children, true) : all(formula.children, false);
      case Op::Not:
        return read(formula.children[0], !want);
      case Op::Imply:
        return want ? choices_.either(read(formula.children[0], false), read(formula.children[1], true))
                    : choices_.both(read(formula.children[0], true), read(formula.children[1], false));
      case Op::Forall:
        return want ? every_member(formula, true) : some_member(formula, false);
      case Op::Exists:
        return want ? some_member(formula, true) : every_member(formula, false);
      case Op::Count:
        return count(members(formula), formula.comparison, formula.number, want);
      case Op::CountCompare:
        return compare_counts(formula, want);
      case Op::Number:
        return choices_.none();  // only read as a part of CountCompare
      case Op::AtEnd:
        return read(formula.children[0], want);
      case Op::Sometime:
        return want ? moment(formula.children[0], true) : keep_always(formula.children[0], false);
      case Op::Always:
        return want ? keep_always(formula.children[0], true) : moment(formula.children[0], false);
      case Op::Until:
        return want ? until(formula.children[0], formula.children[1]) : never_until(formula);
      case Op::Before:
        return want ? before(formula.children[0], formula.children[1]) : never_before(formula);
    }
    return choices_.none();
  }

  EntityIndex entity_of(const Term& term) const {
    return term.kind == Term::Kind::Agent ? kAgentEntity : value_of(term.name);
  }

  EntityIndex value_of(const std::string& name) const {
    for (auto bound = assignment_.rbegin(); bound != assignment_.rend(); ++bound) {
      if (bound->first == name) return bound->second;
    }
    return kNobody;
  }

  bool holds_at_start(const Formula& formula) const { return holds_in(formula, situation_.trace, 0, assignment_); }

  Literal literal_of(const Formula& formula, bool want) const {
    Literal literal;
    literal.predicate = formula.predicate;
    literal.positive = want;
    for (std::size_t i = 0; i < formula.terms.size(); ++i) {
      const Term& term = formula.terms[i];
      if (term.kind == Term::Kind::Symbol) {
        literal.symbol = term.name;
      } else {
        (i == 0 ? literal.subject : literal.object) = entity_of(term);
      }
    }
    return literal;
  }

  /// The truth that a literal, negated or not, has at the start, when it is the one that is wanted.
  std::optional<Literal> stands(const Formula& formula, bool want) const {
    if (formula.op == Op::Not) return stands(formula.children.front(), !want);
    if (formula.op != Op::Atom || formula.predicate == Predicate::SliceOf) return std::nullopt;
    Literal literal = literal_of(formula, want);
    return holds_in(literal, situation_.facts()) ? std::optional(std::move(literal)) : std::nullopt;
  }

  List literal(const Formula& formula, bool want) {
    Literal literal = literal_of(formula, want);
    if (literal.predicate == Predicate::SliceOf && situation_.is_imagined(literal.subject)) {
      const bool truth = situation_.slice(literal.subject).whole == literal.object;
      return truth == want ? choices_.nothing_to_do() : choices_.none();
    }
    if (holds_in(literal, situation_.facts())) return choices_.single(std::move(literal));
    if (!want && !is_placement(literal.predicate) && literal.predicate != Predicate::Held) return undo(literal);
    return achievable(literal, situation_) ? choices_.single(std::move(literal)) : choices_.none();
  }

  /// A state goes away when another of its group comes: `not hot` is reached by cooling. What covers a thing has no
  /// such group, and is wiped off.
  List undo(const Literal& unwanted) {
    List list;
    if (unwanted.predicate == Predicate::Covered && achievable(unwanted, situation_)) return choices_.single(unwanted);
    for (const StateGroup& group : state_groups()) {
      if (std::find(group.predicates.begin(), group.predicates.end(), unwanted.predicate) == group.predicates.end()) {
        continue;
      }
      for (const Predicate other : group.predicates) {
        Literal instead = unwanted;
        instead.predicate = other;
        instead.positive = true;
        instead.symbol.clear();
        if (other != unwanted.predicate && other != Predicate::Filled && achievable(instead, situation_)) {
          list = choices_.either(std::move(list), choices_.single(instead));
        }
      }
    }
    return list;
  }

  List all(const std::vector<Formula>& parts, bool want) {
    // Parts with few ways first: they decide the most, and the beam keeps what agrees with them.
    std::vector<List> lists;
    for (const Formula& part : parts) lists.push_back(read(part, want));
    std::stable_sort(lists.begin(), lists.end(), [](const List& a, const List& b) { return a.size() < b.size(); });
    return choices_.all(pointers_to(lists), {});
  }

  List any(const std::vector<Formula>& parts, bool want) {
    List result;
    for (const Formula& part : parts) result = choices_.either(std::move(result), read(part, want));
    return result;
  }

  static std::vector<const List*> pointers_to(const std::vector<List>& lists) {
    std::vector<const List*> pointers;
    for (const List& list : lists) pointers.push_back(&list);
    return pointers;
  }

  std::vector<EntityIndex> domain_of(const Formula& formula) const {
    return members_of(formula.domain, formula.variable, situation_.trace, assignment_);
  }

  List read_with(const Formula& formula, EntityIndex value, bool want) {
    assignment_.emplace_back(formula.variable, value);
    List list = read(formula.children[0], want);
    assignment_.pop_back();
    return list;
  }

  List some_member(const Formula& formula, bool want) {
    std::vector<EntityIndex> witnesses = domain_of(formula);
    if (witnesses.size() > candidates_) {
      LeastFirst<EntityIndex, double> nearest(
          candidates_, [this](EntityIndex e) { return situation_.walk_m(e) + 10 * experience_.penalty(e); });
      for (const EntityIndex e : std::exchange(witnesses, {}))
        nearest.add(e, situation_.straight_m(e) + 10 * experience_.penalty(e));
      while (const auto witness = nearest.next()) witnesses.push_back(*witness);
    }
    List result;
    for (const EntityIndex witness : witnesses) {
      choices_.add(result, read_with(formula, witness, want));
    }
    return result;
  }

  /// What holds of them already may be thousands of truths, and is not taken for choices.
  List all_of(const Formula& formula, const std::vector<EntityIndex>& members, bool want) {
    std::vector<Literal> standing;
    std::vector<List> lists;
    for (const EntityIndex member : members) {
      assignment_.emplace_back(formula.variable, member);
      auto truth = stands(formula.children[0], want);
      if (!truth) lists.push_back(read(formula.children[0], want));
      assignment_.pop_back();
      if (truth) standing.push_back(std::move(*truth));
      if (!truth && lists.back().empty()) return choices_.none();
    }
    return choices_.all(pointers_to(lists), std::move(standing));
  }

  /// All that exist; of slices that do not exist yet only one thing has to be cut, so each such thing is a way.
  List every_member(const Formula& formula, bool want) {
    std::vector<EntityIndex> real, wholes;
    const std::vector<EntityIndex> domain = domain_of(formula);
    for (const EntityIndex member : domain) {
      if (!situation_.is_imagined(member)) {
        real.push_back(member);
      } else if (wholes.empty() || wholes.back() != situation_.slice(member).whole) {
        wholes.push_back(situation_.slice(member).whole);
      }
    }
    List common = all_of(formula, real, want);
    if (common.empty()) return common;
    if (wholes.empty()) return common;
    List result = real.empty() ? choices_.none() : common;
    for (const EntityIndex whole : wholes) {
      List cut = common;
      for (const EntityIndex member : domain) {
        if (situation_.is_imagined(member) && situation_.slice(member).whole == whole) {
          cut = choices_.both(cut, read_with(formula, member, want));
        }
      }
      result = choices_.either(std::move(result), std::move(cut));
    }
    return result;
  }

  std::vector<Choices::Member> members(const Formula& formula) {
    std::vector<Choices::Member> list;
    for (const EntityIndex member : domain_of(formula)) {
      list.push_back({read_with(formula, member, true), read_with(formula, member, false)});
    }
    return list;
  }

  List count(const std::vector<Choices::Member>& members, Comparison comparison, int number, bool want) const {
    switch (comparison) {
      case Comparison::Equal:
        return want ? choices_.exactly(number, members)
                    : choices_.either(choices_.at_least(number + 1, members), choices_.at_most(number - 1, members));
      case Comparison::AtLeast:
        return want ? choices_.at_least(number, members) : choices_.at_most(number - 1, members);
      case Comparison::Greater:
        return count(members, Comparison::AtLeast, number + 1, want);
      case Comparison::AtMost:
        return want ? choices_.at_most(number, members) : choices_.at_least(number + 1, members);
      case Comparison::Less:
        return count(members, Comparison::AtMost, number - 1, want);
    }
    return choices_.none();
  }

  int counted_at_start(const Formula& formula) {
    int holding = 0;
    for (const EntityIndex member : domain_of(formula)) {
      assignment_.emplace_back(formula.variable, member);
      holding += holds_at_start(formula.children[0]) ? 1 : 0;
      assignment_.pop_back();
    }
    return holding;
  }

  /// Fixes both numbers, those nearest to the present ones first.
  List compare_counts(const Formula& formula, bool want) {
    const Formula &first = formula.children[0], &second = formula.children[1];
    const auto left = members(first), right = members(second);
    const int left_now = counted_at_start(first), right_now = counted_at_start(second);
    constexpr std::size_t kMostPairs = 8;
    std::size_t pairs = 0;
    List result;
    const int most = static_cast<int>(left.size() + right.size());
    for (int change = 0; change <= most && pairs < kMostPairs; ++change) {
      for (int a = 0; a <= static_cast<int>(left.size()); ++a) {
        for (int b = 0; b <= static_cast<int>(right.size()); ++b) {
          if (std::abs(a - left_now) + std::abs(b - right_now) != change) continue;
          if (compares(a, formula.comparison, b) != want) continue;
          ++pairs;
          result =
              choices_.either(std::move(result), choices_.both(choices_.exactly(a, left), choices_.exactly(b, right)));
        }
      }
    }
    return result;
  }

  List moment(const Formula& formula, bool want) {
    if (holds_at_start(formula) == want) return choices_.nothing_to_do();
    List list = read(formula, want);
    for (Alternative& alternative : list) {
      alternative.moments = {Moment{wanted_at_end(alternative), {}}};
      alternative.end.clear();
      alternative.standing.reset();
    }
    return list;
  }

  List keep_always(const Formula& formula, bool want) {
    if (holds_at_start(formula) != want) return choices_.none();
    Alternative alternative;
    alternative.maintained.push_back({want ? formula : negation(formula), assignment_, MaintenanceGoal::kAlways, true});
    return {alternative};
  }

  List until(const Formula& kept, const Formula& goal) {
    if (holds_at_start(goal)) return choices_.nothing_to_do();
    if (!holds_at_start(kept)) return choices_.none();
    List list = moment(goal, true);
    for (Alternative& alternative : list) alternative.maintained.push_back({kept, assignment_, 0, false});
    return list;
  }

  List before(const Formula& first, const Formula& second) {
    if (holds_at_start(second)) return choices_.none();
    if (holds_at_start(first)) return moment(second, true);
    List list = choices_.in_turn(read(first, true), read(second, true));
    for (Alternative& alternative : list) alternative.maintained.push_back({negation(second), assignment_, 0, true});
    return list;
  }

  /// `not (until f g)`: g never, or a moment without f and g up to which g was false.
  List never_until(const Formula& formula) {
    const Formula &kept = formula.children[0], &goal = formula.children[1];
    const Formula neither = conjunction({negation(kept), negation(goal)});
    List list = keep_always(goal, false);
    if (holds_at_start(goal)) return list;
    List broken = moment(neither, true);
    for (Alternative& alternative : broken) {
      if (!alternative.moments.empty()) alternative.maintained.push_back({negation(goal), assignment_, 0, true});
    }
    return choices_.either(std::move(list), std::move(broken));
  }

  /// `not (before f g)`: f never, or g never, or g no later than f.
  List never_before(const Formula& formula) {
    const Formula &first = formula.children[0], &second = formula.children[1];
    List list = choices_.either(keep_always(first, false), keep_always(second, false));
    if (holds_at_start(second)) return choices_.nothing_to_do();
    if (holds_at_start(first)) return list;
    List later = moment(second, true);
    for (Alternative& alternative : later) alternative.maintained.push_back({negation(first), assignment_, 0, false});
    return choices_.either(std::move(list), std::move(later));
  }

  const Situation& situation_;
  const CostPenalties& experience_;
  Choices choices_;
  std::size_t candidates_ = 0;
  Assignment assignment_;
  std::map<const Formula*, Known> known_;  // compared alone, never gone through
  std::map<ReadAs, List> read_;
};

}  // namespace

std::vector<Alternative> read_goal(const Formula& goal, const Situation& situation, const CostPenalties& experience,
                                   const ReadingOptions& options) {
  return Reader(goal, situation, experience, options).read(goal, true);
}

}  // namespace unietp
