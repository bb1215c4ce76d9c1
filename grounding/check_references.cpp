#include "grounding/check_references.h"

#include <algorithm>

#include "grounding/goal_places.h"
#include "logic/evaluate.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using Entities = std::vector<EntityIndex>;

/// A reference by another thing: "(exists (?p - Desk) (on ?a ?p))", or the negation of it.
struct ByOther {
  Predicate relation;
  const Domain* other;
  const std::string* variable;  // of the other
  bool denied = false;
};

std::optional<ByOther> by_other(const Formula& test, const std::string& variable) {
  const bool denied = test.op == Op::Not;
  const Formula& said = denied ? test.children.front() : test;
  if (said.op != Op::Exists || said.children.front().op != Op::Atom) return std::nullopt;
  const Formula& fact = said.children.front();
  if (fact.predicate == Predicate::InRoom || fact != atom(fact.predicate, {variable, said.variable}))
    return std::nullopt;
  return ByOther{fact.predicate, &said.domain, &said.variable, denied};
}

bool is_place_of_a_thing(Predicate relation) {
  using enum Predicate;
  return relation == On || relation == Inside || relation == Under || relation == NextTo;
}

class FactsOfRooms {
 public:
  explicit FactsOfRooms(const Facts& facts) : facts_(facts) {}

  bool share_a_room(EntityIndex one, EntityIndex other) const {
    return facts_.any_related(Predicate::InRoom, one,
                              [&](EntityIndex room) { return facts_.holds(Predicate::InRoom, other, room); });
  }
  bool in_room_of_any(EntityIndex one, const Entities& others) const {
    return std::any_of(others.begin(), others.end(), [&](EntityIndex other) { return share_a_room(one, other); });
  }
  /// Whether it is inside something closed, or on or in something that is, at most so many levels up: contacts may go
  /// in a circle.
  bool is_shut_away(EntityIndex one, int levels = 8) const {
    if (levels == 0) return false;
    return facts_.any_related(Predicate::Inside, one, [&](EntityIndex container) {
      return facts_.holds(Predicate::Closed, container) || is_shut_away(container, levels - 1);
    }) || facts_.any_related(Predicate::On, one, [&](EntityIndex below) { return is_shut_away(below, levels - 1); });
  }
  /// Whether something carries or holds both.
  bool lie_side_by_side(EntityIndex one, EntityIndex other) const {
    const auto holds_other = [&](EntityIndex below) { return on_or_in(other, below); };
    return facts_.any_related(Predicate::On, one, holds_other) ||
           facts_.any_related(Predicate::Inside, one, holds_other);
  }
  bool on_or_in(EntityIndex one, EntityIndex other) const {
    return facts_.holds(Predicate::On, one, other) || facts_.holds(Predicate::Inside, one, other);
  }
  /// The same, or it is on or in something that is, at most so many levels up.
  bool is_carried_by(EntityIndex one, EntityIndex other, int levels = 8) const {
    if (on_or_in(one, other)) return true;
    const auto carried = [&](EntityIndex below) { return is_carried_by(below, other, levels - 1); };
    return levels > 1 &&
           (facts_.any_related(Predicate::On, one, carried) || facts_.any_related(Predicate::Inside, one, carried));
  }
  /// Whether what it is on or in says which of the things it is, as "the fork in the sink" does: the room has one such
  /// place, and no other of the things is at one.
  bool is_told_by_place(EntityIndex one, const Entities& others, const Trace& trace) const {
    const auto tells = [&](EntityIndex place) {
      const auto is_such = [&](EntityIndex other) {
        return trace.entities[other].category == trace.entities[place].category;
      };
      for (EntityIndex at; at.index() < trace.entities.size(); ++at)
        if (at != place && is_such(at) && share_a_room(at, place)) return false;
      return std::none_of(others.begin(), others.end(), [&](EntityIndex other) {
        return facts_.any_related(Predicate::On, other, is_such) ||
               facts_.any_related(Predicate::Inside, other, is_such);
      });
    };
    return facts_.any_related(Predicate::On, one, tells) || facts_.any_related(Predicate::Inside, one, tells);
  }
  /// Whether it is on, in or under something; of `next_to`, beside something.
  bool has_such_a_place(EntityIndex one, Predicate relation) const {
    using enum Predicate;
    const auto has = [&](Predicate kind) { return facts_.any_related(kind, one, [](EntityIndex) { return true; }); };
    return relation == NextTo ? has(NextTo) : has(On) || has(Inside) || has(Under);
  }

 private:
  const Facts& facts_;
};

/// What is odd about calling the things `referents` the ones nearest to a landmark, `others` being those that are not.
std::optional<std::string> odd_nearness(const Entities& referents, const Entities& all_others,
                                        const Entities& landmarks, const FactsOfRooms& home, const Trace& trace) {
  Entities others = all_others;
  std::erase_if(others, [&](EntityIndex one) { return home.is_shut_away(one); });
  for (const EntityIndex one : referents) {
    if (home.is_shut_away(one)) return "it is shut away";
    for (const EntityIndex landmark : landmarks) {
      if (home.is_carried_by(one, landmark)) return "it is on or in that";
      if (!home.share_a_room(one, landmark)) return "that is in another room";
    }
    if (!home.in_room_of_any(one, others)) return "no other one is seen in the room";
    const auto is_beside = [&](EntityIndex other) { return home.lie_side_by_side(one, other); };
    if (std::all_of(others.begin(), others.end(), is_beside)) return "they lie side by side";
    if (home.is_told_by_place(one, all_others, trace)) return "what it is on or in says which it is";
  }
  return std::nullopt;
}

std::optional<std::string> odd_among_others(const Entities& referents, const Entities& others,
                                            const FactsOfRooms& home) {
  const bool together = std::all_of(referents.begin(), referents.end(),
                                    [&](EntityIndex one) { return home.in_room_of_any(one, others); });
  return together ? std::nullopt : std::optional<std::string>("the others are in other rooms");
}

/// What is odd about one test of a reference, or nullopt. `single`: one thing is meant.
std::optional<std::string> odd_test(const Formula& test, const std::string& variable, bool single,
                                    const Entities& referents, const Entities& others, const Trace& trace) {
  const FactsOfRooms home(trace.states.front());
  if (test.op == Op::Atom && test.predicate == Predicate::Size) return odd_among_others(referents, others, home);
  const bool by_dirt =
      test.op == Op::Atom && (test.predicate == Predicate::Dirty || test.predicate == Predicate::Clean);
  const auto is_covered = [&](EntityIndex one) { return trace.states.front().holds(Predicate::Covered, one, "any"); };
  if (by_dirt && (std::any_of(referents.begin(), referents.end(), is_covered) ||
                  std::any_of(others.begin(), others.end(), is_covered)))
    return "what is covered with something looks dirty, too";
  const auto related = by_other(test, variable);
  if (!related) return std::nullopt;
  const auto has_such_a_place = [&](EntityIndex one) { return home.has_such_a_place(one, related->relation); };
  if (!related->denied && is_place_of_a_thing(related->relation) &&
      std::none_of(others.begin(), others.end(), has_such_a_place))
    return "none of the others is at such a place of another thing";
  const bool near = related->relation == Predicate::NextTo || related->relation == Predicate::Nearest;
  if (!single && near) return "several things are told apart by what stands near them";
  const Entities landmarks = members_of(*related->other, *related->variable, trace);
  if (!single) {
    const auto has_all = [&](EntityIndex landmark) {
      return std::all_of(referents.begin(), referents.end(),
                         [&](EntityIndex one) { return home.on_or_in(one, landmark); });
    };
    const bool all_on_one = landmarks.size() > 1 && std::any_of(landmarks.begin(), landmarks.end(), has_all);
    return all_on_one && !related->denied ? std::optional<std::string>("all are on or in one of those") : std::nullopt;
  }
  if (related->relation == Predicate::Nearest) return odd_nearness(referents, others, landmarks, home, trace);
  if (landmarks.size() > 1) return "there are several of those";
  if (related->denied) return odd_among_others(referents, others, home);
  if (related->relation == Predicate::NextTo && std::none_of(referents.begin(), referents.end(), [&](EntityIndex one) {
        return home.in_room_of_any(one, landmarks);
      }))
    return "that is in another room";
  return std::nullopt;
}

}  // namespace

std::optional<GroundingFailure> check_references(const Specification& specification, const Trace& trace) {
  for (const auto& [domain, referents, others] : referred_things(specification.goal, trace)) {
    const Formula& where = domain.domain.where.front();
    const auto tests = where.op == Op::And ? where.children : std::vector<Formula>{where};
    const bool by_power = std::any_of(tests.begin(), tests.end(), [](const Formula& test) {
      return test.op == Op::Atom && (test.predicate == Predicate::PowerOn || test.predicate == Predicate::PowerOff);
    });
    if (by_power && tests.size() > 1)
      return GroundingFailure{RejectionReason::OddReference, to_text(where) + ": it says that it is on, and where", {}};
    for (const Formula& test : tests) {
      if (const auto odd = odd_test(test, domain.variable, domain.op == Op::Exists, referents, others, trace))
        return GroundingFailure{RejectionReason::OddReference, to_text(test) + ": " + *odd, {}};
    }
  }
  return std::nullopt;
}

}  // namespace unietp
