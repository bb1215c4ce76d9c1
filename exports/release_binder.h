#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// What a bound variable may stand for, in our vocabulary and in the release's.
struct ReleaseBound {
  std::string name;
  std::vector<std::string> ours;    // categories; of a slice those of the pieces
  std::vector<std::string> theirs;  // the same in their words
  bool room = false;
  bool late = false;  // some are born only when something is cut
};

/// Says in the release's words what the variables of one goal range over, and what its referring constraints pick out
/// at the start. The first thing that cannot be said there is kept as the reason. Deterministic.
class ReleaseBinder {
 public:
  ReleaseBinder(const Scene& start, const Knowledge& knowledge) : start_(start), knowledge_(knowledge) {}

  /// "" while everything can be said.
  const std::string& why() const { return why_; }
  void refuse(const std::string& why) {
    if (why_.empty()) why_ = why;
  }
  /// The objects that referring constraints pick out, by their category.
  const std::map<std::string, std::vector<std::string>>& referents() const { return referents_; }

  /// What the quantifier's variable stands for; nullopt once something was refused.
  std::optional<ReleaseBound> bind(const Formula& quantifier);
  /// Whether cutting what the home has makes more of a category.
  bool born_later(const std::string& category) const;
  /// OmniGibson takes the whole away when it is cut.
  bool vanishes(const ReleaseBound& bound) const;
  /// Refuses what theirs cannot have beside a referring constraint, when there is one. `counts`: a `forall` or a count.
  void check_referents(bool counts);

 private:
  void add_category(const std::string& category, ReleaseBound& bound) const;
  std::string their_category(const std::string& category) const;
  void add_room(const std::string& type, ReleaseBound& bound);
  void add_pieces(const std::string& whole, ReleaseBound& bound);
  void add_referents(const Formula& quantifier, const ReleaseBound& bound);

  const Scene& start_;
  const Knowledge& knowledge_;
  std::set<std::string> plain_;  // their categories of variables without a referring constraint
  std::map<std::string, std::vector<std::string>> referents_;
  std::string why_;
};

}  // namespace unietp
