#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace unietp {

/// A 128-bit hash: different contents of one run have different digests (with a probability of error of 1 in 10^20 for
/// a million of them). A sum of digests is the digest of a multiset.
struct Digest {
  std::uint64_t a = 0, b = 0;
  bool operator==(const Digest&) const = default;
  Digest& operator+=(const Digest& other) {
    a += other.a;
    b += other.b;
    return *this;
  }
  Digest& operator-=(const Digest& other) {
    a -= other.a;
    b -= other.b;
    return *this;
  }
};

/// Hashes a sequence of words. Two lanes of the finalizer of SplitMix64 (Steele, Lea, Flood 2014).
class Digester {
 public:
  /// Takes in one more item. Order matters; a number counts by its bits, a text also by its length.
  Digester& add(std::uint64_t word) {
    a_ = mix(a_ ^ word) + 0x9e3779b97f4a7c15ULL;
    b_ = mix(b_ + word * 0xd1342543de82ef95ULL) ^ 0x2545f4914f6cdd1dULL;
    return *this;
  }
  Digester& add(double number) { return add(std::bit_cast<std::uint64_t>(number)); }
  Digester& add(std::string_view text) {
    std::uint64_t word = text.size();
    int filled = 0;
    for (const char c : text) {
      word = (word << 8) | static_cast<unsigned char>(c);
      if (++filled == 7) {
        add(word);
        word = 0;
        filled = 0;
      }
    }
    return add(word);
  }
  /// Of all that was added so far.
  Digest digest() const { return {mix(a_ + b_), mix(b_ ^ (a_ << 1))}; }

 private:
  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
  }
  std::uint64_t a_ = 0x243f6a8885a308d3ULL, b_ = 0x13198a2e03707344ULL;
};

/// For unordered containers.
struct DigestHash {
  std::size_t operator()(const Digest& digest) const { return digest.a; }
};

}  // namespace unietp
