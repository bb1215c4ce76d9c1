#include "sense/common_sense.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "akb/provenance.h"
#include "tests/sense/committed_sense.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

Grade grade_of(const std::string& kind, const Role& role, std::vector<std::string> materials = {}) {
  return test::committed_sense().grade({kind, kind, std::move(materials)}, role).grade;
}

/// thing > food > {fruit, meat}; thing > place > {bowl, bin}.
CommonSense small(const std::vector<Evidence>& evidence, Judgments judgments = {}, std::vector<SenseRule> rules = {}) {
  return {Kinds({{"thing", "thing", "things", "", "all", "", ""},
                 {"movable", "movable", "movables", "thing", "carried", "", ""},
                 {"food", "food", "food", "movable", "eaten", "", ""},
                 {"fruit", "fruit", "fruit", "food", "eaten raw", "", ""},
                 {"meat", "meat", "meat", "food", "cooked", "", ""},
                 {"bowl", "bowl", "bowls", "thing", "holds", "in", ""},
                 {"bin", "bin", "bins", "thing", "rubbish", "in", ""}}),
          {},
          std::move(judgments),
          std::move(rules),
          evidence};
}

TEST(CommonSense, SpeaksOfPairsThatNobodyWroteDownByTheWiderKind) {
  const auto sense = small({{"meat", "in:bowl", 20, "dinner", "test"}}, {{{"movable", "in:bowl"}, Grade::Tolerable}});
  EXPECT_EQ(sense.grade({"meat", "meat", {}}, "in:bowl").grade, Grade::Usual);
  // Nobody wrote of fruit: food in general decides, which the meat has made usual.
  EXPECT_EQ(sense.grade({"fruit", "fruit", {}}, "in:bowl").grade, Grade::Usual);
  EXPECT_EQ(sense.grade({"fruit", "fruit", {}}, "in:bin").grade, Grade::Senseless);
}

TEST(CommonSense, WhatWasWrittenMovesAJudgment) {
  const Judgments refused{{{"fruit", "in:bowl"}, Grade::Senseless}};
  EXPECT_EQ(small({}, refused).grade({"fruit", "fruit", {}}, "in:bowl").grade, Grade::Senseless);
  const auto written = small({{"fruit", "in:bowl", 50, "fruit salad", "test"}}, refused);
  const auto sense = written.grade({"fruit", "fruit", {}}, "in:bowl");
  EXPECT_EQ(sense.grade, Grade::Tolerable);
  EXPECT_THAT(sense.reasons, Contains(HasSubstr("fruit salad")));
  EXPECT_THAT(sense.reasons, Contains(HasSubstr("judged senseless")));
}

TEST(CommonSense, WhatAPersonJudgedTolerableIsNeverUsual) {
  const std::vector<Evidence> written{{"meat", "in:bowl", 50, "dinner", "test"}};
  const auto sense = small(written, {{{"food", "in:bowl"}, Grade::Tolerable}});
  for (const std::string kind : {"food", "meat"})
    EXPECT_EQ(sense.grade({kind, kind, {}}, "in:bowl").grade, Grade::Tolerable) << kind;
  // A judgment of the narrower kind comes first.
  const auto narrower = small(written, {{{"food", "in:bowl"}, Grade::Tolerable}, {{"meat", "in:bowl"}, Grade::Usual}});
  EXPECT_EQ(narrower.grade({"meat", "meat", {}}, "in:bowl").grade, Grade::Usual);
}

TEST(CommonSense, ARuleMaySpeakOfThingsByTheirNames) {
  const SenseRule rule{"runny", false, "words:cracked_egg|yolk", {}, "in:*", "it runs over", {"cracked_egg", "yolk"}};
  const auto sense = small({}, {{{"food", "in:bowl"}, Grade::Usual}}, {rule});
  EXPECT_EQ(sense.grade({"food", "cracked egg", {}}, "in:bowl").grade, Grade::Senseless);
  EXPECT_EQ(sense.grade({"food", "egg", {}}, "in:bowl").grade, Grade::Usual);
  EXPECT_TRUE(sense.has_rule_on_name("cracked egg"));
  EXPECT_FALSE(sense.has_rule_on_name("egg"));
}

TEST(CommonSense, NoEvidenceOverridesARule) {
  const auto sense = small({{"meat", "in:bin", 100, "everybody", "test"}}, {{{"meat", "in:bin"}, Grade::Usual}},
                           {{"waste", false, "food", {"fruit"}, "in:*", "food is not wasted"}});
  EXPECT_EQ(sense.grade({"meat", "meat", {}}, "in:bin").grade, Grade::Senseless);
  EXPECT_THAT(sense.grade({"meat", "meat", {}}, "in:bin").reasons, Contains(HasSubstr("food is not wasted")));
  EXPECT_NE(sense.grade({"fruit", "fruit", {}}, "in:bin").reasons.front(), "rule waste: food is not wasted");
}

TEST(CommonSense, APlaceOfAWideKindIsAsGoodAsTheBestOfItsNarrowerOnes) {
  EXPECT_NE(grade_of("cup", "in:storage_cabinet"), Grade::Usual);
  EXPECT_EQ(grade_of("cup", "in:cabinet"), Grade::Usual);
  EXPECT_EQ(grade_of("tooth_care", "in:cabinet"), Grade::Usual);
  EXPECT_EQ(grade_of("fruit_piece", "in:cabinet"), Grade::Senseless);
}

TEST(CommonSense, GradesWhatEverybodyKnows) {
  for (const auto& [kind, role] : std::vector<std::pair<std::string, Role>>{{"cup", "in:kitchen_cabinet"},
                                                                            {"dairy", "in:fridge"},
                                                                            {"book", "on:shelf"},
                                                                            {"garment", "in:wardrobe"},
                                                                            {"garment", "wash"},
                                                                            {"plate", "wash"},
                                                                            {"cup", "fill:coffee"},
                                                                            {"raw_meat", "cook"},
                                                                            {"book", "read"},
                                                                            {"fridge", "open"},
                                                                            {"television", "switch_on"},
                                                                            {"rubbish", "in:trash_can"}})
    EXPECT_EQ(grade_of(kind, role), Grade::Usual) << kind << " " << role;
  for (const auto& [kind, role] : std::vector<std::pair<std::string, Role>>{{"chemical", "on:dining_table"},
                                                                            {"game", "in:trash_can"},
                                                                            {"raw_egg", "cook"},
                                                                            {"salad_piece", "in:toaster"},
                                                                            {"salad_piece", "heat"},
                                                                            {"book", "wash"},
                                                                            {"pan", "fill:wine"},
                                                                            {"cutlery", "in:microwave"},
                                                                            {"laptop", "in:sink"},
                                                                            {"food", "cover:cleaning_agent"},
                                                                            {"stove", "switch_on"},
                                                                            {"fruit", "burn"},
                                                                            {"plate", "break"}})
    EXPECT_EQ(grade_of(kind, role), Grade::Senseless) << kind << " " << role;
}

TEST(CommonSense, MetalIsWhatIsAllOfMetal) {
  EXPECT_EQ(grade_of("bowl", "in:microwave", {"metal"}), Grade::Senseless);
  EXPECT_NE(grade_of("bowl", "in:microwave", {"glass", "metal"}), Grade::Senseless);
  EXPECT_NE(grade_of("bowl", "in:microwave"), Grade::Senseless);
}

TEST(CommonSense, KeepsApartWhatIsDangerousTogether) {
  const auto& sense = test::committed_sense();
  EXPECT_EQ(sense.together({"kitchen_knife", "knife", {}}, {"toy", "doll", {}}).grade, Grade::Senseless);
  EXPECT_EQ(sense.together({"toy", "doll", {}}, {"kitchen_knife", "knife", {}}).grade, Grade::Senseless);
  EXPECT_EQ(sense.together({"bread", "bread", {}}, {"cleaning_agent", "bleach", {}}).grade, Grade::Senseless);
  EXPECT_EQ(sense.together({"plate", "plate", {}}, {"cutlery", "fork", {}}).grade, Grade::Usual);
}

TEST(CommonSense, KnowsWhatNobodyKeepsInOneCabinet) {
  SenseRule rule{"food-apart", false, "movable", {"food", "bowl"}, "food", "food is kept with food"};
  rule.stored = true;
  const CommonSense sense = small({}, {}, {rule});
  using Rules = std::vector<std::size_t>;
  EXPECT_EQ(sense.stored_apart({"fruit", "apple", {}}).one, Rules{});
  EXPECT_EQ(sense.stored_apart({"fruit", "apple", {}}).other, Rules{0});
  EXPECT_EQ(sense.stored_apart({"movable", "soap", {}}).one, Rules{0});
  EXPECT_EQ(sense.stored_apart({"movable", "soap", {}}).other, Rules{});
  EXPECT_NE(sense.grade({"movable", "soap", {}}, "food").why, "rule:food-apart") << "it speaks of no role";
}

TEST(CommonSense, EverySourceOfTheTablesHasALicense) {
  std::vector<Error> errors;
  const auto licenses = read_licenses(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/licences.csv", errors);
  const auto& kinds = test::committed_sense().kinds();
  const auto evidence = read_evidence(test::sense_tables() / "counts.csv", kinds, errors);
  EXPECT_TRUE(errors.empty());
  EXPECT_GT(evidence.size(), 1000u);
  for (const auto& row : evidence) EXPECT_TRUE(license_of(licenses, row.source)) << row.source;
}

}  // namespace
}  // namespace unietp
