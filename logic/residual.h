#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "logic/monitor_program.h"

namespace unietp::monitoring {

/// What a variable stands for: an entity, no entity at all, or, of the variable of a slot that still waits for an
/// entity to appear, that slot. Ordered: entities, nothing, slots.
class Value {
 public:
  /// Throws std::length_error for an entity from 2^31 - 1 on.
  explicit Value(EntityIndex entity) : word_(entity.value()) {
    if (word_ >= kNothing) throw std::length_error("too many entities for a monitor");
  }
  /// No entity, and no variable that waits for one.
  static Value nothing() { return from_word(kNothing); }
  /// A variable whose entity does not exist yet.
  static Value waiting(Slot slot) { return from_word(kWaits | slot); }

  bool waits() const { return (word_ & kWaits) != 0; }  // whether it depends on what comes
  Slot slot() const { return word_ & ~kWaits; }         // of one that waits
  /// Of one that does not wait; EntityIndex::none() for nothing.
  EntityIndex entity() const { return word_ == kNothing ? EntityIndex::none() : EntityIndex(word_); }

  /// As a word of Residuals::data.
  std::uint32_t word() const { return word_; }
  static Value from_word(std::uint32_t word) {
    Value value;
    value.word_ = word;
    return value;
  }
  auto operator<=>(const Value&) const = default;

 private:
  static constexpr std::uint32_t kWaits = 0x8000'0000U, kNothing = kWaits - 1;
  Value() = default;
  std::uint32_t word_ = kNothing;
};

/// Position of a residual in its store.
using Ref = std::uint32_t;
/// The two residuals that are decided.
inline constexpr Ref kFalse = 0, kTrue = 1;

/// What is still asked of the rest of a trace. Equal residuals are one: each is stored once, and/or are flat sorted
/// sets in which no part repeats deeper down, so what can arise from one goal is finite however long the trace.
class Residuals {
 public:
  enum class Kind : std::uint8_t {
    False,
    True,
    Pending,  // data: values of the program node's free variables; to be read at the next position
    Same,     // data: two values, at least one waiting; 1 if asked to be the same
    And,
    Or,       // data: parts
    ForNew,   // id: slot; data: body. For every entity of the slot's domain that appears from now on
    SomeNew,  // the same for some entity
    Sum,      // id: relation; data: constant, number of terms, (part, weight)…, (slot, part, weight)…
  };

  Residuals();
  // The parts of a residual, as said at Kind.
  Kind kind(Ref ref) const { return items_[ref].kind; }
  std::uint32_t id(Ref ref) const { return items_[ref].id; }
  std::span<const std::uint32_t> data(Ref ref) const { return {pool_.data() + items_[ref].begin, items_[ref].size}; }
  std::size_t size() const { return items_.size(); }

  /// `values`: words of the values of the node's free variables.
  Ref pending(NodeId node, std::span<const std::uint32_t> values);
  // Each gives the residual of that form, simplified: parts that are true or false are left out, repeated ones merged.
  Ref same(Value a, Value b, bool positive);
  /// Simplified: decided and repeated parts are dropped, and the parts are sorted, so that equal residuals have equal
  /// refs.
  Ref conjunction(std::vector<Ref> parts) { return junction(Kind::And, std::move(parts)); }
  Ref disjunction(std::vector<Ref> parts) { return junction(Kind::Or, std::move(parts)); }
  /// `body` for every entity that appears later, or for at least one, in the place of `slot`.
  Ref for_new(Slot slot, Ref body);
  Ref some_new(Slot slot, Ref body);

  struct Term {
    Ref part;
    int weight;
    auto operator<=>(const Term&) const = default;
  };
  struct NewTerm {
    Slot slot;
    Ref part;
    int weight;
    auto operator<=>(const NewTerm&) const = default;
  };
  /// A comparison of a number of true terms with a constant.
  Ref sum(Relation relation, int constant, std::vector<Term> terms, std::vector<NewTerm> news);
  struct SumView {
    Relation relation;
    int constant;
    std::vector<Term> terms;
    std::vector<NewTerm> news;
  };
  /// The parts of a residual that is a sum.
  SumView view_sum(Ref ref) const;

  /// The residual with the waiting variable of a slot replaced by an entity.
  Ref instantiate(Ref ref, Slot slot, Value entity);

  /// Copies what a residual needs from another store.
  Ref import(const Residuals& from, Ref ref, std::vector<Ref>& known);

 private:
  struct Item {
    Kind kind;
    std::uint32_t id;
    std::uint32_t begin, size;
    std::uint64_t waiting;  // slots that wait inside, modulo 64
  };

  Ref intern(Kind kind, std::uint32_t id, std::span<const std::uint32_t> data);
  std::uint64_t waiting_in(Kind kind, std::uint32_t id, std::span<const std::uint32_t> data) const;
  void grow_table();
  Ref junction(Kind kind, std::vector<Ref> parts);
  void flatten(Kind kind, std::vector<Ref>& parts) const;
  bool merge_new(Kind kind, std::vector<Ref>& parts);
  Ref assume(Ref ref, const std::vector<Ref>& known, Ref value, Ref self);

  std::vector<Item> items_;
  std::vector<std::uint32_t> pool_;
  std::vector<Ref> table_;  // open addressing; kFalse marks a free place
};

}  // namespace unietp::monitoring
