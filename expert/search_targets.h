#pragma once

#include <vector>

#include "expert/belief.h"
#include "expert/search_needs.h"
#include "expert/search_order.h"
#include "expert/search_problem.h"

namespace unietp {

/// What an agent of M2 or M3 still has to look for, by what its goal needs and what it believes.
class SearchTargets {
 public:
  /// All must outlive it. `profile`: of the mode.
  SearchTargets(const SearchProblem& problem, const SearchNeeds& needs, const Profile& profile, const Belief& belief,
                const SearchOrder& order)
      : problem_(problem), needs_(needs), profile_(profile), belief_(belief), order_(order) {}

  /// What has to be found before it is worth while to plan; empty when nothing has.
  std::vector<SearchTarget> missing() const;
  /// Of what the goal speaks of all of, where there may well be more.
  std::vector<SearchTarget> overlooked() const;
  /// All that the goal needs.
  std::vector<SearchTarget> all() const;

 private:
  bool points() const { return problem_.mode == Mode::M3; }
  bool is_known(const std::string& category) const { return known_of({category}) > 0; }
  int known_of(const std::vector<std::string>& categories) const;
  bool is_movable(const std::string& category) const;
  void add(std::vector<SearchTarget>& targets, const SearchNeed& need) const;
  void add_unseen(std::vector<SearchTarget>& targets, const WantedState& wanted) const;

  const SearchProblem& problem_;
  const SearchNeeds& needs_;
  const Profile& profile_;
  const Belief& belief_;
  const SearchOrder& order_;
};

}  // namespace unietp
