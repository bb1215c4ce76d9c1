#include "report/review_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string file(const std::string& reviews) {
  return R"({"format": "unietp-review/1", "set": "mine", "tasks_sha256": "ab", "reviews": [)" + reviews + "]}";
}
constexpr const char* kAccept = R"({"task": "a-1", "verdict": "accept", "instruction": "Open it.", "comment": ""})";

TEST(ReadReviews, GivesEachVerdict) {
  const auto reviews = read_reviews(
      "r.json",
      file(std::string(kAccept) +
           R"(, {"task": "a-2", "verdict": "edit", "instruction": "Open.", "text": " Shut it. ", "comment": "typo"})"));
  ASSERT_TRUE(reviews) << format(reviews.error());
  EXPECT_THAT(*reviews, ElementsAre(Review{"a-1", Judgment::Accept, "Open it.", "", ""},
                                    Review{"a-2", Judgment::Edit, "Open.", "Shut it.", "typo"}));
}

TEST(ReadReviews, WhatIsWrongIsNamedWithItsPlace) {
  const auto refused = [](const std::string& text) {
    const auto reviews = read_reviews("r.json", text);
    return reviews ? std::string("read") : format(reviews.error());
  };
  EXPECT_THAT(refused("{\"format\": \"unietp-review/2\"}"), HasSubstr("unietp-review/1"));
  EXPECT_THAT(refused("{"), HasSubstr("r.json:1"));
  EXPECT_THAT(refused(file(std::string(kAccept) + "," + kAccept)), HasSubstr("occurs twice"));
  EXPECT_THAT(refused(file(R"({"task": "a", "verdict": "acept", "instruction": "x", "comment": ""})")),
              HasSubstr("did you mean \"accept\""));
  EXPECT_THAT(refused(file(R"({"task": "a", "verdict": "edit", "instruction": "x", "comment": ""})")),
              HasSubstr("an edit needs a text"));
  EXPECT_THAT(refused(file(R"({"task": "a", "verdict": "reject", "instruction": "x", "text": "y", "comment": ""})")),
              HasSubstr("not an edit"));
  EXPECT_THAT(refused(file(R"({"task": "a", "verdict": "reject", "instruction": "x", "comment": 3})")),
              HasSubstr("reviews/0/comment"));
}

}  // namespace
}  // namespace unietp
