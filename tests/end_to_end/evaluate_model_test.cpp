// What SmolLM2-135M-Instruct answered on llama.cpp's server (checks/small_model with RECORD=FILE, one thread; the first
// replies of 20 tasks in M1), given again by a server of the tests.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "schema_checker.h"
#include "tests/llm/server.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::ChatServer;
using ::testing::HasSubstr;

TEST(EvaluateModel, TheRepliesOfASmallModelGiveTablesAndClassesOfFailure) {
  const auto recorded = json_lines(UNIETP_SOURCE_DIR "/tests/end_to_end/models/smollm2.jsonl");
  ASSERT_GE(recorded.size(), 80U);
  ChatServer server([&](const test::Received& request) {
    const auto which = static_cast<std::size_t>(request.number) % recorded.size();
    return test::http("200 OK", recorded[which].dump(), "Content-Type: application/json\r\n");
  });
  const ScratchFolder scratch;
  const std::string out = scratch.at("run");
  const Ended ended =
      run_program({"evaluate", data_set_in_all_modes().string(), "--out", out, "--model", "SmolLM2-135M-Instruct",
                   "--llm-url", server.url, "--images", "none", "--modes", "M1", "--at-once", "1"});
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("SmolLM2-135M-Instruct"));

  // Each reply is recorded as it was said; how it was to be classed is counted here from what the server sent.
  std::size_t number = 0;
  std::int64_t read_tokens = 0, written_tokens = 0;
  for (const Json& episode : json_lines(fs::path(out) / "episodes.jsonl")) {
    for (const Json& step : episode["steps"]) {
      const Json& body = recorded[number++ % recorded.size()];
      EXPECT_EQ(step["reply"], body["choices"][0]["message"]["content"]);
      EXPECT_EQ(step["finish"], body["choices"][0]["finish_reason"]);
      read_tokens += body["usage"]["prompt_tokens"].get<std::int64_t>();
      written_tokens += body["usage"]["completion_tokens"].get<std::int64_t>();
    }
  }
  EXPECT_EQ(number, static_cast<std::size_t>(server.count()));
  const Json totals = Json::parse(*read_file(fs::path(out) / "manifest.json"))["totals"];
  EXPECT_EQ(totals["prompt_tokens"], read_tokens);
  EXPECT_EQ(totals["completion_tokens"], written_tokens);
  EXPECT_EQ(totals["models"], Json::array({recorded.front()["model"]}));

  const Json results = Json::parse(*read_file(fs::path(out) / "results.json"));
  EXPECT_EQ(SchemaChecker().check(results, "results.schema.json"), "");
  const Json& mode = results["modes"][0];
  EXPECT_EQ(mode["all"]["episodes"], kCountInAllModes);
  int failed = 0, output = 0;
  for (const Json& one : mode["failures"]) {
    failed += one["episodes"].get<int>();
    output += one["class"].get<std::string>().starts_with("output: ") ? one["episodes"].get<int>() : 0;
  }
  EXPECT_EQ(failed, kCountInAllModes - mode["all"]["successes"].get<int>());
  EXPECT_GE(output, kCountInAllModes - 1) << "nearly all that it says is no JSON";
  EXPECT_THAT(*read_file(fs::path(out) / "tables.md"), HasSubstr("| SmolLM2-135M-Instruct |"));
  const Ended valid = run_program({"validate", out, "--dataset", data_set_in_all_modes().string()});
  EXPECT_EQ(valid.code, 0) << valid.out << valid.err;
}

}  // namespace
}  // namespace unietp
