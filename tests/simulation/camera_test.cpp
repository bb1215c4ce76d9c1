// What the agent's camera shows: boxes of objects, the segmentation behind them, and the picture.
#include <algorithm>
#include <cmath>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "core/png.h"
#include "core/rng.h"
#include "simulation/channels.h"
#include "simulation/first_solids.h"
#include "simulation/picture.h"
#include "simulation/relations.h"
#include "simulation/solids.h"
#include "simulation/view.h"
#include "simulation/walls.h"
#include "simulation/world.h"
#include "tests/simulation/by_rays.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

Profile profile_of(Simulator simulator) { return *load_profile(UNIETP_SOURCE_DIR "/data/simulators", simulator); }

/// The kitchen as seen from a drawn place and in a drawn direction.
Scene drawn_view(Simulator simulator, Rng& rng) {
  Scene scene = testing::wide_kitchen(simulator);
  scene.agent.position = {1.0 + 2.7 * rng.unit(), 1.9 + rng.unit()};
  scene.agent.yaw = 6.28 * rng.unit();
  scene.agent.pitch = 0.7 * rng.unit() - 0.1;
  if (rng.chance(0.5)) {
    Node& fridge = *edit_node(scene, "fridge_1");
    fridge.opening = 1;
    fridge.states.set({Predicate::Open, ""});
  }
  return scene;
}

class ACamera : public ::testing::TestWithParam<Simulator> {};

/// Things that cross, stand in each other and are as thin as a wire, with glass among them.
TEST_P(ACamera, ShowsInEveryPixelOfPictureAndChannelsWhatTheRayThroughItMeets) {
  const Profile profile = profile_of(GetParam());
  Rng rng(25);
  Rays rays;
  std::size_t solids = 0;
  for (int i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    Scene scene = drawn_view(GetParam(), rng);
    const std::vector<Node> before(scene.nodes.begin(), scene.nodes.end());
    for (int k = 0; k < 40; ++k) {
      Node more = rng.pick(before);
      more.id += "_" + std::to_string(k);
      more.pose = {{rng.uniform(0, 5), rng.uniform(0, 4), rng.uniform(0, 2)},
                   Quat(Eigen::AngleAxisd(rng.uniform(-3, 3), Vec3(1, rng.unit(), rng.unit()).normalized()))};
      if (rng.chance(0.3)) more.size[static_cast<Eigen::Index>(rng.below(3))] = 0.004;
      if (rng.chance(0.2)) more.material = "glass";
      if (rng.chance(0.3)) more.states.set({Predicate::PowerOn, ""});
      if (rng.chance(0.3)) more.states.set({Predicate::Unplugged, ""});
      scene.nodes.push_back(std::move(more));
    }
    const Camera camera = camera_of(scene.agent, profile);
    rays.build(solids_of(scene, camera, kEndless_m, hidden_from_sight(scene)));
    const std::vector<PixelHit> hits = first_solids(rays.solids(), camera);
    std::set<std::int32_t> met;
    for (std::size_t pixel = 0; pixel < hits.size(); ++pixel) {
      const int x = static_cast<int>(pixel) % camera.width, y = static_cast<int>(pixel) / camera.width;
      const auto hit = rays.first(camera.at, camera.ray(x + 0.5, y + 0.5), kEndless_m);
      ASSERT_EQ(hits[pixel].solid, hit ? static_cast<std::int32_t>(hit->solid) : -1) << x << ", " << y;
      if (!hit) continue;
      ASSERT_NEAR(hits[pixel].depth, hit->along, 1e-9) << x << ", " << y;
      ASSERT_LT((hits[pixel].normal - hit->normal).norm(), 1e-9) << x << ", " << y;
      met.insert(hits[pixel].solid);
    }
    solids += met.size();
  }
  EXPECT_GT(solids, 300U);
}

/// Of a wide board behind another one, a strip is seen.
TEST_P(ACamera, ListsAnObjectOfWhichEnoughIsSeen) {
  Profile profile = profile_of(GetParam());
  profile.image_width = profile.image_height = 400;
  profile.vertical_fov_deg = 40;
  Scene scene = testing::wide_kitchen(GetParam());
  scene.nodes = {};
  scene.agent.position = {1.5, 2};
  scene.agent.yaw = scene.agent.pitch = 0;
  const auto add = [&](const char* id, const Vec3& at, const Vec3& size) {
    Node board;
    board.id = id;
    board.category = "Board";
    board.size = size;
    board.boards = {{Vec3::Zero(), size}};
    board.pose.position = at;
    scene.nodes.push_back(std::move(board));
  };
  add("far_1", {2.7, 2, profile.camera_height_m}, {0.02, 0.5, 0.5});
  add("near_1", {2.1, 2, profile.camera_height_m}, {0.02, 0.5, 0.5});
  Rays rays;
  bool hidden = false, listed = false;
  for (double aside = 0.12; aside < 0.14; aside += 0.001) {
    scene.nodes.edit(1).pose.position.y() = 2 + aside;
    const Segmentation image = segmentation_of(scene, profile, rays);
    const std::size_t seen = testing::pixels_by_rays(image, 2)[0].pixels;
    const std::size_t whole = testing::silhouette_by_rays(scene, 0, camera_of(scene.agent, profile), rays);
    const auto boxes = Viewer(scene).view(viewed(scene), scene.agent, profile, kEndless_m);
    const bool is_listed = std::any_of(boxes.begin(), boxes.end(), [](const auto& one) { return one.id == "far_1"; });
    EXPECT_EQ(is_listed, seen >= 4 && 100 * seen >= whole) << seen << " of " << whole;
    hidden = hidden || (!is_listed && seen > 0);
    listed = listed || is_listed;
  }
  EXPECT_TRUE(hidden && listed);
}

TEST_P(ACamera, ListsExactlyWhatARayThroughEveryPixelFinds) {
  const Profile profile = profile_of(GetParam());
  Rng rng(5);
  Viewer viewer(testing::wide_kitchen(GetParam()));
  Rays rays;
  std::size_t listed = 0;
  for (int i = 0; i < 16; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = drawn_view(GetParam(), rng);
    const auto boxes = testing::boxes_by_rays(scene, profile, segmentation_of(scene, profile, rays), rays);
    const auto all = viewer.view(viewed(scene), scene.agent, profile, kEndless_m);
    const auto near = viewer.view(viewed(scene), scene.agent, profile, profile.sight_m);
    const Vec3 eye(scene.agent.position.x(), scene.agent.position.y(), profile.camera_height_m);
    const auto box_in = [](const std::vector<VisibleObject>& list, const std::string& id) {
      const auto found = std::find_if(list.begin(), list.end(), [&](const VisibleObject& v) { return v.id == id; });
      return found == list.end() ? std::nullopt : std::optional(found->box);
    };
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
      const Node& node = scene.nodes[n];
      SCOPED_TRACE(node.id);
      const auto& box = boxes[n];
      EXPECT_EQ(box_in(all, node.id), box);
      const bool close = (node.pose.position - eye).norm() <= profile.sight_m;
      EXPECT_EQ(box_in(near, node.id), close ? box : std::nullopt);
      EXPECT_EQ(viewer.box_of(viewed(scene), n, scene.agent, profile), box);
      const auto whole = viewer.unhidden_box_of(scene, n, scene.agent, profile);
      EXPECT_TRUE(!box || (whole && around(*whole, *box) == *whole));
      const bool first = std::none_of(
          all.begin(), all.end(), [&](const VisibleObject& other) { return other.id < node.id && other.box == box; });
      EXPECT_EQ(viewer.first_with_box(viewed(scene), n, scene.agent, profile), first ? box : std::nullopt);
    }
    listed += near.size();
  }
  EXPECT_GT(listed, 60U);
}

TEST_P(ACamera, ListsWhatIsSeenThroughGlassAsRaysFindIt) {
  const Profile profile = profile_of(GetParam());
  Rng rng(15);
  Rays rays;
  std::size_t only_through = 0;
  for (int i = 0; i < 24; ++i) {
    SCOPED_TRACE(i);
    Scene scene = drawn_view(GetParam(), rng);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
      if (rng.chance(0.5)) scene.nodes.edit(n).material = "glass";
    }
    Node pane;  // right before the eye
    pane.id = "pane_1";
    pane.archetype = Archetype::Panel;
    pane.size = Vec3(1, 0.02, 3);
    pane.material = "glass";
    const Vec2 ahead(std::cos(scene.agent.yaw), std::sin(scene.agent.yaw));
    pane.pose =
        upright(Vec3(scene.agent.position.x() + 0.2 * ahead.x(), scene.agent.position.y() + 0.2 * ahead.y(), 1.5),
                scene.agent.yaw + std::acos(-1) / 2);
    scene.nodes.push_back(pane);
    const Segmentation image = segmentation_of(scene, profile, rays);
    const auto boxes = testing::boxes_by_rays(scene, profile, image, rays);
    const auto listed = Viewer(scene).view(viewed(scene), scene.agent, profile, kEndless_m);
    std::vector<VisibleObject> expected;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
      if (!boxes[n]) continue;
      expected.push_back({scene.nodes[n].id, *boxes[n]});
      const auto node = static_cast<std::int32_t>(n);
      only_through += std::find(image.node.begin(), image.node.end(), node) == image.node.end() ? 1 : 0;
    }
    std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    EXPECT_EQ(listed, expected);
  }
  EXPECT_GT(only_through, 0U);
}

/// Where there are many things, only those near enough are looked at.
TEST_P(ACamera, AmongManyThingsOfAllSizesSeesWhatALookAtAllOfThemSees) {
  const Profile profile = profile_of(GetParam());
  Rng rng(9);
  std::size_t seen = 0;
  for (int home = 0; home < 3; ++home) {
    Scene scene = testing::wide_kitchen(GetParam());
    const std::vector<Node> before(scene.nodes.begin(), scene.nodes.end());
    while (scene.nodes.size() < 700) {
      Node more = rng.pick(before);
      more.id += "_" + std::to_string(scene.nodes.size());
      more.pose.position = {rng.uniform(-4, 9), rng.uniform(-4, 9), rng.uniform(0, 2.5)};
      if (more.openable && rng.chance(0.5)) more.opening = 1;
      scene.nodes.push_back(std::move(more));
    }
    const PhysicsWorld physics = physics_of(scene);
    const auto near = [&](const Bounds& bounds) {
      std::vector<std::size_t> nodes;
      for (const BodyId body : physics.near(bounds, 0)) {
        if (body.is_node()) nodes.push_back(body.index());
      }
      return nodes;
    };
    Viewer some(scene), all(scene);
    for (int look = 0; look < 30; ++look) {
      SCOPED_TRACE(look);
      scene.agent = drawn_view(GetParam(), rng).agent;
      const auto boxes = all.view({scene}, scene.agent, profile, profile.sight_m);
      EXPECT_EQ(some.view({scene, {}, near}, scene.agent, profile, profile.sight_m), boxes);
      const std::size_t one = rng.below(scene.nodes.size());
      EXPECT_EQ(some.box_of({scene, {}, near}, one, scene.agent, profile),
                all.box_of({scene}, one, scene.agent, profile));
      seen += boxes.size();
    }
  }
  EXPECT_GT(seen, 300U);
}

/// Things strewn among closets of a meter, some of which stand open to each other.
TEST_P(ACamera, AmongManyWallsListsExactlyWhatARayThroughEveryPixelFinds) {
  const Profile profile = profile_of(GetParam());
  Rng rng(11);
  Scene scene = testing::wide_kitchen(GetParam());
  for (int i = 0; i < 64; ++i) {
    const double x = -4 + 1.7 * (i % 8), y = -4 + 1.7 * (i / 8);
    scene.rooms.push_back({"closet_" + std::to_string(i), "closet", {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}});
    if (i % 3 == 0) {
      scene.openings.push_back({"hatch_" + std::to_string(i), scene.rooms.back().id, "", {x, y}, {x + 1, y}, 2});
    }
  }
  scene.rooms.front().polygon = {{-8, -8}, {13, -8}, {13, 13}, {-8, 13}};
  const std::vector<Node> before(scene.nodes.begin(), scene.nodes.end());
  while (scene.nodes.size() < 120) {
    Node more = rng.pick(before);
    more.id += "_" + std::to_string(scene.nodes.size());
    more.pose.position = {rng.uniform(-4, 9), rng.uniform(-4, 9), rng.uniform(0, 2)};
    scene.nodes.push_back(std::move(more));
  }
  ASSERT_GT(walls_of(scene).size(), 200U);
  Viewer viewer(scene);
  Rays rays;
  std::size_t listed = 0, hidden = 0;
  for (int look = 0; look < 40; ++look) {
    SCOPED_TRACE(look);
    scene.agent.position = {rng.uniform(-4, 9), rng.uniform(-4, 9)};
    scene.agent.yaw = 6.28 * rng.unit();
    const auto by_rays = testing::boxes_by_rays(scene, profile, segmentation_of(scene, profile, rays), rays);
    const auto boxes = viewer.view(viewed(scene), scene.agent, profile, kEndless_m);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
      const auto reported = std::find_if(boxes.begin(), boxes.end(),
                                         [&](const VisibleObject& one) { return one.id == scene.nodes[n].id; });
      ASSERT_EQ(reported != boxes.end(), by_rays[n].has_value()) << scene.nodes[n].id;
      if (reported == boxes.end()) {
        ++hidden;
        continue;
      }
      EXPECT_EQ(reported->box, *by_rays[n]);
      ++listed;
    }
  }
  EXPECT_GT(listed, 60U);
  EXPECT_GT(hidden, 100U);
}

/// Things come, go, move and open before an eye that stays where it is for some looks.
TEST_P(ACamera, LookingAgainSeesWhatAFirstLookSees) {
  const Profile profile = profile_of(GetParam());
  Rng rng(7);
  Scene scene = drawn_view(GetParam(), rng);
  Viewer viewer(scene);
  std::vector<VisibleObject> before;
  int other = 0;
  for (int look = 0; look < 200; ++look) {
    SCOPED_TRACE(look);
    if (look % 20 == 0) scene.agent = drawn_view(GetParam(), rng).agent;
    std::set<std::size_t> hidden;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      if (rng.chance(0.05)) hidden.insert(i);
    }
    Node& node = scene.nodes.edit(rng.below(scene.nodes.size()));
    if (node.openable) {
      node.opening = 1 - node.opening;
    } else if (node.movable) {
      node.pose.position += Vec3(rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), 0);
    }
    const ViewedScene seen{scene, [&](std::size_t i) { return hidden.contains(i); }};
    const double sight_m = rng.chance(0.8) ? profile.sight_m : kEndless_m;
    const auto now = viewer.view(seen, scene.agent, profile, sight_m);
    EXPECT_EQ(now, Viewer(scene).view(seen, scene.agent, profile, sight_m));
    other += now == before ? 0 : 1;
    before = now;
  }
  EXPECT_GT(other, 60);
}

/// In a large world only what is near is looked at.
TEST_P(ACamera, ShowsInAWorldOfManyThingsWhatALookAtAllOfThemShows) {
  const Knowledge knowledge = testing::kitchen_knowledge(GetParam());
  Profile profile = profile_of(GetParam());
  const std::string mug = find_node(testing::full_kitchen(GetParam()), "mug_1")->category;
  Rng rng(8);
  Scene strewn = testing::full_kitchen(GetParam());
  for (int i = 0; i < 600; ++i)
    testing::add(strewn, "many_" + std::to_string(i), knowledge, mug, rng.uniform(-9, 14), rng.uniform(-9, 14),
                 rng.uniform(0, 2));
  strewn.edges = read_relations(strewn);  // some are in the fridge
  std::size_t listed = 0;
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    strewn.agent.yaw = rng.uniform(-3, 3);
    profile.sight_m = rng.uniform(1, 6);
    const auto world = World::create(strewn, knowledge, profile);
    ASSERT_TRUE(world) << format(world.error());
    const auto all = Viewer(strewn).view(viewed(strewn), strewn.agent, profile, profile.sight_m);
    EXPECT_EQ(world->visible(), all);
    EXPECT_EQ(world->pictured(), Viewer(strewn).view(viewed(strewn), strewn.agent, profile, kEndless_m));
    for (const VisibleObject& one : all) EXPECT_EQ(world->pictured_from(strewn.agent, one.id), one.box);
    listed += all.size();
  }
  EXPECT_GT(listed, 40U);
}

TEST_P(ACamera, GivesTheSameBytesInEveryThread) {
  const Profile profile = profile_of(GetParam());
  Rng rng(6);
  const Scene scene = drawn_view(GetParam(), rng);
  Rays rays;
  const auto visible = Viewer(scene).view(viewed(scene), scene.agent, profile, profile.sight_m);
  const auto picture = picture_of(scene, profile, rays).rgb;
  std::vector<std::vector<VisibleObject>> views(3);
  std::vector<std::vector<std::uint8_t>> pictures(3);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < views.size(); ++i) {
    threads.emplace_back([&, i] {
      Rays own;
      views[i] = Viewer(scene).view(viewed(scene), scene.agent, profile, profile.sight_m);
      pictures[i] = picture_of(scene, profile, own).rgb;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(views[i], visible);
    EXPECT_EQ(pictures[i], picture);
  }
}

TEST_P(ACamera, ShowsWhatLiesAheadInTheMiddleOfAPictureOfTheProfilesSize) {
  const Profile profile = profile_of(GetParam());
  const Knowledge knowledge = testing::kitchen_knowledge(GetParam());
  World world = *World::create(testing::wide_kitchen(GetParam()), knowledge, profile);
  ASSERT_TRUE(world.step({ActionType::GoTo, {"sofa_1"}}).success);
  ASSERT_TRUE(world.step({ActionType::TurnTo, {"sofa_1"}}).success);
  Rays rays;
  const Segmentation image = segmentation_of(world.scene(), profile, rays);
  EXPECT_EQ(image.width, profile.image_width);
  EXPECT_EQ(image.height, profile.image_height);
  const auto middle = static_cast<std::size_t>(image.height / 2) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(image.width / 2);
  EXPECT_EQ(world.scene().nodes[static_cast<std::size_t>(image.node[middle])].id, "sofa_1");
  const Picture picture = picture_of(world.scene(), profile, rays);
  EXPECT_EQ(picture.rgb.size(), 3U * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
}

INSTANTIATE_TEST_SUITE_P(All, ACamera, ::testing::ValuesIn(kSimulators),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

TEST(Camera, DoesNotShowWhatADoorHidesOrTheHandHolds) {
  const Knowledge knowledge = testing::kitchen_knowledge();
  const Profile profile = profile_of(Simulator::Ai2thor);
  Scene scene = testing::kitchen();
  testing::add(scene, "mug_2", knowledge, "Mug", 4.4, 3.6, 0.022);
  scene.edges = read_relations(scene);
  World world = *World::create(scene, knowledge, profile);
  const auto shows = [&](const char* id) {
    Rays rays;
    const auto image = segmentation_of(world.scene(), profile, rays);
    const auto node = static_cast<std::int32_t>(NodeIndex(world.scene().nodes).find(id).value());
    return std::find(image.node.begin(), image.node.end(), node) != image.node.end();
  };
  ASSERT_TRUE(world.step({ActionType::GoTo, {"fridge_1"}}).success);
  EXPECT_FALSE(shows("mug_2"));
  ASSERT_TRUE(world.step({ActionType::Open, {"fridge_1"}}).success);
  ASSERT_TRUE(world.step({ActionType::GoTo, {"mug_2"}}).success);
  EXPECT_TRUE(shows("mug_2"));
  ASSERT_TRUE(world.step({ActionType::PickUp, {"mug_2"}}).success);
  EXPECT_FALSE(shows("mug_2"));
}

TEST(Rays, MeetSolidsWhereTheFormulasSay) {
  Rays rays;
  EXPECT_FALSE(rays.first({0, 0, 0}, {1, 0, 0}, 10)) << "nothing was built";
  const Pose turned{Vec3(5, 0, 0), Quat(Eigen::AngleAxisd(std::acos(-1) / 4, Vec3::UnitZ()))};
  rays.build({{SolidKind::Box, turned, Vec3(1, 1, 1), 0},
              {SolidKind::Sphere, {Vec3(0, 4, 0), Quat::Identity()}, Vec3(2, 2, 2), 1},
              {SolidKind::Cylinder, {Vec3(0, 0, -3), Quat::Identity()}, Vec3(1, 1, 2), 2}});
  const auto box = rays.first({0, 0, 0}, {1, 0, 0}, 10), ball = rays.first({0, 0, 0}, {0, 2, 0}, 10);
  const auto cap = rays.first({0.2, 0, 0}, {0, 0, -1}, 10), side = rays.first({-3, 0, -3}, {1, 0, 0}, 10);
  ASSERT_TRUE(box && ball && cap && side);
  EXPECT_NEAR(box->along, 5 - std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(ball->along, 1.5, 1e-12) << "in lengths of the direction";
  EXPECT_NEAR(ball->normal.y(), -1, 1e-12);
  EXPECT_NEAR(cap->along, 2, 1e-12);
  EXPECT_EQ(cap->normal, Vec3::UnitZ());
  EXPECT_NEAR(side->along, 2.5, 1e-12);
  EXPECT_EQ(side->solid, 2U);
  EXPECT_FALSE(rays.first({0, 0, 0}, {1, 0, 0}, 4)) << "farther than asked";
  EXPECT_FALSE(rays.first({5, 0, 0}, {1, 0, 0}, 10)) << "from the inside it is looked through";
}

TEST(Png, BeginsAsAPngFileAndRepeats) {
  const std::vector<std::uint8_t> rgb(3 * 7 * 5, 90);
  const auto bytes = png(7, 5, rgb);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->substr(1, 3), "PNG");
  EXPECT_EQ(*bytes, *png(7, 5, rgb));
}

}  // namespace
}  // namespace unietp
