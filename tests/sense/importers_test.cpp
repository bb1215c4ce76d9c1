#include "akb/importers.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "akb/wordnet_words.h"
#include "core/files.h"
#include "core/text.h"
#include "sense/usual_places.h"
#include "tests/akb/small_tables.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

std::filesystem::path upstream() { return UNIETP_UPSTREAM_DIR; }

/// What the tables of sense call senseless.
AbsurdPlace absurd(Simulator simulator) {
  static const CommonSense sense = [] {
    std::vector<Error> errors;
    auto read = read_common_sense(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/sense", errors);
    for (const auto& error : errors) ADD_FAILURE() << format(error);
    return read;
  }();
  return [simulator](const Category& object, Predicate relation, const Category& receptacle) {
    return is_absurd(sense, simulator, object, relation, receptacle);
  };
}

/// BEHAVIOR's words are WordNet's too.
bool has_wordnet() { return std::filesystem::exists(std::filesystem::path(WordNetWords::kFolder) / "data.noun"); }

class Importers : public ::testing::TestWithParam<Simulator> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(upstream() / "ai2thor")) {
      GTEST_SKIP() << needs::kSimulatorFiles;
    }
    if (GetParam() == Simulator::Behavior && !has_wordnet()) {
      GTEST_SKIP() << needs::kWordNet;
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Each, Importers, ::testing::ValuesIn(kSimulators),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

TEST_P(Importers, GiveTheCommittedTablesByteForByte) {
  const auto tables =
      import_simulator(GetParam(), upstream(), test::committed_tables() / "curated", absurd(GetParam()));
  ASSERT_TRUE(tables) << format(tables.error());
  for (const auto& table : table_names()) {
    const auto committed = read_file(test::committed_tables() / std::string(name_of(GetParam())) / (table + ".csv"));
    ASSERT_TRUE(committed);
    EXPECT_EQ(table_csv(*tables, table), *committed) << table;
  }
}

TEST_P(Importers, NameTheFileThatIsMissing) {
  const ScratchFolder folder;
  const auto tables = import_simulator(GetParam(), folder.path(), test::committed_tables() / "curated");
  ASSERT_FALSE(tables);
  EXPECT_EQ(tables.error().kind, Error::Kind::Io);
}

TEST_P(Importers, ReportMetadataOfAnotherForm) {
  const ScratchFolder folder;
  std::filesystem::copy(upstream(), folder.path() / "u", std::filesystem::copy_options::recursive);
  const char* files[] = {"ai2thor/object_types.json", "virtualhome/PrefabClass.json", "habitat/ovmm_categories.json",
                         "behavior/object_inventory.json.gz"};
  const auto path = folder.path() / "u" / files[static_cast<std::size_t>(GetParam())];
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  const std::string other = "{\"Apple\": 3}";
  ASSERT_TRUE(write_file(path, path.extension() == ".gz" ? gzip(other) : other));
  const auto tables = import_simulator(GetParam(), folder.path() / "u", test::committed_tables() / "curated");
  ASSERT_FALSE(tables);
  EXPECT_EQ(tables.error().kind, Error::Kind::Schema);
}

/// A copy of our curated tables with one file changed.
void curate(const std::filesystem::path& folder, const std::string& file, const std::string& text) {
  std::filesystem::copy(test::committed_tables() / "curated", folder, std::filesystem::copy_options::recursive);
  ASSERT_TRUE(write_file(folder / file, text));
}

TEST(Curated, ARowOverridesWhatWasImported) {
  if (!std::filesystem::exists(upstream() / "habitat")) GTEST_SKIP() << needs::kSimulatorFiles;
  const ScratchFolder folder;
  curate(folder.path() / "c", "habitat/relation.csv",
         "object,relation,receptacle,likelihood,capacity,source,confidence\n"
         "hammer,inside,fridge,900,1,curated,0.5\n");
  const auto tables = import_habitat(upstream(), folder.path() / "c");
  ASSERT_TRUE(tables) << format(tables.error());
  const auto at = std::find_if(tables->placements.begin(), tables->placements.end(),
                               [](const Placement& p) { return p.object == "hammer" && p.receptacle == "fridge"; });
  ASSERT_NE(at, tables->placements.end());
  EXPECT_GT(at->likelihood, 0.8);
  EXPECT_EQ(at->source, (Source{"curated", 0.5}));
}

TEST(Curated, ARemovedFactIsGoneAndAnUnknownOneIsAnError) {
  if (!std::filesystem::exists(upstream() / "habitat")) GTEST_SKIP() << needs::kSimulatorFiles;
  const ScratchFolder folder;
  curate(folder.path() / "c", "habitat/removed.csv", "table,subject,verb,object\nrelation,apple,inside,fridge\n");
  const auto tables = import_habitat(upstream(), folder.path() / "c");
  ASSERT_TRUE(tables) << format(tables.error());
  EXPECT_TRUE(std::none_of(tables->placements.begin(), tables->placements.end(),
                           [](const Placement& p) { return p.object == "apple" && p.receptacle == "fridge"; }));
  ASSERT_TRUE(write_file(folder.path() / "c" / "habitat" / "removed.csv",
                         "table,subject,verb,object\nrelation,apple,inside,moon\n"));
  const auto bad = import_habitat(upstream(), folder.path() / "c");
  ASSERT_FALSE(bad);
  EXPECT_EQ(replace_all(format(bad.error()), (folder.path() / "c").string() + "/", ""),
            "habitat/removed.csv:2:10: schema error: nothing to remove; expected a fact of the affordance, relation "
            "or alias table");
}

TEST(Curated, AClassToLeaveOutMustBeOneOfTheLexicon) {
  if (!std::filesystem::exists(upstream() / "habitat")) GTEST_SKIP() << needs::kSimulatorFiles;
  const ScratchFolder folder;
  curate(folder.path() / "c", "habitat/left_out.csv", "name,why\nwall,structure\nunicorn,abstract\n");
  const auto bad = import_habitat(upstream(), folder.path() / "c");
  ASSERT_FALSE(bad);
  EXPECT_EQ(replace_all(format(bad.error()), (folder.path() / "c").string() + "/", ""),
            "habitat/left_out.csv:3:1: schema error: no class 'unicorn' to leave out; expected one of "
            "hssd_semantic_lexicon.json");
}

TEST(ImportAll, WritesNothingWhenOneImportFails) {
  const ScratchFolder folder;
  EXPECT_FALSE(import_all(folder.path() / "none", folder.path() / "tables", absurd));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "tables"));
}

}  // namespace
}  // namespace unietp
