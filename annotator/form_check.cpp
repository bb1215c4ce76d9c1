#include "annotator/word_check.h"
#include "annotator/words_for_reading.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace unietp {
namespace {

constexpr std::size_t kFewestWords = 2, kMostWords = 160;
constexpr std::size_t kMostWordsAPart = 24;  // of a goal so large that it has more than kMostWords
constexpr std::string_view kMarkup = "*#<>[]{}|\\`~^=@_\n\r\t";
constexpr std::array<bool, 256> kIsMark = [] {
  std::array<bool, 256> marks{};
  for (const char c : kMarkup) marks[static_cast<unsigned char>(c)] = true;
  return marks;
}();
constexpr std::string_view kEnglish =
    "a. an. the. that. to. of. in. on. into. with. and. or. is. are. should. must. please. you. it. make. sure. put. "
    "every. all. no. not. one. two. place. at. then. before. until. so. i. for. open. close. turn. keep. take. clean. ";

/// `mug_3`, `mug3`, `mug-3`: a name with a number behind it. "mp3" and the like are in the lexicon.
bool is_id(std::string_view word) {
  const std::size_t digits = word.find_last_not_of("0123456789");
  if (digits == std::string_view::npos || digits + 1 == word.size()) return false;
  return word[digits] == '_' || word[digits] == '-' || digits > 1;
}

bool has_coordinates(const std::string& text) {
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const bool point = text[i] == '.' && std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0;
    if (point && std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0) return true;
  }
  return false;
}

/// Number of predicates and operators, each of which needs some words.
std::size_t parts_of(const Formula& goal) {
  std::size_t parts = 1;
  for (const Formula& where : goal.domain.where) parts += parts_of(where);
  for (const Formula& child : goal.children) parts += parts_of(child);
  return parts;
}

}  // namespace

std::vector<std::string> form_faults(const std::string& text, const Specification& specification) {
  std::vector<std::string> faults;
  const auto is_mark = [](char c) { return kIsMark[static_cast<unsigned char>(c)]; };
  if (const auto mark = static_cast<std::size_t>(std::find_if(text.begin(), text.end(), is_mark) - text.begin());
      mark < text.size())
    faults.push_back(std::string("the text has '") + (text[mark] < ' ' ? ' ' : text[mark]) +
                     "', which is not plain English");
  if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c >= 0x80; }))
    faults.emplace_back("the text has letters that are not English");
  if (has_coordinates(text)) faults.emplace_back("the text has a number with a decimal point, such as a coordinate");
  const std::vector<Token> words = tokens_of(text);
  std::size_t known = 0, count = 0;
  for (const Token& word : words) {
    if (!std::isalnum(static_cast<unsigned char>(word.text[0]))) continue;
    ++count;
    known += known * 8 < words.size() && is_among(word.text, kEnglish) ? 1 : 0;  // as far as it matters
    if (is_id(word.text)) faults.push_back("the text names the object id '" + word.text + "'");
    if (!specification.template_name.empty() && word.text == specification.template_name &&
        word.text.find('-') != std::string::npos)
      faults.push_back("the text names the template '" + word.text + "'");
  }
  if (count < kFewestWords) faults.emplace_back("the text has too few words");
  if (count > kMostWords) {
    const std::size_t most = std::max(kMostWords, kMostWordsAPart * parts_of(specification.goal));
    if (count > most)
      faults.push_back("the text has " + std::to_string(count) + " words, more than " + std::to_string(most));
  }
  if (count >= 5 && known * 8 < count) faults.emplace_back("the text does not look English");
  return faults;
}

}  // namespace unietp
