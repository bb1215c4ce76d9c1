// What data/sense/phrases.csv says, laid over the tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/files.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class LayPhrases : public ::testing::Test {
 protected:
  void SetUp() override {
    auto tables = test::small_tables();
    std::string& rows = tables["category"];  // a name that is not the display name
    rows.replace(rows.find("half_apple,half apple"), 21, "half_apple,piece of apple");
    test::write_small_tables(folder.path() / "akb", tables);
    ASSERT_TRUE(write_file(folder.path() / "sense" / "kinds.csv",
                           "name,singular,parent\nthing,thing,\nfood,food,thing\ncup,cup,thing\n"));
    ASSERT_TRUE(write_file(folder.path() / "sense" / "categories.csv",
                           "simulator,category,kind,source\nai2thor,apple,food,curated\n"
                           "ai2thor,half_apple,food,curated\nai2thor,mug,cup,curated\n"));
  }
  /// The categories of AI2-THOR that the phrase of a row with these columns means.
  std::set<std::string> meant(const std::string& kinds_also_except) {
    EXPECT_TRUE(write_file(
        folder.path() / "sense" / "phrases.csv",
        "use,state,phrases,kinds,also,except,source\nhypernym,,a snack," + kinds_also_except + ",curated\n"));
    errors.clear();
    const auto all = read_all_tables(folder.path() / "akb", {}, errors);
    std::set<std::string> categories;
    if (!all.empty()) {
      for (const auto& alias : all[0].aliases)
        if (alias.text == "a snack") categories.insert(alias.category);
    }
    return categories;
  }

  ScratchFolder folder;
  std::vector<Error> errors;
};

TEST_F(LayPhrases, MembersAreNamedByNameOrDisplayName) {
  EXPECT_THAT(meant("food,,"), ElementsAre("apple", "half_apple"));
  EXPECT_THAT(meant("food,,half_apple"), ElementsAre("apple"));
  EXPECT_THAT(meant("food,,piece_of_apple"), ElementsAre("apple"));
  EXPECT_THAT(meant("food,plate,apple"), ElementsAre("half_apple", "plate"));
  EXPECT_THAT(meant("cup,half_apple,"), ElementsAre("half_apple", "mug"));
  EXPECT_THAT(meant("cup,piece_of_apple,"), ElementsAre("half_apple", "mug"));
  EXPECT_THAT(errors, IsEmpty());
}

TEST_F(LayPhrases, AMemberThatNoCategoryIsIsReported) {
  for (const std::string row : {"food,pears,", "food,,pears"}) {
    (void)meant(row);
    ASSERT_EQ(errors.size(), 1U) << row;
    EXPECT_THAT(format(errors.front()), HasSubstr("no simulator has a category that is called 'pears'"));
  }
}

}  // namespace
}  // namespace unietp
