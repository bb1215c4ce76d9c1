#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>

namespace unietp {

/// A position in a list of things of one kind. Each kind has its own type, by its `Tag`: ids of different kinds, and
/// plain numbers, do not convert into each other, so they cannot be mixed up.
template <class Tag>
class TypedId {
 public:
  constexpr TypedId() = default;
  /// Throws std::length_error for a position from 2^32 - 1 on; containers do the same when they are full.
  explicit constexpr TypedId(std::size_t position) : value_(static_cast<std::uint32_t>(position)) {
    if (position >= kNone) throw std::length_error("too many things of a kind");
  }
  /// The id of nothing; greater than all others.
  static constexpr TypedId none() {
    TypedId id;
    id.value_ = kNone;
    return id;
  }

  /// The position as an index of a container, or as 32 bits.
  constexpr std::size_t index() const { return value_; }
  constexpr std::uint32_t value() const { return value_; }

  constexpr TypedId& operator++() {
    *this = TypedId(index() + 1);
    return *this;
  }
  auto operator<=>(const TypedId&) const = default;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t value_ = 0;
};

}  // namespace unietp

/// For unordered containers.
template <class Tag>
struct std::hash<unietp::TypedId<Tag>> {
  std::size_t operator()(unietp::TypedId<Tag> id) const noexcept { return std::hash<std::uint32_t>()(id.value()); }
};
