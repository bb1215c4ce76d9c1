#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "sense/evidence.h"
#include "sense/hypernyms.h"
#include "sense/kinds.h"
#include "sense/word_kinds.h"

namespace unietp {

/// One thing that somebody wrote of a thing in a role, before items are added up.
struct Item {
  Evidence evidence;
  std::string group;   // the activity, title or object that it belongs to: what is held out together
  bool counts = true;  // false for votes that speak against it: they are only checked
};

/// What the readers need to understand upstream's words.
struct Vocabulary {
  const Kinds& kinds;
  const WordKinds& words;
  const Hypernyms& net;
  std::vector<std::pair<std::string, std::string>> synsets;  // synset and category of BEHAVIOR, sorted
};

/// The role of a thing being at a place that is only named, without a trusted relation: "in:fridge".
Role usual_place(const Kinds& kinds, const std::string& place);

/// VirtualHome's activity programs (activity_programs.jsonl.gz): what people put where, and what they did with things.
/// Equal steps of programs of one title are one item of weight 1 + (times - 1) / 8, at most 4. Errors: Io, Parse.
Result<std::vector<Item>> program_items(const std::filesystem::path& file, const Vocabulary& vocabulary);
/// BEHAVIOR's activity definitions: each literal of a goal, once for an activity. The folder holds
/// `<activity>/problem0.bddl` or `<activity>__problem0.bddl`. Things of shops, streets and laboratories are left out.
/// Errors: Io, Parse with line and column.
Result<std::vector<Item>> activity_items(const std::filesystem::path& folder, const Vocabulary& vocabulary);
/// Housekeep's votes (preferences.csv.gz): an item for each object, room and receptacle, of weight
/// 0.06 * (votes - 5), where votes is how many of ten said that it belongs there. Only with six or more votes it counts
/// as a place of the thing. Errors: Io, Parse.
Result<std::vector<Item>> vote_items(const std::filesystem::path& file, const Vocabulary& vocabulary);
/// ProcTHOR's placements (procthor_receptacles.json), of weight count / 4, at most 3. Errors: Io, Parse.
Result<std::vector<Item>> placement_items(const std::filesystem::path& file, const Vocabulary& vocabulary);

}  // namespace unietp
