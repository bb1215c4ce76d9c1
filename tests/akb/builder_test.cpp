// The steps that all importers share, on our own curated words alone.
#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "akb/import_common.h"
#include "core/files.h"
#include "core/text.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

std::filesystem::path curated() { return test::committed_tables() / "curated"; }

/// Our words and rules, and AI2-THOR's categories, without the facts that need all of them.
class WordsAlone {
 public:
  WordsAlone() {
    std::filesystem::copy(curated(), path());
    std::filesystem::create_directories(path() / "ai2thor");
    std::filesystem::copy(curated() / "ai2thor" / "category.csv", path() / "ai2thor");
  }
  std::filesystem::path path() const { return folder_.path() / "c"; }

 private:
  ScratchFolder folder_;
};

RawCategory raw(const std::string& name, bool movable) {
  RawCategory category;
  category.name = name;
  category.movable = movable;
  category.source = {"curated", 1};
  return category;
}

const char* const kLexiconHeader =
    "display,plural,synset,kind,archetype,width,depth,height,mass,rooms,colours,materials\n";

TEST(Lexicon, IsSeveralFilesReadTogether) {
  const ScratchFolder folder;
  std::filesystem::copy(curated(), folder.path() / "c");
  ASSERT_TRUE(write_file(folder.path() / "c" / "lexicon_more.csv",
                         std::string(kLexiconHeader) + "gizmo,,,gadget,box,0.1,0.1,0.1,0.3,,,\n"));
  std::vector<Error> errors;
  const auto lexicon = read_lexicon(folder.path() / "c", errors);
  EXPECT_TRUE(errors.empty());
  EXPECT_TRUE(lexicon.contains("gizmo"));
  EXPECT_TRUE(lexicon.contains("apple"));
}

TEST(Lexicon, AWordInTwoFilesIsAnErrorThatNamesTheSecond) {
  const ScratchFolder folder;
  std::filesystem::copy(curated(), folder.path() / "c");
  ASSERT_TRUE(write_file(folder.path() / "c" / "lexicon_more.csv",
                         std::string(kLexiconHeader) + "apple,,,fruit,sphere,0.1,0.1,0.1,0.3,,,\n"));
  std::vector<Error> errors;
  read_lexicon(folder.path() / "c", errors);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(replace_all(format(errors.front()), folder.path().string() + "/", ""),
            "c/lexicon_more.csv:2:1: schema error: word 'apple' is duplicated; expected each once");
}

TEST(Lexicon, AFolderWithoutOneIsAnError) {
  const ScratchFolder folder;
  std::vector<Error> errors;
  EXPECT_TRUE(parts_of(folder.path(), "lexicon", errors).empty());
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors.front().kind, Error::Kind::Io);
}

TEST(TableBuilder, KeepsEveryModelAndKnowsWhichGoWhereTheCategoryGoes) {
  const WordsAlone words;
  TableBuilder builder(Simulator::Ai2thor, words.path());
  builder.add(raw("Apple", true));
  builder.add(raw("DiningTable", false));
  const Vec3 apple = builder.find("Apple")->size, table = builder.find("DiningTable")->size;
  const Source source{"metadata:models.json", 1};
  builder.model({"as_large", "Apple", apple * 1.1, source});
  builder.model({"too_large", "Apple", apple * 1.3, source});
  builder.model({"small", "Apple", apple * 0.7, source});
  builder.model({"as_high", "DiningTable", table, source});
  builder.model({"turned", "DiningTable", {table.z(), table.x(), table.y()}, source});
  builder.model({"low", "DiningTable", table * 0.8, source});
  builder.model({"of_nothing", "Unicorn", table, source});
  const auto tables = builder.finish();
  ASSERT_TRUE(tables) << format(tables.error());
  const Knowledge k(Simulator::Ai2thor, tables->categories, tables->affordances, tables->placements, tables->effects,
                    tables->aliases, tables->assets);
  const auto names = [&](const char* category) {
    std::vector<std::string> found;
    for (const auto* asset : k.assets_of(category)) found.push_back(asset->name);
    return found;
  };
  EXPECT_EQ(names("Apple"), (std::vector<std::string>{"as_large", "small"}));
  EXPECT_EQ(names("DiningTable"), std::vector<std::string>{"as_high"});
  EXPECT_TRUE(names("Unicorn").empty());
  ASSERT_NE(k.asset("low"), nullptr);
  EXPECT_NEAR((k.asset("low")->size - table * 0.8).norm(), 0, 1e-3) << "its own box, not the category's";
  EXPECT_EQ(k.asset("of_nothing"), nullptr);
}

TEST(TableBuilder, TakesMaterialsFromMetadataUnlessOurTablesHaveThem) {
  const WordsAlone words;
  TableBuilder builder(Simulator::Ai2thor, words.path());
  for (const char* name : {"Cup", "Box"}) {
    RawCategory category = raw(name, true);
    category.materials = {"glass", "paper"};
    builder.add(category);
  }
  builder.add(raw("Plate", true));
  EXPECT_EQ(builder.find("Cup")->materials, (std::vector<std::string>{"glass", "paper"}));
  EXPECT_EQ(builder.find("Box")->materials, std::vector<std::string>{"cardboard"}) << "curated/ai2thor/category.csv";
  EXPECT_EQ(builder.find("Plate")->materials, std::vector<std::string>{"ceramic"}) << "the lexicon";
}

TEST(TableBuilder, ASynonymOfTwoCategoriesOrOfTheNameOfOneIsLeftOut) {
  const WordsAlone words;
  TableBuilder builder(Simulator::Ai2thor, words.path());
  for (const char* name : {"Apple", "Plate", "Fork"}) builder.add(raw(name, true));
  const Source source{"metadata:names.json", 1};
  const auto own = builder.find("Fork")->display;
  for (const auto& [category, text, kind] :
       {std::tuple("Apple", std::string("roundel"), AliasKind::Synonym),
        std::tuple("Plate", std::string("roundel"), AliasKind::Synonym),
        std::tuple("Apple", std::string("windfall"), AliasKind::Synonym), std::tuple("Plate", own, AliasKind::Synonym),
        std::tuple("Fork", own, AliasKind::Synonym),
        std::tuple("Apple", std::string("something round"), AliasKind::Function),
        std::tuple("Plate", std::string("something round"), AliasKind::Function)})
    builder.alias({category, text, kind, source});
  const auto tables = builder.finish();
  ASSERT_TRUE(tables) << format(tables.error());
  std::vector<std::string> kept;
  for (const auto& alias : tables->aliases) {
    if (alias.source == source) kept.push_back(alias.category + ": " + alias.text);
  }
  std::sort(kept.begin(), kept.end());
  EXPECT_EQ(kept, (std::vector<std::string>{"Apple: something round", "Apple: windfall", "Plate: something round"}));
}

TEST(TableBuilder, PutsThingsBesideWhatSharesASupportAndUnderTables) {
  const WordsAlone words;
  TableBuilder builder(Simulator::Ai2thor, words.path());
  for (const char* name : {"Fork", "Plate", "Boots"}) builder.add(raw(name, true));
  for (const char* name : {"DiningTable", "Fridge", "Sink"}) builder.add(raw(name, false));
  builder.afford_by_archetype();
  builder.place_by_kind(1);
  const auto tables = builder.finish();
  ASSERT_TRUE(tables) << format(tables.error());
  const auto placed = [&](const char* object, Predicate relation, const char* receptacle) {
    return std::any_of(tables->placements.begin(), tables->placements.end(), [&](const Placement& p) {
      return p.object == object && p.relation == relation && p.receptacle == receptacle;
    });
  };
  EXPECT_TRUE(placed("Fork", Predicate::NextTo, "Plate"));
  EXPECT_FALSE(placed("Fork", Predicate::NextTo, "Fridge"));
  EXPECT_FALSE(placed("Boots", Predicate::NextTo, "Plate"));
  EXPECT_TRUE(placed("Boots", Predicate::Under, "DiningTable"));
  EXPECT_FALSE(placed("Boots", Predicate::Under, "Fridge"));
}

}  // namespace
}  // namespace unietp
