#include "search_judge.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "expert/rollout.h"
#include "expert/search_needs.h"
#include "expert/search_tools.h"

namespace unietp {
namespace {

/// What is known of a home: things by category, with the rooms by type.
class Known {
 public:
  explicit Known(const Scene& told) {
    for (const Room& room : told.rooms) add(room.id, room.type);
    for (const Node& node : told.nodes) add(node.id, node.category);
  }
  void see(const std::vector<Node>& view) {
    for (const Node& node : view) {
      add(node.id, node.category);
      seen_.insert(node.id);
    }
  }
  bool has(const std::string& id) const { return ids_.contains(id); }
  bool has_seen(const std::string& id) const { return seen_.contains(id); }
  int count(const std::vector<std::string>& categories) const {
    int known = 0;
    for (const std::string& category : std::set(categories.begin(), categories.end())) {
      const auto of_it = by_category_.find(category);
      known += of_it == by_category_.end() ? 0 : of_it->second;
    }
    return known;
  }

 private:
  void add(const std::string& id, const std::string& category) {
    if (ids_.insert(id).second) ++by_category_[category];
  }
  std::set<std::string> ids_, seen_;
  std::map<std::string, int> by_category_;
};

bool has_what_the_goal_asks_for(const Known& known, const SearchNeeds& needs, const Knowledge& knowledge,
                                const Profile& profile) {
  for (const SearchNeed& need : needs.needs) {
    if (known.count(need.categories) < need.at_least) return false;
  }
  for (const WantedState& wanted : needs.states) {
    if (wanted.stated) continue;
    for (const std::string& category : wanted.categories) {
      const auto tools = tools_for(wanted, category, knowledge, profile);
      if (!tools.empty() && known.count(tools) == 0) return false;
    }
  }
  return true;
}

/// Whether it is enough to be told where a thing is: one goes or turns there. M2 tells neither the states and the look
/// of furniture nor what is on it or in it.
bool only_leads_there(ActionType type) {
  const ActionClass group = info(type).group;
  return group == ActionClass::Movement || group == ActionClass::Reach;
}

/// Whether a step leads to what the next one acts on that does more than lead somewhere: it is the way there, even
/// where that works from where it began, too.
bool is_the_way_to_what_is_used(std::size_t step, const std::vector<Action>& done) {
  if (info(done[step].type).group != ActionClass::Reach) return false;
  for (std::size_t i = step + 1; i < done.size(); ++i) {
    if (!only_leads_there(done[i].type)) return done[i].args == done[step].args;
  }
  return false;
}

}  // namespace

bool speaks_of_every(const Formula& goal) {
  const SearchNeeds needs = search_needs(goal);
  return std::any_of(needs.needs.begin(), needs.needs.end(), [](const SearchNeed& need) { return need.every; });
}

JudgedSearch judged_search(const EnvironmentTask& task, Mode mode, const Scene& told,
                           const std::vector<std::vector<Node>>& views, const std::vector<Action>& done,
                           const std::vector<bool>& search) {
  const SearchNeeds needs = search_needs(task.goal);
  const Profile profile = profile_in(mode, *task.data.profile);
  Known known(told);
  const auto knows_what_is_acted_on = [&](std::size_t from) {
    for (std::size_t i = from; i < done.size(); ++i) {
      for (std::size_t k = 0; !search[i] && k < done[i].args.size(); ++k) {
        const bool was_there = find_node(task.start, done[i].args[k]) != nullptr;  // no slice, which is made by a step
        const std::string& name = done[i].args[k];
        if (was_there && !(only_leads_there(done[i].type) ? known.has(name) : known.has_seen(name))) return false;
      }
    }
    return true;
  };
  JudgedSearch judged;
  for (judged.enough = 0; judged.enough < done.size(); ++judged.enough) {
    known.see(views[judged.enough]);
    if (has_what_the_goal_asks_for(known, needs, *task.data.knowledge, profile) &&
        knows_what_is_acted_on(judged.enough))
      break;
  }
  for (std::size_t i = judged.enough; i < search.size(); ++i) {
    if (search[i] && !is_the_way_to_what_is_used(i, done)) judged.late.push_back(i);
  }
  if (judged.late.empty()) return judged;
  auto executions = ExecutionTree::of(task.goal, task.start, *task.data.knowledge, *task.data.profile);
  EXPECT_TRUE(executions) << format(executions.error());
  for (const std::size_t left_out : judged.late) {
    Rollout without(*executions, rules_of(mode));
    for (std::size_t i = 0; i < done.size(); ++i) {
      if (i != left_out) (void)without.go_on(done[i]);
    }
    if (without.reaches_goal()) judged.needless.push_back(left_out);
  }
  return judged;
}

}  // namespace unietp
