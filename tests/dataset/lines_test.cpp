// Every kind of line that the writer makes, held against its schema. The writer itself checks nothing: what it writes
// is typed, and its fields are fixed.
#include "dataset/lines.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "dataset/manifest.h"
#include "schema_checker.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string broken(const std::string& line, const char* schema) {
  EXPECT_EQ(line.find('\n'), std::string::npos);
  return SchemaChecker().check(Json::parse(line), schema);
}

Instruction instruction(const char* why) { return {"Open \"a\" fridge.", "grammar", Style::Direct, {"form"}, why}; }

TEST(Lines, ATaskFollowsItsSchema) {
  TaskEntry task;
  task.id = task.scene = "ai2thor-00001";
  task.template_name = "open-one";
  task.split = "atomic";
  task.simulator = "ai2thor";
  task.layout = "home";
  task.bindings = {{"A", "Fridge"}};
  task.goal_text = "(at-end (exists (?a - Fridge) (open ?a)))";
  task.goal = *parse_formula("goal", task.goal_text, FormulaUse::Goal);
  task.start_constraints = {"(exists (?a - Fridge) (closed ?a))"};
  task.edits = {"added Mug mug_4"};
  task.changes = "{}";
  task.instruction = instruction("");
  task.expert = {{Mode::M1, 3, 0}, {Mode::M3, 7, 1, 4}};
  EXPECT_EQ(broken(line_of(task), "task.schema.json"), "");
  task.instruction = instruction("the model gave no answer");
  EXPECT_EQ(broken(line_of(task), "task.schema.json"), "");
  task.purpose = {"preparing", {"refrigerator is closed"}};
  EXPECT_EQ(broken(line_of(task), "task.schema.json"), "");
  EXPECT_EQ(Json::parse(line_of(task))["purpose"]["because"], Json::array({"refrigerator is closed"}));
  task.forms = {"virtualhome", "virtualhome-unity"};
  EXPECT_EQ(broken(line_of(task), "task.schema.json"), "");
  EXPECT_EQ(Json::parse(line_of(task))["forms"], Json::array({"virtualhome", "virtualhome-unity"}));
  task.split = "";
  EXPECT_NE(broken(line_of(task), "task.schema.json"), "");
}

TEST(Lines, ADemonstrationFollowsItsSchema) {
  const Command open{"open", {{"fridge_1", std::nullopt}}}, box{"open", {{"", PixelBox{1, 2, 3, 4}}}}, stop{"stop", {}};
  const std::vector<VisibleObject> visible{{"fridge_1", {0, 1, 2, 3}}};
  const Delta none;
  const std::vector<Delta> at_once, moments(2);
  for (const Mode mode : kModes) {
    const auto line =
        demonstration_line("ai2thor-00001", mode,
                           {{mode == Mode::M3 ? box : open, false, "too-far", "it is too far", visible, none, at_once},
                            {open, true, "none", "", visible, none, moments},
                            {stop, true, "none", "", {}, none, at_once, false}},
                           {{open, stop}, {open, stop}});
    EXPECT_EQ(broken(line, "demonstration.schema.json"), "");
  }
}

TEST(Lines, ARejectionFollowsItsSchema) {
  EXPECT_EQ(broken(line_of(RejectionEntry{3, 1, "open-one", "ai2thor", "atomic", "expert", "no-plan", ""}),
                   "rejection.schema.json"),
            "");
}

TEST(Lines, WordingsFollowTheirSchema) {
  WordingsEntry wordings{"ai2thor-00001", instruction(""), std::nullopt, "", std::nullopt, std::nullopt, "", {}};
  EXPECT_EQ(broken(line_of(wordings), "wordings.schema.json"), "");
  wordings.referring = wordings.complex = wordings.contrast = instruction("");
  wordings.contrast_goal = "(exists (?a - Fridge) (at-end (closed ?a)))";
  wordings.referring_goal = "(at-end (exists (?a - (Fridge :where (dirty ?a))) (open ?a)))";
  EXPECT_EQ(broken(line_of(wordings), "wordings.schema.json"), "");
  wordings.others = {instruction(""), instruction("the model gave no answer")};
  EXPECT_EQ(broken(line_of(wordings), "wordings.schema.json"), "");
}

TEST(Lines, AReviewMarkFollowsItsSchema) {
  EXPECT_EQ(broken(line_of(ReviewMarkEntry{"ai2thor-00001", "accept", "", ""}), "review-mark.schema.json"), "");
  EXPECT_EQ(
      broken(line_of(ReviewMarkEntry{"ai2thor-00001", "edit", "Open a fridge.", "odd"}), "review-mark.schema.json"),
      "");
}

TEST(Lines, AManifestFollowsItsSchema) {
  Manifest manifest;
  manifest.version = "0.1.0";
  manifest.knowledge_digest = std::string(64, 'a');
  manifest.counts.tasks = 2;
  manifest.counts.by_split = {{"atomic", 2}};
  manifest.counts.by_simulator = {{"ai2thor", 2}};
  manifest.counts.by_template = {{"open-one", 2}};
  manifest.counts.by_sense = {{"tolerable", 1}, {"usual", 1}};
  manifest.counts.by_form = {{"ai2thor", 1}};
  manifest.counts.not_usual = {{"open-one", 1}};
  manifest.counts.rejections = {{"expert", {{"no-plan", 1}}}};
  manifest.counts.balance = {{Dimension::Template, 1, 1, 0}};
  manifest.files = {{"tasks.jsonl", {12, std::string(64, 'b')}}};
  manifest.sources = {{"curated", "this project", "MIT"}};
  SchemaChecker checker;
  EXPECT_EQ(checker.check(Json::parse(to_text(manifest)), "manifest.schema.json"), "");
  manifest.benchmark = "unietp-1.0";
  manifest.writing = WritingEntry{"llm", 7, "training", "gb", {{"llm:m", 2}}, PairsEntry{5, true}};
  manifest.reviews = ReviewCounts{3, 1, 2};
  EXPECT_EQ(checker.check(Json::parse(to_text(manifest)), "manifest.schema.json"), "");
}

TEST(LinesWriter, EndsEveryLine) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "lines";
  auto writer = LinesWriter::begin(file);
  ASSERT_TRUE(writer) << format(writer.error());
  EXPECT_TRUE(writer->add("{}"));
  EXPECT_TRUE(writer->add("[]"));
  EXPECT_TRUE(writer->finish());
  EXPECT_EQ(*read_file(file), "{}\n[]\n");
  EXPECT_FALSE(LinesWriter::begin(file / "below a file"));
}

}  // namespace
}  // namespace unietp
