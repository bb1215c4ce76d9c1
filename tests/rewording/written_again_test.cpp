// What is read by record/ and written again by dataset/ stays as it was, byte for byte.
#include "rewording/written_again.h"

#include <gtest/gtest.h>

#include "scene/scene_json.h"

namespace unietp {
namespace {

Instruction instruction(const char* text, const char* why) { return {text, "grammar", Style::Direct, {"form"}, why}; }

Delta some_changes() {
  Delta changes;
  changes.removed = {"mug_1"};
  changes.edges_added = {{Predicate::On, "cup_1", "table_1"}};
  return changes;
}

TaskEntry some_task() {
  TaskEntry task;
  task.id = task.scene = "ai2thor-00001";
  task.template_name = "open-one";
  task.split = "atomic";
  task.simulator = "ai2thor";
  task.layout = "home";
  task.bindings = {{"B", "Mug"}, {"A", "Fridge"}};
  task.refinement = "by-state";
  task.goal_text = "(at-end (exists (?a - Fridge) (open ?a)))";
  task.goal = *parse_formula("goal", task.goal_text, FormulaUse::Goal);
  task.start_constraints = {"(exists (?a - Fridge) (closed ?a))"};
  task.edits = {"added Mug mug_4", "\"quoted\" \xC3\xA9"};
  task.changes = delta_to_json(some_changes());
  task.instruction = instruction("Open a fridge.", "the model gave no answer");
  task.forms = {"ai2thor"};
  task.expert = {{Mode::M1, 2, 1}, {Mode::M3, 1, 0, 2}};
  task.run_seed = 9007199254740991;
  task.slot = 3;
  task.attempt = 4;
  return task;
}

TEST(WrittenAgain, ATaskAndItsDemonstrationsStayAsTheyWere) {
  const std::string line = line_of(some_task());
  const Command open{"open", {{"fridge_1", std::nullopt}}}, box{"open", {{"", PixelBox{1, 2, 3, 4}}}}, stop{"stop", {}};
  const std::vector<VisibleObject> visible{{"fridge_1", {0, 1, 2, 3}}};
  const Delta none, some = some_changes();
  const std::vector<Delta> at_once, moments{some, none};
  const auto in_m1 = demonstration_line("ai2thor-00001", Mode::M1,
                                        {{open, false, "too-far", "it is too far", visible, none, at_once},
                                         {open, true, "none", "", visible, some, moments},
                                         {stop, true, "none", "", {}, none, at_once}},
                                        {{}, {open, stop}});
  const auto in_m3 = demonstration_line("ai2thor-00001", Mode::M3, {{box, true, "none", "", {}, none, at_once, true}},
                                        {{open, stop}, {}});
  const auto task = read_task("t", 1, line);
  ASSERT_TRUE(task) << format(task.error());
  const auto first = read_demonstration("d", 1, in_m1), second = read_demonstration("d", 1, in_m3);
  ASSERT_TRUE(first) << format(first.error());
  ASSERT_TRUE(second) << format(second.error());
  const auto again = written_again(*task, some_task().instruction, {{Mode::M1, *first}, {Mode::M3, *second}});
  EXPECT_EQ(again.line, line);
  EXPECT_EQ(again.shown, (std::vector<std::string>{in_m1, in_m3}));
  EXPECT_EQ(again.row.bindings, some_task().bindings);
  ASSERT_EQ(again.row.actions.size(), 4U);
  EXPECT_EQ(again.row.actions[0], (ActionRow{Mode::M1, "open", "fridge_1", false, "too-far"}));
  EXPECT_EQ(again.row.actions[3].arguments, "{\"bbox\":[1,2,3,4]}");
}

TEST(WrittenAgain, RejectionsWordingsAndMarksStayAsTheyWere) {
  const auto rejection = line_of(RejectionEntry{3, 1, "open-one", "ai2thor", "atomic", "expert", "no-plan", ""});
  EXPECT_EQ(line_of(written_again(*read_rejection("r", 1, rejection))), rejection);
  const auto wordings = line_of(WordingsEntry{"a",
                                              instruction("One.", ""),
                                              instruction("Two.", "why"),
                                              "(goal)",
                                              instruction("3.", ""),
                                              instruction("4.", ""),
                                              "(other)",
                                              {instruction("5.", ""), instruction("6.", "why")}});
  EXPECT_EQ(line_of(*written_again(*read_wordings("w", 1, wordings))), wordings);
  const auto mark = line_of(ReviewMarkEntry{"a", "edit", "Open it.", "odd"});
  EXPECT_EQ(line_of(written_again(*read_review_mark("m", 1, mark))), mark);
}

TEST(WrittenAgain, AManifestStaysAsItWas) {
  Manifest manifest;
  manifest.version = "0.0.9";
  manifest.knowledge_digest = "digest";
  manifest.benchmark = "unietp-1.0";
  manifest.configuration.seed = 7;
  manifest.configuration.splits = {Split::Atomic};
  manifest.configuration.extended = true;
  manifest.configuration.binding = {{"A", "Mug"}};
  manifest.configuration.templates = {"open-one"};
  manifest.counts.tasks = 2;
  manifest.counts.by_split = {{"atomic", 2}};
  manifest.counts.by_simulator = {{"ai2thor", 2}};
  manifest.counts.by_template = {{"open-one", 2}};
  manifest.counts.by_sense = {{"tolerable", 1}, {"usual", 1}};
  manifest.counts.by_form = {{"ai2thor", 1}};
  manifest.counts.not_usual = {{"open-one", 1}};
  manifest.counts.rejections = {{"expert", {{"no-plan", 1}}}};
  manifest.counts.balance = {{Dimension::Receptacle, 3, 2.123456789012345, 0.1}};
  manifest.files = {{"tasks.jsonl", {5'000'000'000, "b"}}};
  manifest.sources = {{"curated", "this project", "MIT"}};
  manifest.writing = WritingEntry{"llm", 7, "training", "gb", {{"llm:m", 2}}, PairsEntry{5, true}};
  manifest.reviews = ReviewCounts{3, 1, 2};
  const auto record = read_manifest("manifest.json", to_text(manifest));
  ASSERT_TRUE(record) << format(record.error());
  const auto again = written_again("manifest.json", *record);
  ASSERT_TRUE(again) << format(again.error());
  EXPECT_EQ(to_text(*again), to_text(manifest));
}

}  // namespace
}  // namespace unietp
