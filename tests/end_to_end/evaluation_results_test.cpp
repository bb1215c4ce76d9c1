// Results of the real program: a forged number in any file of an evaluation is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/digest.h"
#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "program.h"
#include "schema_checker.h"
#include "tests/llm/server.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/thorough.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A value of the same type that is another one.
Json forged(const Json& value) {
  if (value.is_boolean()) return !value.get<bool>();
  if (value.is_number_integer() || value.is_number_unsigned()) return value.get<std::int64_t>() + 1;
  if (value.is_number()) return value.get<double>() == 0 ? Json(0.25) : Json(value.get<double>() / 2);
  return value.get<std::string>() + "x";
}

std::vector<std::string> leaves(const Json& json) {
  std::vector<std::string> pointers;
  const Json flat = json.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    if (value.is_boolean() || value.is_number() || value.is_string()) pointers.push_back(pointer);
  }
  return pointers;
}

/// A run of four episodes, made once for all tests of this process.
const fs::path& sound_run() {
  static const ScratchFolder kScratch;
  static const fs::path kRun = [] {
    const Ended made = run_program({"evaluate", data_set_in_all_modes().string(), "--policy", "noisy:0.3", "--modes",
                                    "M1,M3", "--limit", "2", "--out", kScratch.at("run")});
    EXPECT_EQ(made.code, 0) << made.err;
    return fs::path(kScratch.at("run"));
  }();
  return kRun;
}

class ForgedRun : public ::testing::Test {
 protected:
  ForgedRun() : run_(scratch_.at("run")) { fs::copy(sound_run(), run_, fs::copy_options::recursive); }
  Ended validated() const { return run_program({"validate", run_, "--dataset", data_set_in_all_modes().string()}); }
  std::string read(const std::string& file) const { return *read_file(fs::path(run_) / file); }
  void write(const std::string& file, const std::string& text) const {
    ASSERT_TRUE(write_file(fs::path(run_) / file, text));
  }
  /// Makes the manifest's checksum of the episodes true again, so that only what they mean is left to find.
  void vouch() const {
    Json manifest = Json::parse(read("manifest.json"));
    for (Json& file : manifest["files"]) {
      if (file["path"] == "episodes.jsonl") file["sha256"] = sha256(read("episodes.jsonl"));
    }
    write("manifest.json", manifest.dump(2) + "\n");
  }

  ScratchFolder scratch_;
  std::string run_;
};

TEST_F(ForgedRun, IsSoundAsItWasWritten) {
  const Ended fine = validated();
  EXPECT_EQ(fine.code, 0) << fine.out << fine.err;
  EXPECT_THAT(fine.out, HasSubstr("no problem"));
  SchemaChecker schemas;
  for (const auto& line : json_lines(fs::path(run_) / "scores.jsonl"))
    EXPECT_EQ(schemas.check(line, "score.schema.json"), "");
  EXPECT_EQ(schemas.check(Json::parse(read("results.json")), "results.schema.json"), "");
  EXPECT_EQ(run_program({"validate", run_}).code, 2) << "it has to be told the data set";
  EXPECT_EQ(run_program({"validate", run_, "--dataset", small_data_set().string()}).code, 2) << "and the right one";
}

TEST_F(ForgedRun, IsFoundByEveryFieldThatFollowsFromTheReplies) {
  const std::string episodes = read("episodes.jsonl"), manifest = read("manifest.json");
  std::vector<std::string> lines = split(episodes, '\n');
  const std::string first = lines.front();
  std::set<std::string> tried;
  for (const std::string& pointer : leaves(Json::parse(first))) {
    std::string field = pointer;  // without numbers: each field once
    std::erase_if(field, [](char c) { return c >= '0' && c <= '9'; });
    if (!tried.insert(field).second) continue;
    Json line = Json::parse(first);
    Json& value = line[Json::json_pointer(pointer)];
    value = forged(value);
    lines.front() = line.dump();
    write("episodes.jsonl", join(lines, "\n"));
    vouch();
    const Ended ended = validated();
    EXPECT_TRUE(ended.code == 1 || ended.code == 2) << pointer << "\n" << ended.out;
  }
  EXPECT_GT(tried.size(), 20U);
  write("episodes.jsonl", episodes);
  write("manifest.json", manifest);
  EXPECT_EQ(validated().code, 0);
}

TEST_F(ForgedRun, IsFoundByEveryNumberOfItsResults) {
  for (const std::string file : {"results.json", "lm_eval.json"}) {
    const std::string sound = read(file);
    const auto pointers = leaves(Json::parse(sound));
    for (std::size_t i = 0; i < pointers.size(); i += static_cast<std::size_t>(test::tries(97, 7))) {
      Json json = Json::parse(sound);
      Json& value = json[Json::json_pointer(pointers[i])];
      value = forged(value);
      write(file, json.dump(1) + "\n");
      const Ended ended = validated();
      EXPECT_EQ(ended.code, 1) << pointers[i];
      EXPECT_THAT(ended.out, HasSubstr(file));
    }
    write(file, sound);
  }
  for (const std::string file :
       {"tables.md", "tables.tex", "tables.csv", "scores.jsonl", "report.html", "timing.jsonl"}) {
    const std::string sound = read(file);
    std::string changed = sound;
    const auto digit = changed.find_last_of("12345678");
    changed[digit] = static_cast<char>(changed[digit] + 1);
    write(file, changed);
    EXPECT_EQ(validated().code, 1) << file;
    write(file, sound);
  }
  EXPECT_EQ(validated().code, 0);
}

TEST_F(ForgedRun, IsFoundByEveryTotalOfItsManifest) {
  test::ChatServer server([](const test::Received& request) {
    return test::completion(request.number % 3 == 2 ? R"({"action": "stop", "args": []})" : "I wonder.");
  });
  const Ended made = run_program({"evaluate", data_set_in_all_modes().string(), "--model", "some-model", "--llm-url",
                                  server.url, "--images", "none", "--price-in", "0.15", "--price-out", "0.6",
                                  "--at-once", "2", "--out", scratch_.at("model")});
  ASSERT_EQ(made.code, 0) << made.err;
  run_ = scratch_.at("model");
  const std::string sound = read("manifest.json");
  const Json totals = Json::parse(sound)["totals"];
  EXPECT_GT(totals["cost"], 0);
  ASSERT_EQ(validated().code, 0);
  std::vector<Json> others;
  for (const std::string& pointer : leaves(totals)) {
    others.push_back(totals);
    Json& value = others.back()[Json::json_pointer(pointer)];
    value = forged(value);
  }
  EXPECT_GE(others.size(), 6U) << totals;
  others.push_back(totals);
  others.back()["models"].push_back("another model");
  for (const Json& other : others) {
    Json manifest = Json::parse(sound);
    manifest["totals"] = other;
    write("manifest.json", manifest.dump(2) + "\n");
    const Ended ended = validated();
    EXPECT_EQ(ended.code, 1) << other << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("manifest.json#/totals/")) << other;
  }
}

TEST_F(ForgedRun, IsNotCompared) {
  ASSERT_EQ(run_program({"compare", run_}).code, 0);
  const auto refused = [&](const std::string& what) {
    const Ended ended = run_program({"compare", run_});
    EXPECT_EQ(ended.code, 2) << what;
    EXPECT_THAT(ended.err, HasSubstr(what));
  };
  const std::string scores = read("scores.jsonl"), episodes = read("episodes.jsonl");
  std::vector<std::string> lines = split(scores, '\n');
  const Json first = Json::parse(lines.front());
  for (const std::string field : {"steps", "actions", "replies", "split", "template", "prompt_tokens"}) {
    Json line = first;
    ASSERT_TRUE(line.contains(field)) << first;
    line[field] = forged(line[field]);
    lines.front() = line.dump();
    write("scores.jsonl", join(lines, "\n"));
    refused("its " + field + " is not that of the episode");
  }
  write("scores.jsonl", scores.substr(scores.find('\n') + 1));
  refused("its task is not that of the episode");
  write("scores.jsonl", scores + lines[1] + "\n");
  refused("has more lines than episodes.jsonl");
  write("scores.jsonl", scores);
  write("episodes.jsonl", episodes.substr(episodes.find('\n') + 1));
  refused("is not the file whose SHA-256 the manifest has");
  write("episodes.jsonl", episodes);
  EXPECT_EQ(run_program({"compare", run_}).code, 0);
}

TEST_F(ForgedRun, MustNotBeMixedWithAnotherDataSet) {
  EXPECT_EQ(run_program({"compare", run_, run_}).code, 0);
  const std::string other = scratch_.at("other");
  ASSERT_EQ(
      run_program({"evaluate", small_data_set().string(), "--policy", "stop", "--limit", "3", "--out", other}).code, 0);
  const Ended mixed = run_program({"compare", run_, other});
  EXPECT_EQ(mixed.code, 2);
  EXPECT_THAT(mixed.err, HasSubstr("cannot be compared"));
}

}  // namespace
}  // namespace unietp
