#include "validator/rest.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "simulation/relations.h"
#include "tests/expert/house.h"

namespace unietp {
namespace {

constexpr double kMoved_m = 0.01;

std::vector<std::string> moved(RestCheck& rest, const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& one : rest.of(scene, physics_of(scene))) names.push_back(scene.nodes[one.node].id);
  return names;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The house, with the dining table and nothing that stands on it somewhere else.
Scene with_table_at(const Vec3& offset) {
  Scene scene = testing::house();
  edit_node(scene, "diningtable_1")->pose.position += offset;
  return scene;
}

/// How far the mug on the table falls, in m.
double fallen(RestCheck& rest, const Scene& scene) {
  for (const auto& one : rest.of(scene, physics_of(scene))) {
    if (scene.nodes[one.node].id == "mug_1") return one.distance_m;
  }
  return 0;
}

TEST(RestCheck, AHouseAtRestStaysAndWhatHangsInTheAirFalls) {
  RestCheck rest(kMoved_m);
  Scene scene = testing::house();
  EXPECT_EQ(moved(rest, scene), std::vector<std::string>{});
  edit_node(scene, "mug_1")->pose.position.z() += 0.3;
  EXPECT_EQ(moved(rest, scene), std::vector<std::string>{"mug_1"});
}

TEST(RestCheck, WhatItFoundOfAHomeSaysNothingOfOneWhoseSupportsStandElsewhere) {
  // One check for all, as for a data set; each answer must be that of a check which has seen nothing else.
  RestCheck shared(kMoved_m);
  EXPECT_EQ(moved(shared, testing::house()), std::vector<std::string>{});
  for (const Vec3& offset : {Vec3(0, 0, -0.3), Vec3(1.5, 0, 0), Vec3(0, 0, -0.1), Vec3(0, 0, 0)}) {
    SCOPED_TRACE(offset.transpose());
    const Scene scene = with_table_at(offset);
    RestCheck fresh(kMoved_m);
    EXPECT_EQ(moved(shared, scene), moved(fresh, scene));
    EXPECT_EQ(has(moved(shared, scene), "mug_1"), offset.norm() > 0);
  }
}

TEST(RestCheck, HowFarAThingFallsIsThatToWhatLiesBelowItNow) {
  RestCheck shared(kMoved_m);
  for (const double lower_m : {0.1, 0.3})
    EXPECT_NEAR(fallen(shared, with_table_at(Vec3(0, 0, -lower_m))), lower_m, 0.02);
}

TEST(RestCheck, WhatLiesFarBelowIsLookedAtAsWell) {
  RestCheck shared(kMoved_m);
  for (const double lower_m : {0.0, 0.2}) {
    Scene scene = with_table_at(Vec3(0, 0, -lower_m));
    edit_node(scene, "mug_1")->pose.position.z() += 0.6;
    EXPECT_NEAR(fallen(shared, scene), 0.6 + lower_m, 0.02);
  }
}

}  // namespace
}  // namespace unietp
