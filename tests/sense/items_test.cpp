#include "sense/items.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/files.h"
#include "sense/fit.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/needs.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

class Items : public ::testing::Test {
 protected:
  void SetUp() override {
    auto net = Hypernyms::read(Hypernyms::kFolder);
    if (!net) GTEST_SKIP() << needs::kWordNet;
    net_ = std::move(*net);
  }
  Vocabulary vocabulary() const { return {test::committed_sense().kinds(), test::committed_words(), net_, {}}; }
  static bool has(const std::vector<Item>& items, const std::string& thing, const Role& role) {
    return std::any_of(items.begin(), items.end(),
                       [&](const Item& item) { return item.evidence.thing == thing && item.evidence.role == role; });
  }

  Hypernyms net_;
  ScratchFolder folder_;
};

TEST_F(Items, OfAProgramSayWhatIsDoneWithThingsAndInWhichOrder) {
  ASSERT_TRUE(
      write_file(folder_.path() / "programs.jsonl",
                 "{\"title\":\"Wash dishes\",\"steps\":[\"Walk to kitchen\",\"Wash plate\","
                 "\"Put plate on dishwasher\",\"Pour water into drinking glass\",\"Switch on dishwasher\"]}\n"));
  const auto items = program_items(folder_.path() / "programs.jsonl", vocabulary());
  ASSERT_TRUE(items) << format(items.error());
  EXPECT_TRUE(has(*items, "plate", "wash"));
  EXPECT_TRUE(has(*items, "plate", "in:dishwasher"));  // their words do not tell on from in
  EXPECT_TRUE(has(*items, "plate", "wash>in:dishwasher"));
  EXPECT_TRUE(has(*items, "dishwasher", "switch_on"));
  EXPECT_TRUE(has(*items, "glass", "fill:water"));
  EXPECT_EQ(items->front().group, "Wash dishes");
}

TEST_F(Items, OfAnActivityAreItsGoals) {
  ASSERT_TRUE(write_file(folder_.path() / "serving/problem0.bddl",
                         "(define (problem serving-0) (:domain omnigibson)\n"
                         "(:init (inside plate.n.04_1 cabinet.n.01_1))\n"
                         "(:goal (and (forall (?pizza.n.01 - pizza.n.01) (and (cooked ?pizza.n.01) (ontop ?pizza.n.01 "
                         "?plate.n.04_1))) (not (covered ?plate.n.04_1 ?dust.n.01_1)) (not (open "
                         "?electric_refrigerator.n.01_1)))))\n"));
  const auto items = activity_items(folder_.path(), vocabulary());
  ASSERT_TRUE(items) << format(items.error());
  EXPECT_TRUE(has(*items, "meal", "cook"));
  EXPECT_TRUE(has(*items, "meal", "on:plate"));
  EXPECT_TRUE(has(*items, "meal", "cook>on:plate"));
  EXPECT_TRUE(has(*items, "plate", "dust"));
  EXPECT_TRUE(has(*items, "fridge", "close"));
  EXPECT_FALSE(has(*items, "plate", "in:cabinet"));  // that is its start
}

TEST_F(Items, OfVotesCountOnlyWithAMajority) {
  ASSERT_TRUE(
      write_file(folder_.path() / "votes.csv",
                 "object,room,receptacle,belongs,misplaced,implausible,mean_reciprocal_rank\n"
                 "mug,kitchen,top_cabinet,9,1,0,1\nmug,bathroom,toilet,0,2,8,0\nmug,kitchen,table,5,5,0,0.5\n"));
  const auto items = vote_items(folder_.path() / "votes.csv", vocabulary());
  ASSERT_TRUE(items) << format(items.error());
  ASSERT_EQ(items->size(), 2u);
  EXPECT_TRUE(items->front().counts);
  EXPECT_EQ(items->front().evidence.role, "in:kitchen_cabinet");
  EXPECT_FALSE(items->back().counts);
  EXPECT_EQ(add_up(*items).size(), 1u);
}

TEST_F(Items, AddUpBySource) {
  const std::vector<Item> items{{{"cup", "wash", 1, "first", "a"}, "g"},
                                {{"cup", "wash", 2, "second", "a"}, "h"},
                                {{"cup", "wash", 1, "third", "b"}, "g"}};
  const auto rows = add_up(items);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows.front(), (Evidence{"cup", "wash", 3, "second", "a"}));
}

TEST_F(Items, RefuseAFolderWithoutActivitiesAndABrokenProgram) {
  EXPECT_FALSE(activity_items(folder_.path(), vocabulary()));
  ASSERT_TRUE(write_file(folder_.path() / "bad.jsonl", "{\"title\":\"x\"}\n"));
  const auto items = program_items(folder_.path() / "bad.jsonl", vocabulary());
  ASSERT_FALSE(items);
  EXPECT_EQ(items.error().pos.line, 1);
}

}  // namespace
}  // namespace unietp
