#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace unietp {

/// A group of kinds of things (Word::kind) that a rule of the importers treats alike.
enum class KindGroup : std::uint8_t {
  Food,           // is eaten
  HeatedVessel,   // may be hot with what is in it
  StoveWare,      // is heated on a stove
  OvenWare,       // is heated in an oven
  MicrowaveWare,  // is heated in a microwave
  Filled,         // holds a liquid, or pours one
  Dirtied,        // gets dirty, and substances are spread on it
  Soaked,         // takes up water
  Heater,         // heats what is in or on it
  Cooler,         // cools what is in it
  Washer,         // washes what is in it
  Laundry,        // is washed by a washing machine, not with dishes
  WornOrSpread,   // is not wiped
  Seasoning,      // is applied to dishes and food
  Seasoned,       // a seasoning is applied to it
  WashedUp,       // soap is applied to it
  Cleaned,        // a cleaner other than soap is applied to it
  HoldsNothing,   // nothing is put on or in it, whatever its shape
  FlatFood,       // nothing is put on it, though it is flat
  OpenFlame,      // a heater on which food burns
  Microwave,      // a heater for microwave ware
  Freezer,        // a cooler that also freezes
  UnderTap,       // a washer whose tap washes, fills and soaks what is in it
  WashesLaundry,  // a washer of laundry alone
  KitchenBlade,   // a blade that cuts food, and nothing else
  Cleaner,        // applies a substance that cleans
  Brewer,         // fills what stands on it with coffee
  Brewed,         // a brewer fills it
  NoReceptacle,   // holds nothing, though a simulator lists it among its receptacles
};
/// Number of groups.
inline constexpr std::size_t kKindGroupCount = static_cast<std::size_t>(KindGroup::NoReceptacle) + 1;
std::string_view name_of(KindGroup group);  // "heated_vessel"

/// The kinds of each group.
using KindGroups = std::map<KindGroup, std::set<std::string>>;
/// Reads curated/kind_groups.csv (group,kind,source). Errors are appended, with line and column: a group that is not
/// one of the above, or has no row.
KindGroups read_kind_groups(const std::filesystem::path& path, std::vector<Error>& errors);

}  // namespace unietp
