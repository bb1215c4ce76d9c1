#include "annotator/phrasing_sets.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace unietp {
namespace {

constexpr std::array<std::string_view, 16> kLeftOut{"a",      "an", "the", "one",   "that", "this", "same", "some",
                                                    "single", "it", "two", "three", "four", "five", "six",  "and"};

bool is_left_out(std::string_view word) { return std::find(kLeftOut.begin(), kLeftOut.end(), word) != kLeftOut.end(); }

}  // namespace

Phrasings phrasings_of(std::string_view text, const NounTable& nouns) {
  const std::vector<Token> words = tokens_of(text);
  std::uint64_t sum = 0xcbf29ce484222325;  // FNV-1a, 64 bits
  const auto add = [&](std::string_view word) {
    for (const char c : word) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    sum = (sum ^ ' ') * 0x100000001b3;
  };
  for (std::size_t i = 0; i < words.size();) {
    const auto function = nouns.function_at(words, i);
    const auto named = std::max(nouns.noun_at(words, i).length, nouns.function_again_at(words, i).length);
    const auto taken = function.length > 0 ? function.length : named;
    const bool mark = std::isalnum(static_cast<unsigned char>(words[i].text[0])) == 0;
    if (taken == 0 && !mark && !is_left_out(words[i].text)) add(words[i].text);
    i += taken > 0 ? taken : 1;
  }
  sum ^= sum >> 32;
  sum ^= sum >> 16;
  return (sum ^ (sum >> 7)) % 2 == 0 ? Phrasings::Training : Phrasings::Benchmark;
}

}  // namespace unietp
