#pragma once

#include <optional>
#include <string>
#include <vector>

#include "akb/facts.h"

namespace unietp {

/// A fact that one of two knowledge bases says and the other does not, or says otherwise or from another source.
struct Difference {
  std::string category, name;    // of the fact
  std::optional<Fact> old, now;  // at least one of them
  /// Only the source or the confidence differs.
  bool same_value() const { return old && now && old->value == now->value; }
  bool operator==(const Difference&) const = default;
};

/// Sorted by category and name of the fact; empty when both say the same from the same sources.
std::vector<Difference> differences(const Knowledge& old, const Knowledge& now);

}  // namespace unietp
