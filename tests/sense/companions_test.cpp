#include "sense/companions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr auto* kActivities = "metadata:activity_definitions";

Item program_item(const std::string& group, const std::string& thing, const Role& role,
                  const char* source = kActivities) {
  return {{thing, role, 1, group + ": " + thing, source}, group};
}

const Kinds& kinds() { return test::committed_sense().kinds(); }

TEST(Companions, AreTheThingsAndPlacesOfOneActivity) {
  auto ignored = program_item("tea", "sofa", "open");
  ignored.counts = false;
  const std::vector<Item> items{program_item("tea", "cup", "on:counter"),
                                program_item("tea", "kettle", "fill:water"),
                                ignored,
                                program_item("tea", "cup", "wash>in:cabinet"),
                                program_item("wash", "cup", "in:sink"),
                                program_item("vote", "bed", "in_room:bedroom", "metadata:preferences.csv.gz")};
  const auto found = add_up(count_companions(items, kinds()));
  EXPECT_EQ(found.all(), 2);
  const std::map<Companions::Pair, int> expected{
      {{"counter", "counter"}, 1}, {{"counter", "cup"}, 1}, {{"counter", "kettle"}, 1}, {{"cup", "cup"}, 2},
      {{"cup", "kettle"}, 1},      {{"cup", "sink"}, 1},    {{"kettle", "kettle"}, 1},  {{"sink", "sink"}, 1}};
  EXPECT_EQ(found.activities(), expected);
}

TEST(Companions, AKindIsComparedWithWhatChanceGives) {
  const Companions made({{{"cup", "cup"}, 9}, {{"cup", "kettle"}, 9}, {{"kettle", "kettle"}, 9}, {{"bed", "bed"}, 20}},
                        99);
  const double cup = 9.3 / 100;
  EXPECT_DOUBLE_EQ(*made.among("cup", {"kettle"}), (9 + cup) / 10 / cup);
  EXPECT_DOUBLE_EQ(*made.among("cup", {"kettle", "bed"}), ((9 + cup) / 10 + cup / 21) / 2 / cup);
  EXPECT_FALSE(made.among("cup", {}));
  EXPECT_FALSE(made.strangers("cup", "kettle"));
  EXPECT_TRUE(made.strangers("bed", "cup"));    // 1.8 by chance, none seen
  EXPECT_FALSE(made.strangers("bed", "sofa"));  // nobody spoke of a sofa
  EXPECT_FALSE(made.strangers("bed", "bed"));
  EXPECT_FALSE(Companions().strangers("bed", "cup"));
}

TEST(Companions, OfTheCommittedTableKnowWhatGoesTogether) {
  const auto& committed = test::committed_sense().companions();
  EXPECT_GT(committed.all(), 1000);
  EXPECT_GT(*committed.among("garment", {"washer"}), 1);
  EXPECT_TRUE(committed.strangers("garment", "fridge"));
  EXPECT_FALSE(committed.strangers("oven", "fridge"));
}

TEST(Companions, AreReadAsTheyAreWritten) {
  const ScratchFolder folder;
  const auto& committed = test::committed_sense().companions();
  ASSERT_TRUE(write_file(folder.path() / "companions.csv",
                         csv_of({{"a", committed}, {"b", {{{{"bed", "cup"}, 2}}, 3}}}, kinds())));
  std::vector<Error> errors;
  const auto read = read_companions(folder.path() / "companions.csv", kinds(), errors);
  EXPECT_THAT(errors, IsEmpty());
  auto expected = committed.activities();
  expected[{"bed", "cup"}] += 2;
  EXPECT_EQ(read.all(), committed.all() + 3);
  EXPECT_EQ(read.activities(), expected);
}

TEST(Companions, AFaultyRowIsToldWithItsPlace) {
  const ScratchFolder folder;
  const auto file = folder.path() / "companions.csv";
  ASSERT_TRUE(write_file(
      file, "thing,other,activities,source\ncup,bed,1,a\ncup,kettel,1,a\nbed,cup,1,a\nbed,cup,1,b\nbed,cup,2,a\n"));
  std::vector<Error> errors;
  (void)read_companions(file, kinds(), errors);
  std::vector<std::string> texts;
  for (const auto& error : errors) texts.push_back(format(error));
  EXPECT_THAT(texts, ElementsAre(HasSubstr("2:5: schema error: expected the two kinds in order"),
                                 HasSubstr("3:5: schema error: 'kettel' is not a kind"),
                                 HasSubstr("'bed' and 'cup' stand twice")));
}

}  // namespace
}  // namespace unietp
