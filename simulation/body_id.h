#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

namespace unietp {

/// A body of a PhysicsWorld: a node by its position in Scene::nodes, a part of a wall by its position in walls_of, or
/// the floor. Nodes and walls are numbered apart. Ordered: nodes, walls, the floor.
class BodyId {
 public:
  /// The first node.
  constexpr BodyId() = default;
  /// Both throw std::length_error for a position from 2^31 - 1 on.
  static constexpr BodyId node(std::size_t position) { return BodyId(position, 0); }
  static constexpr BodyId wall(std::size_t position) { return BodyId(position, kFirstWall); }
  static constexpr BodyId floor() { return from_number(kFloor); }

  constexpr bool is_node() const { return number_ < kFirstWall; }  // a node of the scene
  constexpr bool is_wall() const { return !is_node() && number_ != kFloor; }
  /// The position of a node or a wall.
  constexpr std::size_t index() const { return is_node() ? number_ : number_ - kFirstWall; }

  /// For grids of plain numbers.
  constexpr std::uint32_t number() const { return number_; }
  static constexpr BodyId from_number(std::uint32_t number) {
    BodyId id;
    id.number_ = number;
    return id;
  }
  auto operator<=>(const BodyId&) const = default;

 private:
  static constexpr std::uint32_t kFirstWall = 0x8000'0000U, kFloor = 0xFFFF'FFFFU;
  constexpr BodyId(std::size_t position, std::uint32_t first) : number_(first + static_cast<std::uint32_t>(position)) {
    if (position >= kFloor - kFirstWall) throw std::length_error("too many bodies in a physics world");
  }

  std::uint32_t number_ = 0;
};
/// The floor.
inline constexpr BodyId kFloor = BodyId::floor();

/// The bodies of nodes, in order.
std::vector<BodyId> bodies_of(std::span<const std::size_t> nodes);
/// The inverse; all must be bodies of nodes.
std::vector<std::size_t> nodes_of(std::span<const BodyId> bodies);

}  // namespace unietp

/// For unordered containers.
template <>
struct std::hash<unietp::BodyId> {
  std::size_t operator()(unietp::BodyId id) const noexcept { return std::hash<std::uint32_t>()(id.number()); }
};
