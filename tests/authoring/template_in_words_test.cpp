#include "authoring/template_in_words.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace unietp {
namespace {

const TemplateReading& library() {
  static const auto kReading = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates" / "library");
  return kReading;
}

TEST(TemplateInWords, TheGoalsOfTheLibraryHaveWordsThatNameEveryPlaceholderAndNothingElse) {
  int worded = 0;
  for (const auto& source : library().templates) {
    const auto words = goal_in_words(source);
    if (!words) continue;
    ++worded;
    EXPECT_EQ(words->find("laceholder"), std::string::npos) << source.name << ": " << *words;
    for (const auto& name : categories_of(source.goal)) {
      EXPECT_NE(words->find("<" + name + ">"), std::string::npos) << source.name << ": " << *words;
    }
  }
  EXPECT_GE(worded * 10, static_cast<int>(library().templates.size()) * 9);
}

std::string start_words(const char* formula) {
  const auto read = parse_formula("", formula, FormulaUse::State);
  EXPECT_TRUE(read);
  return start_in_words(*read);
}

TEST(TemplateInWords, StartConstraintsAreShortPhrases) {
  EXPECT_EQ(start_words("(exists (?c - C) (and))"), "at least 1 <C>");
  EXPECT_EQ(start_words("(count >= 2 (?a - A) (dirty ?a))"), "at least 2 <A> that are dirty");
  EXPECT_EQ(start_words("(count = 1 (?a - A) (and (dirty ?a) (not (exists (?b - B) (on ?a ?b)))))"),
            "exactly 1 <A> that is dirty and on no <B>");
  EXPECT_EQ(start_words("(forall (?a - A) (not (filled ?a water)))"), "every <A> is not filled water");
  EXPECT_EQ(start_words("(forall (?r - R) (not (in_room agent ?r)))"), "every <R> is not where the agent is");
  EXPECT_EQ(start_words("(forall (?a - A/slice) (exists (?r - R) (in_room ?a ?r)))"), "every slice of <A> is in a <R>");
}

TEST(TemplateInWords, APlaceholderIsSaidByWhatItAsksFor) {
  EXPECT_EQ(parameter_in_words({"A", {"furniture", "openable"}, {}}),
            "a category that cannot be moved; can be opened and closed");
}

}  // namespace
}  // namespace unietp
