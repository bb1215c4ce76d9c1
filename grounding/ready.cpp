#include "grounding/ready.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grounding/goal_places.h"
#include "grounding/likelihood.h"
#include "grounding/make_node.h"
#include "sense/action_roles.h"
#include "sense/wants.h"

namespace unietp {
namespace {

bool has_member(const Domain& domain, const std::string& category) {
  return std::any_of(domain.members.begin(), domain.members.end(),
                     [&](const Domain::Member& member) { return member.category == category; });
}

/// Whether the formula says of things of the category that they are, or are not, in a state of the group.
bool speaks_of(const Formula& formula, const std::string& category, std::string_view group,
               std::set<std::string> variables = {}) {
  using Op = Formula::Op;
  if (formula.op == Op::Atom)
    return info(formula.predicate).group == group && variables.contains(formula.terms.front().name);
  if (!formula.variable.empty()) {
    if (has_member(formula.domain, category))
      variables.insert(formula.variable);
    else
      variables.erase(formula.variable);
  }
  const auto speaks = [&](const Formula& part) { return speaks_of(part, category, group, variables); };
  return std::any_of(formula.domain.where.begin(), formula.domain.where.end(), speaks) ||
         std::any_of(formula.children.begin(), formula.children.end(), speaks);
}

class Ready {
 public:
  Ready(SceneEditor& editor, const Specification& specification) : editor_(editor), specification_(specification) {}

  void run(const std::function<bool()>& is_sound) {
    if (workspace().household() == nullptr) return;
    const Wants wants = wants_of(specification_.goal);
    for (const Want& want : wants.wants) {
      if (!want.negated) read(want, wants);
    }
    if (states_.empty()) return;
    editor_.refresh();
    std::vector<Node> before;
    for (const auto& [category, states] : states_) {
      for (const Predicate state : states) set_all(category, state, before);
    }
    if (before.empty()) return;
    editor_.refresh();
    if (is_sound()) return;
    for (const Node& node : before) editor_.replace(node);
    editor_.refresh();
  }

 private:
  Workspace& workspace() { return editor_.workspace(); }
  const Household& household() { return *workspace().household(); }

  void read(const Want& want, const Wants& wants) {
    const bool placed = want.predicate == Predicate::On || want.predicate == Predicate::Inside;
    for (const auto& thing : wants.things[want.thing].members) {
      if (!want.other) {
        // What is to be warmed up was cooked before it is cut.
        if (thing.slice && want.predicate != Predicate::Hot) continue;
        const std::string action(action_of(want.predicate));
        use(thing.category, want.predicate == Predicate::Filled ? "fill:" + want.symbol : action);
        continue;
      }
      if (!placed) continue;
      for (const auto& place : wants.things[*want.other].members) {
        if (!thing.slice) use(thing.category, household().role_at(want.predicate, place.category));
        use(place.category, std::string("carry:").append(household().kind_of(thing.category)));
      }
    }
  }

  void use(const std::string& category, const Role& role) {
    for (const Predicate state : household().states_in_use(category, role)) {
      const auto group = info(state).group;
      const auto says = [&](const Formula& one) { return speaks_of(one, category, group); };
      if (says(specification_.goal) || std::any_of(specification_.init.begin(), specification_.init.end(), says))
        continue;
      auto& states = states_[category];
      // Of two uses the first that the goal names decides.
      if (std::none_of(states.begin(), states.end(), [&](Predicate known) { return info(known).group == group; }))
        states.push_back(state);
    }
  }

  /// How many of the category the task may take: as many as the start has to have, or all.
  std::size_t needed(const std::string& category) const {
    for (const QuantifiedDomain& one : quantified_domains(specification_.goal)) {
      if (one.op == Formula::Op::Forall && has_member(one.domain, category))
        return std::numeric_limits<std::size_t>::max();
    }
    int most = 1;
    for (const Formula& start : specification_.init) {
      if (has_member(start.domain, category)) most = std::max(most, start.op == Formula::Op::Count ? start.number : 1);
    }
    return static_cast<std::size_t>(most);
  }

  void set_all(const std::string& category, Predicate state, std::vector<Node>& before) {
    std::vector<Node> others, waiting;
    std::size_t ready = 0;
    for (const std::size_t place : workspace().places().of(category)) {
      const Node& node = workspace().scene().nodes[place];
      if (!node.movable || !workspace().knowledge().has(category, info(state).group)) continue;
      const bool washed = at(node, [&](const std::string& host) { return household().washes(host); });
      if (node.states.has(state)) {
        ready += washed ? 0 : 1;
      } else if (share_in_state(workspace(), node, {state, {}}) >= kHardlyAny || state == Predicate::Clean) {
        const bool kept = at(node, [&](const std::string& host) { return household().puts_away(host); });
        if (state != Predicate::Dirty || !kept) (washed ? waiting : others).push_back(node);
      }
    }
    ready += others.size();
    if (state == Predicate::Clean && ready < needed(category))
      others.insert(others.end(), waiting.begin(), waiting.end());
    for (const Node& node : others) {
      before.push_back(node);
      Node after = node;
      after.states.set({state, {}});
      editor_.replace(after);
    }
  }

  /// Whether something that the node is on or in is of a category that meets the test.
  template <class Test>
  bool at(const Node& node, const Test& test) {
    const auto& present = workspace().current_state();
    const auto entity = present.reader().find(node.id);
    if (!entity) return false;
    const auto& trace = present.now();
    const auto& relations = trace.states.front().relations(*entity);
    return std::any_of(relations.begin(), relations.end(), [&](const auto& one) {
      if (one.first != Predicate::On && one.first != Predicate::Inside) return false;
      const auto host = workspace().places().find(trace.entities[one.second].id);
      return host && test(workspace().scene().nodes[*host].category);
    });
  }

  SceneEditor& editor_;
  const Specification& specification_;
  std::map<std::string, std::vector<Predicate>> states_;  // by category
};

}  // namespace

void make_ready(SceneEditor& editor, const Specification& specification, const std::function<bool()>& is_sound) {
  Ready(editor, specification).run(is_sound);
}

}  // namespace unietp
