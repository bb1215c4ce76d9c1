#include "sense/place_uses.h"

#include <algorithm>

#include "akb/row_reader.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {

std::string_view name_of(PlaceUse use) {
  switch (use) {
    case PlaceUse::Storage:
      return "storage";
    case PlaceUse::DirtyThings:
      return "dirty_things";
    case PlaceUse::DirtyOrNot:
      return "dirty_or_not";
    case PlaceUse::PutAway:
      return "put_away";
    case PlaceUse::OwnRooms:
      return "own_rooms";
    case PlaceUse::NotAtHand:
      return "not_at_hand";
    case PlaceUse::Passing:
      return "passing";
  }
  return "";
}

bool PlaceUses::has(std::string_view place, PlaceUse use, const Kinds& kinds) const {
  const auto found = kinds_.find(use);
  return found != kinds_.end() && std::any_of(found->second.begin(), found->second.end(),
                                              [&](const std::string& kind) { return kinds.is_a(place, kind); });
}

bool PlaceUses::has(const std::vector<std::string>& lineage, PlaceUse use) const {
  const auto found = kinds_.find(use);
  return found != kinds_.end() && std::any_of(lineage.begin(), lineage.end(), [&](const std::string& kind) {
           return std::find(found->second.begin(), found->second.end(), kind) != found->second.end();
         });
}

PlaceUses read_place_uses(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return {};
  }
  RowReader row(path.string(), *text, {"use", "places", "source"}, errors);
  std::map<PlaceUse, std::vector<std::string>> places;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const std::string name = row.required("use");
    const auto* const use =
        std::find_if(kPlaceUses.begin(), kPlaceUses.end(), [&](PlaceUse one) { return name_of(one) == name; });
    auto all = split(row.required("places"), '|');
    for (const auto& kind : all) {
      if (kinds.find(kind) == nullptr) row.fail("places", "'" + kind + "' is not a kind of kinds.csv");
    }
    if (use == kPlaceUses.end()) {
      row.fail("use", "'" + name +
                          "' is not a use; known are storage, dirty_things, dirty_or_not, put_away, own_rooms, "
                          "not_at_hand and passing");
    } else if (!places.try_emplace(*use, std::move(all)).second) {
      row.fail("use", "'" + name + "' stands twice");
    }
  }
  for (const PlaceUse use : kPlaceUses) {
    if (!places.contains(use)) {
      errors.push_back(
          {Error::Kind::Schema, path.string(), {}, "no row for the use '" + std::string(name_of(use)) + "'"});
    }
  }
  return PlaceUses(std::move(places));
}

}  // namespace unietp
