#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "generator/specification.h"
#include "small_home.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

/// The committed tables, compiled once into a temporary folder.
class RealKnowledge : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto folder = fs::temp_directory_path() / ("unietp_generator_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const auto errors = compile_knowledge(fs::path(UNIETP_SOURCE_DIR) / "data/akb", folder / "knowledge.sqlite");
    for (const auto& error : errors) ADD_FAILURE() << format(error);
    if (errors.empty()) {
      for (const auto simulator : kSimulators) {
        auto loaded = load_knowledge(folder / "knowledge.sqlite", simulator);
        ASSERT_TRUE(loaded) << format(loaded.error());
        bases().push_back(std::move(*loaded));
      }
    }
    fs::remove_all(folder);
  }
  static void TearDownTestSuite() { bases().clear(); }
  static std::vector<Knowledge>& bases() {
    static std::vector<Knowledge> kept;
    return kept;
  }
};

TEST_F(RealKnowledge, FillsEveryTemplateSomewhere) {
  for (const auto& source : library()) {
    const bool fills = std::any_of(bases().begin(), bases().end(), [&](const Knowledge& knowledge) {
      return !enumerate_bindings(source, knowledge, 1).empty();
    });
    EXPECT_TRUE(fills) << source.name << " has no binding in any of the knowledge bases";
  }
}

TEST_F(RealKnowledge, GivesSpecificationsThatCanBeMet) {
  for (const auto& knowledge : bases()) {
    for (const auto& source : library()) {
      SCOPED_TRACE(source.name + " on " + std::string(name_of(knowledge.simulator())));
      std::set<Binding> drawn;
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const auto binding = sample_binding(source, knowledge, {}, Rng(seed));
        if (!binding) break;
        EXPECT_TRUE(fits_by_scan(source, *binding, knowledge));
        drawn.insert(*binding);
        const auto made = instantiate(source, knowledge, *binding);
        EXPECT_TRUE(made) << format(made.error());
      }
      RecordProperty(source.name + "." + std::string(name_of(knowledge.simulator())), static_cast<int>(drawn.size()));
    }
  }
}

TEST_F(RealKnowledge, OffersReferringConstraintsForMostTemplates) {
  for (const auto& knowledge : bases()) {
    int refined = 0;
    for (const auto& source : library()) {
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const auto binding = sample_binding(source, knowledge, {}, Rng(seed));
        if (!binding) break;
        const auto plain = instantiate(source, knowledge, *binding);
        if (plain && refine_referring(*plain, knowledge, Rng(seed))) {
          ++refined;
          break;
        }
      }
    }
    EXPECT_GE(refined, 12) << name_of(knowledge.simulator());
  }
}

}  // namespace
}  // namespace unietp
