// What people read is in American English: the pages, and the comments and names of the code. Names in files that the
// program reads and writes, such as `colour`, stay as they are; pages and comments write them in backquotes or as a
// part of a longer name.
#include <algorithm>
#include <array>
#include <cctype>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "code_pieces.h"
#include "core/files.h"
#include "core/text.h"
#include "source_files.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// How words begin that are spelled differently in Britain.
constexpr std::array<std::string_view, 25> kBritish{
    "analyse",   "behaviour", "cancelled", "catalogue", "centimetre", "centre",   "colour",  "favour", "flavour",
    "generalis", "honour",    "initialis", "judgement", "kilometre",  "labelled", "licence", "metre",  "millimetre",
    "neighbour", "normalis",  "optimis",   "randomis",  "recognis",   "summaris", "towards"};

bool is_british(std::string word) {
  word = lower(word);
  if (word.starts_with("optimist") || word.starts_with("optimism")) return false;
  return std::any_of(kBritish.begin(), kBritish.end(), [&](std::string_view stem) { return word.starts_with(stem); });
}

/// British words of a text outside of `names`, "quotations", paths and words with an underscore or a dot inside.
std::vector<std::string> british_words(std::string_view text) {
  std::vector<std::string> found;
  char quote = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const bool in_word = std::isalpha(static_cast<unsigned char>(c)) != 0;
    if (!in_word) {
      if (c == '`' || c == '"') quote = quote == 0 ? c : quote == c ? 0 : quote;
      if (c == '\n' && quote == '"') quote = 0;
      ++at;
      continue;
    }
    std::size_t end = at;
    const auto belongs = [&](std::size_t i) {
      return std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_' || text[i] == '/' ||
             (text[i] == '.' && i + 1 < text.size() && std::isalnum(static_cast<unsigned char>(text[i + 1])) != 0);
    };
    while (end < text.size() && belongs(end)) ++end;
    const std::string word(text.substr(at, end - at));
    const bool is_name = word.find_first_of("_./") != std::string::npos || (end < text.size() && text[end] == '(');
    if (quote == 0 && !is_name && is_british(word)) found.push_back(word);
    at = end;
  }
  return found;
}

/// A page without what stands between ``` and ```.
std::string without_listings(std::string_view page) {
  std::string kept;
  const auto parts = split(replace_all(std::string(page), "```", "\f"), '\f');
  for (std::size_t i = 0; i < parts.size(); i += 2) kept += parts[i];
  return kept;
}

TEST(Spelling, OfPagesIsAmerican) {
  const std::filesystem::path source = UNIETP_SOURCE_DIR;
  std::vector<std::filesystem::path> pages{source / "README.md", source / "CONTRIBUTING.md"};
  for (const auto& entry : std::filesystem::directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md" && entry.path().stem() != "coverage")  // a table of names
      pages.push_back(entry.path());
  for (const auto& page : pages) EXPECT_THAT(british_words(without_listings(*read_file(page))), IsEmpty()) << page;
}

TEST(Spelling, OfCommentsIsAmerican) {
  for (const auto& file : source_files({".cpp", ".h"})) {
    const auto code = read_file(file);
    ASSERT_TRUE(code) << file;
    for (const CodePiece& piece : pieces_of(*code)) {
      if (piece.kind != CodePiece::Kind::Comment) continue;
      EXPECT_THAT(british_words(piece.text), IsEmpty()) << file;
    }
  }
}

/// The words of which a name is made, as `few`, `Colors` and `png` of `fewColors_png`.
std::vector<std::string> words_of_names(std::string_view code) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < code.size(); ++i) {
    const auto c = static_cast<unsigned char>(code[i]);
    const bool begins = std::isupper(c) != 0 && i > 0 && std::isupper(static_cast<unsigned char>(code[i - 1])) == 0;
    if ((begins || std::isalpha(c) == 0) && !words.back().empty()) words.emplace_back();
    if (std::isalpha(c) != 0) words.back() += code[i];
  }
  return words;
}

TEST(Spelling, OfNamesInCodeIsAmerican) {
  for (const auto& file : source_files({".cpp", ".h"})) {
    const auto code = read_file(file);
    ASSERT_TRUE(code) << file;
    std::vector<std::string> found;
    for (const CodePiece& piece : pieces_of(*code))
      if (piece.kind == CodePiece::Kind::Code)
        for (const std::string& word : words_of_names(piece.text))
          if (is_british(word)) found.push_back(word);
    EXPECT_THAT(found, IsEmpty()) << file;
  }
}

TEST(Spelling, FindsTheWordsOfANameInCode) {
  EXPECT_THAT(words_of_names("kFewColours_png(Metre)"), ElementsAre("k", "Few", "Colours", "png", "Metre", ""));
}

TEST(Spelling, LeavesNamesOfFilesAsTheyAre) {
  EXPECT_THAT(british_words("Two Metres of colour."), ElementsAre("Metres", "colour"));
  EXPECT_THAT(british_words("`colour`, \"colour\", data/licences.csv, is_colour, nodes.colour, neighbours(3)"),
              IsEmpty());
  EXPECT_THAT(british_words("An optimist paints in color."), IsEmpty());
}

}  // namespace
}  // namespace unietp
