#include "templates/phrasing_counts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "core/text.h"

namespace unietp {
namespace {

using WordList = std::vector<std::string>;

constexpr std::array<std::string_view, 13> kNumbers = {"zero",  "one",   "two",  "three", "four",   "five",  "six",
                                                       "seven", "eight", "nine", "ten",   "eleven", "twelve"};

WordList words_of(std::string_view text) {
  WordList words(1);
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

bool says_one_of(const WordList& words, const WordList& accepted) {
  return std::any_of(accepted.begin(), accepted.end(), [&](const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  });
}

WordList words_for(int number) {
  WordList words = {std::to_string(number)};
  if (static_cast<std::size_t>(number) < kNumbers.size())
    words.emplace_back(kNumbers[static_cast<std::size_t>(number)]);
  const WordList of_two = {"pair", "couple", "both", "second", "another", "twice", "several", "enough"};
  const WordList of_more = {"trio", "few", "several", "third"};
  const auto& more = number == 2 ? of_two : of_more;
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// "the {A:plural}"
bool names_them_all(std::string_view text) {
  for (auto at = text.find("he {"); at != std::string_view::npos; at = text.find("he {", at + 1)) {
    if (text.substr(at, text.find('}', at) - at).ends_with(":plural")) return true;
  }
  return false;
}

struct Asked {
  std::set<std::vector<int>> numbers;  // each in the ways it may be said: "more than two" is "at least three"
  bool all = false;
};

void collect(const Formula& formula, Asked& asked) {
  if (formula.op == Formula::Op::Count && formula.number >= 2) {
    std::vector<int> ways = {formula.number};
    if (formula.comparison == Comparison::Greater) ways.push_back(formula.number + 1);
    if (formula.comparison == Comparison::Less) ways.push_back(formula.number - 1);
    asked.numbers.insert(ways);
  }
  if (formula.op == Formula::Op::Forall) asked.all = true;
  for (const auto& child : formula.children) collect(child, asked);
}

}  // namespace

std::vector<DoubtfulPhrasing> doubtful_phrasings(const Template& source) {
  Asked asked;
  collect(source.goal, asked);
  const WordList of_all = {"all",    "every",      "each",      "any",     "no",      "none",    "whole",
                           "entire", "everything", "whatever",  "only",    "never",   "nothing", "both",
                           "clear",  "empty",      "whichever", "neither", "without", "not",     "rest",
                           "those",  "together",   "where"};  // "leave the one on the bed where it is"
  std::vector<DoubtfulPhrasing> doubtful;
  for (std::size_t i = 0; i < source.instructions.size(); ++i) {
    const auto words = words_of(source.instructions[i]);
    for (const auto& ways : asked.numbers) {
      const bool said =
          std::any_of(ways.begin(), ways.end(), [&](int number) { return says_one_of(words, words_for(number)); });
      if (said) continue;
      doubtful.push_back({i, "the goal counts " + std::to_string(ways.front()) +
                                 ", but this phrasing has no word for that, such as '" + words_for(ways.front()).at(1) +
                                 "'"});
    }
    if (asked.all && !says_one_of(words, of_all) && !names_them_all(source.instructions[i])) {
      doubtful.push_back({i,
                          "the goal is about every object of a category, but this phrasing has no word for that, "
                          "such as 'all' or 'every'"});
    }
  }
  return doubtful;
}

}  // namespace unietp
