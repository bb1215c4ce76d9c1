#include "evaluation/episode_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sample_records.h"
#include "schema_checker.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

TEST(EpisodeRecord, ReadsBackWhatWasWritten) {
  for (const EpisodeRecord& episode : {sample_episode(), errored_episode()}) {
    const auto line = episode_line(episode);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const auto read = read_episode("episodes.jsonl", 1, line);
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(*read, episode);
    EXPECT_EQ(episode_line(*read), line);
  }
  const auto timing = read_timing("timing.jsonl", 1, timing_line(sample_timing()));
  ASSERT_TRUE(timing) << format(timing.error());
  EXPECT_EQ(*timing, sample_timing());
}

TEST(EpisodeRecord, IsAsItsSchemaSays) {
  SchemaChecker checker;
  for (const EpisodeRecord& episode : {sample_episode(), errored_episode()})
    EXPECT_EQ(checker.check(Json::parse(episode_line(episode)), "episode.schema.json"), "");
  EXPECT_EQ(checker.check(Json::parse(timing_line(sample_timing())), "timing.schema.json"), "");
}

/// Removes, mistypes and adds fields, wherever there are some, and calls `judge` with each result and the place.
template <class Judge>
void spoil_each_field(const Json& whole, const Json& part, const std::string& pointer, const Judge& judge) {
  if (part.is_array()) {
    for (std::size_t i = 0; i < part.size(); ++i)
      spoil_each_field(whole, part[i], pointer + "/" + std::to_string(i), judge);
  }
  if (!part.is_object()) return;
  Json more = whole;
  more[Json::json_pointer(pointer)]["extra"] = 1;
  judge(more, pointer + "/extra");
  for (const auto& [name, value] : part.items()) {
    const bool may_be_missing = name == "simulator" || name.starts_with("edges_");
    if (!may_be_missing) {
      Json less = whole;
      less[Json::json_pointer(pointer)].erase(name);
      judge(less, pointer + "/" + name);
    }
    Json mistyped = whole;
    mistyped[Json::json_pointer(pointer)][name] = value.is_object() ? Json(7) : Json::object();
    judge(mistyped, pointer + "/" + name);
    spoil_each_field(whole, value, pointer + "/" + name, judge);
  }
}

TEST(EpisodeRecord, RefusesMissingMistypedAndUnknownFields) {
  int damaged = 0;
  const Json episode = Json::parse(episode_line(errored_episode()));
  spoil_each_field(episode, episode, "", [&](const Json& json, const std::string& place) {
    const auto read = read_episode("episodes.jsonl", 4, json.dump());
    ++damaged;
    ASSERT_FALSE(read) << place;
    EXPECT_THAT(format(read.error()), HasSubstr("episodes.jsonl:4")) << place;
  });
  const Json timing = Json::parse(timing_line(sample_timing()));
  spoil_each_field(timing, timing, "", [&](const Json& json, const std::string& place) {
    ++damaged;
    EXPECT_FALSE(read_timing("timing.jsonl", 4, json.dump())) << place;
  });
  EXPECT_GT(damaged, 100);
}

TEST(EpisodeRecord, RefusesFieldsThatContradictEachOther) {
  const Json sound = Json::parse(episode_line(sample_episode()));
  const auto refused = [&](const char* pointer, const Json& value) {
    Json json = sound;
    json[Json::json_pointer(pointer)] = value;
    const auto read = read_episode("episodes.jsonl", 1, json.dump());
    return read ? std::string("read") : read.error().message;
  };
  EXPECT_EQ(refused("/end", "stop"), "read");
  EXPECT_THAT(refused("/end", "errored"), HasSubstr("\"error\" exactly"));
  EXPECT_THAT(refused("/error", {{"kind", "timeout"}, {"message", "m"}}), HasSubstr("\"error\" exactly"));
  EXPECT_THAT(refused("/repeat", 0), HasSubstr("from 1"));
  EXPECT_THAT(refused("/progress", 1.5), HasSubstr("from 0 to 1"));
  EXPECT_THAT(refused("/steps/0/actions/0/failure", "not_visible"), HasSubstr("none"));
  EXPECT_THAT(refused("/steps/0/actions", Json::array()), HasSubstr("at least one action"));
  EXPECT_THAT(refused("/steps/0/prompt", "abc"), HasSubstr("SHA-256"));
  EXPECT_THAT(refused("/models", {"b", "a"}), HasSubstr("in order"));
  EXPECT_THAT(refused("/end", "tired"), HasSubstr("errored"));
}

TEST(EpisodeRecord, BytesThatAreNoTextBecomeText) {
  EpisodeRecord episode = sample_episode();
  episode.steps[0].reply = "caf\xE9 \x01";
  const auto read = read_episode("episodes.jsonl", 1, episode_line(episode));
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_EQ(read->steps[0].reply, "caf\xEF\xBF\xBD \x01");
}

}  // namespace
}  // namespace unietp
