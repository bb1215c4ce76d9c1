#include "logic/trace.h"

#include <algorithm>

namespace unietp {
namespace {

constexpr std::size_t kWordBits = 64;

bool test(const std::vector<std::uint64_t>& bits, EntityIndex entity) {
  const std::size_t word = entity / kWordBits;
  return word < bits.size() && ((bits[word] >> (entity % kWordBits)) & 1U) != 0;
}

void mark(std::vector<std::uint64_t>& bits, EntityIndex entity) {
  const std::size_t word = entity / kWordBits;
  if (word >= bits.size()) bits.resize(word + 1);
  bits[word] |= std::uint64_t{1} << (entity % kWordBits);
}

}  // namespace

void Facts::set_exists(EntityIndex entity) { mark(existing_, entity); }

void Facts::set(Predicate predicate, EntityIndex entity) {
  const auto index = static_cast<std::size_t>(predicate);
  if (index >= unary_.size()) unary_.resize(index + 1);
  mark(unary_[index], entity);
}

void Facts::set(Predicate predicate, EntityIndex first, EntityIndex second) {
  if (pair_start_.size() < first + std::size_t{2}) {
    pair_start_.resize(first + std::size_t{2}, static_cast<std::uint32_t>(pairs_.size()));
  }
  const Pair key = pair_of(predicate, second);
  const auto from = pairs_.begin() + pair_start_[first];
  const auto to = pairs_.begin() + pair_start_[first + 1];
  const auto at = std::lower_bound(from, to, key);
  if (at != to && *at == key) return;
  pairs_.insert(at, key);
  for (std::size_t i = first + std::size_t{1}; i < pair_start_.size(); ++i) ++pair_start_[i];
}

void Facts::set(Predicate predicate, EntityIndex entity, std::string symbol) {
  Symbolic fact{predicate, entity, std::move(symbol)};
  const auto at = std::lower_bound(symbolic_.begin(), symbolic_.end(), fact);
  if (at == symbolic_.end() || *at != fact) symbolic_.insert(at, std::move(fact));
}

bool Facts::exists(EntityIndex entity) const { return test(existing_, entity); }

bool Facts::holds(Predicate predicate, EntityIndex entity) const {
  const auto index = static_cast<std::size_t>(predicate);
  return index < unary_.size() && test(unary_[index], entity) && exists(entity);
}

bool Facts::holds(Predicate predicate, EntityIndex first, EntityIndex second) const {
  if (first >= pair_start_.size() || first + std::size_t{1} >= pair_start_.size()) return false;
  const Pair key = pair_of(predicate, second);
  const Pair* from = pairs_.data() + pair_start_[first];
  const Pair* to = pairs_.data() + pair_start_[first + 1];
  constexpr std::ptrdiff_t kScan = 8;  // an object stands in few relations unless `nearest` is asked for
  if (to - from > kScan) {
    from = std::lower_bound(from, to, key);
  } else {
    while (from != to && *from < key) ++from;
  }
  return from != to && *from == key && exists(first) && exists(second);
}

bool Facts::holds(Predicate predicate, EntityIndex entity, std::string_view symbol) const {
  if (!exists(entity)) return false;
  const auto before = [](const Symbolic& a, const std::pair<Predicate, EntityIndex>& b) {
    return std::tie(a.predicate, a.entity) < std::tie(b.first, b.second);
  };
  auto at = std::lower_bound(symbolic_.begin(), symbolic_.end(), std::pair(predicate, entity), before);
  for (; at != symbolic_.end() && at->predicate == predicate && at->entity == entity; ++at) {
    if (symbol == "any" || at->symbol == symbol) return true;
  }
  return false;
}

}  // namespace unietp
