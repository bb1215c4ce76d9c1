#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/shared_value.h"
#include "logic/entity_list.h"
#include "logic/vocabulary.h"

namespace unietp {

/// The truths of one state: which entities exist and what holds of them. A word of bits per entity and sorted pairs, so
/// that a goal is read in microseconds. Atoms about entities that do not exist here are false. A copy is cheap and
/// changing it costs what changes: the states and relations that both have are one block in memory.
class Facts {
 public:
  // An entity may have facts before it exists; they hold once it does.
  void set_exists(EntityIndex entity);
  void set(Predicate predicate, EntityIndex entity);
  void set(Predicate predicate, EntityIndex first, EntityIndex second);
  void set(Predicate predicate, EntityIndex entity, std::string symbol);
  /// Takes back what was set of one entity; what was not set stays so.
  void clear(Predicate predicate, EntityIndex entity);
  void clear(Predicate predicate, EntityIndex first, EntityIndex second);
  /// All states and symbols of an entity; its relations stay.
  void clear_states(EntityIndex entity);
  /// The entity exists no longer, nor anything that was set of it as the first.
  void forget(EntityIndex entity);

  // False of entities that do not exist.
  bool exists(EntityIndex entity) const;
  /// The entities that exist, one bit each, lowest bit first.
  const std::vector<std::uint64_t>& existing() const { return *existing_; }
  /// Whether a state without a symbol, or a relation, is true here.
  bool holds(Predicate predicate, EntityIndex entity) const;
  bool holds(Predicate predicate, EntityIndex first, EntityIndex second) const;
  /// With the symbol `any`: for some symbol.
  bool holds(Predicate predicate, EntityIndex entity, std::string_view symbol) const;

  /// The entities of which a state holds, ascending.
  std::vector<EntityIndex> with(Predicate state) const;
  /// The relations in which an entity is the first, to what exists, sorted.
  std::vector<std::pair<Predicate, EntityIndex>> relations(EntityIndex first) const;

  /// Whether what is asked is true of some entity that exists and to which the first one stands in the relation.
  template <class Asked>
  bool any_related(Predicate relation, EntityIndex first, const Asked& asked) const {
    if (!exists(first)) return false;
    for (const Pair pair : pairs(first)) {
      const EntityIndex second = second_of(pair);
      if (static_cast<Predicate>(pair >> 32) == relation && exists(second) && asked(second)) return true;
    }
    return false;
  }

  /// Equal when the same was set.
  bool operator==(const Facts& other) const;

 private:
  using Bits = std::vector<std::uint64_t>;
  using Pair = std::uint64_t;  // predicate and second entity; the first is known by its place
  static Pair pair_of(Predicate predicate, EntityIndex second) {
    return (static_cast<Pair>(predicate) << 32) | second.value();
  }
  static EntityIndex second_of(Pair pair) { return EntityIndex(static_cast<std::uint32_t>(pair)); }
  struct Symbol {
    Predicate predicate;
    std::string text;
    auto operator<=>(const Symbol&) const = default;
  };
  /// Sorted lists of all entities, one after the other: those of entity e go from start[e] to start[e + 1].
  template <class T>
  struct Lists {
    std::vector<T> all;
    std::vector<std::uint32_t> start;
    std::span<const T> of(EntityIndex entity) const;
    void insert(EntityIndex entity, T value);
  };
  using States = std::uint64_t;  // a bit for each predicate
  struct Ground {
    static constexpr std::size_t kAtOnce = 32;
    std::vector<States> states;    // by entity
    std::vector<States> anywhere;  // by so many entities: what any of them has or had
    Lists<Pair> pairs;
    Lists<Symbol> symbols;
  };
  /// What one entity has in place of its part of the ground.
  struct Part {
    States states = 0;
    std::vector<Pair> pairs;
    std::vector<Symbol> symbols;
  };
  struct Own {
    EntityIndex entity;
    SharedValue<Part> part;
  };
  struct Owned {
    std::vector<Own> all;    // by entity, sorted
    std::uint64_t some = 0;  // a bit for each, by the last digits of its number: most entities are seen to have none
  };

  const Part* own(EntityIndex entity) const;
  Part& make_own(EntityIndex entity);
  States states(EntityIndex entity) const;
  void set_states(EntityIndex entity, States states);
  std::span<const Pair> pairs(EntityIndex entity) const;
  std::span<const Symbol> symbols(EntityIndex entity) const;
  bool alone() const { return own_->all.empty() && (ground_ == nullptr || ground_.use_count() == 1); }
  Ground& ground();

  SharedValue<Bits> existing_;
  std::shared_ptr<Ground> ground_;  // shared by a state and those that were copied from it; never changed then
  SharedValue<Owned> own_;
};

/// A finite sequence of states over one list of entities: the start state, then the state at each moment of each
/// action.
struct Trace {
  EntityList entities;        // all that exist at any position
  std::vector<Facts> states;  // never empty when a formula is read on it
};

}  // namespace unietp
