#include "sense/special_places.h"

#include <algorithm>

#include "akb/row_reader.h"
#include "core/files.h"
#include "core/text.h"
#include "sense/word_kinds.h"

namespace unietp {

bool SpecialPlaces::may_hold(std::string_view place, std::string_view kind, const Kinds& kinds) const {
  const auto found = holds_.find(normal_word(place));
  return found == holds_.end() || std::any_of(found->second.begin(), found->second.end(),
                                              [&](const std::string& held) { return kinds.is_a(kind, held); });
}

SpecialPlaces read_special_places(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return {};
  }
  RowReader row(path.string(), *text, {"places", "holds", "source"}, errors);
  std::map<std::string, std::vector<std::string>, std::less<>> holds;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const std::string held = row.required("holds");
    const auto all = held == "-" ? std::vector<std::string>() : split(held, '|');
    for (const auto& kind : all) {
      if (kinds.find(kind) == nullptr) row.fail("holds", "'" + kind + "' is not a kind of kinds.csv");
    }
    for (const auto& place : split(row.required("places"), '|')) {
      if (!holds.try_emplace(place, all).second) row.fail("places", "'" + place + "' stands twice");
    }
  }
  return SpecialPlaces(std::move(holds));
}

}  // namespace unietp
