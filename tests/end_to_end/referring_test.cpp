// Tasks that refer, and tasks in harder words, made and proven by the real program.
#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "data_set.h"

namespace unietp {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

struct Wanted {
  std::string name, split, refinement, style;
  std::vector<std::string> words;  // the instruction has one of them
};

/// A data set of one template: each task in the split, proven again from the files, and worded so.
void expect_proven(const Wanted& wanted, const std::string& simulators) {
  SCOPED_TRACE(wanted.name);
  const ScratchFolder scratch;
  const auto out = scratch.at("set");
  const auto made = run_program({"generate", "--template", wanted.name, "--simulators", simulators, "--count", "2",
                                 "--seed", "8", "--attempts", "300", "--out", out});
  ASSERT_EQ(made.code, 0) << made.err;
  const auto tasks = json_lines(std::filesystem::path(out) / "tasks.jsonl");
  ASSERT_EQ(tasks.size(), 2U);
  for (const auto& task : tasks) {
    EXPECT_EQ(task["split"], wanted.split);
    EXPECT_EQ(task["refinement"], wanted.refinement);
    EXPECT_EQ(task["instruction"]["style"], wanted.style);
    const auto text = task["instruction"]["text"].get<std::string>();
    const bool said = std::any_of(wanted.words.begin(), wanted.words.end(),
                                  [&](const std::string& words) { return text.find(words) != std::string::npos; });
    EXPECT_TRUE(said) << text;
  }
  const auto verdict = validate(out);
  EXPECT_EQ(verdict.code, 0);
  EXPECT_EQ(verdict.proven, 2);
}

TEST(Referring, TemplatesThatReferAreProven) {
  expect_proven({"pick-up-the-nearest",
                 "instance_grounding",
                 "referring",
                 "direct",
                 {"nearest to the", "nearest to a", "closest to the", "closest to a"}},
                "ai2thor,habitat");
  expect_proven({"place-the-larger-inside", "instance_grounding", "referring", "direct", {"larger", "bigger"}},
                "ai2thor,habitat");
  expect_proven({"open-the-one-in-room", "instance_grounding", "referring", "direct", {" in the "}},
                "ai2thor,virtualhome");
}

TEST(Referring, StylesOfATemplateAreProven) {
  expect_proven({"close-before-opening", "linguistic", "", "inverted-order", {", but close", ", but first close"}},
                "ai2thor,habitat");
  expect_proven({"switch-on-what-was-filled", "linguistic", "", "subordinate-clause", {"Once it's in", "As soon as"}},
                "ai2thor");
  expect_proven({"place-inside-leave-others-on", "linguistic", "", "distractor", {"Leave the one"}},
                "ai2thor,virtualhome");
  expect_proven({"place-a-couple-inside", "linguistic", "", "vague-quantity", {"a couple of"}}, "virtualhome,habitat");
}

TEST(Referring, ATemplateInAUsersHomeMayAskForAKind) {
  const ScratchFolder scratch;
  const auto source = std::filesystem::path(UNIETP_SOURCE_DIR);
  std::filesystem::create_directories(scratch.path() / "templates/library/atomic");
  std::filesystem::create_directory_symlink(source / "data", scratch.path() / "data");
  std::ofstream(scratch.path() / "templates/library/atomic/hold-by-colour.template") << R"((template hold-by-colour
  (name "pick up one <A> told by its colour")
  (split atomic)
  (refinement by-attribute)
  (parameters (A - pickupable countable))
  (init (exists (?a - A) (and)))
  (goal (exists (?a - A) (at-end (held ?a))))
  (instruction "Pick up {A:indefinite}.")))";
  const auto out = scratch.at("set");
  const auto made = run_program({"--data", scratch.path().string(), "generate", "--simulators", "ai2thor,habitat",
                                 "--count", "2", "--seed", "1", "--out", out});
  ASSERT_EQ(made.code, 0) << made.err;
  for (const auto& task : json_lines(std::filesystem::path(out) / "tasks.jsonl")) {
    EXPECT_EQ(task["refinement"], "by-attribute");
    EXPECT_THAT(task["goal"]["text"].get<std::string>(), AnyOf(HasSubstr("(colour ?a "), HasSubstr("(material ?a ")));
  }
}

}  // namespace
}  // namespace unietp
