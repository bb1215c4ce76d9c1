// The key stands in one header of what is sent, and nowhere else, whatever the server does with it.
#include <unistd.h>

#include <filesystem>

#include <gmock/gmock.h>

#include "asking.h"
#include "core/files.h"
#include "llm/cache.h"
#include "llm/redact.h"

namespace unietp {
namespace {

using test::ChatServer;
using test::completion;
using test::endpoint_of;
using test::http;
using test::kKey;
using test::question;
using test::quick;
using test::Received;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Key, IsSentInOneHeader) {
  ChatServer server(test::answer_to);
  ASSERT_TRUE(ask_all(endpoint_of(server), {question(0)}, quick(), nullptr)[0]);
  const auto received = server.received().at(0);
  EXPECT_THAT(received.head, HasSubstr(std::string("Authorization: Bearer ") + kKey));
  EXPECT_THAT(received.body, Not(HasSubstr(kKey)));
  EXPECT_THAT(display_text(question(0)), Not(HasSubstr(kKey)));
}

TEST(Key, IsNotSentWhenThereIsNone) {
  ChatServer server(test::answer_to);
  ASSERT_TRUE(ask_all({server.url, "tiny", ""}, {question(0)}, quick(), nullptr)[0]);
  EXPECT_THAT(server.received().at(0).head, Not(HasSubstr("Authorization")));
}

TEST(Key, WithALineEndIsRefusedWithoutShowingIt) {
  ChatServer server(test::answer_to);
  const auto answers = ask_all({server.url, "tiny", "sk-1234\r\nX: y"}, {question(0)}, quick(), nullptr);
  ASSERT_FALSE(answers[0]);
  EXPECT_THAT(format(answers[0].error()), Not(HasSubstr("sk-1234")));
  EXPECT_EQ(server.count(), 0);
}

std::string escaped(const std::string& text) {
  std::string bytes;
  const char* digits = "0123456789abcdef";
  for (const char c : text) bytes += std::string("\\u00") + digits[(c >> 4) & 15] + digits[c & 15];
  return bytes;
}

TEST(Key, IsInNoErrorAndNoFileWhenTheServerRepeatsIt) {
  const std::string key = kKey, half = key.substr(0, 14), leak = "your key " + key + " is bad, so is " + half + "***";
  const std::vector<std::string> answers = {
      http("401 Unauthorized", leak),
      http("401 " + leak, leak, "WWW-Authenticate: " + key + "\r\n"),
      http("403 Forbidden", R"({"error":{"message":")" + leak + "\"}}"),
      http("403 Forbidden", R"({"error":")" + escaped(leak) + "\"}"),
      http("429 Too Many Requests", R"({"message":")" + leak + "\"}", "Retry-After: " + key + "\r\n"),
      http("500 Oh", R"({"detail":")" + leak + "\"}"),
      http("200 OK", leak),
      completion(leak),
      completion("{\"to\": \"" + leak + "\"}"),
      completion("{\"to\": [\"" + escaped(leak) + "\"]}"),
      completion("{\"" + key + "\": 1}"),
      http("302 Found", "", "Location: http://127.0.0.1:9/" + key + "\r\n"),
      leak,
  };
  const auto folder = std::filesystem::temp_directory_path() / ("unietp-llm-key-" + std::to_string(::getpid()));
  for (const auto& answer : answers) {
    SCOPED_TRACE(answer);
    ChatServer server([&](const Received&) { return answer; });
    {
      auto cache = LlmCache::open(folder / "answers.sqlite");
      ASSERT_TRUE(cache) << format(cache.error());
      const auto got = ask_all(endpoint_of(server), {question(0)}, quick(), &*cache);
      ASSERT_FALSE(got[0]) << got[0]->text;
      EXPECT_THAT(format(got[0].error()), Not(HasSubstr(half)));
      EXPECT_FALSE(cache->failure());
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      EXPECT_THAT(*read_file(entry.path()), Not(HasSubstr(half)));
  }
  std::filesystem::remove_all(folder);
}

TEST(Redacted, HidesTheKeyAndLongPartsOfIt) {
  EXPECT_EQ(redacted("a sk-very-secret-0123456789 b", kKey), "a [key] b");
  EXPECT_EQ(redacted("sk-very-***6789", kKey), "[key]***6789");
  EXPECT_EQ(redacted("sk-very or 6789", kKey), "sk-very or 6789");  // too short to tell
  EXPECT_EQ(redacted("abcabc", "abc"), "[key][key]");
  EXPECT_EQ(redacted("nothing to hide", ""), "nothing to hide");
}

TEST(PlainLine, IsOneLineThatATerminalMayShow) {
  EXPECT_EQ(plain_line(" a\x1b[31m\nb\xc3\xa9 ", 200), "a [31m b");
  EXPECT_EQ(plain_line("abcdef", 3), "abc...");
}

}  // namespace
}  // namespace unietp
