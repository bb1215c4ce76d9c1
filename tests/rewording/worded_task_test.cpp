#include "rewording/worded_task.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text.h"
#include "tests/record/small_set.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(WordedTask, IsTheSpecificationThatItsRecordTellsOf) {
  const SmallSet set;
  set.write({task_line("ai2thor-00001"), task_line("ai2thor-00002")},
            {shown_line("ai2thor-00001"), shown_line("ai2thor-00002")});
  const auto parts = all_lines(set.folder());
  EXPECT_THAT(parts.modes, ElementsAre(Mode::M1));
  EXPECT_FALSE(parts.wordings);
  std::vector<std::string> ids;
  const auto read = for_each_worded_task(set.folder(), parts, [&](WordedTask&& task) -> Result<Done> {
    ids.push_back(task.record.id);
    const Specification& made = task.specification;
    EXPECT_EQ(to_text(made.goal), task.record.goal_text);
    EXPECT_EQ(made.goal, task.record.goal_tree);
    EXPECT_EQ(made.template_name, task.record.template_name);
    EXPECT_EQ(made.binding, task.record.bindings);
    EXPECT_EQ(made.init.size(), task.record.start_constraints.size());
    EXPECT_EQ(name_of(made.simulator), task.record.simulator);
    return Done{};
  });
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_THAT(ids, ElementsAre("ai2thor-00001", "ai2thor-00002"));
}

TEST(WordedTask, IsMatchedWithItsDemonstrationUnparsed) {
  const auto matched = [](const std::vector<std::string>& shown) {
    const SmallSet set;
    set.write({task_line("ai2thor-00001"), task_line("ai2thor-00002")}, shown);
    std::vector<std::string> ids;
    const auto read = for_each_matched_task(set.folder(), [&](WordedTask&& task) -> Result<Done> {
      ids.push_back(task.record.id);
      return Done{};
    });
    return read ? join(ids, " ") : format(read.error());
  };
  const std::string first = shown_line("ai2thor-00001"), second = shown_line("ai2thor-00002");
  EXPECT_EQ(matched({first, second}), "ai2thor-00001 ai2thor-00002");
  EXPECT_THAT(matched({first}), HasSubstr("expected the demonstration of ai2thor-00002"));
  EXPECT_THAT(matched({second, first}), HasSubstr("expected the demonstration of ai2thor-00001"));
  EXPECT_THAT(matched({first, second, second}), HasSubstr("expected the end of the file"));
}

TEST(WordedTask, OfADataSetWithoutDemonstrationsAsksForThoseOfM1) {
  const SmallSet set;
  set.write_bytes("tasks.jsonl", task_line("ai2thor-00001") + "\n");
  EXPECT_THAT(all_lines(set.folder()).modes, ElementsAre(Mode::M1));
}

}  // namespace
}  // namespace unietp
