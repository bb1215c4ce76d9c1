#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "interchange/format_facts.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// What a bound variable ranges over, in our vocabulary and in the release's.
struct ReleaseBound {
  std::string name;
  std::vector<std::string> ours;    // categories; of a slice those of the pieces
  std::vector<std::string> theirs;  // the same in their words
  bool room = false;
  bool late = false;  // some exist only after something is cut
};

/// Translates the domains of one goal's variables, and the objects that its referring constraints select at the start,
/// to the release's format. Keeps the first reason why that is impossible. Deterministic.
class ReleaseBinder {
 public:
  ReleaseBinder(const Scene& start, const Knowledge& knowledge, const FormatFacts& facts)
      : start_(start), knowledge_(knowledge), facts_(facts) {}

  /// The first reason why the goal cannot be expressed; "" for none.
  const std::string& why() const { return why_; }
  /// Notes a reason; only the first counts.
  void refuse(const std::string& why) {
    if (why_.empty()) why_ = why;
  }
  /// Ids of the objects that referring constraints select, by category.
  const std::map<std::string, std::vector<std::string>>& referents() const { return referents_; }

  /// What the quantifier's variable ranges over; nullopt once there is a reason.
  std::optional<ReleaseBound> bind(const Formula& quantifier);
  /// Whether cutting something in the home makes objects of the category.
  bool made_by_cutting(const std::string& category) const;
  /// Whether an object disappears when it is cut, as OmniGibson removes it.
  bool vanishes(const ReleaseBound& bound) const;
  /// Refuses what the release's evaluator does not allow together with a referring constraint. `counts`: a `forall` or
  /// a count.
  void check_referents(bool counts);

 private:
  void add_category(const std::string& category, ReleaseBound& bound) const;
  std::string their_category(const std::string& category) const;
  void add_room(const std::string& type, ReleaseBound& bound);
  void add_pieces(const std::string& whole, ReleaseBound& bound);
  void add_referents(const Formula& quantifier, const ReleaseBound& bound);

  const Scene& start_;
  const Knowledge& knowledge_;
  const FormatFacts& facts_;
  std::set<std::string> plain_;  // their categories of variables without a referring constraint
  std::map<std::string, std::vector<std::string>> referents_;
  std::string why_;
};

}  // namespace unietp
