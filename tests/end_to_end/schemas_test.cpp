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

constexpr const char* kGoalOfEveryKind =
    "(or (at-end (forall (?m - (Mug :where (imply (dirty ?m) (held ?m)))) (exists (?t - (either Sofa Bread/slice))"
    " (and (on ?m ?t) (not (= ?m ?t))))))"
    " (before (sometime (count >= 2 (?o - object) (filled ?o water)))"
    " (until (always (exists (?r - room) (in_room agent ?r))) (at-end"
    " (count > (number (?c - Cup) (open ?c)) (number (?b - Bowl) (dirty ?b)))))))";

/// What a command prints with --json, whatever it ends with.
Json printed(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  const auto ended = run_program(arguments);
  auto json = Json::parse(ended.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << ended.out << ended.err;
  return json;
}

TEST(Schemas, DescribeWhatCommandsPrintForPrograms) {
  const ScratchFolder scratch;
  const std::string bad = scratch.at("bad.template"), homes = scratch.at("homes"), changed = scratch.at("akb");
  ASSERT_TRUE(write_file(bad, "(template bad (goal (at-end (opn ?a))))"));
  fs::copy(kSource / "data" / "akb", changed, fs::copy_options::recursive);
  const std::string tables = (kSource / "data" / "akb").string();
  const std::string overrides = *read_file(fs::path(changed) / "override.csv");
  ASSERT_TRUE(write_file(fs::path(changed) / "override.csv", overrides + "ai2thor,Mug,mass,0.9,a heavy one\n"));
  const std::vector<std::pair<const char*, std::vector<std::string>>> outputs{
      {"scene-making", {"scene", "make", "--simulator", "habitat", "--count", "1", "--out", homes}},
      {"scene-statistics", {"scene", "stats", homes}},
      {"scene-list", {"scene", "list", "--simulators", "behavior"}},
      {"template", {"template", "show", "wash-then-heat"}},
      {"template-list", {"template", "list", "--class", "logical"}},
      {"template-lint", {"template", "lint", bad}},
      {"vocabulary", {"template", "vocabulary"}},
      {"template-try", {"template", "try", "place-one-next-to", "--simulator", "behavior", "--count", "2"}},
      {"template-why-not", {"template", "why-not", "place-one-inside", "--bind", "A=Fridge", "B=Mug"}},
      {"template-why-not", {"template", "why-not", "open-one", "--bind", "A=Fridge", "--try", "--homes", "1"}},
      {"coverage", {"template", "coverage", "--tries", "1", "--template", "open-one"}},
      {"goal", {"goal", kGoalOfEveryKind}},
      {"knowledge-show", {"knowledge", "show", "ai2thor", "Mug"}},
      {"knowledge-show", {"knowledge", "show", "habitat"}},
      {"knowledge-why", {"knowledge", "why", "ai2thor", "Mug", "on:CounterTop"}},
      {"knowledge-why", {"knowledge", "why", "ai2thor", "Mug", "openable"}},
      {"knowledge-stats", {"knowledge", "stats"}},
      {"knowledge-diff", {"knowledge", "diff", tables, changed}}};
  SchemaChecker checker;
  for (const auto& [schema, arguments] : outputs)
    EXPECT_EQ(checker.check(printed(arguments), std::string(schema) + ".schema.json"), "") << schema;
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
