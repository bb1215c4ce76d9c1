#pragma once

#include <optional>
#include <vector>

#include "symbolic/goal.h"

namespace unietp::symbolic {

/// What could ever become true from a start by the offered actions, if nothing that was once true were lost. A cheap
/// over-approximation: what it excludes is really impossible.
class Reach {
 public:
  Reach(const Setting& setting, const World& start);

  /// Whether the atom may ever become true (`wanted`), or false.
  bool may(const Atom& atom, bool wanted) const;

 private:
  struct Outlook {
    std::uint64_t states = 0;
    SubstanceSet fillings, coats;
    bool exists = false, held = false, uncovered = false;
    bool operator==(const Outlook&) const = default;
  };
  bool offered(ActionType action) const { return setting_.rules->capabilities().has(action); }
  const Outlook& of(Id id) const { return outlooks_[id.index()]; }
  bool may_have(Id id, Predicate state) const;
  void spread();
  void do_alone(Id id, Outlook& next) const;
  void do_with(Id tool, Id target, Outlook& next) const;
  bool works(Id tool, Id target, const Reaction& reaction) const;
  bool may_be_at(Id id, Predicate relation, Id place, int depth) const;
  bool may_fail(const Atom& atom) const;

  const Setting& setting_;
  const World& start_;
  std::vector<Outlook> outlooks_;
};

/// A truth of a goal that is out of reach.
struct OutOfReach {
  Atom atom;
  bool wanted = true;
};
/// Why the goal cannot be met from the start that `reach` was made for, or nullopt when nothing excludes it.
std::optional<OutOfReach> out_of_reach(const Goal& goal, const Reach& reach, const Setting& setting,
                                       const World& start);

}  // namespace unietp::symbolic
