#include "run/known_homes.h"

#include <gtest/gtest.h>

#include "core/digest.h"
#include "forged_set.h"
#include "run/make_home.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

/// The table follows from the recipes and facts. To write it anew: `unietp scene make --benchmark --out HOMES`, then
/// the SHA-256 of each unpacked file, in order of name.
TEST(KnownHomes, AreTheHomesOfTheBenchmark) {
  const auto known = read_known_homes(std::filesystem::path(UNIETP_SOURCE_DIR) / "data" / "runs");
  ASSERT_TRUE(known) << format(known.error());
  const Resources& resources = library();
  EXPECT_EQ(known->size(), resources.benchmark.size());
  RunConfiguration configuration;
  configuration.homes = HomeSource::Benchmark;
  for (const auto& layout : resources.benchmark) {
    const auto home = make_home(configuration, resources, layout.id);
    ASSERT_TRUE(home) << format(home.error());
    EXPECT_EQ(known->at(layout.id), sha256(scene_to_json(*home))) << layout.id;
  }
}

TEST(MakeHome, RefusesNamesThatTheRunDoesNotHave) {
  RunConfiguration configuration;
  for (const char* name : {"", "ai2thor", "ai2thor-home-0000", "ai2thor-home-x", "ai2thor-home-1",
                           "elsewhere-home-0001", "ai2thor-benchmark-01", "ai2thor-home-99999999999999999999"})
    EXPECT_FALSE(make_home(configuration, library(), name)) << name;
}

}  // namespace
}  // namespace unietp
