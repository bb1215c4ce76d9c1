// What Unity's table of classes says of VirtualHome's programs.
#include "exports/virtualhome_unity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

const UnityClasses& classes() {
  static const auto read = read_unity_classes(UNIETP_SOURCE_DIR "/data/scene_files/virtualhome_unity.csv");
  return *read;
}

TEST(UnitysTable, AllowsWhatItsClassesCan) {
  EXPECT_EQ(denied_by_unity({"[Walk] <closet> (3)", "[Grab] <mug> (1)", "[Open] <kitchen_cabinet> (2)",
                             "[PutIn] <mug> (1) <kitchen_cabinet> (2)", "[StandUp]"},
                            classes()),
            "");
}

TEST(UnitysTable, DeniesWithWhatUnitysApartmentsHave) {
  EXPECT_EQ(denied_by_unity({"[Open] <washing_machine> (2)"}, classes()),
            "Unity's table denies Open of washingmachine, which the graphs of its own apartments allow");
  EXPECT_EQ(denied_by_unity({"[Grab] <mug> (1)", "[PutIn] <mug> (1) <box> (2)"}, classes()),
            "Unity's table denies PutIn of box");
  EXPECT_EQ(denied_by_unity({"[Grab] <oventray> (1)"}, classes()), "Unity's table denies Grab of oventray")
      << "a class that it does not know";
}

TEST(UnitysTable, ThatIsNoneIsRefused) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at(""), "table.csv", "class,action,source\nbox,Open,x\n"));
  const auto read = read_unity_classes(folder.at("table.csv"));
  ASSERT_FALSE(read);
  EXPECT_THAT(format(read.error()), HasSubstr("class, property and source"));
}

}  // namespace
}  // namespace unietp
