// data/schemas/ describes the files that the program reads and writes, and docs/fields.md is written from it. What
// finished data sets hold against it stands beside the tests of those files.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"
#include "data_set.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const fs::path kSource = UNIETP_SOURCE_DIR;

TEST(Schemas, AreWhatTheFieldPageIsWrittenFrom) {
  const auto page = run_program({"schemas", "--page"});
  ASSERT_EQ(page.code, 0) << page.err;
  EXPECT_EQ(*read_file(kSource / "docs" / "fields.md"), page.out)
      << "write it anew: unietp schemas --page > docs/fields.md";
}

TEST(Schemas, AreWellNamedAndLeadNowhereWrong) {
  for (const auto& entry : fs::directory_iterator(kSource / "data" / "schemas")) {
    const std::string name = entry.path().filename();
    SCOPED_TRACE(name);
    const auto schema = schema_file(name);
    EXPECT_EQ(schema["$id"], name);
    EXPECT_FALSE(schema.value("title", "").empty());
    EXPECT_FALSE(schema.value("description", "").empty());
  }
}

TEST(Schemas, DescribeTheSettingsThatComeWithTheProgram) {
  SchemaChecker checker;
  for (const char* name : {"benchmark.json", "training.json"}) {
    const auto settings = Json::parse(*read_file(kSource / "data" / "runs" / name));
    EXPECT_EQ(checker.check(settings, "run.schema.json"), "") << name;
  }
}

TEST(Schemas, DescribeAShardAndWhatItsRunReports) {
  const ScratchFolder scratch;
  ASSERT_TRUE(write_file(scratch.path() / "run.json", R"({"format": "unietp-run/1", "count": 2, "block": 1,
    "homes": "drawn", "rooms": 5, "objects": 25, "simulators": ["ai2thor"], "splits": ["atomic"]})"));
  const auto ended = run_program(
      {"training", "--config", scratch.at("run.json"), "--shard", "1/2", "--json", "--out", scratch.at("part")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  SchemaChecker checker;
  EXPECT_EQ(checker.check(Json::parse(ended.out), "generation.schema.json"), "");
  const auto shard = Json::parse(*read_file(scratch.path() / "part" / "shard.json"));
  EXPECT_EQ(checker.check(shard, "shard.schema.json"), "");
}

}  // namespace
}  // namespace unietp
