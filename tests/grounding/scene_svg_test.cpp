#include "grounding/scene_svg.h"

#include <gtest/gtest.h>

#include "homes.h"

namespace unietp {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(SceneSvg, DrawsEveryRoomThingAndStopOnce) {
  const auto style = style_of(Simulator::Habitat);
  ASSERT_TRUE(style);
  const auto home = home_of(*style, 3);
  ASSERT_TRUE(home);
  const std::string plain = scene_svg(*home);
  const std::string walked = scene_svg(*home, {{{1, 1}, {2, 1}}, {{2, 1}, {2, 2}, {1, 1}}});
  std::size_t movable = 0;
  for (const Node& node : home->nodes) movable += node.movable ? 1 : 0;
  EXPECT_EQ(count_of(plain, "<circle"), movable);
  EXPECT_EQ(count_of(walked, ">1,3<"), 1u) << "the walk ends where it began";
  EXPECT_EQ(count_of(walked, ">2<"), 1u);
  EXPECT_EQ(count_of(plain, "<polyline"), 0u);
  EXPECT_EQ(count_of(walked, "<polyline"), 2u);
  for (const Room& room : home->rooms) {
    std::string name = room.id;
    std::replace(name.begin(), name.end(), '_', ' ');
    EXPECT_EQ(count_of(plain, ">" + name + "<"), 1u) << name;
  }
  EXPECT_EQ(count_of(plain, "\"nan"), 0u);
  EXPECT_EQ(plain, scene_svg(*home)) << "equal scenes, equal bytes";
}

TEST(SceneSvg, EscapesWhatXmlWouldMisread) {
  Scene scene;
  scene.id = "a<b&c";
  const std::string svg = scene_svg(scene);
  EXPECT_NE(svg.find("a&lt;b&amp;c"), std::string::npos);
}

}  // namespace
}  // namespace unietp
