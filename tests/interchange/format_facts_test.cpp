#include "interchange/format_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "interchange/category_names.h"
#include "interchange/house_names.h"
#include "interchange/virtualhome_words.h"
#include "tests/interchange/import_rates.h"
#include "tests/support/scratch_folder.h"

namespace unietp::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char* const kWords = "word,category,source\nsofa,couch,curated\n";
const char* const kDoors = "model,width_m,height_m,source\nNarrow,0.9,2,curated\nWide,2,2,curated\n";
const char* const kFloors =
    "room,material,source\nBathroom,A,curated\nBedroom,B,curated\nKitchen,C,curated\nLivingRoom,D,curated\n";

/// Sound tables, but for those that `others` replaces.
FormatFactsReading reading_of(const std::string& words, const std::string& doors, const std::string& floors,
                              const std::map<std::string, std::string>& others = {}) {
  const ScratchFolder folder;
  std::map<std::string, std::string> texts{
      {"virtualhome_rooms.csv", "class,room,source\nhallway,corridor,curated\nentrance_hall,corridor,curated\n"},
      {"virtualhome_states.csv", "word,state,source\nON,power_on,curated\n"},
      {"virtualhome_properties.csv", "property,affordance,source\nGRABBABLE,pickupable,curated\n"},
      {"virtualhome_prefabs.csv",
       "prefab,class,width_m,depth_m,height_m,source\nBed_1,bed,1,2,0.5,curated\nBed_2,bed,,,,curated\n"},
      {"virtualhome_faced.csv", "class,source\ntv,curated\n"},
      {"building_words.csv", "word,source\ndoorframe,curated\n"},
      {"procthor_lacks.csv", "model,lacks,source\nFixed_Mug,fillable|pickupable,curated\n"}};
  for (const auto& [name, text] : others) texts[name] = text;
  for (const auto& [name, text] : texts) EXPECT_TRUE(write_file(folder.path() / name, text));
  EXPECT_TRUE(write_file(folder.path() / "replicacad_words.csv", words));
  EXPECT_TRUE(write_file(folder.path() / "procthor_doors.csv", doors));
  EXPECT_TRUE(write_file(folder.path() / "procthor_floors.csv", floors));
  return read_format_facts(folder.path());
}

std::vector<std::string> texts_of(const std::vector<Error>& errors) {
  std::vector<std::string> texts;
  for (const Error& error : errors) {
    const std::string text = format(error);
    texts.push_back(text.substr(text.rfind('/') + 1));
  }
  return texts;
}

TEST(FormatFacts, AreReadFromTheirTables) {
  const auto [facts, errors] = reading_of(kWords, kDoors, kFloors);
  EXPECT_THAT(texts_of(errors), ElementsAre());
  EXPECT_EQ(facts.replicacad_words.at("sofa"), "couch");
  EXPECT_THAT(facts.model_lacks.at("Fixed_Mug"), ElementsAre("fillable", "pickupable"));
  EXPECT_EQ(facts.floor_materials.at("Kitchen"), "C");
  EXPECT_EQ(door_model_for(1.4, facts).name, "Narrow");
  EXPECT_EQ(door_model_for(1.5, facts).name, "Wide");
  EXPECT_EQ(door_model_for(1.45, facts).name, "Narrow") << "ties go to the first";
  EXPECT_EQ(room_type_of_virtualhome("Entrance_Hall", facts), "corridor");
  EXPECT_EQ(room_type_of_virtualhome("Kitchen", facts), "kitchen");
  EXPECT_EQ(virtualhome_room_name("corridor", facts), "hallway") << "the first that is listed";
  EXPECT_EQ(state_of_virtualhome("ON", facts), (State{Predicate::PowerOn, ""}));
  EXPECT_EQ(state_of_virtualhome("SITTING", facts), std::nullopt);
  EXPECT_EQ(virtualhome_state(Predicate::PowerOn, facts), "ON");
  ASSERT_EQ(facts.virtualhome_properties.size(), 1U);
  EXPECT_EQ(facts.virtualhome_properties[0].ours, "pickupable");
  ASSERT_EQ(facts.virtualhome_prefabs.at("bed").size(), 2U);
  EXPECT_EQ(facts.virtualhome_prefabs.at("bed")[0].size, Vec3(1, 2, 0.5));
  EXPECT_EQ(facts.virtualhome_prefabs.at("bed")[1].size, Vec3(0, 0, 0)) << "not told";
  EXPECT_TRUE(is_of_the_building("Door_Frame", facts));
  EXPECT_FALSE(is_of_the_building("Drawer", facts));
}

TEST(FormatFacts, EveryProblemOfATableIsReportedWithItsPlace) {
  EXPECT_THAT(texts_of(reading_of("word,source\nsofa,curated\n", kDoors, kFloors).errors),
              ElementsAre("replicacad_words.csv:1:1: schema error: missing column 'category'; expected word, category, "
                          "source"));
  EXPECT_THAT(texts_of(reading_of("word,category,source\nsofa,couch,curated\nsofa,bed,curated\n",
                                  "model,width_m,height_m,source\nNarrow,-1,2,curated\n", kFloors)
                           .errors),
              ElementsAre("replicacad_words.csv:3:1: schema error: 'sofa' stands twice",
                          "procthor_doors.csv:2:8: schema error: bad width_m '-1'; expected a number > 0 and <= 10"));
  EXPECT_THAT(texts_of(reading_of(kWords, "model,width_m,height_m,source\n",
                                  "room,material,source\nBathroom,A,curated\nBedroom,B,curated\nKitchen,C,curated\n")
                           .errors),
              ElementsAre("procthor_doors.csv: schema error: is empty; expected at least one model",
                          "procthor_floors.csv: schema error: lacks a row for LivingRoom"));
}

TEST(FormatFacts, WordsForWhatWeDoNotHaveAreProblems) {
  EXPECT_THAT(texts_of(reading_of(kWords, kDoors, kFloors,
                                  {{"virtualhome_states.csv", "word,state,source\nON,glowing,curated\n"},
                                   {"virtualhome_properties.csv", "property,affordance,source\nGRAB,grab,curated\n"},
                                   {"building_words.csv", "word,source\nwall,curated\nwall,curated\n"}})
                           .errors),
              ElementsAre(HasSubstr("virtualhome_states.csv:2:4: schema error"),
                          HasSubstr("virtualhome_properties.csv:2:6: schema error"),
                          "building_words.csv:3:1: schema error: 'wall' stands twice"));
}

TEST(FormatFacts, TheCommittedTablesNameCategoriesThatHabitatHas) {
  for (const auto& [word, category] : format_facts().replicacad_words) {
    EXPECT_NE(committed_knowledge(Simulator::Habitat).find(category), nullptr) << word << " is a " << category;
  }
  EXPECT_EQ(format_facts().floor_materials.size(), kProcthorRooms.size());
}

}  // namespace
}  // namespace unietp::testing
