#include "sense/generic_words.h"

#include <algorithm>

#include "akb/row_reader.h"
#include "core/text.h"
#include "sense/word_kinds.h"

namespace unietp {

bool GenericWords::may_mean(std::string_view name, std::string_view kind, const Kinds& kinds) const {
  const auto found = names_.find(normal_word(name));
  return found != names_.end() && std::any_of(found->second.begin(), found->second.end(),
                                              [&](const std::string& wider) { return kinds.is_a(kind, wider); });
}

bool GenericWords::contains(std::string_view name) const { return names_.contains(normal_word(name)); }

GenericWords read_generic_words(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  std::map<std::string, std::vector<std::string>, std::less<>> names;
  each_row(path, {"words", "kinds", "source"}, errors, [&](RowReader& row) {
    const auto covered = row.list("kinds");
    if (covered.empty()) row.fail("kinds", "expected kinds of kinds.csv");
    for (const auto& kind : covered) {
      if (kinds.find(kind) == nullptr) row.fail("kinds", "'" + kind + "' is not a kind of kinds.csv");
    }
    for (const auto& word : split(row.required("words"), '|')) {
      if (!names.try_emplace(word, covered).second) row.fail("words", "'" + word + "' stands twice");
    }
    row.required("source");
  });
  return GenericWords(std::move(names));
}

}  // namespace unietp
