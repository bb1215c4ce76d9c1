#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>

namespace unietp {

/// The position of one thing among all things of a kind. Each kind has a type of its own by its `Tag`: ids of different
/// kinds do not convert into each other, nor from or to plain numbers, so they cannot be swapped.
template <class Tag>
class TypedId {
 public:
  constexpr TypedId() = default;
  /// Throws std::length_error for a position from 2^32 - 1 on; containers do the same when they are full.
  explicit constexpr TypedId(std::size_t position) : value_(static_cast<std::uint32_t>(position)) {
    if (position >= kNone) throw std::length_error("too many things of a kind");
  }
  /// That of nothing: greater than all others.
  static constexpr TypedId none() {
    TypedId id;
    id.value_ = kNone;
    return id;
  }

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

template <class Tag>
struct std::hash<unietp::TypedId<Tag>> {
  std::size_t operator()(unietp::TypedId<Tag> id) const noexcept { return std::hash<std::uint32_t>()(id.value()); }
};
