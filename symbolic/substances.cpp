#include "symbolic/substances.h"

#include <bit>

namespace unietp::symbolic {
namespace {

constexpr std::size_t kWordBits = 64;

std::size_t word_of(SubstanceId substance) { return substance.index() / kWordBits; }
std::uint64_t bit_of(SubstanceId substance) { return std::uint64_t{1} << (substance.index() % kWordBits); }

}  // namespace

bool SubstanceSet::contains(SubstanceId substance) const {
  return word_of(substance) < words_.size() && (words_[word_of(substance)] & bit_of(substance)) != 0;
}

bool SubstanceSet::has_other_than(std::optional<SubstanceId> one) const {
  int count = 0;
  for (const auto word : words_) count += std::popcount(word);
  return count > (one && contains(*one) ? 1 : 0);
}

void SubstanceSet::insert(SubstanceId substance) {
  if (word_of(substance) >= words_.size()) words_.resize(word_of(substance) + 1);
  words_[word_of(substance)] |= bit_of(substance);
}

void SubstanceSet::insert(const SubstanceSet& others) {
  if (others.words_.size() > words_.size()) words_.resize(others.words_.size());
  for (std::size_t i = 0; i < others.words_.size(); ++i) words_[i] |= others.words_[i];
}

void SubstanceSet::erase(SubstanceId substance) {
  if (contains(substance)) words_[word_of(substance)] &= ~bit_of(substance);
  while (!words_.empty() && words_.back() == 0) words_.pop_back();
}

std::uint64_t SubstanceSet::hash() const {
  std::uint64_t hash = words_.size();
  for (const auto word : words_) hash = (hash ^ word) * 0xff51afd7ed558ccdU;
  return hash;
}

}  // namespace unietp::symbolic
