#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "sense/kinds.h"

namespace unietp {

/// What places of a kind are used for.
enum class PlaceUse {
  Storage,      // things are kept there, so they are not cleared away from it
  DirtyThings,  // dirty things go there to be washed or thrown away
  DirtyOrNot,   // the same, and they may also go there while the place itself is dirty
  PutAway,      // things go there only in rooms where they usually are: no shampoo in the cabinet of a living room
  OwnRooms,     // the same of places where nothing is put away: no wine glass in the sink of a bathroom
  NotAtHand,  // nobody who needs a thing now has it put there: where things are put away, washed, stored or thrown away
  Passing,    // tasks put things there, but nobody keeps them there: food waits in an oven only while it is cooked
};
inline constexpr std::array kPlaceUses{PlaceUse::Storage, PlaceUse::DirtyThings, PlaceUse::DirtyOrNot,
                                       PlaceUse::PutAway, PlaceUse::OwnRooms,    PlaceUse::NotAtHand,
                                       PlaceUse::Passing};
std::string_view name_of(PlaceUse use);

/// The kinds of places that have each use. Read only after loading.
class PlaceUses {
 public:
  PlaceUses() = default;
  explicit PlaceUses(std::map<PlaceUse, std::vector<std::string>> kinds) : kinds_(std::move(kinds)) {}

  /// True for a kind of place that has this use, or that is a narrower kind of one. A kind that is not of the taxonomy
  /// has none.
  bool has(std::string_view place, PlaceUse use, const Kinds& kinds) const;
  /// The same by the names of the kind of place and all wider ones (Category::kinds).
  bool has(const std::vector<std::string>& lineage, PlaceUse use) const;

 private:
  std::map<PlaceUse, std::vector<std::string>> kinds_;
};

/// Reads place_uses.csv (use,places,source): a use and kinds of places, separated by `|`. Errors are appended: Io,
/// Parse; Schema for an unknown use or kind, and for a use that stands twice or nowhere.
PlaceUses read_place_uses(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);

}  // namespace unietp
