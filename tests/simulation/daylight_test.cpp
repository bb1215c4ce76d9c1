// Light that falls through windows.
#include "simulation/daylight.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simulation/picture.h"
#include "simulation/profile.h"

namespace unietp {
namespace {

/// Two rooms of 4 m by 4 m, side by side, with a window in the outer wall of the western one that faces `inward`.
Scene home_with_window(const Vec2& at, const Vec2& inward) {
  Scene scene;
  scene.rooms = {{"bedroom_1", "bedroom", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}},
                 {"kitchen_1", "kitchen", {{-4, 0}, {0, 0}, {0, 4}, {-4, 4}}}};
  Node window;
  window.id = "window_1";
  window.category = "Window";
  window.archetype = Archetype::Panel;
  window.size = Vec3(1.2, 0.08, 1.2);
  window.pose = upright(Vec3(at.x(), at.y(), 1.45), std::atan2(inward.x(), -inward.y()));
  scene.nodes.push_back(window);
  return scene;
}
Scene with_sunny_window() { return home_with_window({3.9, 2}, {-1, 0}); }

std::vector<Daylight> windows_of(const Scene& scene) { return daylight_of(scene, Camera(), 100); }

/// Where a ray of the sun through this point meets the floor.
Vec3 lit_floor(const Vec3& point) { return point - point.z() / toward_sun().z() * toward_sun(); }

TEST(Daylight, SunshineOnTheFloorHasTheShapeOfThePane) {
  const Scene scene = with_sunny_window();
  const auto windows = windows_of(scene);
  ASSERT_EQ(windows.size(), 1U);
  EXPECT_NEAR((windows[0].inward - Vec3(-1, 0, 0)).norm(), 0, 1e-9);
  const Vec3 pane = scene.nodes[0].pose.position;
  for (const double aside : {-0.7, -0.5, -0.3, 0.0, 0.3, 0.5, 0.7}) {
    for (const double up : {-0.7, -0.5, -0.3, 0.0, 0.3, 0.5, 0.7}) {
      const Vec3 floor = lit_floor(pane + Vec3(0, aside, up));
      const bool in_pane = std::abs(aside) > 0 && std::abs(aside) < 0.55 && std::abs(up) > 0 && std::abs(up) < 0.55;
      const auto way = way_to_sunny_pane(windows, floor);
      EXPECT_EQ(way.has_value(), in_pane) << aside << ", " << up;
      EXPECT_NEAR((floor + way.value_or(0) * toward_sun() - pane).x(), way ? 0 : (floor - pane).x(), 1e-9);
    }
  }
}

TEST(Daylight, OfTheSkyFadesWithDistanceAndStaysInItsRoom) {
  for (const Scene& scene : {with_sunny_window(), home_with_window({0.1, 2}, {1, 0})}) {
    const auto windows = windows_of(scene);
    const Vec3 in = windows[0].inward;
    const auto light = [&](double away) {
      return sky_light(windows, windows[0].at + away * in - Vec3(0, 0, 1), Vec3::UnitZ()).sum();
    };
    EXPECT_GT(light(1), 0.2);
    EXPECT_GT(light(1), 1.5 * light(2));
    EXPECT_GT(light(2), light(3.5));
    EXPECT_GT(light(3.5), 0);
    EXPECT_EQ(light(-0.5), 0) << "behind the window";
    EXPECT_EQ(light(4.2), 0) << "another room, or outside";
  }
}

TEST(Daylight, DoesNotShineThroughWindowsThatTheSunIsNotBefore) {
  const Scene scene = home_with_window({0.1, 2}, {1, 0});
  const auto windows = windows_of(scene);
  ASSERT_EQ(windows.size(), 1U);
  for (double x = 0.2; x < 4; x += 0.1) EXPECT_FALSE(way_to_sunny_pane(windows, {x, 2.3, 0}));
}

TEST(Daylight, IsSeenInThePictureAndThingsCastShadowsInIt) {
  Profile profile;
  profile.image_width = profile.image_height = 200;
  profile.camera_height_m = 1.5;
  Scene scene = with_sunny_window();
  const Vec3 patch = lit_floor(scene.nodes[0].pose.position + Vec3(0, 0.3, 0.3));
  scene.agent.position = {0.6, 0.6};
  scene.agent.yaw = std::atan2(patch.y() - 0.6, patch.x() - 0.6);
  scene.agent.pitch = 0.6;
  Scene dark = scene;
  dark.nodes.edit(0).category = "Picture";
  Scene shaded = scene;
  Node board;
  board.id = "board_1";
  board.category = "Board of nothing known";
  board.archetype = Archetype::Box;
  board.size = Vec3(0.3, 0.3, 0.02);
  board.pose = upright(patch + 0.9 * toward_sun(), 0);
  shaded.nodes.push_back(board);
  Rays rays;
  const auto pixel = camera_of(scene.agent, profile).pixel(patch);
  ASSERT_TRUE(pixel);
  const auto bright = [&](const Scene& one) {
    const Picture picture = picture_of(one, profile, rays);
    const auto at = 3 * (static_cast<std::size_t>(pixel->y()) * 200 + static_cast<std::size_t>(pixel->x()));
    return int{picture.rgb[at]} + picture.rgb[at + 1] + picture.rgb[at + 2];
  };
  EXPECT_GT(bright(scene), bright(dark) * 5 / 4);
  EXPECT_LT(bright(shaded), bright(scene) * 9 / 10);
  EXPECT_GT(bright(shaded), bright(dark)) << "the sky still lights it";
}

}  // namespace
}  // namespace unietp
