#include "akb/kind_groups.h"

#include <algorithm>
#include <array>

#include "akb/row_reader.h"
#include "core/files.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, kKindGroupCount> kKindGroups{
    "food",           "heated_vessel", "stove_ware", "oven_ware", "microwave_ware", "filled",
    "dirtied",        "soaked",        "heater",     "cooler",    "washer",         "laundry",
    "worn_or_spread", "seasoning",     "seasoned",   "washed_up", "cleaned",        "holds_nothing",
    "flat_food",      "open_flame",    "microwave",  "freezer",   "under_tap",      "washes_laundry",
    "kitchen_blade",  "cleaner",       "brewer",     "brewed",    "no_receptacle"};

}  // namespace

std::string_view name_of(KindGroup group) { return kKindGroups[static_cast<std::size_t>(group)]; }

KindGroups read_kind_groups(const std::filesystem::path& path, std::vector<Error>& errors) {
  KindGroups groups;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return groups;
  }
  const std::vector<std::string> names(kKindGroups.begin(), kKindGroups.end());
  RowReader row(path.string(), *text, {"group", "kind", "source"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto name = row.one_of("group", names, "group");
    auto kind = row.required("kind");
    if (!row.sound()) continue;
    const auto at = std::find(names.begin(), names.end(), name) - names.begin();
    groups[static_cast<KindGroup>(at)].insert(std::move(kind));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!groups.contains(static_cast<KindGroup>(i)))
      errors.push_back(
          {Error::Kind::Schema, path.string(), {}, "no row of the group '" + names[i] + "'; expected one or more"});
  }
  return groups;
}

}  // namespace unietp
