#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace unietp {

/// A stream of random numbers as a value: SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number
/// generators"). Draws are our own because std:: distributions and std::shuffle differ between standard libraries.
/// `fork` gives an independent stream named by (stage, item), so later draws stay in place when one item draws more.
class Rng {
 public:
  explicit constexpr Rng(std::uint64_t seed) : key_(seed), state_(seed) {}

  /// The next 64 random bits.
  std::uint64_t next();
  std::uint64_t below(std::uint64_t bound);  // uniform in [0, bound), bound > 0, by rejection
  double unit();                             // uniform in [0, 1), 53 bits
  double uniform(double low, double high);   // uniform in [low, high)
  bool chance(double probability);           // true with the given probability
  /// Index drawn in proportion to the weights (each >= 0, sum > 0).
  std::size_t weighted(std::span<const double> weights);
  /// Depends on this stream's seed and the name only, not on how many numbers were drawn before.
  Rng fork(std::string_view stage, std::uint64_t item) const;

  template <class T>  // a random order, each equally likely (Fisher-Yates)
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }
  template <class List>  // an item of a list that is not empty, each equally likely
  const typename List::value_type& pick(const List& items) {
    return items[below(items.size())];
  }

 private:
  std::uint64_t key_;
  std::uint64_t state_;
};

}  // namespace unietp
