#include "logic/trace.h"

#include <algorithm>

namespace unietp {
namespace {

constexpr std::size_t kWordBits = 64;
static_assert(kPredicateCount <= kWordBits, "the states of an entity are one word");

bool has(std::uint64_t word, EntityIndex entity) { return ((word >> (entity.index() % kWordBits)) & 1U) != 0; }

bool test(const std::vector<std::uint64_t>& bits, EntityIndex entity) {
  const std::size_t word = entity.index() / kWordBits;
  return word < bits.size() && has(bits[word], entity);
}

void mark(std::vector<std::uint64_t>& bits, EntityIndex entity) {
  const std::size_t word = entity.index() / kWordBits;
  if (word >= bits.size()) bits.resize(word + 1);
  bits[word] |= std::uint64_t{1} << (entity.index() % kWordBits);
}

std::uint64_t bit_of(Predicate predicate) { return std::uint64_t{1} << static_cast<unsigned>(predicate); }

template <class T>
void insert_once(std::vector<T>& sorted, T value) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (at == sorted.end() || *at != value) sorted.insert(at, std::move(value));
}

/// Without trailing zeros, which change nothing.
std::span<const std::uint64_t> significant(const std::vector<std::uint64_t>& bits) {
  std::size_t size = bits.size();
  while (size > 0 && bits[size - 1] == 0) --size;
  return {bits.data(), size};
}

}  // namespace

template <class T>
std::span<const T> Facts::Lists<T>::of(EntityIndex entity) const {
  const std::size_t i = entity.index();
  if (i + 1 >= start.size()) return {};
  return {all.data() + start[i], all.data() + start[i + 1]};
}

template <class T>
void Facts::Lists<T>::insert(EntityIndex entity, T value) {
  const std::size_t place = entity.index();
  if (start.size() < place + 2) start.resize(place + 2, static_cast<std::uint32_t>(all.size()));
  const auto from = all.begin() + start[place];
  const auto to = all.begin() + start[place + 1];
  const auto at = std::lower_bound(from, to, value);
  if (at != to && *at == value) return;
  all.insert(at, std::move(value));
  for (std::size_t i = place + 1; i < start.size(); ++i) ++start[i];
}

Facts::Ground& Facts::ground() {
  // Not shared: copies of a state share its ground on purpose, until one of them changes something.
  if (ground_ == nullptr) ground_ = std::make_shared<Ground>();
  return *ground_;
}

const Facts::Part* Facts::own(EntityIndex entity) const {
  const auto& [all, some] = *own_;
  if (!has(some, entity)) return nullptr;
  const auto at = std::lower_bound(all.begin(), all.end(), entity,
                                   [](const Own& one, EntityIndex wanted) { return one.entity < wanted; });
  return at != all.end() && at->entity == entity ? &*at->part : nullptr;
}

Facts::Part& Facts::make_own(EntityIndex entity) {
  auto& [all, some] = own_.edit();
  const auto at = std::lower_bound(all.begin(), all.end(), entity,
                                   [](const Own& one, EntityIndex wanted) { return one.entity < wanted; });
  if (at != all.end() && at->entity == entity) return at->part.edit();
  const auto pairs_here = pairs(entity);
  const auto symbols_here = symbols(entity);
  Part part{states(entity), {pairs_here.begin(), pairs_here.end()}, {symbols_here.begin(), symbols_here.end()}};
  some |= std::uint64_t{1} << (entity.index() % kWordBits);
  return all.insert(at, Own{entity, std::move(part)})->part.edit();
}

Facts::States Facts::states(EntityIndex entity) const {
  if (const Part* mine = own(entity)) return mine->states;
  return ground_ == nullptr || entity.index() >= ground_->states.size() ? 0 : ground_->states[entity.index()];
}

void Facts::set_states(EntityIndex entity, States states) {
  if (states == this->states(entity)) return;
  if (!alone()) {
    make_own(entity).states = states;
    return;
  }
  Ground& all = ground();
  const std::size_t place = entity.index();
  if (place >= all.states.size()) {
    all.states.resize(place + 1);
    all.anywhere.resize(place / Ground::kAtOnce + 1);
  }
  all.states[place] = states;
  all.anywhere[place / Ground::kAtOnce] |= states;
}

std::span<const Facts::Pair> Facts::pairs(EntityIndex entity) const {
  if (const Part* mine = own(entity)) return mine->pairs;
  return ground_ == nullptr ? std::span<const Pair>() : ground_->pairs.of(entity);
}

std::span<const Facts::Symbol> Facts::symbols(EntityIndex entity) const {
  if (const Part* mine = own(entity)) return mine->symbols;
  return ground_ == nullptr ? std::span<const Symbol>() : ground_->symbols.of(entity);
}

void Facts::set_exists(EntityIndex entity) {
  if (!exists(entity)) mark(existing_.edit(), entity);
}

void Facts::set(Predicate predicate, EntityIndex entity) { set_states(entity, states(entity) | bit_of(predicate)); }

void Facts::set(Predicate predicate, EntityIndex first, EntityIndex second) {
  const Pair pair = pair_of(predicate, second);
  if (alone()) {
    ground().pairs.insert(first, pair);
  } else {
    insert_once(make_own(first).pairs, pair);
  }
}

void Facts::set(Predicate predicate, EntityIndex entity, std::string symbol) {
  Symbol fact{predicate, std::move(symbol)};
  if (alone()) {
    ground().symbols.insert(entity, std::move(fact));
  } else {
    insert_once(make_own(entity).symbols, std::move(fact));
  }
}

void Facts::clear(Predicate predicate, EntityIndex entity) {
  set_states(entity, states(entity) & ~bit_of(predicate));
  const auto has = [predicate](const Symbol& symbol) { return symbol.predicate == predicate; };
  if (const auto here = symbols(entity); std::any_of(here.begin(), here.end(), has)) {
    std::erase_if(make_own(entity).symbols, has);
  }
}

void Facts::clear(Predicate predicate, EntityIndex first, EntityIndex second) {
  const Pair pair = pair_of(predicate, second);
  if (const auto here = pairs(first); std::binary_search(here.begin(), here.end(), pair)) {
    std::erase(make_own(first).pairs, pair);
  }
}

void Facts::clear_states(EntityIndex entity) {
  set_states(entity, 0);
  if (!symbols(entity).empty()) make_own(entity).symbols.clear();
}

void Facts::forget(EntityIndex entity) {
  if (exists(entity))
    existing_.edit()[entity.index() / kWordBits] &= ~(std::uint64_t{1} << (entity.index() % kWordBits));
  clear_states(entity);
  if (!pairs(entity).empty()) make_own(entity).pairs.clear();
}

bool Facts::exists(EntityIndex entity) const { return test(*existing_, entity); }

bool Facts::holds(Predicate predicate, EntityIndex entity) const {
  return exists(entity) && (states(entity) & bit_of(predicate)) != 0;
}

bool Facts::holds(Predicate predicate, EntityIndex first, EntityIndex second) const {
  const auto here = pairs(first);
  const Pair pair = pair_of(predicate, second);
  const Pair* from = here.data();
  const Pair* to = from + here.size();
  constexpr std::ptrdiff_t kScan = 8;  // an object stands in few relations unless `nearest` is asked for
  if (to - from > kScan) {
    from = std::lower_bound(from, to, pair);
  } else {
    while (from != to && *from < pair) ++from;
  }
  return from != to && *from == pair && exists(first) && exists(second);
}

bool Facts::holds(Predicate predicate, EntityIndex entity, std::string_view symbol) const {
  if (!exists(entity)) return false;
  for (const Symbol& fact : symbols(entity)) {
    if (fact.predicate == predicate && (symbol == "any" || fact.text == symbol)) return true;
  }
  return false;
}

std::vector<EntityIndex> Facts::with(Predicate state) const {
  std::vector<EntityIndex> entities;
  const std::size_t stretches = ground_ == nullptr ? 0 : ground_->anywhere.size();
  for (std::size_t i = 0; i < stretches; ++i) {
    if ((ground_->anywhere[i] & bit_of(state)) == 0) continue;
    const std::size_t end = std::min((i + 1) * Ground::kAtOnce, ground_->states.size());
    for (std::size_t entity = i * Ground::kAtOnce; entity < end; ++entity) {
      if ((ground_->states[entity] & bit_of(state)) != 0) entities.push_back(EntityIndex(entity));
    }
  }
  for (const Own& mine : own_->all) entities.push_back(mine.entity);
  std::sort(entities.begin(), entities.end());
  entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
  std::erase_if(entities, [&](EntityIndex entity) { return !holds(state, entity); });
  return entities;
}

std::vector<std::pair<Predicate, EntityIndex>> Facts::relations(EntityIndex first) const {
  std::vector<std::pair<Predicate, EntityIndex>> relations;
  if (!exists(first)) return relations;
  for (const Pair pair : pairs(first)) {
    const EntityIndex second = second_of(pair);
    if (exists(second)) relations.emplace_back(static_cast<Predicate>(pair >> 32), second);
  }
  return relations;
}

bool Facts::operator==(const Facts& other) const {
  const auto same = [](const auto& a, const auto& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
  if (!same(significant(*existing_), significant(*other.existing_))) return false;
  const auto count_of = [](const Facts& facts) {
    std::size_t count = facts.own_->all.empty() ? 0 : facts.own_->all.back().entity.index() + 1;
    if (facts.ground_ == nullptr) return count;
    const Ground& ground = *facts.ground_;
    return std::max({count, ground.states.size(), ground.pairs.start.size(), ground.symbols.start.size()});
  };
  const std::size_t count = std::max(count_of(*this), count_of(other));
  for (EntityIndex entity; entity.index() < count; ++entity) {
    if (states(entity) != other.states(entity) || !same(pairs(entity), other.pairs(entity)) ||
        !same(symbols(entity), other.symbols(entity)))
      return false;
  }
  return true;
}

}  // namespace unietp
