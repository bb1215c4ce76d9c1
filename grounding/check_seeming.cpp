#include "grounding/check_seeming.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "logic/evaluate.h"

namespace unietp {
namespace {

using Op = Formula::Op;

class SeemingRelations {
 public:
  SeemingRelations(const Formula& goal, const Trace& trace, const Knowledge& knowledge)
      : trace_(trace), knowledge_(knowledge) {
    note_moved(goal);
  }

  void read(const Formula& formula) {
    if (formula.op == Op::Atom) compare(formula);
    const bool binds =
        formula.op == Op::Forall || formula.op == Op::Exists || formula.op == Op::Count || formula.op == Op::Number;
    if (binds) {
      // What a description tells apart are all things of the category.
      scope_.emplace_back(formula.variable, bare(formula.domain));
      describing_ = true;
      for (const Formula& where : formula.domain.where) read(where);
      describing_ = false;
      scope_.back().second = closed(formula.domain, formula.variable);
    }
    const bool denies = formula.op == Op::Count && formula.number == 0 && formula.comparison == Comparison::Equal;
    denying_ += denies ? 1 : 0;
    for (const Formula& child : formula.children) read(child);
    denying_ -= denies ? 1 : 0;
    if (binds) scope_.pop_back();
  }

  std::optional<GroundingFailure> found() const { return found_; }

 private:
  static Domain bare(Domain domain) {
    domain.where.clear();
    return domain;
  }
  /// Without a description that speaks of other variables.
  static Domain closed(const Domain& domain, const std::string& variable) {
    for (const Formula& where : domain.where)
      for (const std::string& free : free_variables(where))
        if (free != variable) return bare(domain);
    return domain;
  }

  std::vector<EntityIndex> members(const Term& term) const {
    if (term.kind != Term::Kind::Variable) return {};
    const auto bound =
        std::find_if(scope_.rbegin(), scope_.rend(), [&](const auto& one) { return one.first == term.name; });
    return bound == scope_.rend() ? std::vector<EntityIndex>() : members_of(bound->second, bound->first, trace_);
  }

  void compare(const Formula& fact) {
    if (found_) return;
    if (fact.predicate == Predicate::Clean && !describing_) return tell_clean(members(fact.terms[0]), {});
    if (fact.predicate == Predicate::NextTo && !describing_) {
      find_in_the_wash(members(fact.terms[1]));
      if (!found_) find_stored(fact.terms[1]);
      return;
    }
    if (fact.predicate != Predicate::On && fact.predicate != Predicate::Inside) return;
    const Facts& now = trace_.states.front();
    const auto things = members(fact.terms[0]), places = members(fact.terms[1]);
    for (const EntityIndex thing : things)
      for (const EntityIndex place : places) {
        if (thing == place || now.holds(fact.predicate, thing, place)) continue;
        if (!is_carried_to(thing, place, fact.predicate)) continue;
        found_ = {RejectionReason::PartHolds,
                  trace_.entities[thing].id + " seems to be at " + trace_.entities[place].id +
                      ": it is on or in something that is",
                  {}};
        return;
      }
    if (describing_) return;
    if (denying_ > 0) return find_taken_dirty(things, places);
    tell_clean(things, places);
    if (!found_) find_stored(fact.terms[1]);
  }

  /// The variables of things that the goal puts somewhere or wants held or clean.
  void note_moved(const Formula& formula) {
    using enum Predicate;
    constexpr std::array kMoves{On, Inside, OnFloor, InRoom, Held, NextTo, Clean};
    if (formula.op == Op::Atom && formula.terms[0].kind == Term::Kind::Variable &&
        std::find(kMoves.begin(), kMoves.end(), formula.predicate) != kMoves.end())
      moved_.insert(formula.terms[0].name);
    for (const Formula& child : formula.children) note_moved(child);
  }

  /// Finds what all dishes and the like, to which something is to be put, are put away in: nobody wants toast on a
  /// plate in the cabinet, or an apple in a bowl in the sink. What the goal puts somewhere else or wants clean is taken
  /// out.
  void find_stored(const Term& term) {
    if (term.kind != Term::Kind::Variable || moved_.contains(term.name)) return;
    const auto places = members(term);
    const auto is_stored = [&](EntityIndex place) {
      return is_movable(place) && trace_.states.front().any_related(Predicate::Inside, place,
                                                                    [&](EntityIndex around) { return stores(around); });
    };
    if (places.empty() || !std::all_of(places.begin(), places.end(), is_stored)) return;
    found_ = {RejectionReason::PartHolds, trace_.entities[places.front()].id + " is put away", {}};
  }

  /// A cabinet, a drawer, and what washes or is washed in.
  bool stores(EntityIndex place) const {
    const Category* category = knowledge_.find(trace_.entities[place].category);
    return category != nullptr && has_trait(*category, KindTrait::PutsAway);
  }

  /// Finds a dirty thing that is to be taken out of where such things are washed.
  void find_taken_dirty(const std::vector<EntityIndex>& things, const std::vector<EntityIndex>& places) {
    const Facts& now = trace_.states.front();
    for (const EntityIndex thing : things)
      for (const EntityIndex place : places) {
        if (!now.holds(Predicate::Dirty, thing) || !now.holds(Predicate::Inside, thing, place) || !washes(place, thing))
          continue;
        found_ = {RejectionReason::PartHolds, trace_.entities[thing].id + " is dirty and waits to be washed", {}};
        return;
      }
  }

  /// Finds a clean thing beside dirty ones; with `places`, one that is to go where it is washed.
  void tell_clean(const std::vector<EntityIndex>& things, const std::vector<EntityIndex>& places) {
    const Facts& now = trace_.states.front();
    const auto is_there = [&](EntityIndex thing) {
      return std::any_of(places.begin(), places.end(), [&](EntityIndex place) {
        return now.holds(Predicate::Inside, thing, place) || now.holds(Predicate::On, thing, place);
      });
    };
    const auto clean = std::find_if(things.begin(), things.end(), [&](EntityIndex thing) {
      return now.holds(Predicate::Clean, thing) && !is_there(thing);
    });
    if (clean == things.end()) return;
    const auto is_dirty = [&](EntityIndex thing) { return now.holds(Predicate::Dirty, thing); };
    const auto is_washed_there = [&](EntityIndex place) { return washes(place, *clean); };
    if (places.empty() ? std::none_of(things.begin(), things.end(), is_dirty)
                       : std::none_of(places.begin(), places.end(), is_washed_there))
      return;
    found_ = {
        RejectionReason::PartHolds, trace_.entities[*clean].id + " is clean, and only dirty ones seem to be meant", {}};
  }

  /// Finds a thing that waits where such things are washed: nothing is put beside it there.
  void find_in_the_wash(const std::vector<EntityIndex>& things) {
    for (const EntityIndex thing : things) {
      const auto waits = [&](EntityIndex place) { return washes(place, thing); };
      if (!trace_.states.front().any_related(Predicate::Inside, thing, waits)) continue;
      found_ = {RejectionReason::PartHolds, trace_.entities[thing].id + " is where it is washed", {}};
      return;
    }
  }

  bool washes(EntityIndex place, EntityIndex thing) const {
    const auto effects = knowledge_.effects_of(trace_.entities[place].category, Treatment::Washes);
    return std::any_of(effects.begin(), effects.end(),
                       [&](const Effect* effect) { return effect->target == trace_.entities[thing].category; });
  }

  bool is_movable(EntityIndex thing) const {
    const Category* category = knowledge_.find(trace_.entities[thing].category);
    return category != nullptr && category->movable;
  }

  /// Whether it is on or in something movable that is at the place, at most so many levels up: contacts may go in a
  /// circle.
  bool is_carried_to(EntityIndex thing, EntityIndex place, Predicate relation, int levels = 4) const {
    const Facts& now = trace_.states.front();
    const auto carries = [&](EntityIndex below) {
      return below != thing && below != place && is_movable(below) &&
             (now.holds(relation, below, place) || (levels > 1 && is_carried_to(below, place, relation, levels - 1)));
    };
    return now.any_related(Predicate::On, thing, carries) || now.any_related(Predicate::Inside, thing, carries);
  }

  const Trace& trace_;
  const Knowledge& knowledge_;
  std::set<std::string, std::less<>> moved_;           // variables
  std::vector<std::pair<std::string, Domain>> scope_;  // bound variables, innermost last
  bool describing_ = false;                            // within the description of what is bound
  int denying_ = 0;                                    // counts of zero around
  std::optional<GroundingFailure> found_;
};

}  // namespace

std::optional<GroundingFailure> check_seeming(const Formula& goal, const Trace& trace, const Knowledge& knowledge) {
  SeemingRelations relations(goal, trace, knowledge);
  relations.read(goal);
  return relations.found();
}

}  // namespace unietp
