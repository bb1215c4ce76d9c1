#include "sense/place_uses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> place_problems(const std::string& rows) {
  const ScratchFolder folder;
  EXPECT_TRUE(write_file(folder.path() / "place_uses.csv", "use,places,source\n" + rows));
  std::vector<Error> errors;
  (void)read_place_uses(folder.path() / "place_uses.csv", test::committed_sense().kinds(), errors);
  std::vector<std::string> texts;
  for (const auto& error : errors) texts.push_back(format(error));
  return texts;
}

TEST(PlaceUses, AreThoseOfTheirKindAndOfWiderOnes) {
  const auto& sense = test::committed_sense();
  EXPECT_TRUE(sense.used_for("cabinet", PlaceUse::Storage));
  EXPECT_TRUE(sense.used_for("kitchen_cabinet", PlaceUse::Storage));
  EXPECT_FALSE(sense.used_for("no_kind_at_all", PlaceUse::Storage));
  EXPECT_FALSE(sense.used_for("oven", PlaceUse::Storage));
  EXPECT_TRUE(sense.used_for("shelf", PlaceUse::PutAway));
  EXPECT_FALSE(sense.used_for("fridge", PlaceUse::PutAway));
  EXPECT_TRUE(sense.used_for("sink", PlaceUse::OwnRooms));
  EXPECT_FALSE(sense.used_for("sink", PlaceUse::PutAway));
  EXPECT_TRUE(sense.used_for("oven", PlaceUse::Passing));
  EXPECT_TRUE(sense.used_for("counter", PlaceUse::DirtyThings));
  EXPECT_FALSE(sense.used_for("counter", PlaceUse::DirtyOrNot));
  EXPECT_TRUE(sense.used_for("kitchen_cabinet", PlaceUse::NotAtHand));
  EXPECT_FALSE(sense.used_for("counter", PlaceUse::NotAtHand));
  EXPECT_TRUE(sense.place_uses().has({"kitchen_cabinet", "cabinet", "place"}, PlaceUse::NotAtHand));
  EXPECT_FALSE(sense.place_uses().has({"counter", "place"}, PlaceUse::NotAtHand));
}

TEST(PlaceUses, AFaultyRowIsReportedWithItsPlace) {
  const std::string rest =
      "dirty_things,sink,curated\ndirty_or_not,sink,curated\nput_away,shelf,curated\nnot_at_hand,sink,curated\n"
      "own_rooms,sink,curated\npassing,oven,curated\n";
  EXPECT_THAT(place_problems("storage,cabinet|drawer,curated\n" + rest), IsEmpty());
  EXPECT_THAT(place_problems("storage,cabnet,curated\n" + rest),
              Contains(HasSubstr("2:9: schema error: 'cabnet' is not")));
  EXPECT_THAT(place_problems("store,cabinet,curated\n" + rest), Contains(HasSubstr("'store' is not a use; known are")));
  EXPECT_THAT(place_problems(rest), Contains(HasSubstr("no row for the use 'storage'")));
  EXPECT_THAT(place_problems(rest + "storage,cabinet,curated\npassing,stove,curated\n"),
              Contains(HasSubstr("'passing' stands twice")));
}

}  // namespace
}  // namespace unietp
