#include "homes/foreign_scenes.h"

#include <algorithm>
#include <ctime>
#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/limits.h"
#include "interchange/format_facts.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;

std::vector<Backend> backends_without_things() {
  std::vector<Backend> backends;
  for (const auto simulator : kSimulators) {
    Knowledge knowledge(simulator, {}, {}, {}, {}, {});
    NounTable nouns(knowledge, {});
    backends.push_back({std::move(knowledge), Profile{}, std::move(nouns)});
  }
  return backends;
}

/// The ids of the homes in a file of iTHOR's scenes with these names.
std::vector<std::string> ids_of(const std::vector<std::string>& scene_names) {
  std::string lines;
  for (const auto& name : scene_names) {
    const nlohmann::json home = {
        {"sceneName", name},
        {"objects",
         nlohmann::json::array(
             {{{"objectId", "Floor|1"}, {"objectType", "Floor"}, {"position", {{"x", 0}, {"y", 0}, {"z", 0}}}}})}};
    lines += home.dump() + "\n";
  }
  const ScratchFolder folder;
  EXPECT_TRUE(write_file(folder.path() / "scenes.jsonl", lines));
  const auto reading =
      read_foreign_scenes("ithor", {folder.path() / "scenes.jsonl"}, backends_without_things(), FormatFacts());
  EXPECT_TRUE(reading.errors.empty()) << format(reading.errors.front());
  std::vector<std::string> ids;
  for (const auto& home : reading.homes) ids.push_back(home.source.id);
  return ids;
}

TEST(ForeignScenes, OfOneNameAreToldApartWithoutRegardToCase) {
  EXPECT_THAT(ids_of({"a", "A", "a-2", "a", "b/../c", ".."}), ElementsAre("a", "A-2", "a-2-2", "a-3", "b_.._c", "_."));
}

TEST(ForeignScenes, AFileWithoutAHomeIsTold) {
  const ScratchFolder folder;
  const auto file = folder.path() / "scenes.jsonl";
  ASSERT_TRUE(write_file(file, "[]"));
  const auto reading = read_foreign_scenes("procthor", {file}, backends_without_things(), FormatFacts());
  ASSERT_EQ(reading.errors.size(), 1U);
  EXPECT_EQ(reading.errors[0].where, file.string());
  EXPECT_EQ(reading.errors[0].message, "contains no home");
  EXPECT_TRUE(reading.homes.empty());
}

/// Processor time of this process, s.
double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TEST(ForeignScenes, OfOneNameAreReadInLinearTime) {
  const auto time_of = [](std::size_t homes) {
    const std::vector<std::string> names(homes, "house");
    const double begin = processor_time();
    const auto ids = ids_of(names);
    const double taken = processor_time() - begin;
    EXPECT_EQ(ids.size(), homes);
    EXPECT_EQ(ids.back(), "house-" + std::to_string(homes));
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), homes);
    return taken;
  };
  (void)time_of(100);
  // Eight times the homes take eight times as long; if each number were looked for from 2, it would be some fifty
  // times.
  const double few = time_of(limits::kHomesInFile / 8), all = time_of(limits::kHomesInFile);
  EXPECT_LT(all, 20 * few);
}

}  // namespace
}  // namespace unietp
