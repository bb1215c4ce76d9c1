#include "dataset/configuration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ParseSimulators, TakesNamesInAnyOrderAndGivesTheirOwn) {
  const auto parsed = parse_simulators("--simulators", "habitat, ai2thor,habitat");
  ASSERT_TRUE(parsed);
  EXPECT_THAT(*parsed, ElementsAre(Simulator::Ai2thor, Simulator::Habitat));
}

TEST(ParseSimulators, RefusesAnUnknownNameWithTheNearestAndAllAccepted) {
  const auto parsed = parse_simulators("--simulators", "ai2thor,behaviour");
  ASSERT_FALSE(parsed);
  EXPECT_EQ(parsed.error().where, "--simulators");
  EXPECT_THAT(parsed.error().message, HasSubstr("\"behaviour\", did you mean \"behavior\""));
  EXPECT_THAT(parsed.error().message, HasSubstr("ai2thor, virtualhome, habitat, behavior"));
}

TEST(ParseSplits, RefusesNothing) {
  EXPECT_FALSE(parse_splits("--splits", " , "));
  const auto parsed = parse_splits("--splits", "linguistic,atomic");
  ASSERT_TRUE(parsed);
  EXPECT_THAT(*parsed, ElementsAre(Split::Atomic, Split::Linguistic));
}

}  // namespace
}  // namespace unietp
