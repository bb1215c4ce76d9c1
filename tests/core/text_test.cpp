#include "core/text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "core/rng.h"

namespace unietp {
namespace {

using Words = std::vector<std::string>;

TEST(Text, SplitAndJoinAreInverse) {
  EXPECT_EQ(split("a,b,,c", ','), (Words{"a", "b", "", "c"}));
  EXPECT_EQ(split("", ','), Words{""});
  for (const char* text : {"a,b", "", ",", "a,,b,"}) EXPECT_EQ(join(split(text, ','), ","), text);
  EXPECT_EQ(join({}, ","), "");
  EXPECT_EQ(join({"a", "a"}, ", "), "a, a");
}

TEST(Text, TrimLowerAndReplaceAllChangeWhatTheyName) {
  EXPECT_EQ(trim(" \t a b\r\n"), "a b");
  EXPECT_EQ(trim(" \n"), "");
  EXPECT_EQ(lower("CoffeeTable_1"), "coffeetable_1");
  EXPECT_EQ(replace_all("a_b_c", "_", "__"), "a__b__c");
  EXPECT_EQ(replace_all("aaa", "aa", "b"), "ba");
  EXPECT_TRUE(starts_with_vowel_letter("Apple"));
  EXPECT_FALSE(starts_with_vowel_letter("mug"));
  EXPECT_FALSE(starts_with_vowel_letter(""));
}

TEST(NearestName, FindsAMisspelledNameAndNothingFarAway) {
  const Words names = {"open", "closed", "power_on", "power_off"};
  EXPECT_EQ(nearest_name("opn", names), "open");
  EXPECT_EQ(nearest_name("OPEN", names), "open");
  EXPECT_EQ(nearest_name("poweron", names), "power_on");
  EXPECT_EQ(nearest_name("opne", names), "open");
  EXPECT_EQ(nearest_name("mgu", {"bat", "mug"}), "mug");
  EXPECT_EQ(nearest_name("elephant", names), "");
  EXPECT_EQ(nearest_name("x", {}), "");
  EXPECT_EQ(nearest_name("cat", {"bat", "rat"}), "bat");  // a tie goes to the first
}

TEST(NumberText, ReadsBackToTheSameNumber) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(2), "2");
  Rng rng(1);
  for (int i = 0; i < 10000; ++i) {
    const double value = rng.uniform(-1, 1) * (i % 2 == 0 ? 1e-9 : 1e12);
    ASSERT_EQ(std::strtod(number_text(value).c_str(), nullptr), value);
  }
}

}  // namespace
}  // namespace unietp
