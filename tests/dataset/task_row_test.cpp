#include "dataset/task_row.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;

TaskRow row() {
  TaskRow row;
  row.bindings = {{"A", "Fridge"}, {"B", "side table"}};
  row.actions = {{Mode::M1, "go_to", "fridge_1", true, "none"},
                 {Mode::M1, "open", "fridge_1", false, "too-far"},
                 {Mode::M3, "open", "{\"bbox\":[1,2,3,4]}", true, "none"},
                 {Mode::M3, "stop", "", true, "none"}};
  return row;
}

TEST(TaskRow, ItsListsReadBackAsTheyWere) {
  EXPECT_EQ(bindings_from(bindings_text(row())), row().bindings);
  EXPECT_EQ(actions_from(actions_text(row())), row().actions);
  EXPECT_TRUE(bindings_from("")->empty());
  EXPECT_TRUE(actions_from("")->empty());
}

TEST(TaskRow, DamagedTextsAreRefused) {
  for (const char* text : {"A", "A\tB", "A\tB\tC\n", "\n"}) EXPECT_FALSE(bindings_from(text)) << text;
  for (const char* text : {"M1\topen\tx\t1\n", "M9\topen\tx\t1\tnone\n", "M1\topen\tx\t2\tnone\n"})
    EXPECT_FALSE(actions_from(text)) << text;
}

TEST(TaskRow, CountsStepsByMode) {
  EXPECT_EQ(steps_and_failures(row(), Mode::M1), std::pair(2, 1));
  EXPECT_EQ(steps_and_failures(row(), Mode::M2), std::pair(0, 0));
  EXPECT_THAT(modes_of(row()), ElementsAre(Mode::M1, Mode::M3));
}

}  // namespace
}  // namespace unietp
