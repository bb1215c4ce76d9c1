#include "dataset/balance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;

Template two_places() {
  Template source;
  source.parameters = {
      {"A", {"pickupable"}, {}}, {"B", {"furniture", "receptacle"}, {}}, {"C", {"any"}, {}}, {"R", {"room"}, {}}};
  source.constraints = {{ConstraintType::FitsInside, {"A", "C"}, {}}};
  return source;
}

TEST(DimensionOf, APlaceIsAReceptacleHoweverItIsAskedFor) {
  const auto source = two_places();
  EXPECT_EQ(dimension_of(source.parameters[0], source), Dimension::Category);
  EXPECT_EQ(dimension_of(source.parameters[1], source), Dimension::Receptacle);
  EXPECT_EQ(dimension_of(source.parameters[2], source), Dimension::Receptacle);
  EXPECT_EQ(dimension_of(source.parameters[3], source), Dimension::Room);
}

TEST(TraitsOf, NamesWhatIsBoundAndWhereWhatIsHandledStands) {
  Episode episode;
  episode.specification.template_name = "store-one";
  episode.specification.simulator = Simulator::Habitat;
  episode.specification.binding = {{"A", "bowl"}, {"B", "fridge"}};
  episode.layout = "home-1";
  episode.start.rooms = {{"kitchen_1", "kitchen", {}}, {"bedroom_1", "bedroom", {}}};
  episode.start.edges = {{Predicate::InRoom, "bowl_1", "bedroom_1"},
                         {Predicate::InRoom, "fridge_1", "kitchen_1"},
                         {Predicate::InRoom, "bed_1", "bedroom_1"}};
  Demonstration demonstration;
  demonstration.steps.emplace_back();
  demonstration.steps.back().action.args = {"fridge_1"};
  auto source = two_places();
  source.name = "store-one";
  EXPECT_EQ(
      to_text(traits_of(source, episode, demonstration)),
      "template store-one\ncategory habitat/bowl\nreceptacle habitat/fridge\nroom habitat/kitchen\nscene home-1\n");
}

TEST(Traits, TextAndBack) {
  const std::vector<Trait> traits{{Dimension::Template, "a b"}, {Dimension::Room, "ai2thor/kitchen"}};
  EXPECT_EQ(traits_from(to_text(traits)), traits);
  EXPECT_THAT(traits_from("nonsense\nroom x\n"), ElementsAre(Trait{Dimension::Room, "x"}));
}

TEST(Frequencies, WeighAValueLessTheOftenerItWasUsed) {
  Frequencies counts;
  counts.add({Dimension::Category, "mug"});
  counts.add({Dimension::Category, "bowl"});
  counts.add({Dimension::Category, "bowl"});
  EXPECT_DOUBLE_EQ(counts.weight(Dimension::Category, "plate"), 1);
  EXPECT_LT(counts.weight(Dimension::Category, "bowl"), counts.weight(Dimension::Category, "mug"));
  EXPECT_DOUBLE_EQ(counts.weight(Dimension::Receptacle, "mug"), 1);  // dimensions do not mix
}

TEST(Frequencies, TellHowEvenTheyAre) {
  Frequencies even, uneven;
  for (const auto* value : {"a", "b", "c", "d"}) even.add({Dimension::Room, value});
  for (const auto* value : {"a", "a", "a", "b"}) uneven.add({Dimension::Room, value});
  ASSERT_EQ(even.spreads().size(), 1U);
  EXPECT_EQ(even.spreads()[0].values, 4);
  EXPECT_DOUBLE_EQ(even.spreads()[0].effective, 4);
  EXPECT_DOUBLE_EQ(even.spreads()[0].variation, 0);
  EXPECT_EQ(uneven.spreads()[0].values, 2);
  EXPECT_DOUBLE_EQ(uneven.spreads()[0].effective, 1.6);
  EXPECT_DOUBLE_EQ(uneven.spreads()[0].variation, 0.5);
}

}  // namespace
}  // namespace unietp
