#include "akb/kind_groups.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "akb/metadata_json.h"
#include "akb/placement_rules.h"
#include "core/files.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const auto kCurated = test::committed_tables() / "curated";

std::vector<std::string> problems_of(const std::string& csv) {
  const ScratchFolder folder;
  EXPECT_TRUE(write_file(folder.path() / "groups.csv", csv));
  std::vector<Error> errors;
  (void)read_kind_groups(folder.path() / "groups.csv", errors);
  std::vector<std::string> texts;
  for (const auto& error : errors) texts.push_back(format(error));
  return texts;
}

TEST(KindGroups, OfTheCommittedTableAreComplete) {
  std::vector<Error> errors;
  const auto groups = read_kind_groups(kCurated / "kind_groups.csv", errors);
  EXPECT_THAT(errors, IsEmpty());
  EXPECT_EQ(groups.size(), kKindGroupCount);
  EXPECT_TRUE(groups.at(KindGroup::Washer).contains("dishwasher"));
}

TEST(KindGroups, AnUnknownGroupAndOneWithoutARowAreErrors) {
  const auto problems = problems_of("group,kind,source\nfood,fruit,curated\nfoood,meal,curated\n");
  EXPECT_THAT(problems, Contains(HasSubstr("groups.csv:3:1")));
  EXPECT_THAT(problems, Contains(HasSubstr("no row of the group 'washer'")));
  EXPECT_THAT(problems, Not(Contains(HasSubstr("no row of the group 'food'"))));
}

TEST(PlacementRules, MeanTheKindThatTheyNameAndThoseThatCountAsIt) {
  std::vector<Error> errors;
  const auto rules = read_placement_rules(kCurated, errors);
  EXPECT_THAT(errors, IsEmpty());
  const auto rule_for = [&](Predicate relation, std::string_view receptacle) {
    return *std::find_if(rules.begin(), rules.end(), [&](const PlacementRule& rule) {
      return rule.relation == relation && rule.receptacles.front() == receptacle;
    });
  };
  EXPECT_THAT(rule_for(Predicate::On, "dresser").receptacles, ElementsAre("dresser", "cabinet"));
  EXPECT_THAT(rule_for(Predicate::On, "dining_table").receptacles, ElementsAre("dining_table"));
}

TEST(NameTexts, RefuseANameThatStandsTwiceAndARowWithoutAMeaning) {
  const ScratchFolder folder;
  const auto read = [&](const std::string& csv) {
    EXPECT_TRUE(write_file(folder.path() / "names.csv", csv));
    return read_name_texts(folder.path() / "names.csv");
  };
  const auto sound = read("name,class\ncouch,sofa\ncup,mug\n");
  ASSERT_TRUE(sound) << format(sound.error());
  EXPECT_EQ(sound->at("cup"), "mug");
  EXPECT_FALSE(read("name,class\ncup,mug\ncup,glass\n"));
  EXPECT_FALSE(read("name,class\n,mug\n"));
}

}  // namespace
}  // namespace unietp
