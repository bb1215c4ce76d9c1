#include "akb/lay_phrases.h"

#include <algorithm>
#include <set>

#include "akb/row_reader.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

bool lists(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// A row of phrases.csv.
struct PhraseRow {
  AliasKind use = AliasKind::Hypernym;
  std::vector<std::string> phrases, kinds, also, except;
  std::string source;
};

/// Whether a list has the category, by its name or by what it is called: "coffeepot", "coffee_pot".
bool lists_category(const std::vector<std::string>& list, const Category& category) {
  return lists(list, lower(category.name)) || lists(list, replace_all(lower(category.display), " ", "_"));
}

bool is_of(const Category& category, const PhraseRow& row) {
  if (lists_category(row.except, category)) return false;
  return lists_category(row.also, category) || std::any_of(category.kinds.begin(), category.kinds.end(),
                                                           [&](const auto& kind) { return lists(row.kinds, kind); });
}

/// The phrases of the row that is read; of a request with its state in front.
std::vector<std::string> phrases_of(RowReader& row, AliasKind use) {
  auto phrases = row.list("phrases");
  if (phrases.empty()) row.fail("phrases", "expected at least one phrase");
  const auto state = row.text("state");
  if ((use == AliasKind::Request) != !state.empty())
    row.fail("state", "a state stands with requests, and only with them");
  if (!state.empty() && !predicate_named(state)) row.fail("state", "'" + state + "' is not a state");
  for (auto& phrase : phrases) {
    const bool sentence = use == AliasKind::Occasion || use == AliasKind::Request;
    if (sentence != phrase.ends_with('.')) row.fail("phrases", "sentences, and only they, end with a full stop");
    if (!state.empty()) phrase.insert(0, state + " ");
  }
  return phrases;
}

}  // namespace

void lay_phrases(const fs::path& tables, std::vector<Tables>& all, std::vector<Error>& errors) {
  const auto file = tables.parent_path() / "sense" / "phrases.csv";
  std::error_code code;
  if (!fs::exists(file, code)) return;
  const auto text = read_file(file);
  if (!text) return errors.push_back(text.error());
  std::set<std::string> kinds, seen;
  for (const auto& simulator : all)
    for (const auto& category : simulator.categories) kinds.insert(category.kinds.begin(), category.kinds.end());
  RowReader row(file.string(), *text, {"use", "state", "phrases", "kinds", "also", "except", "source"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    PhraseRow read;
    read.use = row.value_of("use", {"hypernym", "description", "occasion", "request"}, "use", alias_kind_named);
    read.phrases = phrases_of(row, read.use);
    read.kinds = row.list("kinds"), read.also = row.list("also"), read.except = row.list("except");
    read.source = row.required("source");
    for (const auto& phrase : read.phrases)
      if (!seen.insert(phrase).second) row.fail("phrases", "'" + phrase + "' stands twice");
    for (const auto& kind : read.kinds)
      if (!kinds.empty() && !kinds.contains(kind)) row.fail("kinds", "'" + kind + "' is not the kind of any category");
    if (!row.sound()) continue;
    for (auto& simulator : all)
      for (const auto& category : simulator.categories)
        if (is_of(category, read))
          for (const auto& phrase : read.phrases)
            simulator.aliases.push_back({category.name, phrase, read.use, {read.source, 1}});
  }
}

}  // namespace unietp
