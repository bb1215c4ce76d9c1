#pragma once

#include <vector>

#include "expert/estimate.h"
#include "expert/subgoal.h"

namespace unietp {

/// Lists of alternatives as an algebra: one of several, all of several, k of several. Every list is sorted by cost,
/// free of repeats and at most `beam` long.
class Choices {
 public:
  Choices(const Situation& situation, const CostPenalties& experience, std::size_t beam)
      : situation_(situation), experience_(experience), beam_(beam) {}

  using List = std::vector<Alternative>;
  /// No way: it cannot be done.
  static List none() { return {}; }
  /// One way, which takes nothing.
  static List nothing_to_do() { return {Alternative{}}; }
  /// One way: to leave a truth as it is when it holds at the start, else to make it true.
  List single(Literal literal) const;
  /// The cheapest of both lists.
  List either(List a, List b) const;
  /// `to` becomes either(to, more).
  void add(List& to, List more) const;
  /// Every pair that does not contradict itself.
  List both(List a, const List& b) const;
  /// All of several lists, and truths that hold at the start.
  List all(const std::vector<const List*>& lists, std::vector<Literal> standing) const;
  /// As `both`, but nothing has to hold together: the parts are moments of their own.
  List in_turn(const List& a, const List& b) const;

  struct Member {
    List yes, no;  // ways to make it one of those counted, and not
  };
  /// Exactly, at least or at most k of the members.
  List exactly(int k, const std::vector<Member>& members) const;
  List at_least(int k, const std::vector<Member>& members) const;
  List at_most(int k, const std::vector<Member>& members) const;

 private:
  List trimmed(List list) const;
  void leave_out_costlier(List& list, const List& than) const;
  List with_standing(const List& list, const std::vector<const List*>& others, std::vector<Literal> standing) const;
  void add_all_of(List& to, const std::vector<const List*>& lists, std::vector<Literal> standing) const;
  std::vector<std::vector<bool>> picks(std::size_t k, const std::vector<double>& price) const;

  const Situation& situation_;
  const CostPenalties& experience_;
  std::size_t beam_;
};

}  // namespace unietp
