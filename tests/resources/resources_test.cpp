#include "resources/resources.h"

#include <set>

#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

DataFolders own_folders() {
  return {UNIETP_SOURCE_DIR, std::filesystem::path(::testing::TempDir()) / "unietp-resources-cache"};
}

TEST(Resources, TheCommittedDataLoadsWithoutAnError) {
  const auto reading = load_resources(own_folders());
  for (const auto& error : reading.errors) ADD_FAILURE() << format(error);
  EXPECT_EQ(reading.resources.backends.size(), 4U);
  EXPECT_EQ(reading.resources.recipes.size(), 4U);
  EXPECT_FALSE(reading.resources.templates.empty());
  EXPECT_EQ(reading.resources.digest.size(), 64U);
}

/// What decides a text is knowledge, too: a run is not continued, and a data set not proven, with other names.
TEST(Resources, TheDigestSeesNamesPhrasesAndTemplates) {
  const ScratchFolder folder;
  for (const char* part : {"data", "templates"}) {
    std::filesystem::copy(std::filesystem::path(UNIETP_SOURCE_DIR) / part, folder.path() / part,
                          std::filesystem::copy_options::recursive);
  }
  const DataFolders copied{folder.path(), folder.path() / "cache"};
  const auto before = knowledge_digest(copied);
  ASSERT_TRUE(before) << format(before.error());
  EXPECT_EQ(*before, *knowledge_digest(own_folders()));
  std::set<std::string> digests{*before};
  for (const char* file : {"data/english/everyday_names.csv", "data/english/rare_names.csv", "data/sense/phrases.csv",
                           "templates/library/atomic/cook-one.template"}) {
    const auto text = read_file(folder.path() / file);
    ASSERT_TRUE(text);
    ASSERT_TRUE(write_file(folder.path() / file, *text + "\n"));
    EXPECT_TRUE(digests.insert(*knowledge_digest(copied)).second) << file;
  }
}

TEST(LoadBackends, GivesAgentsOfTheProfileWideWithTheExtendedLibraryOnly) {
  auto folders = own_folders();
  for (const bool extended : {false, true}) {
    folders.extended_library = extended;
    const auto reading = load_backends(folders);
    ASSERT_TRUE(reading.errors.empty());
    const auto offers = [&](Simulator simulator, ActionType action) {
      return reading.backends[static_cast<std::size_t>(simulator)].profile.offers(action);
    };
    EXPECT_EQ(offers(Simulator::Virtualhome, ActionType::SitOn), extended);
    EXPECT_EQ(offers(Simulator::Behavior, ActionType::Fold), extended);
    EXPECT_EQ(offers(Simulator::Ai2thor, ActionType::Break), extended);
    EXPECT_TRUE(offers(Simulator::Behavior, ActionType::PickUp));
  }
}

TEST(UnknownCategories, ANameThatIsNoPlaceholderMustBeKnownToASimulator) {
  const auto reading = load_backends(own_folders());
  ASSERT_TRUE(reading.errors.empty());
  Template source;
  source.name = "own";
  source.simulators = {Simulator::Ai2thor};
  source.parameters = {{"A", {"pickupable"}, {}}};
  source.goal = at_end(exists("a", of_category("A"), exists("m", of_category("Mug"), atom(Predicate::On, {"a", "m"}))));
  EXPECT_TRUE(unknown_categories(source, reading.backends).empty());
  source.goal = at_end(exists("a", of_category("Mugg"), atom(Predicate::Open, {"a"})));
  const auto errors = unknown_categories(source, reading.backends);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].message.find("did you mean \"Mug\""), std::string::npos);
  const ScratchFolder folder;
  source.file = (folder.path() / "own.template").string();
  ASSERT_TRUE(write_file(source.file, "(Muggs aMugg Mugg-2)\n(Mugg)\n"));
  EXPECT_EQ(unknown_categories(source, reading.backends)[0].pos, (SourcePos{2, 2})) << "as a word of its own";
  ASSERT_TRUE(write_file(source.file, "Mugg"));
  EXPECT_EQ(unknown_categories(source, reading.backends)[0].pos, (SourcePos{1, 1}));
  source.goal = at_end(exists("a", of_category("A"), atom(Predicate::Open, {"a"})));
  source.constraints = {{ConstraintType::Kind, {"A", "food"}, {}}};
  EXPECT_TRUE(unknown_categories(source, reading.backends).empty());
  source.constraints = {{ConstraintType::Kind, {"A", "foood"}, {}}};
  ASSERT_EQ(unknown_categories(source, reading.backends).size(), 1U);
  EXPECT_NE(unknown_categories(source, reading.backends)[0].message.find("did you mean 'food'"), std::string::npos);
}

}  // namespace
}  // namespace unietp
