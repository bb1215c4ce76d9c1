#include "logic/residual.h"

#include <algorithm>
#include <limits>

namespace unietp::monitoring {
namespace {

constexpr std::uint64_t bit_of(Slot slot) { return std::uint64_t{1} << (slot % 64); }
std::uint64_t waiting_bit(Value value) { return value.waits() ? bit_of(value.slot()) : 0; }

std::uint64_t hash_of(Residuals::Kind kind, std::uint32_t id, std::span<const std::uint32_t> data) {
  std::uint64_t hash = (static_cast<std::uint64_t>(kind) << 32 | id) * 0x9e3779b97f4a7c15ULL;
  for (const std::uint32_t word : data) hash = (hash ^ word) * 0xff51afd7ed558ccdULL + (hash >> 29);
  return hash ^ (hash >> 32);
}

bool has(const std::vector<Ref>& sorted, Ref ref) { return std::binary_search(sorted.begin(), sorted.end(), ref); }

}  // namespace

Residuals::Residuals() : items_{{Kind::False, 0, 0, 0, 0}, {Kind::True, 0, 0, 0, 0}}, table_(64, kFalse) {}

std::uint64_t Residuals::waiting_in(Kind kind, std::uint32_t id, std::span<const std::uint32_t> data) const {
  std::uint64_t mask = 0;
  switch (kind) {
    case Kind::False:
    case Kind::True:
      break;
    case Kind::Pending:
      for (const std::uint32_t word : data) mask |= waiting_bit(Value::from_word(word));
      break;
    case Kind::Same:
      for (const std::uint32_t word : data.first(2)) mask |= waiting_bit(Value::from_word(word));
      break;
    case Kind::And:
    case Kind::Or:
      for (const Ref part : data) mask |= items_[part].waiting;
      break;
    case Kind::ForNew:
    case Kind::SomeNew:
      mask = items_[data[0]].waiting;
      break;
    case Kind::Sum: {
      const std::size_t terms = data[1];
      for (std::size_t i = 0; i < terms; ++i) mask |= items_[data[2 + 2 * i]].waiting;
      for (std::size_t i = 2 + 2 * terms; i < data.size(); i += 3) mask |= items_[data[i + 1]].waiting;
      break;
    }
  }
  (void)id;
  return mask;
}

void Residuals::grow_table() {
  table_.assign(table_.size() * 2, kFalse);
  const std::size_t mask = table_.size() - 1;
  for (Ref ref = 2; ref < items_.size(); ++ref) {
    std::size_t at = hash_of(items_[ref].kind, items_[ref].id, data(ref)) & mask;
    while (table_[at] != kFalse) at = (at + 1) & mask;
    table_[at] = ref;
  }
}

Ref Residuals::intern(Kind kind, std::uint32_t id, std::span<const std::uint32_t> data_in) {
  if (items_.size() * 2 >= table_.size()) grow_table();
  const std::size_t mask = table_.size() - 1;
  std::size_t at = hash_of(kind, id, data_in) & mask;
  for (; table_[at] != kFalse; at = (at + 1) & mask) {
    const Item& item = items_[table_[at]];
    if (item.kind != kind || item.id != id || item.size != data_in.size()) continue;
    if (std::equal(data_in.begin(), data_in.end(), pool_.begin() + item.begin)) return table_[at];
  }
  const auto begin = static_cast<std::uint32_t>(pool_.size());
  const std::uint64_t waiting = waiting_in(kind, id, data_in);
  pool_.insert(pool_.end(), data_in.begin(), data_in.end());
  items_.push_back({kind, id, begin, static_cast<std::uint32_t>(data_in.size()), waiting});
  table_[at] = static_cast<Ref>(items_.size() - 1);
  return table_[at];
}

Ref Residuals::pending(NodeId node, std::span<const std::uint32_t> values) {
  return intern(Kind::Pending, node, values);
}

Ref Residuals::same(Value a, Value b, bool positive) {
  if (a == b) return positive ? kTrue : kFalse;
  if (!a.waits() && !b.waits()) return positive ? kFalse : kTrue;
  const std::uint32_t data[] = {std::min(a, b).word(), std::max(a, b).word(), positive ? 1U : 0U};
  return intern(Kind::Same, 0, data);
}

Ref Residuals::for_new(Slot slot, Ref body) {
  if (body == kTrue) return kTrue;
  return intern(Kind::ForNew, slot, {&body, 1});
}

Ref Residuals::some_new(Slot slot, Ref body) {
  if (body == kFalse) return kFalse;
  return intern(Kind::SomeNew, slot, {&body, 1});
}

Residuals::SumView Residuals::view_sum(Ref ref) const {
  const auto words = data(ref);
  SumView view{static_cast<Relation>(id(ref)), static_cast<int>(words[0]), {}, {}};
  const std::size_t terms = words[1];
  for (std::size_t i = 0; i < terms; ++i) {
    view.terms.push_back({words[2 + 2 * i], static_cast<int>(words[3 + 2 * i])});
  }
  for (std::size_t i = 2 + 2 * terms; i < words.size(); i += 3) {
    view.news.push_back({words[i], words[i + 1], static_cast<int>(words[i + 2])});
  }
  return view;
}

Ref Residuals::sum(Relation relation, int constant, std::vector<Term> terms, std::vector<NewTerm> news) {
  std::sort(terms.begin(), terms.end());
  std::sort(news.begin(), news.end());
  std::vector<Term> kept;
  for (const Term& term : terms) {
    if (term.part == kTrue) constant += term.weight;
    if (term.part == kTrue || term.part == kFalse) continue;
    if (!kept.empty() && kept.back().part == term.part)
      kept.back().weight += term.weight;
    else
      kept.push_back(term);
  }
  std::erase_if(kept, [](const Term& term) { return term.weight == 0; });
  std::erase_if(news, [](const NewTerm& term) { return term.part == kFalse; });
  constexpr int kUnbounded = std::numeric_limits<int>::max() / 4;
  int low = constant, high = constant;
  for (const Term& term : kept) (term.weight > 0 ? high : low) += term.weight;
  for (const NewTerm& term : news) (term.weight > 0 ? high : low) = term.weight > 0 ? kUnbounded : -kUnbounded;
  const bool at_low = compare_with_zero(relation, low), at_high = compare_with_zero(relation, high);
  const bool two_sided = relation == Relation::Equal || relation == Relation::Unequal;
  if (low == high) return at_low ? kTrue : kFalse;
  if (two_sided && (low > 0 || high < 0)) return relation == Relation::Equal ? kFalse : kTrue;
  if (!two_sided && at_low == at_high) return at_low ? kTrue : kFalse;
  std::vector<std::uint32_t> words = {static_cast<std::uint32_t>(constant), static_cast<std::uint32_t>(kept.size())};
  for (const Term& term : kept) words.insert(words.end(), {term.part, static_cast<std::uint32_t>(term.weight)});
  for (const NewTerm& term : news) {
    words.insert(words.end(), {term.slot, term.part, static_cast<std::uint32_t>(term.weight)});
  }
  return intern(Kind::Sum, static_cast<std::uint32_t>(relation), words);
}

void Residuals::flatten(Kind kind, std::vector<Ref>& parts) const {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (items_[parts[i]].kind != kind) continue;
    const auto inner = data(parts[i]);
    parts[i] = inner[0];
    parts.insert(parts.end(), inner.begin() + 1, inner.end());
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
}

/// `for every new x: f` and `for every new x: g` is `for every new x: f and g`. True if something was joined.
bool Residuals::merge_new(Kind kind, std::vector<Ref>& parts) {
  const Kind quantifier = kind == Kind::And ? Kind::ForNew : Kind::SomeNew;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (items_[parts[i]].kind != quantifier) continue;
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      if (items_[parts[j]].kind != quantifier || id(parts[i]) != id(parts[j])) continue;
      const Slot slot = id(parts[i]);
      const Ref body = junction(kind, {data(parts[i])[0], data(parts[j])[0]});
      parts[i] = quantifier == Kind::ForNew ? for_new(slot, body) : some_new(slot, body);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
      return true;
    }
  }
  return false;
}

/// `ref` where every part in `known` has become `value`; `self` is the part of the outer set that is being looked into.
Ref Residuals::assume(Ref ref, const std::vector<Ref>& known, Ref value, Ref self) {
  if (ref != self && has(known, ref)) return value;
  const Kind kind = items_[ref].kind;
  if (kind != Kind::And && kind != Kind::Or) return ref;
  const auto words = data(ref);
  std::vector<Ref> parts(words.begin(), words.end());
  bool changed = false;
  for (Ref& part : parts) {
    const Ref now = assume(part, known, value, self);
    changed = changed || now != part;
    part = now;
  }
  return changed ? junction(kind, std::move(parts)) : ref;
}

Ref Residuals::junction(Kind kind, std::vector<Ref> parts) {
  const Ref neutral = kind == Kind::And ? kTrue : kFalse;
  const Ref decisive = kind == Kind::And ? kFalse : kTrue;
  const Kind opposite = kind == Kind::And ? Kind::Or : Kind::And;
  for (bool changed = true; changed;) {
    changed = false;
    flatten(kind, parts);
    std::erase(parts, neutral);
    if (has(parts, decisive)) return decisive;
    if (parts.size() <= 1) return parts.empty() ? neutral : parts.front();
    if (merge_new(kind, parts)) {
      changed = true;
      continue;
    }
    for (Ref& part : parts) {
      if (items_[part].kind != opposite) continue;
      const Ref now = assume(part, parts, neutral, part);
      if (now == part) continue;
      part = now;
      changed = true;
      break;
    }
  }
  return intern(kind, 0, parts);
}

Ref Residuals::instantiate(Ref ref, Slot slot, Value entity) {
  const Item item = items_[ref];
  if ((item.waiting & bit_of(slot)) == 0) return ref;
  const auto words = data(ref);
  std::vector<std::uint32_t> copy(words.begin(), words.end());
  switch (item.kind) {
    case Kind::False:
    case Kind::True:
      return ref;
    case Kind::Pending:
      std::replace(copy.begin(), copy.end(), Value::waiting(slot).word(), entity.word());
      return intern(Kind::Pending, item.id, copy);
    case Kind::Same:
      std::replace(copy.begin(), copy.begin() + 2, Value::waiting(slot).word(), entity.word());
      return same(Value::from_word(copy[0]), Value::from_word(copy[1]), copy[2] != 0);
    case Kind::And:
    case Kind::Or:
      for (Ref& part : copy) part = instantiate(part, slot, entity);
      return junction(item.kind, std::move(copy));
    case Kind::ForNew:
      return for_new(item.id, instantiate(copy[0], slot, entity));
    case Kind::SomeNew:
      return some_new(item.id, instantiate(copy[0], slot, entity));
    case Kind::Sum: {
      SumView view = view_sum(ref);
      for (auto& term : view.terms) term.part = instantiate(term.part, slot, entity);
      for (auto& term : view.news) term.part = instantiate(term.part, slot, entity);
      return sum(view.relation, view.constant, std::move(view.terms), std::move(view.news));
    }
  }
  return ref;
}

Ref Residuals::import(const Residuals& from, Ref ref, std::vector<Ref>& known) {
  if (ref <= kTrue) return ref;
  if (known[ref] != kFalse) return known[ref];
  const auto words = from.data(ref);
  std::vector<std::uint32_t> copy(words.begin(), words.end());
  switch (from.kind(ref)) {
    case Kind::And:
    case Kind::Or:
      for (Ref& part : copy) part = import(from, part, known);
      std::sort(copy.begin(), copy.end());
      break;
    case Kind::ForNew:
    case Kind::SomeNew:
      copy[0] = import(from, copy[0], known);
      break;
    case Kind::Sum: {
      SumView view = from.view_sum(ref);
      for (auto& term : view.terms) term.part = import(from, term.part, known);
      for (auto& term : view.news) term.part = import(from, term.part, known);
      return known[ref] = sum(view.relation, view.constant, std::move(view.terms), std::move(view.news));
    }
    case Kind::False:
    case Kind::True:
    case Kind::Pending:
    case Kind::Same:
      break;
  }
  return known[ref] = intern(from.kind(ref), from.id(ref), copy);
}

}  // namespace unietp::monitoring
