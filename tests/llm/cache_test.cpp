#include <unistd.h>

#include <filesystem>

#include <gmock/gmock.h>

#include "asking.h"
#include "core/files.h"
#include "llm/cache.h"

namespace unietp {
namespace {

using test::answer_to;
using test::ChatServer;
using test::endpoint_of;
using test::question;
using test::questions;
using test::quick;
using test::text_for;
using ::testing::HasSubstr;

class LlmCacheTest : public ::testing::Test {
 protected:
  LlmCacheTest() { std::filesystem::create_directories(folder_); }
  ~LlmCacheTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  LlmCache cache() {
    auto opened = LlmCache::open(file_);
    EXPECT_TRUE(opened) << format(opened.error());
    return std::move(*opened);
  }
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("unietp-llm-cache-" + std::to_string(::getpid()));
  const std::filesystem::path file_ = folder_ / "below" / "answers.sqlite";
};

TEST_F(LlmCacheTest, ASecondRunAsksNothingAndGivesTheSameBytes) {
  ChatServer server(answer_to);
  const auto endpoint = endpoint_of(server);
  auto first_cache = cache();
  const auto first = ask_all(endpoint, questions(7), quick(), &first_cache);
  EXPECT_EQ(server.count(), 7);
  auto second_cache = cache();
  const auto second = ask_all(endpoint, questions(7), quick(), &second_cache);
  EXPECT_EQ(server.count(), 7);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(first[i]->text, second[i]->text);
  const auto totals = totals_of(second);
  EXPECT_EQ(totals.cached, 7);
  EXPECT_EQ(totals.prompt_tokens, 0);
}

TEST_F(LlmCacheTest, KeepsEachAnswerAsItCome) {
  std::atomic<bool> stop = false;
  ChatServer server(answer_to);
  auto options = quick();
  options.stop = &stop;
  options.at_once = 1;
  int seen = 0;
  options.on_answer = [&](std::size_t, const Result<LlmAnswer>&) { stop = ++seen == 2; };
  {
    auto kept = cache();
    (void)ask_all(endpoint_of(server), questions(5), options, &kept);
  }
  auto kept = cache();
  const auto answers = ask_all(endpoint_of(server), questions(5), quick(), &kept);
  EXPECT_EQ(totals_of(answers).cached, 2);
  EXPECT_EQ(answers[4]->text, text_for(4));
}

TEST_F(LlmCacheTest, KnowsAnAnswerByAllThatShapedItAndNotByTheKey) {
  const LlmEndpoint endpoint{"http://a/v1/chat/completions", "tiny", "key"};
  const auto digest = digest_of(endpoint, question(0));
  EXPECT_EQ(digest_of({endpoint.url, endpoint.model, "another key"}, question(0)), digest);
  EXPECT_NE(digest_of({"http://b/v1/chat/completions", endpoint.model, ""}, question(0)), digest);
  EXPECT_NE(digest_of({endpoint.url, "large", ""}, question(0)), digest);
  EXPECT_NE(digest_of(endpoint, question(1)), digest);
  auto request = question(0);
  request.schema = "{}";
  EXPECT_NE(digest_of(endpoint, request), digest);
  request = question(0);
  request.temperature = 0;
  EXPECT_NE(digest_of(endpoint, request), digest);
  request = question(0);
  request.max_tokens = 5;
  EXPECT_NE(digest_of(endpoint, request), digest);
}

TEST_F(LlmCacheTest, KeepsNoFailure) {
  ChatServer server([](const auto& received) {
    return received.number == 0 ? test::http("404 Not Found", "") : answer_to(received);
  });
  auto kept = cache();
  EXPECT_FALSE(ask_all(endpoint_of(server), {question(0)}, quick(), &kept)[0]);
  EXPECT_TRUE(ask_all(endpoint_of(server), {question(0)}, quick(), &kept)[0]);
}

TEST_F(LlmCacheTest, AnAnswerThatWasDamagedInTheFileIsAskedAgain) {
  ChatServer server(answer_to);
  auto kept = cache();
  kept.store(digest_of(endpoint_of(server), question(0)), "tiny", {"no object", 1, 1, 1, false});
  const auto answers = ask_all(endpoint_of(server), {question(0)}, quick(), &kept);
  ASSERT_TRUE(answers[0]);
  EXPECT_EQ(answers[0]->text, text_for(0));
}

TEST_F(LlmCacheTest, AFileOfAnotherKindIsRefusedAndLeftAlone) {
  const std::string text = "These are my notes, which are longer than a header of SQLite would be, by some way indeed.";
  ASSERT_TRUE(write_file(file_, text));
  const auto opened = LlmCache::open(file_);
  ASSERT_FALSE(opened);
  EXPECT_THAT(format(opened.error()), HasSubstr("answers.sqlite"));
  EXPECT_EQ(*read_file(file_), text);
  EXPECT_FALSE(LlmCache::open(folder_));
}

}  // namespace
}  // namespace unietp
