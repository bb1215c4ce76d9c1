#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "expert/belief.h"
#include "expert/execution_tree.h"
#include "expert/explorer.h"
#include "expert/known_home.h"
#include "expert/rollout.h"
#include "expert/search_problem.h"

namespace unietp {

/// Makes plans in a world made of what is believed: the home as it was believed when the first plan was made, with what
/// has come into view since, where the agent does again what it has done since then. How things come into the picture
/// of M3 is left to who does the plan: it names all that is believed. Deterministic.
class BeliefPlanner {
 public:
  /// Must outlive it.
  explicit BeliefPlanner(const SearchProblem& problem) : problem_(problem) {}

  /// How to go on: the rest of the present plan if it still works, unless `anew`, else another, which closes what it
  /// opens and what was `opened` before (tidied). False, and what there was stays, when none is found.
  bool make(const Belief& belief, KnownHome& home, int steps_left, const std::vector<std::string>& opened,
            bool anew = false);
  /// Use other things than this where others will do.
  void avoid(std::string id) { avoided_.push_back(std::move(id)); }
  /// Another plan is needed.
  void drop() { plan_.clear(); }

  /// Of the plan; empty when there is none.
  std::span<const Action> rest() const { return std::span(plan_).subspan(std::min(next_, plan_.size())); }
  /// Nothing of the plan is left to be done.
  void only_stop() { next_ = plan_.empty() ? 0 : plan_.size() - 1; }
  /// The first of the rest is taken.
  void advance() { ++next_; }
  /// An action was done, which changed this.
  void did(const Action& action, const Delta& changes);
  /// Where the plan should have led by now, as far as it was followed here (the caller steps it); nullptr before the
  /// first.
  World* foreseen() const { return foreseen_.get(); }

  /// No plan was made, since what was done does not work in the home that is believed now.
  bool unfit() const { return unfit_; }
  const Trouble& trouble() const { return trouble_; }

 private:
  bool points() const { return problem_.mode == Mode::M3; }
  ModeRules rules(int steps_left) const;
  Scene believed_before(const Belief& belief) const;
  bool replay(Rollout& again);
  std::optional<std::vector<Action>> the_rest(Rollout rollout) const;
  std::optional<std::vector<Action>> another_plan(ExecutionTree& tree, const ModeRules& rules,
                                                  const std::vector<Action>& done,
                                                  const std::vector<std::string>& opened);

  const SearchProblem& problem_;
  std::vector<Action> plan_;
  std::size_t next_ = 0;
  bool unfit_ = false;
  std::unique_ptr<Scene> believed_scene_;       // before the first plan
  std::unique_ptr<ExecutionTree> believed_;     // made of that
  std::unique_ptr<World> foreseen_;             // in it
  std::vector<Action> done_;                    // since the first plan
  std::set<std::string, std::less<>> touched_;  // what that changed
  std::vector<std::string> avoided_;
  Trouble trouble_;
};

}  // namespace unietp
