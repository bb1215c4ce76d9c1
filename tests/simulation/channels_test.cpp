// What pixels hold besides color, and pictures from other places than the agent's eye.
#include "simulation/channels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "simulation/channel_png.h"
#include "simulation/relations.h"
#include "simulation/state_solids.h"
#include "simulation/view.h"
#include "simulation/viewpoint.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

Profile small_profile(Simulator simulator) {
  Profile profile = *load_profile(UNIETP_SOURCE_DIR "/data/simulators", simulator);
  profile.image_width = 160;
  profile.image_height = 120;
  return profile;
}

Scene kitchen_seen_from(Simulator simulator, Rng& rng) {
  Scene scene = testing::wide_kitchen(simulator);
  scene.agent.position = {1.0 + 2.7 * rng.unit(), 1.9 + rng.unit()};
  scene.agent.yaw = 6.28 * rng.unit();
  return scene;
}

Vec3 in_w(const Camera& camera, const float* part) {
  return part[0] * camera.right + part[1] * camera.down + part[2] * camera.ahead;
}

std::ptrdiff_t pixels_of(const Channels& channels, std::size_t node) {
  return std::count(channels.node.begin(), channels.node.end(), static_cast<std::int32_t>(node));
}

class AChannel : public ::testing::TestWithParam<Simulator> {};

TEST_P(AChannel, PutsEveryPixelOnTheSurfaceThatItShows) {
  const Profile profile = small_profile(GetParam());
  Rng rng(3);
  Rays rays;
  for (int i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = kitchen_seen_from(GetParam(), rng);
    const Camera camera = camera_of(scene.agent, profile);
    const Channels channels = channels_of(scene, camera);
    EXPECT_EQ(channels.node, segmentation_of(scene, profile, rays).node);
    std::set<std::string> off;
    int far_off = 0, turned_away = 0, bent = 0, flat = 0;
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const auto at = static_cast<std::size_t>(y * camera.width + x);
        const Vec3 point = camera.at + static_cast<double>(channels.depth[at]) * camera.ray(x + 0.5, y + 0.5);
        const Vec3 normal = in_w(camera, &channels.normal[3 * at]);
        EXPECT_NEAR(normal.norm(), 1, 1e-5);
        turned_away += normal.dot(point - camera.at) > 0 ? 1 : 0;
        if (channels.node[at] >= 0) {
          const Node& node = scene.nodes[static_cast<std::size_t>(channels.node[at])];
          const Bounds box = bounds_of(node.pose, node.size);
          constexpr double kHandles_m = 0.06;  // stand out of doors
          const double out = (box.low - point).cwiseMax(point - box.high).maxCoeff();
          const bool inside = out < kHandles_m + reach_of_states(node);
          far_off += inside ? 0 : 1;
          if (!inside) off.insert(node.id);
        } else if (normal.z() > 0.99) {
          far_off += std::abs(point.z()) < 1e-4 ? 0 : 1;  // the floor
        }
        if (x + 1 == camera.width || channels.node[at + 1] != channels.node[at]) continue;
        if ((in_w(camera, &channels.normal[3 * at + 3]) - normal).norm() > 1e-6) continue;
        const Vec3 beside = camera.at + static_cast<double>(channels.depth[at + 1]) * camera.ray(x + 1.5, y + 0.5);
        ++flat;
        bent += std::abs((beside - point).dot(normal)) < 0.002 ? 0 : 1;  // of one face; two may be parallel
      }
    }
    EXPECT_EQ(far_off, 0) << ::testing::PrintToString(off);
    EXPECT_EQ(turned_away, 0);
    EXPECT_GT(flat, 5000);
    EXPECT_LT(bent, flat / 100);
  }
}

TEST_P(AChannel, ShowsTheAgentFromBehindWhereverItStands) {
  const Profile profile = small_profile(GetParam());
  Rng rng(4);
  Rays rays;
  for (int i = 0; i < 24; ++i) {
    SCOPED_TRACE(i);
    Scene scene = kitchen_seen_from(GetParam(), rng);
    if (i % 2 == 1) scene.agent = {{2.2, 0.4}, std::acos(-1) / 2, 0, {}};  // its back to the wall
    const Channels channels = channels_from(scene, profile, Viewpoint::Behind, rays);
    EXPECT_GT(pixels_of(channels, scene.nodes.size()), 160 * 120 / 60);
    const Camera camera = shot_of(scene, profile, Viewpoint::Behind, rays).camera;
    const Vec2 away = camera.at.head<2>() - scene.agent.position;
    EXPECT_LT(away.dot(Vec2(std::cos(scene.agent.yaw), std::sin(scene.agent.yaw))), 0);
    EXPECT_LT(away.norm(), 2.2);
  }
}

TEST_P(AChannel, ShowsTheWholeHomeFromAboveWithNorthUp) {
  const Profile profile = small_profile(GetParam());
  Rng rng(5);
  Rays rays;
  const Scene scene = kitchen_seen_from(GetParam(), rng);
  const Camera camera = shot_of(scene, profile, Viewpoint::Above, rays).camera;
  for (const Room& room : scene.rooms) {
    for (const Vec2& corner : room.polygon) {
      for (const double height : {0.0, scene.wall_height}) {
        const auto pixel = camera.pixel(Vec3(corner.x(), corner.y(), height));
        ASSERT_TRUE(pixel);
        EXPECT_GE(pixel->minCoeff(), 0);
        EXPECT_LE(pixel->x(), camera.width);
        EXPECT_LE(pixel->y(), camera.height);
      }
    }
  }
  EXPECT_LT(camera.pixel(Vec3(1, 2, 0))->y(), camera.pixel(Vec3(1, 1, 0))->y());
  EXPECT_LT(camera.pixel(Vec3(1, 1, 0))->x(), camera.pixel(Vec3(2, 1, 0))->x());
  const Channels channels = channels_from(scene, profile, Viewpoint::Above, rays);
  EXPECT_GT(pixels_of(channels, scene.nodes.size()), 20) << "the agent";
  for (const char* id : {"diningtable_1", "fridge_1", "sofa_1"})
    EXPECT_GT(pixels_of(channels, *NodeIndex(scene.nodes).find(id)), 20) << id;
  for (std::size_t i = 2; i < channels.normal.size(); i += 3)
    ASSERT_LT(channels.normal[i], 0.5) << "no ceiling is seen from its other side";
  const Picture picture = picture_from(scene, profile, Viewpoint::Above, rays);
  EXPECT_EQ(picture.rgb.size(), 3U * 160 * 120);
}

INSTANTIATE_TEST_SUITE_P(All, AChannel, ::testing::ValuesIn(kSimulators),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

TEST(Channels, OfABoxAheadAreItsDistanceAndItsFace) {
  Scene scene;
  Node box;
  box.id = "box_1";
  box.archetype = Archetype::Box;
  box.category = "Box of nothing known";
  box.size = Vec3(1, 4, 3);
  box.pose = upright(Vec3(3, 0, 1.5), 0);
  scene.nodes.push_back(box);
  Profile profile = small_profile(Simulator::Ai2thor);
  const Channels channels = channels_of(scene, camera_of(scene.agent, profile));
  const std::size_t middle = 60 * 160 + 80;
  EXPECT_EQ(channels.node[middle], 0);
  EXPECT_NEAR(channels.depth[middle], 2.5, 1e-6);
  EXPECT_EQ(channels.depth[middle], channels.depth[middle + 20]) << "along the view direction, not along the ray";
  EXPECT_NEAR(channels.normal[3 * middle + 2], -1, 1e-6);
  Camera up = camera_of(scene.agent, profile);
  up.at.z() = 5;
  up.ahead = Vec3::UnitZ();
  up.down = up.ahead.cross(up.right);
  const Channels sky = channels_of(scene, up);
  EXPECT_EQ(sky.depth[middle], std::numeric_limits<float>::infinity());
  EXPECT_EQ(sky.normal[3 * middle + 2], 0);
  EXPECT_EQ(sky.node[middle], -1);
}

TEST(Channels, HaveNamesAndFilesOfTheirOwn) {
  for (const Channel channel : kChannels) EXPECT_EQ(channel_named(name_of(channel)), channel);
  EXPECT_EQ(channel_named("pixels"), std::nullopt);
  Channels one;
  one.width = one.height = 1;
  one.depth = {1.5F};
  one.normal = {0, 0, -1};
  one.node = {6};
  const auto depth = depth_png(one), normals = normals_png(one), instances = instances_png(one);
  ASSERT_TRUE(depth && normals && instances);
  EXPECT_NE(*depth, *instances);
  EXPECT_EQ(*channel_png(one, Channel::Depth), *depth);
  EXPECT_EQ(*channel_png(one, Channel::Normals), *normals);
  EXPECT_EQ(*channel_png(one, Channel::Instances), *instances);
}

TEST(Viewpoints, ShowWhatTheAgentHoldsInItsHandAndItsOwnEyeDoesNot) {
  const Knowledge knowledge = testing::kitchen_knowledge();
  Profile profile = *load_profile(UNIETP_SOURCE_DIR "/data/simulators", Simulator::Ai2thor);
  World world = *World::create(testing::kitchen(), knowledge, profile);
  ASSERT_TRUE(world.step({ActionType::GoTo, {"mug_1"}}).success);
  ASSERT_TRUE(world.step({ActionType::PickUp, {"mug_1"}}).success);
  ASSERT_TRUE(world.step({ActionType::GoTo, {"fridge_1"}}).success);
  Rays rays;
  const Scene& scene = world.scene();
  const auto mug = *NodeIndex(scene.nodes).find("mug_1");
  EXPECT_EQ(pixels_of(channels_from(scene, profile, Viewpoint::Agent, rays), mug), 0);
  EXPECT_GT(pixels_of(channels_from(scene, profile, Viewpoint::Above, rays), mug), 0);
  EXPECT_EQ(picture_from(scene, profile, Viewpoint::Agent, rays).rgb, picture_of(scene, profile, rays).rgb);
  EXPECT_NE(picture_from(scene, profile, Viewpoint::Behind, rays).rgb, picture_of(scene, profile, rays).rgb);
}

}  // namespace
}  // namespace unietp
