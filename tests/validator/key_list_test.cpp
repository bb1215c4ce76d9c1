#include "validator/key_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(KeyList, NamesTheFirstOfEachRepeatInOrderOfPlace) {
  KeyList keys;
  std::size_t place = 0;
  for (const char* key : {"a", "b", "a", "c", "b", "a"}) keys.add(key, place++);
  EXPECT_THAT(keys.repeats(), ElementsAre(Repeat{2, 0}, Repeat{4, 1}, Repeat{5, 0}));
  EXPECT_THAT(keys.places("a"), ElementsAre(0U, 2U, 5U));
  EXPECT_THAT(keys.places("z"), IsEmpty());
}

TEST(TaskNames, GiveBackNamesAndPlaces) {
  TaskNames names;
  for (const char* name : {"ai2thor-1", "", "habitat-2", "ai2thor-1"}) names.add(name);
  EXPECT_EQ(names.name(0), "ai2thor-1");
  EXPECT_EQ(names.name(1), "");
  EXPECT_EQ(names.name(2), "habitat-2");
  EXPECT_THAT(names.repeats(), ElementsAre(Repeat{3, 0}));
  EXPECT_THAT(names.places("habitat-2"), ElementsAre(2U));
}

}  // namespace
}  // namespace unietp
