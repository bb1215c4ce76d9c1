#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../llm/asking.h"
#include "annotator/llm_writer.h"
#include "small_knowledge.h"

namespace unietp {
namespace {

using test::ChatServer;
using test::completion;
using test::http;
using test::Received;
using testing_support::asking;
using testing_support::small_knowledge;

constexpr const char* kGoal = "(exists (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))";

std::string saying(const std::string& text) { return completion("{\"instruction\": \"" + text + "\"}"); }

/// A server that gives these answers, one after the other, the last one ever after.
ChatServer::Handler one_by_one(std::vector<std::string> answers) {
  return [answers = std::move(answers)](const Received& received) {
    return answers[std::min(static_cast<std::size_t>(received.number), answers.size() - 1)];
  };
}

Result<Instruction> written_by(ChatServer& server) {
  LlmWriterOptions options;
  options.endpoint = test::endpoint_of(server);
  options.ask = test::quick();
  return write_instruction_with_llm(asking(kGoal), small_knowledge(), options, Rng(1));
}

TEST(LlmWriter, TakesAnAnswerThatSaysTheGoal) {
  ChatServer server(one_by_one({saying("Place one mug on the table.")}));
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->text, "Place one mug on the table.");
  EXPECT_EQ(written->writer, "llm:tiny");
  ASSERT_EQ(server.count(), 1);
  EXPECT_TRUE(server.received()[0].structured);
}

TEST(LlmWriter, SendsBackWhatWasWrongAndTakesTheNext) {
  ChatServer server(one_by_one({saying("Put a mug in the fridge."), saying("Put a mug on the table.")}));
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->writer, "llm:tiny");
  ASSERT_EQ(server.count(), 2);
  EXPECT_NE(server.received()[1].user.find("refused"), std::string::npos);
}

TEST(LlmWriter, WaitsAsAskedAndTriesAgain) {
  ChatServer server(one_by_one({http("429 Too Many Requests", "slow down", "Retry-After: 0\r\n"), http("503 Busy", ""),
                                saying("Put a mug on the table.")}));
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->writer, "llm:tiny");
}

TEST(LlmWriter, FallsBackToTheGrammarAfterGarbage) {
  ChatServer server(one_by_one(
      {http("200 OK", "<html>"), http("200 OK", "{}"), saying("Fly to the moon."), saying("Put mug_3 away.")}));
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->writer, "grammar");
  EXPECT_TRUE(check_instruction(written->text, asking(kGoal), small_knowledge()).empty());
}

TEST(LlmWriter, FallsBackToTheGrammarWhenNothingComes) {
  ChatServer server(one_by_one({""}));
  const auto written = written_by(server);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->writer, "grammar");
}

}  // namespace
}  // namespace unietp
