#pragma once

#include <set>
#include <string>
#include <vector>

#include "logic/formula.h"
#include "scene/states.h"

namespace unietp {

/// Whether a list of categories, types of rooms or ids holds one.
bool holds(const std::vector<std::string>& list, const std::string& one);

/// Things that have to be known of before a goal can be planned for.
struct SearchNeed {
  std::vector<std::string> categories;  // of any of these; or types of rooms
  int at_least = 1;
  bool every = false;                    // the goal speaks of each of them, so none may be overlooked
  std::vector<std::string> places = {};  // categories of what the goal says they are on or in; empty: anywhere
  std::vector<std::string> rooms = {};   // types of rooms that the goal says they are in; empty: any
  bool floor = false;                    // the goal says that they are on the floor
  std::vector<std::string> near = {};    // categories of what the goal says one of them is the nearest to
};

/// A state that a goal asks for, or says that things are in.
struct WantedState {
  std::vector<std::string> categories;
  State state;
  bool positive = true;
  bool stated = false;  // in a `:where`: they are so at the start
  /// It is a color or material, which shows in a picture alone and never changes.
  bool is_look() const { return state.predicate == Predicate::Color || state.predicate == Predicate::Material; }
};

/// What the text of a goal tells somebody who has to look for things first.
struct SearchNeeds {
  std::vector<SearchNeed> needs;
  std::vector<WantedState> states;
  std::set<std::string> shut;  // categories that the goal keeps shut, or wants to be opened after something else
};
/// Depends on the goal alone.
SearchNeeds search_needs(const Formula& goal);

}  // namespace unietp
