#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "akb/rows.h"
#include "core/result.h"

namespace unietp {

class RowReader;

/// One simulator's tables as they stand in its six CSV files.
struct Tables {
  std::vector<Category> categories;
  std::vector<AffordanceFact> affordances;
  std::vector<Placement> placements;
  std::vector<Effect> effects;
  std::vector<Alias> aliases;
  std::vector<Asset> assets;
};

/// The six table names in their order: category, affordance, relation, effect, alias, asset.
const std::vector<std::string>& table_names();
/// The columns that a table must have, in any order.
const std::vector<std::string>& columns_of(std::string_view table);

/// Cells that several tables have: the column `needs`, and `kind` of an alias.
std::vector<EffectNeed> read_needs(RowReader& row);
AliasKind read_alias_kind(RowReader& row);

/// Reads and checks `<folder>/{category,...}.csv`; appends every problem to `errors` (Schema, Parse or Io with file,
/// line and column). Rows with a problem are left out. Lists are joined by `|` in their cell.
Tables read_tables(const std::filesystem::path& folder, std::vector<Error>& errors);

/// The tables of the four simulators in `<folder>/<simulator>/`, in the order of kSimulators and sorted, with completed
/// facts (completed.h) laid under them, and `<folder>/override.csv` (where there is one) and then each of `overrides`
/// over them, and the kinds and functions of lay_kinds.h. Errors: as above, and
/// those of read_overrides and apply_overrides; overrides are looked at only when the tables are sound.
std::vector<Tables> read_all_tables(const std::filesystem::path& folder,
                                    const std::vector<std::filesystem::path>& overrides, std::vector<Error>& errors);
/// The same without completed facts: what other sources than language models state.
std::vector<Tables> read_stated_tables(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& overrides, std::vector<Error>& errors);

/// Sorts each table by its key, the order in which files and queries give them.
void sort_tables(Tables& tables);

/// The text of one table (`table` as in table_names) with all columns and a header; equal tables give equal bytes.
std::string table_csv(const Tables& tables, std::string_view table);
/// Writes the six files of one simulator. Errors: Io.
Result<Done> write_tables(const std::filesystem::path& folder, const Tables& tables);

}  // namespace unietp
