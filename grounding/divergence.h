#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace unietp {

/// The sum of the values.
template <class Key>
double total(const std::map<Key, double>& values) {
  double sum = 0;
  for (const auto& [key, value] : values) sum += value;
  return sum;
}

/// The value of a key, 0 where it is missing.
template <class Key>
double value_or_zero(const std::map<Key, double>& values, const Key& key) {
  const auto found = values.find(key);
  return found == values.end() ? 0 : found->second;
}

/// The keys of both, each once.
template <class Key>
std::set<Key> keys_of(const std::map<Key, double>& a, const std::map<Key, double>& b) {
  std::set<Key> keys;
  for (const auto& [key, value] : a) keys.insert(key);
  for (const auto& [key, value] : b) keys.insert(key);
  return keys;
}

/// Jensen-Shannon divergence in bits, from 0 to 1, of values >= 0, which are made to add up to 1 first. nullopt when
/// one side has nothing.
template <class Key>
std::optional<double> divergence(const std::map<Key, double>& a, const std::map<Key, double>& b) {
  const double sum_a = total(a), sum_b = total(b);
  if (sum_a <= 0 || sum_b <= 0) return std::nullopt;
  const auto half = [](double p, double q) { return p <= 0 ? 0 : p * std::log2(2 * p / (p + q)); };
  double bits = 0;
  for (const Key& key : keys_of(a, b)) {
    const double p = value_or_zero(a, key) / sum_a, q = value_or_zero(b, key) / sum_b;
    bits += (half(p, q) + half(q, p)) / 2;
  }
  return bits;
}

}  // namespace unietp
