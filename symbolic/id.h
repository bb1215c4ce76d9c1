#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace unietp::symbolic {

/// Who takes part in a symbolic scene: a thing, a room, the agent, or nobody. Things and rooms are numbered apart, by
/// their positions in ObjectTable::things and ObjectTable::rooms. Ordered: things, rooms, the agent, nobody.
class Id {
 public:
  /// Nobody.
  constexpr Id() = default;
  /// Both throw std::length_error for a position from 2^31 on (of rooms, two less).
  static constexpr Id thing(std::size_t position) { return Id(position, 0, kFirstRoom); }
  static constexpr Id room(std::size_t position) { return Id(position, kFirstRoom, kAgent - kFirstRoom); }
  static constexpr Id agent() { return Id(0, kAgent, 1); }

  constexpr bool is_thing() const { return value_ < kFirstRoom; }  // neither a room nor the agent
  constexpr bool is_room() const { return value_ >= kFirstRoom && value_ < kAgent; }
  /// The position of a thing or of a room; the others have none.
  constexpr std::size_t index() const { return is_thing() ? value_ : value_ - kFirstRoom; }
  /// Different for different ids.
  constexpr std::uint32_t value() const { return value_; }

  auto operator<=>(const Id&) const = default;

 private:
  static constexpr std::uint32_t kFirstRoom = 0x8000'0000U, kAgent = 0xFFFF'FFFEU, kNobody = 0xFFFF'FFFFU;
  constexpr Id(std::size_t position, std::uint32_t first, std::uint32_t count)
      : value_(first + static_cast<std::uint32_t>(position)) {
    if (position >= count) throw std::length_error("too many things or rooms in a symbolic scene");
  }

  std::uint32_t value_ = kNobody;
};

inline constexpr Id kNobody{};  // names nothing
inline constexpr Id kAgent = Id::agent();

}  // namespace unietp::symbolic
