#include "grounding/layout_library.h"

#include <set>

#include <gtest/gtest.h>

#include "core/digest.h"
#include "homes.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

std::vector<BenchmarkLayout> committed() {
  const auto layouts = benchmark_layouts(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/layouts");
  EXPECT_TRUE(layouts) << format(layouts.error());
  return layouts ? *layouts : std::vector<BenchmarkLayout>{};
}

/// Of all of a scene but its name.
std::string digest_of(Scene scene) {
  scene.id = "home";
  return sha256(scene_to_json(scene));
}

TEST(BenchmarkLayouts, Are170OfSevenRoomsAndTwoHundredAndTenObjectsOnAverage) {
  const auto layouts = committed();
  ASSERT_EQ(layouts.size(), 170u);
  std::map<Simulator, int> counts;
  double rooms = 0, objects = 0;
  for (const BenchmarkLayout& layout : layouts) {
    ++counts[layout.simulator];
    rooms += layout.rooms;
    objects += layout.objects;
  }
  EXPECT_EQ(counts[Simulator::Ai2thor], 50);
  EXPECT_EQ(counts[Simulator::Virtualhome], 50);
  EXPECT_EQ(counts[Simulator::Habitat], 20);
  EXPECT_EQ(counts[Simulator::Behavior], 50);
  EXPECT_NEAR(rooms / 170, 7, 0.5);
  EXPECT_NEAR(objects / 170, 210, 15);
}

class EveryLibrary : public ::testing::TestWithParam<Simulator> {};

TEST_P(EveryLibrary, GeneratesEveryBenchmarkLayoutAsItsRowSaysAndTrainingLayoutsThatAreNoneOfThem) {
  const auto style = style_of(GetParam());
  ASSERT_TRUE(style);
  std::set<std::string> digests;
  double rooms = 0, objects = 0;
  for (const BenchmarkLayout& layout : committed()) {
    if (layout.simulator != GetParam()) continue;
    const auto home = benchmark_layout(layout, style->recipe, style->knowledge, style->profile);
    ASSERT_TRUE(home) << layout.id << ": " << format(home.error());
    EXPECT_EQ(home->id, layout.id);
    EXPECT_EQ(static_cast<int>(home->rooms.size()), layout.rooms);
    rooms += static_cast<double>(home->rooms.size());
    objects += static_cast<double>(home->nodes.size());
    EXPECT_TRUE(digests.insert(digest_of(*home)).second) << layout.id;
  }
  const auto count = static_cast<double>(digests.size());
  EXPECT_NEAR(rooms / count, 7, 0.5);
  EXPECT_NEAR(objects / count, 210, 15);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {  // seeds that benchmark layouts have too
    for (std::uint64_t n = 0; n < 3; ++n) {
      const auto home = training_layout(style->recipe, style->knowledge, style->profile, n, seed);
      ASSERT_TRUE(home) << n << ": " << format(home.error());
      EXPECT_TRUE(digests.insert(digest_of(*home)).second) << home->id;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Simulators, EveryLibrary, ::testing::ValuesIn(kSimulators),
                         [](const auto& one) { return std::string(name_of(one.param)); });

TEST(ReadBenchmark, ReportsEveryErrorWithLineAndColumn) {
  const auto table = read_benchmark("b.csv",
                                    "id,simulator,seed,rooms,objects\n"
                                    "a,ai2thor,1,7,210\n"
                                    "a,ai2thor,2,7,210\n"
                                    "b,ai2thor,1,7,210\n"
                                    "c,thor,1,7,210\n"
                                    "d,habitat,-1,7,210\n"
                                    "e,habitat,1,99,210\n"
                                    "f,habitat,2,7,many\n");
  EXPECT_EQ(table.layouts.size(), 1u);
  std::vector<std::string> messages;
  for (const Error& error : table.errors) messages.push_back(format(error));
  const std::vector<std::string> expected{
      "b.csv:3:1: schema error: 'a' is duplicated; expected a new id",
      "b.csv:4:11: schema error: is duplicated for ai2thor; expected a different seed for each layout",
      "b.csv:5:3: schema error: unknown simulator 'thor'; expected one of ai2thor, virtualhome, habitat, behavior",
      "b.csv:6:11: schema error: expected a whole number from 0 to 18446744073709551615, got '-1'",
      "b.csv:7:13: schema error: expected a whole number from 4 to 12, got '99'",
      "b.csv:8:15: schema error: expected a whole number from 50 to 600, got 'many'"};
  EXPECT_EQ(messages, expected);
}

}  // namespace
}  // namespace unietp
