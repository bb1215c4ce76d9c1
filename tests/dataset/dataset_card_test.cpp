// The card of a data set: what it tells of size and of where candidates went.
#include "dataset/dataset_card.h"

#include <gmock/gmock.h>

namespace unietp {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(DatasetCard, NamesTheClassOfItsSize) {
  for (const auto& [tasks, name] :
       {std::pair(0, "n<1K"), std::pair(999, "n<1K"), std::pair(1000, "1K<n<10K"), std::pair(99999, "10K<n<100K"),
        std::pair(100000, "100K<n<1M"), std::pair(100000000, "100M<n<1B")}) {
    Manifest manifest;
    manifest.counts.tasks = tasks;
    EXPECT_THAT(dataset_card(manifest), HasSubstr("\n- " + std::string(name) + "\n")) << tasks;
  }
}

TEST(DatasetCard, TellsWhereTheCandidatesWent) {
  Manifest manifest;
  manifest.counts.tasks = 7;
  manifest.counts.rejections["grounding"]["no-free-place"] = 3;
  const std::string card = dataset_card(manifest);
  EXPECT_THAT(card, HasSubstr("# 7 verified embodied-planning tasks\n"));
  EXPECT_THAT(card, HasSubstr("| grounding | no-free-place | 3 |\n| – | accepted | 7 |\n"));
  EXPECT_THAT(card, Not(HasSubstr("| expert |")));
}

TEST(DatasetCard, TellsTheShareOfEachFormOfASimulatorThatHasTasks) {
  Manifest manifest;
  manifest.counts.tasks = 11;
  manifest.counts.by_simulator = {{"ai2thor", 8}, {"virtualhome", 3}};
  manifest.counts.by_form = {{"virtualhome", 3}, {"virtualhome-unity", 2}};
  EXPECT_THAT(dataset_card(manifest),
              HasSubstr("|---|---|---|---|\n| ai2thor | 0 | 8 | 0.0 % |\n| virtualhome | 3 | 3 | 100.0 % |\n"
                        "| virtualhome-unity | 2 | 3 | 66.7 % |\n\n"));
}

}  // namespace
}  // namespace unietp
