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
  /// Throws std::length_error for a position that does not fit into 32 bits; containers do the same when they are full.
  explicit constexpr TypedId(std::size_t position) : value_(static_cast<std::uint32_t>(position)) {
    if (position > std::numeric_limits<std::uint32_t>::max())
      throw std::length_error("more than 2^32 things of a kind");
  }

  constexpr std::size_t index() const { return value_; }
  constexpr std::uint32_t value() const { return value_; }

  constexpr TypedId& operator++() {
    *this = TypedId(index() + 1);
    return *this;
  }
  auto operator<=>(const TypedId&) const = default;

 private:
  std::uint32_t value_ = 0;
};

}  // namespace unietp

template <class Tag>
struct std::hash<unietp::TypedId<Tag>> {
  std::size_t operator()(unietp::TypedId<Tag> id) const noexcept { return std::hash<std::uint32_t>()(id.value()); }
};
