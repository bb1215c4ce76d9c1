#include <gtest/gtest.h>

#include "core/text.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

/// One change to the sound small tables and the whole message that it must give.
struct BadTable {
  const char* name;
  const char* table;
  const char* from;
  const char* to;
  const char* message;  // after the folder
};
void PrintTo(const BadTable& bad, std::ostream* out) { *out << bad.name; }

class BadTables : public ::testing::TestWithParam<BadTable> {};

TEST_P(BadTables, GiveExactlyTheirMessage) {
  const BadTable& bad = GetParam();
  const ScratchFolder folder;
  auto texts = test::small_tables();
  const auto at = texts[bad.table].find(bad.from);
  ASSERT_NE(at, std::string::npos);
  texts[bad.table].replace(at, std::string_view(bad.from).size(), bad.to);
  test::write_small_tables(folder.path(), texts);
  std::vector<Error> errors;
  read_tables(folder.path() / "habitat", errors);
  ASSERT_EQ(errors.size(), 1U) << (errors.empty() ? "" : format(errors.back()));
  EXPECT_EQ(replace_all(format(errors.front()), (folder.path() / "habitat").string() + "/", ""), bad.message);
}

const BadTable kBad[] = {
    {"NumberThatIsNone", "category", "0.24,0.24,0.02", "0.24,0.24,2 cm",
     "category.csv:7:57: schema error: bad height '2 cm'; expected a number > 0 and <= 100"},
    {"NumberOutOfRange", "category", "0.75,0.72,1.8,75", "0.75,0.72,1.8,-75",
     "category.csv:3:57: schema error: bad mass '-75'; expected a number > 0 and <= 90000"},
    {"NotANumber", "relation", "fridge,0.6", "fridge,nan",
     "relation.csv:2:21: schema error: bad likelihood 'nan'; expected a number > 0 and <= 1"},
    {"UnknownArchetype", "category", "true,true,vessel", "true,true,vesel",
     "category.csv:6:33: schema error: unknown archetype 'vesel'; expected one of block, table, seat, bed, shelf, "
     "cabinet, drawers, basin, panel, fixture, box, cylinder, sphere, plate, vessel, lidded, folding; did you mean "
     "'vessel'?"},
    {"UnknownRoom", "category", "kitchen|office", "kitchen|ofice",
     "category.csv:6:57: schema error: unknown room type 'ofice'; expected one of kitchen, living_room, bedroom, "
     "bathroom, dining_room, corridor, office; did you mean 'office'?"},
    {"BadFlag", "category", "knife.n.01,true,true", "knife.n.01,yes,true",
     "category.csv:5:31: schema error: bad countable 'yes'; expected true or false"},
    {"EmptyDisplay", "category", "mug,mug,mugs", "mug,,mugs",
     "category.csv:6:5: schema error: empty display; expected a text"},
    {"BadList", "category", "red|green", "red|",
     "category.csv:2:75: schema error: bad colours 'red|'; expected words joined by |"},
    {"UnknownAffordance", "affordance", "mug,pickupable", "mug,pickable",
     "affordance.csv:6:5: schema error: unknown affordance 'pickable'; expected one of burnable, breakable, "
     "consumable, "
     "container, cookable, coverable, dirtyable, drain, fillable, foldable, freezable, heatable, heat_source, "
     "cold_source, lieable, openable, pickupable, pluggable, readable, receptacle, sittable, sliceable, soakable, "
     "switchable; "
     "did "
     "you mean 'pickupable'?"},
    {"UnknownCategory", "relation", "apple,on,plate", "apple,on,plat",
     "relation.csv:3:10: schema error: unknown category 'plat'; expected one of apple, fridge, half_apple, knife, mug, "
     "plate; did you mean 'plate'?"},
    {"UnknownRelation", "relation", "apple,on,plate", "apple,onto,plate",
     "relation.csv:3:7: schema error: unknown relation 'onto'; expected one of on, inside, next_to, under"},
    {"CapacityZero", "relation", "0.4,3", "0.4,0",
     "relation.csv:3:20: schema error: bad capacity '0'; expected a whole number >= 1"},
    {"UnknownEffect", "effect", "fridge,cools", "fridge,cool",
     "effect.csv:2:8: schema error: unknown effect 'cool'; expected one of heats, cools, freezes, cooks, burns, "
     "washes, soaks, fills, slices, wipes, dispenses, drains, attaches; did you mean 'cools'?"},
    {"UnknownNeed", "effect", "closed|inside", "shut|inside",
     "effect.csv:2:23: schema error: unknown need 'shut'; expected one of closed, power_on, held, inside, on, "
     "under_tap"},
    {"SliceWithoutPieces", "effect", "half_apple,2", "half_apple,0",
     "effect.csv:3:31: schema error: bad amount '0'; expected a whole number >= 1"},
    {"UnknownAliasKind", "alias", "mug,function", "mug,functions",
     "alias.csv:2:5: schema error: unknown kind of alias 'functions'; expected one of synonym, function, context, "
     "hypernym, description, occasion, request; did "
     "you mean 'function'?"},
    {"MissingSource", "relation", "derived:kind", "",
     "relation.csv:2:28: schema error: missing source; expected metadata:<file>, derived:<rule>, llm:<model>, "
     "override:<file> or curated"},
    {"MalformedSource", "affordance", "metadata:types.json", "metadata: types.json",
     "affordance.csv:3:17: schema error: bad source 'metadata: types.json'; expected metadata:<file>, derived:<rule>, "
     "llm:<model>, override:<file> or curated"},
    {"ConfidenceZero", "affordance", "types.json,0.9", "types.json,0",
     "affordance.csv:3:37: schema error: bad confidence '0'; expected a number > 0 and <= 1"},
    {"DuplicateKey", "affordance", "apple,sliceable,metadata:types.json,0.9", "apple,pickupable,curated,1",
     "affordance.csv:3:1: schema error: row for 'apple pickupable' is duplicated; expected one row per key"},
    {"BadCsv", "alias", "\"cup, with a handle\"", "cup \"with\" a handle",
     "alias.csv:3:17: parse error: quote inside an unquoted field; expected the whole field in quotes and the quote "
     "doubled"},
};

INSTANTIATE_TEST_SUITE_P(Each, BadTables, ::testing::ValuesIn(kBad),
                         [](const auto& bad) { return std::string(bad.param.name); });

TEST(BadTables, AColumnOfAnotherNameIsBothUnknownAndMissing) {
  const ScratchFolder folder;
  auto texts = test::small_tables();
  texts["affordance"] = replace_all(texts["affordance"], "source,confidence", "source,confidenc");
  test::write_small_tables(folder.path(), texts);
  std::vector<Error> errors;
  read_tables(folder.path() / "habitat", errors);
  ASSERT_EQ(errors.size(), 2U);
  const auto where = (folder.path() / "habitat" / "affordance.csv").string();
  EXPECT_EQ(format(errors[0]), where +
                                   ":1:28: schema error: unknown column 'confidenc'; expected category, affordance, "
                                   "source, confidence; did you mean 'confidence'?");
  EXPECT_EQ(
      format(errors[1]),
      where + ":1:1: schema error: missing column 'confidence'; expected category, affordance, source, confidence");
}

TEST(BadTables, EveryFaultOfEverySimulatorIsReportedAtOnce) {
  const ScratchFolder folder;
  auto texts = test::small_tables();
  texts["effect"] = replace_all(texts["effect"], "fridge,cools", "fridg,cool");
  texts["alias"] = replace_all(texts["alias"], ",1\n", ",2\n");
  test::write_small_tables(folder.path(), texts);
  EXPECT_EQ(compile_knowledge(folder.path(), folder.path() / "k.sqlite").size(), 4U * 4U);
}

TEST(BadTables, AMissingFileIsNamed) {
  const ScratchFolder folder;
  test::write_small_tables(folder.path(), test::small_tables());
  std::filesystem::remove(folder.path() / "behavior" / "effect.csv");
  const auto errors = compile_knowledge(folder.path(), folder.path() / "k.sqlite");
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors.front().kind, Error::Kind::Io);
  EXPECT_NE(format(errors.front()).find("behavior/effect.csv"), std::string::npos);
}

}  // namespace
}  // namespace unietp
