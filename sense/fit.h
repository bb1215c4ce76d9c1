#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "sense/items.h"

namespace unietp {

/// Where the items are read from.
struct SenseSources {
  std::filesystem::path metadata;    // folder with virtualhome/, housekeep/, ai2thor/ (docs/sense.md)
  std::filesystem::path activities;  // of BEHAVIOR
  std::filesystem::path bddl;        // data/bddl: the synsets of BEHAVIOR's categories
};

/// The synsets of data/bddl/synsets.csv with their categories, sorted. Errors: Io, Parse.
Result<std::vector<std::pair<std::string, std::string>>> read_category_synsets(const std::filesystem::path& bddl);

/// The items of all sources, source by source. Errors: Io, Parse.
Result<std::vector<Item>> read_items(const SenseSources& sources, const Vocabulary& vocabulary);

/// Adds up the items that count: one row for each kind, role and source, with its heaviest item as the example. Sorted.
std::vector<Evidence> add_up(std::span<const Item> items);

/// Writes categories.csv, counts.csv and companions.csv into a folder; reads kinds.csv, words.csv and hypernyms.csv of
/// `tables`. Deterministic. Errors: Io, Parse, Schema.
Result<Done> fit_sense_into(const std::filesystem::path& folder, const std::filesystem::path& tables,
                            const SenseSources& sources, const std::vector<Knowledge>& knowledge);

}  // namespace unietp
