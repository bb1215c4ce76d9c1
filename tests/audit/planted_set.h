#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/rng.h"
#include "record/dataset_reader.h"

namespace unietp::testing {

/// A task of a made-up set, and what policies are asked about it.
struct MadeTask {
  FinishedTask task;
  std::string small_thing, furniture;  // ids: of what the goal moves, and onto what
  std::vector<std::string> kind;       // ids of the things of the kind that a phrase refers to; the first is meant
};

/// Tasks in homes drawn at random, whose goals are drawn from what a home has: two thirds refer to one of several mugs
/// or of several cabinets by color. Nothing but the color tells which.
std::vector<MadeTask> made_set(int homes, Rng rng);

/// A leak that a policy profits by: does to a thing, or to its home, what gives it away.
struct Plant {
  std::string_view policy;
  enum class On { SmallThing, Furniture, OfKind } on;  // what it is done to
  void (*apply)(MadeTask& made, const std::string& id, Rng& rng);
};
const std::vector<Plant>& plants();

/// The set with a leak: in most tasks it is done to what is right (or, `is_aimed` false, to one of the things that
/// might be).
std::vector<MadeTask> planted(std::vector<MadeTask> made, const Plant& plant, bool is_aimed, Rng rng);

}  // namespace unietp::testing
