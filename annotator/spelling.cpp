#include "annotator/spelling.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>

#include <hunspell/hunspell.hxx>

namespace unietp {
namespace {

constexpr std::array kDictionaries = {"en_US", "en_GB"};
constexpr const char* kFolder = "/usr/share/hunspell/";

/// By word: whether it belongs to a name of the lexicon.
std::vector<bool> in_names(const std::vector<Token>& words, const NounTable& nouns) {
  std::vector<bool> known(words.size(), false);
  for (std::size_t i = 0; i < words.size();) {
    const auto length = std::max(nouns.noun_at(words, i).length, nouns.function_at(words, i).length);
    std::fill_n(known.begin() + static_cast<std::ptrdiff_t>(i), length, true);
    i += std::max<std::size_t>(length, 1);
  }
  return known;
}

bool is_word(const std::string& text) { return std::isalpha(static_cast<unsigned char>(text[0])) != 0; }

}  // namespace

struct Spelling::Dictionaries {
  std::vector<std::unique_ptr<Hunspell>> all;

  /// Also tries capitals, since texts are in lower case and dictionaries have "AI" and "Monday".
  bool know(const std::string& word) {
    auto capital = word;
    capital[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(capital[0])));
    return std::any_of(all.begin(), all.end(), [&](auto& one) { return one->spell(word) || one->spell(capital); });
  }
};

Spelling::Spelling(std::unique_ptr<Dictionaries> dictionaries) : dictionaries_(std::move(dictionaries)) {}
Spelling::Spelling(Spelling&&) noexcept = default;
Spelling& Spelling::operator=(Spelling&&) noexcept = default;
Spelling::~Spelling() = default;

Result<Spelling> Spelling::open() {
  auto dictionaries = std::make_unique<Dictionaries>();
  for (const std::string name : kDictionaries) {
    const auto rules = kFolder + name + ".aff", words = kFolder + name + ".dic";
    for (const auto& file : {rules, words}) {
      std::error_code code;
      if (!std::filesystem::is_regular_file(file, code))
        return Error{Error::Kind::Io,
                     file,
                     {},
                     "is missing, and with it the check of spelling; install hunspell-en-us and hunspell-en-gb"};
    }
    dictionaries->all.push_back(std::make_unique<Hunspell>(rules.c_str(), words.c_str()));
  }
  return Spelling(std::move(dictionaries));
}

std::vector<std::string> Spelling::faults(const std::string& text, const NounTable& nouns) const {
  const auto words = tokens_of(text);
  const auto named = in_names(words, nouns);
  std::vector<std::string> found;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto& word = words[i].text;
    if (named[i] || !is_word(word) || !seen.insert(word).second || dictionaries_->know(word)) continue;
    const auto near = dictionaries_->all.front()->suggest(word);
    found.push_back("the word '" + word + "' is in no dictionary" + (near.empty() ? "" : " (" + near.front() + "?)"));
  }
  return found;
}

}  // namespace unietp
