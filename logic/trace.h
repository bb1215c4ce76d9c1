#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "logic/vocabulary.h"

namespace unietp {

/// Position in Trace::entities. Meaningless in another trace.
using EntityIndex = std::uint32_t;

/// Something that a variable can stand for.
struct Entity {
  enum class Kind : std::uint8_t { Object, Room, Agent };
  Kind kind = Kind::Object;
  std::string id;        // "mug_3"
  std::string category;  // "Mug"; of a room its type ("Kitchen")
  std::string slice_of;  // category of the whole that was cut, for `A/slice`; else empty
  bool operator==(const Entity&) const = default;
};

/// The truths of one state: which entities exist and what holds of them. Bit sets per predicate, so that a goal is read
/// in microseconds. Atoms about entities that do not exist here are false.
class Facts {
 public:
  void set_exists(EntityIndex entity);
  void set(Predicate predicate, EntityIndex entity);
  void set(Predicate predicate, EntityIndex first, EntityIndex second);
  void set(Predicate predicate, EntityIndex entity, std::string symbol);

  bool exists(EntityIndex entity) const;
  /// The entities that exist, one bit each, lowest bit first.
  const std::vector<std::uint64_t>& existing() const { return existing_; }
  bool holds(Predicate predicate, EntityIndex entity) const;
  bool holds(Predicate predicate, EntityIndex first, EntityIndex second) const;
  /// With the symbol `any`: for some symbol.
  bool holds(Predicate predicate, EntityIndex entity, std::string_view symbol) const;

  bool operator==(const Facts&) const = default;

 private:
  using Bits = std::vector<std::uint64_t>;
  using Pair = std::uint64_t;  // predicate and second entity; the first is known by its place
  static Pair pair_of(Predicate predicate, EntityIndex second) { return (static_cast<Pair>(predicate) << 32) | second; }
  struct Symbolic {
    Predicate predicate;
    EntityIndex entity;
    std::string symbol;
    auto operator<=>(const Symbolic&) const = default;
  };
  Bits existing_;
  std::vector<Bits> unary_;  // by predicate; grown on demand
  std::vector<Pair> pairs_;  // those of entity e: sorted, from pair_start_[e] to pair_start_[e + 1]
  std::vector<std::uint32_t> pair_start_;
  std::vector<Symbolic> symbolic_;  // sorted
};

/// A finite sequence of states over one list of entities: the start state, then the state after each action.
struct Trace {
  std::vector<Entity> entities;  // all that exist at any position
  std::vector<Facts> states;     // never empty when a formula is read on it
};

}  // namespace unietp
