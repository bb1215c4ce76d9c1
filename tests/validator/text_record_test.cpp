#include "validator/text_record.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

using Checks = std::vector<std::string>;

bool is_sound(const std::string& writer, const Checks& checks, const std::string& why, bool by_model) {
  return origin_fault({writer, checks, why}, by_model).empty();
}

TEST(TextOrigin, HasTheChecksOfItsWriter) {
  const Checks read{"form", "parses-back", "style"}, judged{"form", "words", "style", "judged-back"};
  EXPECT_TRUE(is_sound("grammar", read, "", false));
  EXPECT_TRUE(is_sound("grammar", read, "refused", true));
  EXPECT_TRUE(is_sound("llm:m", judged, "", true));
  EXPECT_TRUE(is_sound("person", read, "", false));
  EXPECT_TRUE(is_sound("person:unchecked", {"form", "style"}, "", false));
  EXPECT_FALSE(is_sound("grammar", {"form", "style", "parses-back"}, "", false));
  EXPECT_FALSE(is_sound("grammar", judged, "", false));
  EXPECT_FALSE(is_sound("llm:m", read, "", true));
  EXPECT_FALSE(is_sound("person:unchecked", read, "", false));
  EXPECT_FALSE(is_sound("person:unchecked", {"words"}, "", false));
}

TEST(TextOrigin, SaysWhyTheGrammarStandsInForAModelAndOnlyThen) {
  const Checks read{"form", "parses-back", "style"}, judged{"form", "words", "style", "judged-back"};
  EXPECT_FALSE(is_sound("grammar", read, "", true));
  EXPECT_FALSE(is_sound("grammar", read, "refused", false));
  EXPECT_FALSE(is_sound("llm:m", judged, "refused", true));
  EXPECT_FALSE(is_sound("llm:m", judged, "", false));
  EXPECT_FALSE(is_sound("llm:", judged, "", true));
  EXPECT_FALSE(is_sound("nobody", read, "", false));
}

}  // namespace
}  // namespace unietp
