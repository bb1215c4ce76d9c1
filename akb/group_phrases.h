#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "akb/rows.h"
#include "core/error.h"

namespace unietp {

/// What things of a group are for and when one wants them, for people to read: "something to drink from", "I am
/// thirsty." A group is a synset or a kind of kinds.csv.
class GroupPhrases {
 public:
  /// `kind` is Function or Context. Phrases keep the order in which they were added.
  void add(const std::string& group, AliasKind kind, const std::string& text);
  /// The phrases of a kind that the first group with any has.
  std::vector<std::string> of(const std::vector<std::string>& groups, AliasKind kind) const;

 private:
  std::map<std::pair<std::string, AliasKind>, std::vector<std::string>> texts_;  // by group and kind
};

/// Reads curated/phrases.csv (group,kind,text). Errors are appended, with line and column.
GroupPhrases read_group_phrases(const std::filesystem::path& path, std::vector<Error>& errors);

}  // namespace unietp
