#include "akb/group_phrases.h"

#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "akb/tables.h"
#include "core/files.h"

namespace unietp {

void GroupPhrases::add(const std::string& group, AliasKind kind, const std::string& text) {
  texts_[{group, kind}].push_back(text);
}

std::vector<std::string> GroupPhrases::of(const std::vector<std::string>& groups, AliasKind kind) const {
  for (const auto& group : groups) {
    const auto found = texts_.find({group, kind});
    if (found != texts_.end()) return found->second;
  }
  return {};
}

GroupPhrases read_group_phrases(const std::filesystem::path& path, std::vector<Error>& errors) {
  GroupPhrases phrases;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return phrases;
  }
  RowReader row(path.string(), *text, {"group", "kind", "text"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto group = row.required("group");
    const AliasKind kind = read_alias_kind(row);
    const auto words = row.required("text");
    if (row.sound()) phrases.add(group, kind, words);
  }
  return phrases;
}

}  // namespace unietp
