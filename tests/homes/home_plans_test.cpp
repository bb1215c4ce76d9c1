#include "homes/home_plans.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The committed recipes, with what the program knows.
class HomePlans : public ::testing::Test {
 protected:
  static const HomeInputs& inputs() {
    static const HomeInputsReading kRead = load_home_inputs(folders());
    EXPECT_TRUE(kRead.errors.empty());
    return kRead.inputs;
  }
  static DataFolders folders() {
    return {UNIETP_SOURCE_DIR, std::filesystem::path(::testing::TempDir()) / "unietp-home-plans-cache"};
  }
};

TEST_F(HomePlans, AHomeOfTheBenchmarkIsNamedAndTheNearestNameIsToldOtherwise) {
  const auto two = benchmark_homes(inputs(), folders(), false, {"habitat-benchmark-02", "ai2thor-benchmark-01"});
  ASSERT_TRUE(two) << format(two.error());
  ASSERT_EQ(two->size(), 2U);
  EXPECT_EQ((*two)[0].id, "ai2thor-benchmark-01") << "in the order of the benchmark";
  EXPECT_EQ((*two)[1].id, "habitat-benchmark-02");
  const auto all = benchmark_homes(inputs(), folders(), true, {});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->size(), 170U);
  const auto wrong = benchmark_homes(inputs(), folders(), false, {"ai2thor-benchmark-01", "habitat-benchmrak-02"});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().kind, Error::Kind::Usage);
  EXPECT_THAT(wrong.error().message, HasSubstr("did you mean \"habitat-benchmark-02\""));
  EXPECT_THAT(wrong.error().message, Not(HasSubstr("ai2thor-benchmark-01\"")));
}

TEST_F(HomePlans, NewHomesHaveTheSizeThatIsAskedForAndDoNotDependOnTheirNumber) {
  const auto one = new_homes(inputs(), Simulator::Ai2thor, {1, 5, 5, 0});
  const auto three = new_homes(inputs(), Simulator::Ai2thor, {3, 5, 5, 0});
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(one[0].id, three[0].id);
  EXPECT_THAT(one[0].id, HasSubstr("-sized-5-0"));
  const auto made = one[0].make(), again = three[0].make(), other = three[1].make();
  ASSERT_TRUE(made && again && other);
  EXPECT_EQ(*made, *again);
  EXPECT_NE(*made, *other);
  EXPECT_EQ(made->rooms.size(), 5U);
  EXPECT_GT(made->nodes.size(), 120U);
  const auto few = new_homes(inputs(), Simulator::Ai2thor, {1, 5, 5, 20})[0].make();
  ASSERT_TRUE(few);
  EXPECT_LT(few->nodes.size(), made->nodes.size());
  const auto as_usual = new_homes(inputs(), Simulator::Ai2thor, {1, 5, 5, 150})[0].make();
  ASSERT_TRUE(as_usual);
  EXPECT_EQ(*as_usual, *made) << "30 objects for each room unless their number is given";
  EXPECT_THAT(new_homes(inputs(), Simulator::Ai2thor, {1, 5, 0, 0})[0].id, HasSubstr("-training-5-0"));
}

}  // namespace
}  // namespace unietp
