#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/result.h"
#include "exports/bddl_words.h"
#include "exports/ltlf_formula.h"
#include "record/dataset_reader.h"

namespace unietp {

/// The numbers of an ability: what something cooks at, in °C; how hot or cold a source is, in °C, and the share of the
/// difference that it makes up in a second. 0 for abilities without numbers.
struct BehaviorAbility {
  double celsius = 0, rate_per_s = 0;
};
/// What BEHAVIOR's annotations say that things can do or undergo, by synset; one that is missing can do nothing of it.
/// The words are those of data/bddl/abilities.csv, and BEHAVIOR's but for "gives_water", a source of it; "takes_water"
/// and "wipes_stains", of what removes water, or stains without a cleaning agent; and "saturable", of all that removes
/// something.
using BehaviorAbilities = std::map<std::string, std::map<std::string, BehaviorAbility, std::less<>>, std::less<>>;

/// Errors: Io; those of a table that is none.
Result<BehaviorAbilities> read_behavior_abilities(const std::filesystem::path& file);

/// Why OmniGibson's primitives refuse the demonstration in M1, do not lead where it leads, or have no state for a goal;
/// "" where nothing of that is known. Things whose category has no synset, and halves, are not asked about. Source:
/// OmniGibson 1.1.1, its symbolic primitives, object states and their temperatures.
std::string denied_by_omnigibson(const FinishedTask& task, const LtlfGoal& goal, const BddlSynsets& synsets,
                                 const BehaviorAbilities& abilities);

}  // namespace unietp
