#pragma once

#include <string_view>
#include <vector>

#include "audit/guess.h"
#include "audit/shuffle.h"
#include "audit/thing_model.h"

namespace unietp {

/// The models for the part of the homes that a task belongs to.
struct ModelsOfPart {
  const ThingModel* small_things = nullptr;
  const ThingModel* of_kind = nullptr;
};

/// A policy that does without what a task needs: it names the option with the highest value, of equals one at random.
/// Its chance is what it reaches when what the channel names is shuffled and all else that it knows is left as it is.
struct ShortcutPolicy {
  std::string_view name;   // "last-listed"
  std::string_view knows;  // what it is allowed to know, for people; that alone is no leak
  GuessChoice choice = GuessChoice::SmallThing;
  const LeakChannel* channel = nullptr;  // what it tries to profit by
  float (*value)(const GuessOption& option, const ModelsOfPart& models) = nullptr;
};

/// All policies, in the order of the report.
const std::vector<ShortcutPolicy>& shortcut_policies();

}  // namespace unietp
