#include "grounding/scene_svg.h"

#include <gtest/gtest.h>

#include "grounding/label_layout.h"
#include "grounding/node_drawing.h"
#include "grounding/svg_canvas.h"
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
  EXPECT_EQ(count_of(plain, "<g><title>"), home->nodes.size() + 1) << "every thing and the agent";
  EXPECT_EQ(count_of(walked, ">1,3<"), 1u) << "the walk ends where it began";
  EXPECT_EQ(count_of(walked, ">2<"), 1u);
  EXPECT_EQ(count_of(plain, "class=\"leg\""), 0u);
  EXPECT_EQ(count_of(walked, "class=\"leg\""), 2u);
  for (const Room& room : home->rooms) {
    std::string name = room.id;
    std::replace(name.begin(), name.end(), '_', ' ');
    EXPECT_EQ(count_of(plain, ">" + name + "<"), 1u) << name;
  }
  EXPECT_EQ(count_of(plain, "\"nan"), 0u);
  EXPECT_EQ(plain, scene_svg(*home)) << "equal scenes, equal bytes";
}

TEST(NodeDrawing, WhatHangsHighIsDashedAndWhatIsRoundIsACircle) {
  Node node;
  node.id = "thing_1";
  const auto drawn = [&](double bottom, double top) {
    SvgCanvas canvas({-1, -1}, {1, 1}, "");
    node.size = {0.4, 0.4, top - bottom};
    node.pose.position = {0, 0, (bottom + top) / 2};
    draw_furniture(canvas, node);
    return count_of(std::move(canvas).finish(), "stroke-dasharray");
  };
  EXPECT_EQ(drawn(0, 2), 0U) << "a wardrobe reaches high, but stands on the floor";
  EXPECT_EQ(drawn(0.9, 2), 0U);
  EXPECT_EQ(drawn(1.4, 2), 1U);
  for (const auto& [archetype, circles] : {std::pair{Archetype::Cylinder, 1U},
                                           {Archetype::Sphere, 1U},
                                           {Archetype::Plate, 1U},
                                           {Archetype::Vessel, 1U},
                                           {Archetype::Box, 0U}}) {
    SvgCanvas canvas({-1, -1}, {1, 1}, "");
    node.archetype = archetype;
    draw_object(canvas, node, Simulator::Ai2thor, false);
    EXPECT_EQ(count_of(std::move(canvas).finish(), "<circle"), circles) << static_cast<int>(archetype);
  }
}

/// Corners of the first polygon.
std::size_t corners_of(const std::string& svg) {
  const auto begin = svg.find("points=\"");
  if (begin == std::string::npos) return 0;
  const std::string points = svg.substr(begin + 8, svg.find('"', begin + 8) - begin - 8);
  return static_cast<std::size_t>(std::count(points.begin(), points.end(), ','));
}

TEST(NodeDrawing, ThingsHaveTheOutlineOfTheShapeThatTheCameraShows) {
  Node node;
  node.id = "thing_1";
  node.movable = true;
  const auto drawn = [&](const char* category, const Vec3& size) {
    SvgCanvas canvas({-1, -1}, {1, 1}, "");
    node.category = category;
    node.archetype = Archetype::Box;
    node.size = size;
    draw_object(canvas, node, Simulator::Behavior, false);
    return std::move(canvas).finish();
  };
  EXPECT_EQ(corners_of(drawn("set_triangle", {0.117, 0.117, 0.005})), 3U);
  EXPECT_EQ(corners_of(drawn("ruler", {0.33, 0.026, 0.005})), 4U);
  EXPECT_EQ(count_of(drawn("plate", {0.2, 0.2, 0.02}), "<circle"), 1U);
  EXPECT_GE(corners_of(drawn("frying_pan", {0.4, 0.25, 0.06})), 8U) << "round, with a handle";
  EXPECT_EQ(corners_of(drawn("nothing_known", {0.2, 0.2, 0.2})), 4U);
}

double attribute(const std::string& element, const std::string& name) {
  const auto at = element.find(" " + name + "=\"");
  return std::strtod(element.c_str() + at + name.size() + 3, nullptr);
}

TEST(SceneSvg, NoTwoLabelsOverlap) {
  for (const auto simulator : kSimulators) {
    const auto style = style_of(simulator);
    ASSERT_TRUE(style);
    const auto home = home_of(*style, 7);
    ASSERT_TRUE(home);
    const std::string svg = scene_svg(*home);
    std::vector<LabelBox> boxes;
    for (auto at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) {
      const std::string element = svg.substr(at, svg.find("</text>", at) - at);
      const std::string words = element.substr(element.find('>') + 1);
      boxes.push_back({{attribute(element, "x"), attribute(element, "y")},
                       text_extent_px(words, attribute(element, "font-size") - 0.01)});
    }
    EXPECT_GT(boxes.size(), home->rooms.size() + 10);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << i << " and " << j;
    }
  }
}

TEST(PlaceLabels, TakesTheLeastCrowdedPlaceAndLeavesOutWhatHasNone) {
  const Label first{"sofa", {10}, {{0, 0}, {100, 0}}, 0};
  const Label second{"lamp", {10}, {{2, 0}, {200, 0}}, 0};
  const Label third{"desk", {10}, {{3, 0}}, 0};
  const auto placed = place_labels({first, second, third}, {{{100, 0}, {5, 5}}});
  ASSERT_TRUE(placed[0] && placed[1]);
  EXPECT_EQ(placed[0]->center_px, Vec2(0, 0));
  EXPECT_EQ(placed[1]->center_px, Vec2(200, 0));
  EXPECT_FALSE(placed[2]);
}

TEST(SceneSvg, EscapesWhatXmlWouldMisread) {
  Scene scene;
  scene.id = "a<b&c";
  const std::string svg = scene_svg(scene);
  EXPECT_NE(svg.find("a&lt;b&amp;c"), std::string::npos);
}

}  // namespace
}  // namespace unietp
