#pragma once

#include <set>
#include <utility>
#include <vector>

#include "annotator/clause.h"
#include "annotator/home_counts.h"
#include "core/result.h"
#include "core/rng.h"

namespace unietp {

/// The content and order of a text, before words are chosen. Every noun phrase of a variable that is the same
/// throughout the text is `New` and carries the variable: the wording decides between "a mug", "that mug" and "it".
struct Plan {
  Message message;
  std::set<std::pair<std::string, std::string>> distinct;  // variables said to be different objects, both ways
  std::vector<NounPhrase> conditions;                      // that the start meets: "a fridge is closed"
};

/// What a plan may contain.
struct PlanOptions {
  bool choosing = false;    // may start with "Choose a kitchen.", which fixes the scope of what follows
  bool conditions = false;  // fill in Plan::conditions
  bool everyday = false;    // says the order of two things with the things themselves
  bool exactly = false;     // operator by operator, as one proposition: any goal has such words
  HomeCounts home = {};
};

/// Deterministic in rng, which chooses among equal orders and groupings. `goal` is `expanded` (meaning.h), or,
/// `exactly`, any. `start`: the start constraints; where they say that there are exactly two of something, the text may
/// say "both". What no clause can say is stated operator by operator. Errors: Unsatisfiable, naming the part of the
/// goal that has no words; `exactly` has none.
Result<Plan> plan_message(const Formula& goal, const std::vector<Formula>& start, PlanOptions options, Rng rng);

}  // namespace unietp
