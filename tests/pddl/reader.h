#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace unietp::testing {

/// PDDL as the standard has it, strictly: what is not declared, not of its type or not among the requirements is an
/// error. Shares no code with what writes it. A bracketed list, or a word in lower case.
struct PddlList {
  std::string word;  // "" for a list
  std::vector<PddlList> parts;
  bool is_word() const { return !word.empty(); }
};

struct PddlVariable {
  std::string name, type;
};

struct PddlAction {
  std::vector<PddlVariable> parameters;
  PddlList precondition, effect;
};

struct PddlDomain {
  std::string name;
  std::set<std::string> requirements;
  std::map<std::string, std::string> types;  // type, its parent
  std::map<std::string, std::vector<PddlVariable>> predicates;
  std::map<std::string, PddlAction> actions;
};

using PddlFact = std::vector<std::string>;  // "on", "a", "b"
using PddlState = std::set<PddlFact>;

struct PddlProblem {
  std::string name;
  std::map<std::string, std::string> objects;  // name, type
  PddlState init;
  PddlList goal;
};

/// Throws std::runtime_error with what is wrong.
PddlDomain read_pddl_domain(std::string_view text);
PddlProblem read_pddl_problem(std::string_view text, const PddlDomain& domain);
/// One action a line, "(go_to mug_1 table_1 kitchen_1)".
std::vector<PddlFact> read_pddl_plan(std::string_view text);

/// Executes grounded actions: effects' conditions are read before any effect, then what goes goes, then what comes
/// comes.
class PddlMachine {
 public:
  PddlMachine(const PddlDomain& domain, const PddlProblem& problem);
  const PddlState& state() const { return state_; }
  /// False, and nothing changes, when the precondition does not hold. Throws for an unknown action or wrong arguments.
  bool perform(const PddlFact& step);
  bool goal_holds() const;
  void reset(PddlState state) { state_ = std::move(state); }
  /// All steps whose preconditions hold now.
  std::vector<PddlFact> possible() const;

 private:
  using Scope = std::map<std::string, std::string>;
  bool is_of(const std::string& object, const std::string& type) const;
  bool holds(const PddlList& formula, const Scope& scope) const;
  PddlFact ground(const PddlList& atom, const Scope& scope) const;
  void collect(const PddlList& effect, const Scope& scope, PddlState& comes, PddlState& goes) const;
  template <class Use>
  void each(const std::vector<PddlVariable>& variables, std::size_t from, Scope& scope, Use use) const;
  void possible_from(const std::string& name, const PddlAction& action, Scope& scope, PddlFact& step,
                     std::vector<PddlFact>& found) const;
  bool may_hold(const PddlList& formula, const Scope& scope) const;

  const PddlDomain& domain_;
  const PddlProblem& problem_;
  PddlState state_;
};

/// Whether all steps can be done, and the goal holds after them.
bool reaches_goal(const PddlDomain& domain, const PddlProblem& problem, const std::vector<PddlFact>& plan);
/// The first step without which a plan reaches the goal too, but for those of the monitors, which follow each action
/// and are left out with it; "" when each is needed.
std::string needless_step(const PddlDomain& domain, const PddlProblem& problem, const std::vector<PddlFact>& plan);

/// The length of a shortest plan by breadth-first search, -1 when there is none of `most` steps.
int shortest_pddl_plan(const PddlDomain& domain, const PddlProblem& problem, int most);

std::vector<PddlVariable> pddl_variables(const PddlList& list, std::size_t from, bool variables);

}  // namespace unietp::testing
