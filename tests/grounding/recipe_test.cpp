#include <gtest/gtest.h>

#include "core/files.h"
#include "grounding/where.h"
#include "homes.h"

namespace unietp {
namespace {

TEST(LoadRecipe, ReadsTheCommittedRecipesOfAllSimulators) {
  for (const Simulator simulator : kSimulators) {
    const auto style = style_of(simulator);
    ASSERT_TRUE(style) << name_of(simulator);
    EXPECT_GE(style->recipe.rooms.size(), 5u);
    for (const FurnitureRule& rule : style->recipe.furniture) EXPECT_TRUE(parse_where(rule.where)) << rule.where;
  }
}

class BadRecipe : public testing::Test {
 protected:
  /// The first error of a recipe whose second data row is the given one.
  std::string error_of(const std::string& row) {
    const auto style = style_of(Simulator::Ai2thor);
    const auto folder = std::filesystem::temp_directory_path() / ("unietp_recipe_" + std::to_string(::getpid()));
    const auto file = folder / "ai2thor.csv";
    EXPECT_TRUE(
        write_file(file, "room,category,at_least,at_most,where,source\nkitchen,Sink,1,1,wall,curated\n" + row + "\n"));
    const auto recipe = load_recipe(folder, style->knowledge);
    std::filesystem::remove_all(folder);
    return recipe ? "no error" : format(recipe.error());
  }
};

TEST_F(BadRecipe, IsReportedWithLineColumnAndWhatIsAccepted) {
  EXPECT_EQ(error_of("attic,Sink,1,1,wall,curated"),
            "ai2thor.csv:3:1: schema error: unknown room type 'attic'; expected kitchen, living_room, bedroom, "
            "bathroom, dining_room, office or corridor");
  EXPECT_EQ(error_of("kitchen,Fridg,1,1,wall,curated"),
            "ai2thor.csv:3:9: schema error: the knowledge base has no category 'Fridg'; did you mean 'Fridge'?");
  EXPECT_EQ(error_of("kitchen,Mug,1,1,wall,curated"),
            "ai2thor.csv:3:9: schema error: 'Mug' is movable; a recipe lists furniture");
  EXPECT_EQ(error_of("kitchen,Fridge,-1,1,wall,curated"),
            "ai2thor.csv:3:16: schema error: expected a number from 0 to 20, got '-1'");
  EXPECT_EQ(error_of("kitchen,Fridge,2,1,wall,curated"),
            "ai2thor.csv:3:18: schema error: expected a number from at_least (and 1) to 20, got '1'");
  EXPECT_EQ(error_of("kitchen,Fridge,1,1,ceiling,curated"),
            "ai2thor.csv:3:20: schema error: expected wall, corner, centre, wall-hung[:metres], on:, at:, beside: or "
            "above:<category>[:metres], got 'ceiling'");
  EXPECT_EQ(error_of("kitchen,Faucet,1,1,above:Bathtub,curated"),
            "ai2thor.csv:3:20: schema error: 'Bathtub' must be listed above for the same room");
  EXPECT_EQ(error_of("kitchen,Fridge,1,1,wall,"), "ai2thor.csv:3:25: schema error: a source is missing");
}

TEST(ParseWhere, ReadsHostsAndHeights) {
  const auto above = parse_where("above:Sink:0.4");
  ASSERT_TRUE(above);
  EXPECT_EQ(above->kind, Where::Kind::Above);
  EXPECT_EQ(above->host, "Sink");
  EXPECT_EQ(above->height_m, 0.4);
  EXPECT_EQ(parse_where("wall-hung")->height_m, std::nullopt);
  for (const char* bad : {"", "on", "on:", "wall:2", "at:Desk:1", "wall-hung:high", "wall-hung:9", "above:Sink:1:2"}) {
    EXPECT_FALSE(parse_where(bad)) << bad;
  }
}

}  // namespace
}  // namespace unietp
