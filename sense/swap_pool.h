#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "akb/knowledge.h"
#include "sense/common_sense.h"

namespace unietp {

/// What else could physically stand in an item's place: kinds of things and places of one knowledge base.
class SwapPool {
 public:
  enum class By {
    Physics,  // fits by size and shape, or can be carried, or has the part that is needed
    Listing,  // the knowledge base has a placement or an affordance for it
  };

  SwapPool(const CommonSense& sense, const Knowledge& knowledge);

  /// The item with another thing or another place; nothing when there is none. `draw` chooses: even numbers swap the
  /// thing, odd ones the place.
  std::optional<Evidence> swapped(const Evidence& item, By by, std::uint64_t draw) const;

 private:
  using Pairs = std::map<std::string, std::set<std::string>>;
  void add(By by, const std::string& thing, const Role& role);

  Pairs things_at_[2], roles_of_[2];                     // by role; by kind of thing
  std::map<std::string, std::set<std::string>> having_;  // kinds by affordance
  std::set<std::string> carried_;                        // kinds of what can be carried
};

}  // namespace unietp
