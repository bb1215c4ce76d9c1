#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "exports/bddl_words.h"
#include "exports/behavior_halves.h"
#include "exports/ltlf_formula.h"

namespace unietp {

/// What the objects of a problem are called, by our ids; halves of what can be cut by the entities of a HalvedTrace.
using BddlNames = std::map<std::string, std::string>;

/// A goal over literals of BDDL.
struct BehaviorGoal {
  LtlfGoal goal;                                  // grounded in the objects of the start and the halves that may come
  std::map<std::string, std::string> literals;    // the BDDL formula of each proposition, by its name
  std::vector<std::vector<std::string>> holding;  // at the start and at each moment since, names of those that hold
  std::string last;                               // what the last state must meet, in BDDL
  bool last_decides = true;                       // whether that is the whole goal
  std::set<std::string> objects;                  // ids of the things that it names, without halves
  std::set<std::string> floors;                   // ids of the rooms whose floors it names
  std::set<std::string> substances;               // synsets of those that it names
};

/// The goal of a task of BEHAVIOR, where a thing that is cut becomes two halves, and each counts as a piece. `floors`:
/// what the floors of rooms are called. Errors: Unsatisfiable with the reason: what LTLf does not say, what BDDL has no
/// word for, a goal that the halves change: at some step of the demonstration it is true with them and not without, or
/// the other way around.
Result<BehaviorGoal> behavior_goal(const FinishedTask& task, const Knowledge& knowledge, const BddlWords& words,
                                   const BddlNames& names, const BddlNames& floors);

}  // namespace unietp
