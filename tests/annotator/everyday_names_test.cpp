// Things are called as people call them, not as a catalog lists them.
#include "annotator/everyday_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>

#include "annotator/authored.h"
#include "annotator/everyday_phrases.h"
#include "annotator/instruction.h"
#include "annotator/noun_table.h"
#include "annotator/words_for_writing.h"
#include "core/files.h"
#include "core/text.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(EverydayNames, OfPackagesSayWhatIsInThem) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Behavior);
  const NounTable nouns(knowledge, committed_names());
  int packages = 0;
  for (const Category& category : knowledge.categories()) {
    for (const std::string package : {"jar", "sack", "carton", "package"}) {
      if (!category.name.ends_with("_" + package) || category.kinds.empty() || category.kinds[0] == "outside") continue;
      const std::string content = category.name.substr(0, category.name.size() - package.size() - 1);
      // "The honey jar" is another category than "the jar of honey".
      if (content == "liquid" || content.starts_with("hinge") || knowledge.find(package + "_of_" + content) != nullptr)
        continue;
      ++packages;
      EXPECT_NE(nouns.display(category.name)->singular.find(" of "), std::string::npos) << category.name;
    }
  }
  EXPECT_GT(packages, 30);
}

TEST(EverydayNames, AreThoseOfOneCategoryInBothEnglishes) {
  for (const Simulator simulator : kSimulators) {
    const Knowledge& knowledge = committed_knowledge(simulator);
    for (const English english : {English::Us, English::Gb}) {
      const NounTable nouns(knowledge, committed_names(), english);
      std::map<std::string, std::string> named;
      for (const Category& category : knowledge.categories()) {
        const auto [at, is_new] = named.emplace(nouns.display(category.name)->singular, category.name);
        EXPECT_TRUE(is_new) << name_of(simulator) << ": " << category.name << " and " << at->second << " are both '"
                            << at->first << "'";
      }
    }
  }
}

TEST(EverydayNames, DifferBetweenTheTwoEnglishes) {
  EXPECT_EQ(committed_names()->of("chickpea can", English::Us), "can of chickpeas");
  EXPECT_EQ(committed_names()->of("chickpea can", English::Gb), "tin of chickpeas");
  EXPECT_EQ(committed_names()->of("mug", English::Us), "");
}

TEST(EverydayNames, WithoutTablesThingsAreCalledAsTheKnowledgeBaseCallsThem) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  EXPECT_EQ(NounTable(knowledge, committed_names()).display("GarbageCan")->singular, "trash can");
  EXPECT_EQ(NounTable(knowledge, {}).display("GarbageCan")->singular, knowledge.find("GarbageCan")->display);
}

/// The errors of three tables, without the folder.
std::vector<std::string> errors_of(const std::string& names, const std::string& rare,
                                   const std::string& look_alikes = "name,others,source\n") {
  const ScratchFolder folder;
  EXPECT_TRUE(write_file(folder.at("everyday_names.csv"), names));
  EXPECT_TRUE(write_file(folder.at("rare_names.csv"), rare));
  EXPECT_TRUE(write_file(folder.at("look_alikes.csv"), look_alikes));
  EXPECT_TRUE(write_file(folder.at("name_uses.csv"), "name,uses,source\npot,has_lid,curated\n"));
  std::vector<Error> errors;
  (void)read_everyday_names(folder.path(), errors);
  std::vector<std::string> texts;
  for (const Error& error : errors) texts.push_back(replace_all(format(error), folder.path().string() + "/", ""));
  return texts;
}

TEST(EverydayNames, ReportsBadRowsWithFileLineAndColumn) {
  const std::string header = "name,us,gb,source\n";
  EXPECT_THAT(errors_of(header + "oven stove,stove,cooker,curated\n", header + "bath,false,true,curated\n"), IsEmpty());
  EXPECT_THAT(errors_of(header + "mug,cup,cup,curated\nmug,cup,cup,curated\nfork,,fork,curated\n",
                        header + "bath,no,true,curated\n"),
              ElementsAre(StartsWith("everyday_names.csv:3:1: schema error: 'mug' stands twice"),
                          StartsWith("everyday_names.csv:4:6: "), StartsWith("rare_names.csv:2:6: ")));
  EXPECT_THAT(errors_of(header + "mug,cup\n", ""),
              ElementsAre(StartsWith("everyday_names.csv:2:"), StartsWith("rare_names.csv:")));
}

TEST(EverydayNames, HaveLookAlikes) {
  const std::string header = "name,us,gb,source\n";
  EXPECT_THAT(errors_of(header, header, "name,others,source\nstand,,curated\nbox,carton,\nbox,carton,curated\n"),
              ElementsAre(StartsWith("look_alikes.csv:3:12: ")));
  EXPECT_THAT(errors_of(header, header, "name,others,source\nstand|box,carton,curated\nbox,carton,curated\n"),
              ElementsAre(StartsWith("look_alikes.csv:3:1: schema error: 'box' stands twice")));
  EXPECT_THAT(committed_names()->look_alikes("fan"), ElementsAre("ceiling fan"));
  EXPECT_THAT(committed_names()->look_alikes("stand"), ::testing::Contains("nightstand"));
  EXPECT_THAT(committed_names()->look_alikes("mug"), IsEmpty());
}

TEST(EverydayNames, TellWhatIsDoneWithAThingByTheEndOfItsName) {
  const EverydayNames& names = *committed_names();
  EXPECT_TRUE(names.ends_as("upper kitchen cabinet", NameUse::PutsAway));
  EXPECT_FALSE(names.ends_as("kitchen cabinet door", NameUse::PutsAway));
  EXPECT_FALSE(names.ends_as("cabinet", NameUse::HeatsFood));
  EXPECT_TRUE(names.is_word_for("cabinets", NameUse::HasTop));
  EXPECT_FALSE(names.is_word_for("drawer", NameUse::HasTop));
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("name_uses.csv"), "name,uses,source\npot,has_lit,curated\n"));
  std::vector<Error> errors;
  (void)read_everyday_names(folder.path(), errors);
  ASSERT_THAT(errors, ::testing::SizeIs(4)) << "three files are missing";
  EXPECT_THAT(format(errors.back()), ::testing::HasSubstr("name_uses.csv:2:5"));
}

TEST(EverydayNames, OfBritonsAreCountedAsTheyCountThem) {
  const NounTable thor(committed_knowledge(Simulator::Ai2thor), committed_names(), English::Gb);
  EXPECT_EQ(thor.display("ToiletPaper")->plural, "toilet rolls");
  EXPECT_TRUE(thor.display("ToiletPaper")->countable);
}

TEST(Substances, AreWrittenAsInEnglish) {
  EXPECT_EQ(symbol_words("parmesan"), "Parmesan");
  EXPECT_EQ(symbol_words("black_pepper"), "black pepper");
  const Knowledge& knowledge = committed_knowledge(Simulator::Behavior);
  for (const char* goal : {"(exists (?a - steak) (at-end (covered ?a parmesan)))",
                           "(exists (?a - (steak :where (covered ?a parmesan))) (at-end (cooked ?a)))"}) {
    Specification asked;
    asked.goal = *parse_formula("test", goal, FormulaUse::Goal);
    const auto written = write_instruction(asked, knowledge, Rng(1));
    ASSERT_TRUE(written) << format(written.error());
    EXPECT_NE(written->text.find("Parmesan"), std::string::npos) << written->text;
    EXPECT_EQ(written->text.find("parmesan"), std::string::npos) << written->text;
  }
}

TEST(Tops, AreSaidOfCabinetsWithARoomToo) {
  const NounTable nouns(committed_knowledge(Simulator::Ai2thor), committed_names());
  EXPECT_EQ(with_tops("Put the mug on a kitchen cabinet.", nouns), "Put the mug on top of a kitchen cabinet.");
  EXPECT_EQ(with_tops("Put the mug on the cabinet.", nouns), "Put the mug on top of the cabinet.");
  EXPECT_EQ(with_tops("Put the mug on a kitchen counter.", nouns), "Put the mug on a kitchen counter.");
}

TEST(Zips, AreWhatABackpackHas) {
  EXPECT_EQ(with_zips("Put both closed backpacks in the closed box."),
            "Put both zipped-up backpacks in the closed box.");
  const Knowledge& knowledge = committed_knowledge(Simulator::Behavior);
  Specification asked;
  asked.goal = *parse_formula("test",
                              "(exists (?b - wardrobe) (forall (?a - (backpack :where (closed ?a))) "
                              "(at-end (inside ?a ?b))))",
                              FormulaUse::Goal);
  const auto written = write_instruction(asked, knowledge, Rng(1));
  ASSERT_TRUE(written) << format(written.error());
  EXPECT_NE(written->text.find("zipped-up"), std::string::npos) << written->text;
}

TEST(Shakers, AreShakenOverFood) {
  Specification asked;
  asked.goal =
      *parse_formula("test", "(exists (?a - bagel) (at-end (covered ?a lemon-pepper_seasoning)))", FormulaUse::Goal);
  const auto written = write_instruction(asked, committed_knowledge(Simulator::Behavior), Rng(1));
  ASSERT_TRUE(written) << format(written.error());
  EXPECT_TRUE(written->text.starts_with("Sprinkle ")) << written->text;
}

/// "Put some juice in the fridge. Leave the one on the table where it is."
TEST(TheOneThatStays, IsNothingThatNobodyCounts) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Virtualhome);
  const NounTable nouns(knowledge, committed_names());
  const auto written = [&](const std::string& thing) {
    Specification asked;
    asked.binding = {{"A", thing}, {"B", "fridge"}, {"C", "kitchentable"}};
    const std::string goal =
        "(exists (?b - fridge) (exists (?a - THING) (and (at-end (inside ?a ?b)) (always (forall (?d - (THING :where "
        "(exists (?c - kitchentable) (on ?d ?c)))) (exists (?e - kitchentable) (on ?d ?e)))))))";
    asked.goal = *parse_formula("test", replace_all(goal, "THING", thing), FormulaUse::Goal);
    return authored_text("Put {A:indefinite} {B:into}. Leave the one {C:on} where it is.", asked, nouns,
                         {Style::Distractor, true, {}, {}}, HomeCounts(), Rng(1));
  };
  EXPECT_TRUE(written("carrot"));
  EXPECT_FALSE(written("juice"));
}

/// "A slice of celery", not "of celery stalk".
TEST(Slices, AreOfWhatGrowsAndNotOfOnePartOfIt) {
  EXPECT_EQ(as_sliced("celery stalk"), "celery");
  EXPECT_EQ(as_sliced("stalk of celery"), "celery");
  EXPECT_EQ(as_sliced("fennel bulb"), "fennel");
  EXPECT_EQ(as_sliced("garlic clove"), "garlic");
  EXPECT_EQ(as_sliced("sourdough loaf"), "sourdough");
  EXPECT_EQ(as_sliced("tomato"), "tomato");
  const Knowledge& knowledge = committed_knowledge(Simulator::Behavior);
  for (const auto& [category, said] : {std::pair{"celery", "of celery "}, std::pair{"whole_fennel", "of fennel "}}) {
    Specification asked;
    const std::string goal =
        "(exists (?b - chopping_board) (at-end (count >= 2 (?s - " + std::string(category) + "/slice) (on ?s ?b))))";
    asked.goal = *parse_formula("test", goal, FormulaUse::Goal);
    const auto written = write_instruction(asked, knowledge, Rng(1));
    ASSERT_TRUE(written) << format(written.error());
    EXPECT_NE(written->text.find(said), std::string::npos) << written->text;
  }
}

TEST(OneOfSeveral, IsSaidOfWhatIsClosedOrTurnedOff) {
  const NounTable nouns(committed_knowledge(Simulator::Ai2thor), committed_names());
  EXPECT_EQ(with_one_of("Close a book and put it in the drawer.", nouns),
            "Close one of the books and put it in the drawer.");
  EXPECT_EQ(with_one_of("Turn off a desk lamp.", nouns), "Turn off one of the desk lamps.");
  EXPECT_EQ(with_one_of("Turn a desk lamp off.", nouns), "Turn one of the desk lamps off.");
  for (const char* as_it_is :
       {"Open a book.", "Turn on a desk lamp.", "Turn a desk lamp on.", "Close the book.", "Close something to read."})
    EXPECT_EQ(with_one_of(as_it_is, nouns), as_it_is);
}

TEST(RareNames, AreNotSaid) {
  EXPECT_FALSE(committed_names()->is_said("multiport hub", English::Us));
  EXPECT_FALSE(committed_names()->is_said("rucksack", English::Us));
  EXPECT_TRUE(committed_names()->is_said("rucksack", English::Gb));
  EXPECT_TRUE(committed_names()->is_said("coffee mug", English::Us));
}

}  // namespace
}  // namespace unietp
