#include "scene/scene_lines.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "random_scene.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

/// One after the other by one reader, so that it knows lines of those before.
TEST(SceneLines, ReadWhatTheWholeReaderReadsForAnySeed) {
  SceneLines lines;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Scene scene = random_scene(rng);
    for (int step = 0; step < 4; ++step) {
      const auto read = lines.read("x", scene_to_json(scene));
      ASSERT_TRUE(read) << format(read.error());
      EXPECT_EQ(*read, scene);
      scene = random_successor(std::move(scene), rng);
    }
  }
}

/// Each byte of a scene replaced by each of a few others: the same scene or the same words as from the whole reader.
TEST(SceneLines, FindTheSameFaultsAtTheSamePlaces) {
  Rng rng(3);
  Scene scene = random_scene(rng);
  while (scene.nodes.size() < 3 || scene.edges.empty()) scene = random_scene(rng);
  scene.nodes.resize(3);
  std::erase_if(scene.edges, [&](const Edge& edge) {
    const auto is_there = [&](const std::string& id) {
      return std::any_of(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) { return node.id == id; }) ||
             id == "agent" ||
             std::any_of(scene.rooms.begin(), scene.rooms.end(), [&](const Room& room) { return room.id == id; });
    };
    return !is_there(edge.from) || !is_there(edge.to);
  });
  scene.agent.held.clear();
  const std::string text = scene_to_json(scene);
  ASSERT_TRUE(scene_from_json("x", text));
  SceneLines lines;
  int refused = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char other : {'}', '\n', ',', '1'}) {
      std::string spoilt = text;
      spoilt[i] = other;
      const auto whole = scene_from_json("x", spoilt), by_lines = lines.read("x", spoilt);
      ASSERT_EQ(static_cast<bool>(whole), static_cast<bool>(by_lines)) << spoilt;
      if (whole) {
        ASSERT_EQ(*whole, *by_lines);
      } else {
        ++refused;
        ASSERT_EQ(format(whole.error()), format(by_lines.error()));
      }
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace unietp
