#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "core/least_first.h"
#include "expert/attempt.h"
#include "expert/put_down_options.h"
#include "expert/repositioning.h"
#include "logic/formula.h"

namespace unietp {

/// Brings literals about by actions in an attempt: reaching, opening what is in the way, freeing a hand, choosing tools
/// and places, each with the next best option when one fails.
class Methods {
 public:
  /// `relevant`: categories that the goal speaks of; things are put aside elsewhere if possible.
  /// `avoided`: ids of tools that are taken only where no other will do.
  /// `clears`: things that are in the way are carried away; else another witness or place is left to be tried.
  Methods(Attempt& attempt, std::vector<std::string> relevant, std::vector<std::string> avoided, bool clears)
      : attempt_(attempt), relevant_(std::move(relevant)), shunned_(std::move(avoided)), clears_(clears) {}
  /// Something failed for want of room, so clearing may help.
  static bool lacked_room(const Attempt& attempt);

  /// True when the literal holds afterwards.
  bool achieve(const Literal& literal);

 private:
  bool wipe_off(const Literal& literal);
  bool pour_away(EntityIndex vessel);
  bool change_state(const Literal& literal);
  bool with_held_tool(const Literal& literal, ActionType action, Treatment treatment);
  bool with_tool_on_held(const Literal& literal, ActionType action, Treatment treatment);
  bool pour_from_vessel(const Literal& literal);
  bool in_appliance(const Literal& literal, Treatment treatment);
  bool place(const Literal& literal);
  bool place_in_room(const std::string& id, const std::string& room);
  bool put_down_in(const std::string& id, const std::string& room);
  bool place_beside(const std::string& id, const std::string& neighbor);
  bool set_beside(const std::string& id, const std::string& neighbor);
  std::vector<Action> ways_beside(const std::string& neighbor) const;
  bool let_fall(const std::string& id, const std::string& room);
  bool put_shut(const std::string& id, ActionType action, const std::string& target);
  bool put_in_grasp(const std::string& id, ActionType action, const std::string& target);
  bool put_so_that(const std::string& id, const std::vector<Action>& then);
  bool put_out_of_the_way(const std::string& id, const Action& action);
  bool make_room(const std::string& id, ActionType action, const std::string& target);
  bool carry_away(const std::string& other, const std::string& id, const std::string& target);
  bool leave_room(const std::string& id, ActionType action, const std::string& target);
  bool nest(const std::string& id, const std::string& target);
  bool put_together(const std::string& id, const std::string& neighbor);
  bool reopen(const std::string& id, ActionType action, const std::string& target);
  std::vector<std::string> in_the_way_on(const std::string& target, const std::string& but) const;
  std::string next_for(const std::string& target, const std::string& but) const;
  bool still_opens(const std::string& id) const;
  Postcondition room_at(const std::string& id, ActionType action, const std::string& target) const;
  bool unblock(ActionType action, const std::string& id);
  bool shut_in_the_way(ActionType action, const std::string& id);
  PutDownOptions put_down_options(const std::string& id, const std::string& room, const std::string& except) const;
  bool is_named(const std::string& id) const;
  bool take_away(const Literal& literal);

  bool hold(const std::string& id);
  bool free_hand(const std::string& wanted);
  bool put_aside(const std::string& id, const std::string& except = {});
  bool put(const std::string& id, ActionType action, const std::string& target);
  bool open_around(const std::string& id);
  bool stand_up();
  bool applies(ActionRule rule) const;
  bool bring_about(const ActionNeed& need, const std::string& id, Predicate aim);
  bool directly(ActionType action, const std::string& id);
  bool do_at(ActionType action, const std::string& id);
  std::vector<std::vector<Action>> ways_to_shut_a_door(const std::string& id) const;
  bool shut_out_of_the_way(const std::string& id);
  bool from_elsewhere(const Action& action, const std::string& about, const Postcondition& aim);
  bool works(const std::vector<Action>& steps) const;
  bool works_at(const Action& action) const;
  bool is(const std::string& id, Predicate state) const;
  const Node* find(const std::string& id) const;

  using ToolRank = std::tuple<bool, bool, double, std::string>;  // avoided, not in hand, meters away, id
  using Tools = LeastFirst<std::string, ToolRank>;
  Tools nearest_of(const std::vector<const Effect*>& rules, const std::string& except) const;

  Attempt& attempt_;
  std::vector<std::string> relevant_, shunned_;
  bool clears_;
  bool pours_ = false;  // a vessel is being filled to be poured from
};

}  // namespace unietp
