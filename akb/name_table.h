#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace unietp {

/// Finds the number of a name by hash, while the names themselves stand elsewhere: `name_of(number)` gives one. The
/// answers do not depend on the hash.
class NameSlots {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  NameSlots() = default;
  /// Numbers below `count`. Of equal names the lowest number is found.
  template <class NameOf>
  NameSlots(std::size_t count, const NameOf& name_of) : slots_(std::bit_ceil(2 * count + 1), kNone) {
    for (std::uint32_t number = 0; number < count; ++number) {
      std::size_t at = home(name_of(number));
      while (slots_[at] != kNone) at = next(at);
      slots_[at] = number;
    }
  }
  /// kNone for an unknown name.
  template <class NameOf>
  std::uint32_t find(std::string_view name, const NameOf& name_of) const {
    if (slots_.empty()) return kNone;
    std::size_t at = home(name);
    while (slots_[at] != kNone && name_of(slots_[at]) != name) at = next(at);
    return slots_[at];
  }

 private:
  std::size_t home(std::string_view name) const { return std::hash<std::string_view>{}(name) & (slots_.size() - 1); }
  std::size_t next(std::size_t at) const { return (at + 1) & (slots_.size() - 1); }

  std::vector<std::uint32_t> slots_;  // open addressing; a power of two of them, less than half full
};

/// Distinct names, numbered in sorted order, so that numbers compare as the names do. A value: copies and moves answer
/// like the original.
class NameTable {
 public:
  static constexpr std::uint32_t kNone = NameSlots::kNone;

  NameTable() = default;
  /// Names in any order; repeats count once.
  explicit NameTable(std::vector<std::string> names);

  /// kNone for a name that is not in the table.
  std::uint32_t number(std::string_view name) const;
  bool contains(std::string_view name) const { return number(name) != kNone; }
  const std::vector<std::string>& names() const { return names_; }
  std::size_t size() const { return names_.size(); }

 private:
  std::vector<std::string> names_;  // sorted
  NameSlots slots_;
};

}  // namespace unietp
