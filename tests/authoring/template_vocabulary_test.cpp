#include "authoring/template_vocabulary.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/files.h"

namespace unietp {
namespace {

std::size_t words_below(const std::vector<VocabularyGroup>& groups, std::size_t& without_meaning) {
  std::size_t words = 0;
  for (const auto& group : groups) {
    words += group.words.size() + words_below(group.groups, without_meaning);
    for (const auto& word : group.words) {
      if (word.word.empty() || word.usage.empty() || word.meaning.empty()) ++without_meaning;
      EXPECT_EQ(word.meaning.find('\n'), std::string::npos) << word.word;
      EXPECT_EQ(word.meaning.find('|'), std::string::npos) << word.word;
    }
  }
  return words;
}

TEST(TemplateVocabulary, EveryWordHasAUsageAndAMeaningOfOneLine) {
  std::size_t without_meaning = 0;
  EXPECT_GT(words_below(template_vocabulary(), without_meaning), 150U);
  EXPECT_EQ(without_meaning, 0U);
}

/// `unietp template vocabulary --markdown > docs/vocabulary.md` writes it anew.
TEST(TemplateVocabulary, TheCommittedPageIsTheGeneratedOne) {
  const auto page = read_file(std::filesystem::path(UNIETP_SOURCE_DIR) / "docs" / "vocabulary.md");
  ASSERT_TRUE(page);
  EXPECT_EQ(*page, vocabulary_page(template_vocabulary()));
}

TEST(TemplateVocabulary, TheTreeIsTheSameAsJson) {
  const auto groups = template_vocabulary();
  const auto json = vocabulary_json(groups);
  EXPECT_EQ(json["format"], "unietp-vocabulary/1");
  ASSERT_EQ(json["groups"].size(), groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    EXPECT_EQ(json["groups"][i]["name"], groups[i].name);
    EXPECT_EQ(json["groups"][i]["words"].size(), groups[i].words.size());
  }
}

}  // namespace
}  // namespace unietp
