#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/typed_id.h"

namespace unietp::symbolic {

/// Position of a substance in Rules::symbols().
using SubstanceId = TypedId<struct SubstanceTag>;
/// Stands for any substance.
inline constexpr std::nullopt_t kAnySymbol = std::nullopt;

/// A set of substances. An empty one allocates no memory.
class SubstanceSet {
 public:
  bool empty() const { return words_.empty(); }
  bool contains(SubstanceId substance) const;  // whether it is one of them
  /// Whether a substance other than `one` is in it.
  bool has_other_than(std::optional<SubstanceId> one) const;
  void insert(SubstanceId substance);
  void insert(const SubstanceSet& others);
  void erase(SubstanceId substance);
  void clear() { words_.clear(); }
  /// Different for most different sets.
  std::uint64_t hash() const;
  bool operator==(const SubstanceSet&) const = default;

 private:
  std::vector<std::uint64_t> words_;  // a bit for each substance; the last word is never 0
};

}  // namespace unietp::symbolic
