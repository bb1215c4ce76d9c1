#include "llm/batch.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "asking.h"
#include "core/text.h"

namespace unietp {
namespace {

using test::question;
using test::questions;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Json = nlohmann::json;

std::string answer_line(const std::string& id, const std::string& content) {
  return Json{{"id", "x"},
              {"custom_id", id},
              {"response",
               {{"status_code", 200},
                {"body",
                 {{"choices", Json::array({{{"message", {{"content", content}}}}})},
                  {"usage", {{"prompt_tokens", 5}, {"completion_tokens", 2}}}}}}},
              {"error", nullptr}}
      .dump();
}

TEST(Batch, ARequestIsALineWithItsDigestAndTheBodyOfAChat) {
  const auto endpoint = batch_endpoint("tiny");
  const auto line = batch_line(endpoint, question(1));
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(id_of_batch_line(line), digest_of(endpoint, question(1)));
  EXPECT_EQ(id_of_batch_line("no request"), "");
  const auto json = Json::parse(line);
  EXPECT_EQ(json["method"], "POST");
  EXPECT_EQ(json["url"], "/v1/chat/completions");
  EXPECT_EQ(json["body"]["model"], "tiny");
  EXPECT_EQ(json["body"]["messages"][1]["content"], "question 1");
  EXPECT_EQ(json["body"]["response_format"]["json_schema"]["name"], "answer");
  EXPECT_LE(json["custom_id"].get<std::string>().size(), 64U);
}

TEST(Batch, AFileHoldsFiftyThousandRequestsAtMost) {
  const std::vector<std::string> lines(120'001, "{}");
  const auto files = batch_files(lines);
  ASSERT_THAT(files, SizeIs(3));
  EXPECT_EQ(split(files[0], '\n').size(), 50'001U);  // the last one is empty
  EXPECT_EQ(files[2].size(), 3U * 20'001);
  EXPECT_THAT(batch_files({"12345", "12345", "12345"}, 10, 12), SizeIs(2));
  EXPECT_THAT(batch_files({}), SizeIs(0));
}

TEST(Batch, AnswersAreReadInAnyOrder) {
  BatchAnswers there, back;
  const std::string a = answer_line("a", R"({"to":"a"})"), b = answer_line("b", R"(Well: {"to":"b"})");
  read_batch_answers("x.jsonl", a + "\n" + b + "\n", there);
  read_batch_answers("x.jsonl", b + "\n\n" + a, back);
  for (const auto* read : {&there, &back}) {
    EXPECT_THAT(read->unreadable, SizeIs(0));
    ASSERT_THAT(read->by_id, SizeIs(2));
    ASSERT_TRUE(read->by_id.at("b"));
    EXPECT_EQ(read->by_id.at("b")->text, R"({"to":"b"})");
    EXPECT_EQ(read->by_id.at("a")->prompt_tokens, 5);
  }
}

TEST(Batch, FailuresAndUnreadableLinesAreTold) {
  BatchAnswers answers;
  read_batch_answers("out.jsonl",
                     R"({"custom_id":"a","response":null,"error":{"code":"expired","message":"out of time"}})"
                     "\n"
                     R"({"custom_id":"b","response":{"status_code":500,"body":{"error":{"message":"oh"}}}})"
                     "\n"
                     R"({"custom_id":"c","response":{"status_code":200,"body":{"choices":[]}}})"
                     "\n" +
                         answer_line("d", "I would rather not.") + "\n{\"custom_id\": \"e\", \"resp",
                     answers);
  for (const char* id : {"a", "b", "c", "d"}) {
    ASSERT_TRUE(answers.by_id.contains(id)) << id;
    EXPECT_FALSE(answers.by_id.at(id)) << id;
    EXPECT_EQ(answers.failures[id], 1);
  }
  EXPECT_THAT(answers.by_id.at("a").error().message, HasSubstr("out of time"));
  EXPECT_THAT(answers.by_id.at("b").error().message, HasSubstr("status 500"));
  ASSERT_THAT(answers.unreadable, SizeIs(1));
  EXPECT_EQ(answers.unreadable[0].pos.line, 5);
}

TEST(Batch, AnAnswerWinsOverAFailureWhicheverIsReadFirst) {
  const std::string bad = R"({"custom_id":"a","response":null,"error":{"message":"expired"}})";
  const std::string good = answer_line("a", R"({"to":"a"})");
  for (const auto& text : {bad + "\n" + good, good + "\n" + bad}) {
    BatchAnswers answers;
    read_batch_answers("x", text, answers);
    EXPECT_TRUE(answers.by_id.at("a"));
  }
}

}  // namespace
}  // namespace unietp
