#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "akb/facts.h"
#include "akb/tables.h"
#include "scene/simulator.h"

namespace unietp {

/// One row of an override file: what somebody knows better than all tables.
struct Override {
  Simulator simulator = Simulator::Ai2thor;
  std::string category;
  FactName fact;
  std::string value;   // as it stands in the file; apply_overrides reads it
  std::string reason;  // for people
  SourcePos category_at, fact_at, value_at;
};

/// The override files in the order in which they win: `<tables>/override.csv` if there is one, then `own`.
std::vector<std::filesystem::path> override_files(const std::filesystem::path& tables,
                                                  const std::vector<std::filesystem::path>& own);

/// `override:<file>` for facts that the file of this path decides; blanks in its name become `_`.
std::string override_source(const std::filesystem::path& file);

/// Reads an override file: columns simulator, category, fact, value, reason. Appends to `errors` (Parse, Schema with
/// line and column): those of read_csv, an unknown simulator or fact, no reason, two rows for one fact. Faulty rows are
/// left out.
std::vector<Override> read_overrides(const std::string& where, std::string_view text, std::vector<Error>& errors);

/// Lays overrides over the tables of the four simulators (in the order of kSimulators), row after row; what they set
/// has `override_source(where)` as its source, confidence 1. Values:
///   properties             a text; true or false; `0.3 x 0.2 x 0.1` meters; kilograms; words joined by `|`
///   an affordance          true or false; `pickupable` and `movable` go together
///   on:C, inside:C, ...    true, false or the likelihood; a new one gets the mean likelihood of the object's others
///                          (1 if it has none) and as many as fit
///   on:C:capacity          a whole number
///   heats:C, fills:C, ...  true, false, or what it gives; `5 C` of slicing; a new one needs what the tool's others
///   need heats:C:needs          words joined by `|` alias:TEXT             true (a synonym), false, or the kind
///   asset:NAME             false, or its size
/// Errors (Schema, at the cell): a category that the simulator lacks, with the nearest; a value that does not read; a
/// detail of a fact that does not hold.
void apply_overrides(const std::string& where, const std::vector<Override>& overrides, std::vector<Tables>& all,
                     std::vector<Error>& errors);

}  // namespace unietp
