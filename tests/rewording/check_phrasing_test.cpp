#include "rewording/check_phrasing.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

Resources with_one_template() {
  Resources resources;
  Template source;
  source.name = "move-one";
  source.instructions = {"Put {A:indefinite} on the floor of {R:definite}.", "Turn on {A:indefinite}."};
  resources.templates.push_back(source);
  return resources;
}

TaskRecord said(const char* text, int phrasing, const char* writer = "grammar") {
  TaskRecord task;
  task.template_name = "move-one";
  task.instruction = text;
  task.phrasing = phrasing;
  task.writer = writer;
  return task;
}

TEST(CheckPhrasing, TakesTextsThatHaveItsWordsInOrder) {
  const Resources resources = with_one_template();
  EXPECT_TRUE(check_phrasing(said("Put a mug on the kitchen floor.", 1), resources).empty());
  EXPECT_TRUE(check_phrasing(said("There is a lamp on the desk. Turn it on.", 2), resources).empty());
  EXPECT_TRUE(check_phrasing(said("Move a mug.", 0), resources).empty());
}

TEST(CheckPhrasing, RefusesOtherWordsOtherWritersAndPhrasingsThatAreNotThere) {
  const Resources resources = with_one_template();
  EXPECT_EQ(check_phrasing(said("Move a mug to the kitchen.", 1), resources).size(), 1u);
  EXPECT_EQ(check_phrasing(said("Turn off a lamp.", 2), resources).size(), 1u);
  EXPECT_EQ(check_phrasing(said("Turn on a lamp.", 3), resources).size(), 1u);
  EXPECT_EQ(check_phrasing(said("Turn on a lamp.", 2, "llm:m"), resources).size(), 1u);
}

}  // namespace
}  // namespace unietp
