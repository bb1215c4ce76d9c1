#include "scene/start.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "random_scene.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

std::vector<Node> by_id(const SharedList<Node>& list) {
  std::vector<Node> nodes(list.begin(), list.end());
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.id < b.id; });
  return nodes;
}

std::size_t place_of(const Scene& scene, const Node& node) { return NodeIndex(scene.nodes).find(node.id).value(); }

/// A home, and a scene that grew out of it in up to four steps.
std::pair<Scene, Scene> grown(std::uint64_t seed) {
  Rng rng(seed);
  const Scene home = random_scene(rng);
  Scene scene = home;
  for (std::uint64_t step = 0; step < 1 + seed % 4; ++step) scene = random_successor(std::move(scene), rng);
  return {home, scene};
}

TEST(StartIn, GivesBackWhatGrewOutOfTheHomeForAnySeed) {
  int gone = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const auto [home, scene] = grown(seed);
    const Delta changes = changes_of(home, scene);
    const Scene start = start_in(home, changes);
    EXPECT_EQ(by_id(start.nodes), by_id(scene.nodes));
    EXPECT_EQ(start.edges, scene.edges);
    EXPECT_EQ(start.agent, scene.agent);
    EXPECT_EQ(changes_of(home, start), changes);
    const auto read = start_in("x", home, changes, "task");
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(read->id, "task");
    EXPECT_EQ(read->nodes, start.nodes);
    gone += changes.removed.empty() ? 0 : 1;
  }
  EXPECT_GT(gone, 50);
}

/// What stays keeps its place unless it was among the last, which fill the gaps.
TEST(StartIn, MovesNoMoreThanTheGapsNeed) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const auto [home, scene] = grown(seed);
    const Delta changes = changes_of(home, scene);
    const Scene start = start_in(home, changes);
    std::size_t moved = 0;
    for (const Node& node : home.nodes) {
      if (find_node(start, node.id) != nullptr && place_of(start, node) != place_of(home, node)) ++moved;
    }
    EXPECT_LE(moved, changes.removed.size());
  }
}

TEST(StartIn, ChangesThatDoNotFitTheHomeAreRefused) {
  const auto refusal = [](const Scene& home, const Delta& changes) {
    const auto start = start_in("tasks.jsonl:3", home, changes, "task");
    return start ? std::string("it was taken") : format(start.error());
  };
  Rng rng(5);
  Scene home;
  home.id = "home";
  home.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 4}}}};
  home.nodes = {random_node("table_1", rng), random_node("mug_1", rng)};
  home.edges = {{Predicate::On, "mug_1", "table_1"}};
  EXPECT_EQ(refusal(home, {}), "it was taken");
  Delta changes;
  changes.removed = {"cup_1"};
  EXPECT_THAT(refusal(home, changes), HasSubstr("tasks.jsonl:3"));
  EXPECT_THAT(refusal(home, changes), HasSubstr("no object \"cup_1\" in the home that could be gone"));
  changes.removed = {"mug_1"};
  EXPECT_THAT(refusal(home, changes), HasSubstr("no object \"mug_1\""));  // the edge speaks of it still
  changes.edges_removed = {home.edges.begin(), home.edges.end()};
  EXPECT_EQ(refusal(home, changes), "it was taken");
  changes = {};
  changes.edges_added = {home.edges.begin(), home.edges.end()};
  EXPECT_THAT(refusal(home, changes), HasSubstr("has the edge on from \"mug_1\" to \"table_1\" already"));
  changes.edges_added = {};
  changes.edges_removed = {{Predicate::Inside, "mug_1", "table_1"}};
  EXPECT_THAT(refusal(home, changes), HasSubstr("has no edge inside from \"mug_1\" to \"table_1\""));
}

}  // namespace
}  // namespace unietp
