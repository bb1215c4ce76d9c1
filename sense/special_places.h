#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "sense/kinds.h"

namespace unietp {

/// Places that are made for some things only, such as a wine fridge or a filing cabinet. Their kind says what holds for
/// all places of that kind; this says which of those things are left.
class SpecialPlaces {
 public:
  SpecialPlaces() = default;
  /// By the name of the place, in the form of words.csv: the kinds that it holds.
  explicit SpecialPlaces(std::map<std::string, std::vector<std::string>, std::less<>> holds)
      : holds_(std::move(holds)) {}

  /// False for a thing that is of none of the kinds that this place is made for; true for any other place.
  /// `place`: in any form that normal_word takes. A kind that is not of the taxonomy is of none.
  bool may_hold(std::string_view place, std::string_view kind, const Kinds& kinds) const;
  const std::map<std::string, std::vector<std::string>, std::less<>>& all() const { return holds_; }

 private:
  std::map<std::string, std::vector<std::string>, std::less<>> holds_;
};

/// Reads special_places.csv (places,holds,source): names of places and kinds of things, both separated by `|`; `-` for
/// a place that holds nothing that can be carried. Errors are appended: Io, Parse; Schema for an unknown kind, and a
/// place that stands twice.
SpecialPlaces read_special_places(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);

}  // namespace unietp
