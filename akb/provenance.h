#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "akb/facts.h"

namespace unietp {

/// Where a source's facts come from and on what terms they are used.
struct License {
  std::string prefix;  // a source begins with it
  std::string origin, license;
};
/// Reads data/licenses.csv (source, origin, license). Errors appended: Io, Parse, Schema.
std::vector<License> read_licenses(const std::filesystem::path& file, std::vector<Error>& errors);
/// The longest prefix of a source, or nothing when no row allows it.
std::optional<License> license_of(const std::vector<License>& licenses, std::string_view source);

/// What a rule of `derived:<rule>` says, in words.
struct RuleMeaning {
  std::string rule, meaning;
};
/// Reads data/akb/rules.csv (rule, meaning). Errors appended: Io, Parse, Schema.
std::vector<RuleMeaning> read_rules(const std::filesystem::path& file, std::vector<Error>& errors);
/// The meaning of `derived:<rule>`; nothing for another source or an unexplained rule.
std::optional<std::string> meaning_of(const std::vector<RuleMeaning>& rules, std::string_view source);

/// A row written by hand that says something of a fact.
struct CuratedRow {
  std::string file;  // below the folder that was searched: "ai2thor/category.csv"
  int line = 0;
};
/// Rows of the hand-written tables in `<curated>/` and `<curated>/<simulator>/` that decide or once fed this fact, by
/// their columns: a cell of the category, the words of its display name, the same pair, the same alias. In order of
/// file name and line; files that do not read are passed over.
std::vector<CuratedRow> curated_rows(const std::filesystem::path& curated, Simulator simulator,
                                     const Category& category, const FactName& fact);

}  // namespace unietp
