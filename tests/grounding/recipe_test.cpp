#include "grounding/recipe.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "grounding/furniture_position.h"
#include "homes.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(LoadRecipe, ReadsTheCommittedRecipesOfAllSimulators) {
  for (const Simulator simulator : kSimulators) {
    const auto style = style_of(simulator);
    ASSERT_TRUE(style) << name_of(simulator);
    EXPECT_EQ(style->recipe.rooms.size(), 7u);
    EXPECT_GE(style->recipe.furniture.size(), 60u);
    EXPECT_GE(style->recipe.objects.size(), 60u);
    EXPECT_GT(style->recipe.unseen_share, 0);
    for (const FurnitureRule& rule : style->recipe.furniture)
      EXPECT_TRUE(parse_furniture_position(rule.where)) << rule.where;
  }
}

class BadRecipe : public ::testing::Test {
 protected:
  static RecipeTexts sound() {
    return {
        "room,weight,at_least,at_most,area_low,area_high,source\nkitchen,1,1,1,10,20,curated\nbedroom,1,1,4,"
        "10,20,curated\n"
        "bathroom,1,1,3,10,20,curated\nliving_room,1,1,2,10,20,curated\n",
        "room,category,mean,at_least,at_most,where,source\nkitchen,Sink,1,1,1,wall,curated\n",
        "room,category,mean,source\nany,unseen,0.1,curated\nkitchen,Mug,1,curated\n",
        "category,mean,source\nFridge,2,curated\n"};
  }
  static std::string first_error(const RecipeTexts& texts) {
    static const auto style = style_of(Simulator::Ai2thor);
    const auto recipe = read_recipe(texts, style->knowledge);
    return recipe ? "no error" : format(recipe.error());
  }
  static std::string furniture(const std::string& row) {
    RecipeTexts texts = sound();
    texts.furniture += row + "\n";
    return first_error(texts);
  }
  static std::string room(const std::string& row) {
    RecipeTexts texts = sound();
    texts.rooms += row + "\n";
    return first_error(texts);
  }
  static std::string object(const std::string& row) {
    RecipeTexts texts = sound();
    texts.objects += row + "\n";
    return first_error(texts);
  }
};

TEST_F(BadRecipe, IsReportedWithLineColumnAndWhatIsAccepted) {
  ASSERT_EQ(first_error(sound()), "no error");
  EXPECT_EQ(furniture("attic,Sink,1,1,1,wall,curated"),
            "ai2thor.csv:3:1: schema error: unknown room of this simulator 'attic'; expected one of bathroom, bedroom, "
            "kitchen, living_room");
  EXPECT_EQ(furniture("kitchen,Fridg,1,1,1,wall,curated"),
            "ai2thor.csv:3:9: schema error: unknown piece of furniture 'Fridg'; expected a piece of furniture of the "
            "category table; did you mean 'Fridge'?");
  EXPECT_EQ(furniture("kitchen,Mug,1,1,1,wall,curated"),
            "ai2thor.csv:3:9: schema error: 'Mug' is movable; a recipe lists furniture");
  EXPECT_EQ(furniture("kitchen,Fridge,1,-1,1,wall,curated"),
            "ai2thor.csv:3:18: schema error: bad at_least '-1'; expected a whole number >= 0");
  EXPECT_EQ(furniture("kitchen,Fridge,2,2,1,wall,curated"),
            "ai2thor.csv:3:20: schema error: bad at_most '1'; expected a whole number >= 2");
  EXPECT_EQ(furniture("kitchen,Fridge,3,1,2,wall,curated"),
            "ai2thor.csv:3:16: schema error: expected a number from at_least to at_most");
  EXPECT_EQ(furniture("kitchen,Fridge,1,1,1,roof,curated"),
            "ai2thor.csv:3:22: schema error: expected wall, run, corner, centre, ceiling, wall-hung[:metres], "
            "outer-wall[:metres], on:, at:, beside:, before:, facing: or above:<category>[:metres], got 'roof'");
  EXPECT_EQ(furniture("kitchen,Faucet,1,1,1,above:Bathtub,curated"),
            "ai2thor.csv:3:22: schema error: 'Bathtub' must be listed above for the same room");
  EXPECT_EQ(furniture("kitchen,Fridge,1,1,1,wall,"),
            "ai2thor.csv:3:27: schema error: expected metadata:<file>, derived:<rule>, llm:<model> or curated");
  EXPECT_EQ(room("kitchen,1,1,1,10,20,curated"), "ai2thor_rooms.csv:6:1: schema error: 'kitchen' occurs twice");
  EXPECT_EQ(room("office,1,0,1,20,10,curated"),
            "ai2thor_rooms.csv:6:17: schema error: bad area_high '10'; expected a number >= 20 and <= 80");
  EXPECT_EQ(object("kitchen,Mug,2,curated"), "ai2thor_objects.csv:4:9: schema error: is duplicated for the same room");
  RecipeTexts no_rooms = sound();
  no_rooms.rooms = "room,weight,at_least,at_most,area_low,area_high,source\nkitchen,1,1,1,10,20,curated\n";
  EXPECT_EQ(first_error(no_rooms), "ai2thor_rooms.csv:1:1: schema error: a home needs at least 4 room types");
}

/// The errors that reading a table gives.
template <class Read>
std::vector<std::string> errors_of(const Read& read, const std::string& text) {
  std::vector<Error> errors;
  (void)read("table.csv", text, errors);
  std::vector<std::string> texts;
  for (const Error& error : errors) texts.push_back(format(error));
  return texts;
}

TEST(ReadRoomDoors, ReportsUnknownUsesAndRooms) {
  const std::string header = "use,room,other,source\n";
  std::vector<Error> errors;
  const RoomDoors doors = read_room_doors("table.csv",
                                          header +
                                              "at_the_end,kitchen,living_room,curated\n"
                                              "at_the_end,office,corridor,curated\n",
                                          errors);
  EXPECT_TRUE(errors.empty());
  EXPECT_EQ(doors.at_the_end, (RoomDoors::Pairs{{"kitchen", "living_room"}, {"office", "corridor"}}));
  EXPECT_TRUE(doors.walked_through.empty());
  EXPECT_THAT(errors_of(read_room_doors, header + "inside,kitchen,attic,curated\n"),
              ElementsAre(StartsWith("table.csv:2:1: schema error: unknown use 'inside'"),
                          StartsWith("table.csv:2:16: schema error: unknown room type 'attic'")));
}

TEST(ReadHomeScales, ReportsUnknownMissingAndRepeatedSimulators) {
  const std::string header = "simulator,fewest_rooms,most_rooms,objects_a_room,source\n";
  const std::string three = "ai2thor,5,8,30,curated\nvirtualhome,4,6,28,curated\nhabitat,8,11,29.5,curated\n";
  EXPECT_THAT(errors_of(read_home_scales, header + three + "behavior,7,10,31.4,curated\n"), IsEmpty());
  EXPECT_THAT(errors_of(read_home_scales, header + three + "ai2thor,5,8,30,curated\nmars,5,4,0,curated\n"),
              ElementsAre("table.csv:5:1: schema error: stands twice",
                          "table.csv:6:1: schema error: 'mars' is not a simulator", StartsWith("table.csv:6:8: "),
                          StartsWith("table.csv:6:10: "), "table.csv: schema error: no row for behavior"));
}

TEST(ParseWhere, ReadsHostsAndHeights) {
  const auto above = parse_furniture_position("above:Sink:0.4");
  ASSERT_TRUE(above);
  EXPECT_EQ(above->kind, FurniturePosition::Kind::Above);
  EXPECT_EQ(above->host, "Sink");
  EXPECT_EQ(above->height_m, 0.4);
  EXPECT_EQ(parse_furniture_position("wall-hung")->height_m, std::nullopt);
  EXPECT_EQ(parse_furniture_position("outer-wall:0.2")->height_m, 0.2);
  for (const char* bad :
       {"", "on", "on:", "wall:2", "at:Desk:1", "before:Sofa:1", "wall-hung:high", "wall-hung:9", "above:Sink:1:2"}) {
    EXPECT_FALSE(parse_furniture_position(bad)) << bad;
  }
}

}  // namespace
}  // namespace unietp
