// Every state that a goal can name changes the picture of an object of every archetype, and of every category that can
// have it.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/picture.h"
#include "simulation/portrait.h"
#include "simulation/solids.h"
#include "simulation/state_solids.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/thorough.h"

namespace unietp {
namespace {

/// Mean difference between two pictures over the pixels that show the object in one of them, of 255.
constexpr double kLeastContrast = 9;
/// Of plugs and of small parts of devices: at least this many of 200 x 200 pixels differ by at least that much.
constexpr int kLeastPixels = 100;
constexpr double kClearly = 24;

Profile profile_for(int pixels) {
  Profile profile = *load_profile(UNIETP_SOURCE_DIR "/data/simulators", Simulator::Ai2thor);
  profile.image_width = profile.image_height = pixels;
  return profile;
}

/// A room of 6 x 6 m with an agent that looks down at (3, 3).
Scene empty_room() {
  Scene scene;
  scene.rooms.push_back({"living_room_1", "living_room", {{0, 0}, {6, 0}, {6, 6}, {0, 6}}});
  return scene;
}

Node thing(Archetype archetype, const Vec3& size) {
  Node node;
  node.id = "thing_1";
  node.category = "thing";
  node.archetype = archetype;
  node.movable = size.maxCoeff() < 0.5;
  node.size = size;
  node.color = "white";
  const double low = size.maxCoeff() < 0.5 ? 1.0 : 0.0;
  node.pose = upright(Vec3(3, 3, low + size.z() / 2), 0);
  return node;
}

/// At arm's length from the front, a little to the right.
Scene before(const Scene& room, const Node* node, const Profile& profile, const Vec3& middle, double reach) {
  Scene scene = room;
  if (node != nullptr) scene.nodes.push_back(*node);
  const double away = 0.35 + 1.5 * reach;
  scene.agent.position = {middle.x() + 0.35 * away, middle.y() - away};
  const Vec3 way = middle - Vec3(scene.agent.position.x(), scene.agent.position.y(), profile.camera_height_m);
  scene.agent.yaw = std::atan2(way.y(), way.x());
  scene.agent.pitch = std::atan2(-way.z(), way.head<2>().norm());
  return scene;
}

Picture look(const Node* node, const Node& framed, const Profile& profile) {
  Rays rays;
  const double reach = framed.size.maxCoeff() / 2;
  return picture_of(before(empty_room(), node, profile, framed.pose.position, reach), profile, rays);
}

struct Contrast {
  double mean = 0;       // over the pixels that show the object, of 255
  int clear_pixels = 0;  // differ by at least kClearly
};

Contrast contrast(const Node& a, const Node& b, const Profile& profile) {
  const Picture none = look(nullptr, a, profile), one = look(&a, a, profile), other = look(&b, a, profile);
  Contrast contrast;
  int pixels = 0;
  for (std::size_t i = 0; i < none.rgb.size(); i += 3) {
    double apart = 0;
    bool shown = false;
    for (std::size_t c = i; c < i + 3; ++c) {
      shown = shown || one.rgb[c] != none.rgb[c] || other.rgb[c] != none.rgb[c];
      apart += std::abs(one.rgb[c] - other.rgb[c]) / 3.0;
    }
    contrast.mean += apart;
    contrast.clear_pixels += apart >= kClearly ? 1 : 0;
    pixels += shown ? 1 : 0;
  }
  contrast.mean /= std::max(1, pixels);
  return contrast;
}

struct Pair {
  State with, without;
};

/// Each state of a group beside the group's default, and what has a symbol.
std::vector<Pair> pairs() {
  std::vector<Pair> pairs;
  for (const StateGroup& group : state_groups()) {
    for (std::size_t i = 1; i < group.predicates.size(); ++i) {
      if (group.predicates[i] != Predicate::Filled)
        pairs.push_back({{group.predicates[i], ""}, {group.predicates.front(), ""}});
    }
  }
  for (const char* liquid : {"water", "coffee", "wine"})
    pairs.push_back({{Predicate::Filled, liquid}, {Predicate::Empty, ""}});
  for (const char* cover : {"dust", "flour", "jam"})
    pairs.push_back({{Predicate::Covered, cover}, {Predicate::Dry, ""}});
  return pairs;
}

/// No plate of any simulator is soaked, and what is filled has a hollow (VisibleFilling asks every such category).
bool may_be(Archetype archetype, Predicate state) {
  if (state == Predicate::Filled) return archetype == Archetype::Vessel || archetype == Archetype::Basin;
  return archetype != Archetype::Plate || state != Predicate::Soaked;
}

class VisibleState : public ::testing::TestWithParam<Archetype> {};

TEST_P(VisibleState, ChangesThePictureAtArmsLength) {
  const Profile profile = profile_for(200);
  const bool large = GetParam() <= Archetype::Fixture;
  for (const char* color : {"white", "black", "brown"}) {
    for (const Pair& pair : pairs()) {
      if (!may_be(GetParam(), pair.with.predicate)) continue;
      Node with = thing(GetParam(), large ? Vec3(0.8, 0.6, 0.8) : Vec3(0.2, 0.2, 0.16));
      with.color = color;
      with.openable = pair.with.predicate == Predicate::Open;
      Node without = with;
      with.states.set(pair.with);
      without.states.set(pair.without);
      if (with.openable) with.opening = 1;
      SCOPED_TRACE(std::string(color) + " " + std::string(info(pair.with.predicate).name) + " " + pair.with.symbol);
      const Contrast found = contrast(with, without, profile);
      EXPECT_GE(found.clear_pixels, kLeastPixels);
      if (pair.with.predicate != Predicate::PluggedIn) {
        EXPECT_GE(found.mean, kLeastContrast);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, VisibleState, ::testing::ValuesIn(all_archetypes().begin(), all_archetypes().end()),
                         [](const auto& archetype) { return std::string(name_of(archetype.param)); });

/// How many pixels of two pictures of one size differ clearly.
int clear_pixels(const Picture& one, const Picture& other) {
  int pixels = 0;
  for (std::size_t i = 0; i < one.rgb.size(); i += 3) {
    double apart = 0;
    for (std::size_t c = i; c < i + 3; ++c) apart += std::abs(one.rgb[c] - other.rgb[c]) / 3.0;
    pixels += apart >= kClearly ? 1 : 0;
  }
  return pixels;
}

TEST(VisibleFilling, OfEveryCategoryThatCanBeFilledIsSeenFromAbove) {
  std::size_t asked = 0;
  for (const Simulator simulator : kSimulators) {
    const Knowledge& knowledge = committed_knowledge(simulator);
    Profile profile;
    profile.simulator = simulator;
    for (const Category& category : knowledge.categories()) {
      if (!knowledge.has(category.name, "fillable")) continue;
      SCOPED_TRACE(std::string(name_of(simulator)) + " " + category.name);
      const Node empty = object_of(knowledge, category, 0);
      Node full = empty;
      full.states.set({Predicate::Filled, "water"});
      const PortraitOptions view{.on_table = empty.movable};
      EXPECT_GE(clear_pixels(portrait_of(empty, profile, view), portrait_of(full, profile, view)), kLeastPixels);
      ++asked;
    }
  }
  EXPECT_GE(asked, 60U);
}

/// What a goal can ask of an object of a category besides its first states: of each group of states that it has the
/// others, and that dust covers it. With UNIETP_THOROUGH all are asked, otherwise some of each simulator.
std::vector<State> states_of(const Knowledge& knowledge, const Category& category) {
  std::vector<State> states;
  for (const StateGroup& group : state_groups()) {
    if (!knowledge.has(category.name, group.affordance)) continue;
    for (std::size_t i = 1; i < group.predicates.size(); ++i)
      states.push_back({group.predicates[i], group.predicates[i] == Predicate::Filled ? "water" : ""});
  }
  if (category.movable) states.push_back({Predicate::Covered, "dust"});
  return states;
}

/// Whether a portrait of an object of the category shows that it has the state; of a large thing, all of which is seen
/// from farther away than people stand, one with more pixels.
bool is_seen(const Knowledge& knowledge, const Category& category, const State& state, std::uint32_t seed,
             const Profile& profile) {
  const Node before = object_of(knowledge, category, seed);
  Node after = before;
  after.states.set(state);
  if (state.predicate == Predicate::Open) after.opening = 1;
  PortraitOptions view{.on_table = before.movable};
  const auto differs = [&] {
    return clear_pixels(portrait_of(before, profile, view), portrait_of(after, profile, view)) >= kLeastPixels;
  };
  if (differs()) return true;
  constexpr double kArmsLength_m = 0.5, kMost = 4;
  view.pixels = static_cast<int>(view.pixels * std::clamp(before.size.maxCoeff() / kArmsLength_m, 1.0, kMost));
  return differs();
}

/// Asked in every run: some of their states are seen from near alone, or hardly on one object of several (mud on a
/// chopstick).
const std::set<std::string> kThinOrLarge{"chopstick", "half_rope", "rope", "multi_station_furniture_sink",
                                         "multi_station_wall_mounted_sink"};

class VisibleCategoryState : public ::testing::TestWithParam<Simulator> {};

TEST_P(VisibleCategoryState, ChangesThePictureOfEveryCategoryThatCanHaveIt) {
  const Knowledge& knowledge = committed_knowledge(GetParam());
  Profile profile;
  profile.simulator = GetParam();
  std::vector<std::pair<const Category*, State>> all;
  for (const Category& category : knowledge.categories()) {
    for (const State& state : states_of(knowledge, category)) all.emplace_back(&category, state);
  }
  EXPECT_GE(all.size(), 100U);
  constexpr std::size_t kSample = 40;
  const std::size_t every = test::tries(1, 0) == 0 ? 1 : std::max<std::size_t>(1, all.size() / kSample);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [category, state] = all[i];
    if (i % every != 0 && kThinOrLarge.count(category->name) == 0) continue;
    SCOPED_TRACE(category->name + " " + std::string(info(state.predicate).name) + " " + state.symbol);
    if (is_seen(knowledge, *category, state, 0, profile)) continue;
    for (const std::uint32_t seed : {1U, 2U, 3U})
      EXPECT_TRUE(is_seen(knowledge, *category, state, seed, profile)) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(All, VisibleCategoryState, ::testing::ValuesIn(kSimulators.begin(), kSimulators.end()),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

/// From the side, at the height of the thing, only glass shows what is in it.
TEST(VisibleFilling, IsSeenFromTheSideThroughGlassAlone) {
  for (const char* category : {"Mug", "Bowl", "Pot", "Cup"}) {
    for (const char* material : {"ceramic", "glass"}) {
      SCOPED_TRACE(std::string(category) + " " + material);
      const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
      Node empty = object_of(knowledge, *knowledge.find(category), 0);
      empty.material = material;
      Node full = empty;
      full.states.set({Predicate::Filled, "coffee"});
      const PortraitOptions level{.down_rad = 0, .on_table = false};
      Profile profile;
      profile.simulator = Simulator::Ai2thor;
      const int differing = clear_pixels(portrait_of(empty, profile, level), portrait_of(full, profile, level));
      if (std::string(material) == "glass") {
        EXPECT_GE(differing, 10 * kLeastPixels);
      } else {
        EXPECT_EQ(differing, 0);
      }
    }
  }
}

TEST(VisibleState, OfADeviceIsWhatSuchDevicesShow) {
  const Profile profile = profile_for(200);
  for (const char* category : {"FloorLamp", "Television", "StoveBurner", "Faucet", "Candle", "Toaster", "ShowerHead"}) {
    Node on = thing(Archetype::Box, {0.3, 0.2, 0.25});
    on.category = category;
    Node off = on;
    on.states.set({Predicate::PowerOn, ""});
    off.states.set({Predicate::PowerOff, ""});
    EXPECT_GE(contrast(on, off, profile).clear_pixels, kLeastPixels) << category;
  }
}

TEST(VisibleState, OfALampLightsWhatIsNear) {
  const Profile profile = profile_for(120);
  Node lamp = thing(Archetype::Cylinder, {0.2, 0.2, 0.4});
  lamp.category = "table_lamp";
  const Vec3 aside = lamp.pose.position;
  Scene dark = before(empty_room(), &lamp, profile, aside, 0.5), bright = dark;
  dark.nodes.edit(0).states.set({Predicate::PowerOff, ""});
  bright.nodes.edit(0).states.set({Predicate::PowerOn, ""});
  Rays rays;
  const Picture off = picture_of(dark, profile, rays), on = picture_of(bright, profile, rays);
  int brighter = 0;
  for (std::size_t i = 0; i < off.rgb.size(); i += 3) brighter += on.rgb[i] > off.rgb[i] + 8 ? 1 : 0;
  EXPECT_GT(brighter, 120 * 120 / 4) << "most of the picture is floor and wall";
}

TEST(VisibleMaterial, IsToldFromOthersOfTheSameColor) {
  const Profile profile = profile_for(200);
  const std::vector<std::string> materials{"wood",    "metal", "glass",  "ceramic", "fabric",
                                           "leather", "stone", "wicker", "rubber",  "cardboard"};
  constexpr double kLeast = 3;  // a grain changes a part of the pixels
  for (const std::string& one : materials) {
    for (const std::string& other : materials) {
      if (one >= other) continue;
      Node a = thing(Archetype::Box, {0.3, 0.25, 0.2});
      a.material = one;
      a.color = "brown";
      Node b = a;
      b.material = other;
      EXPECT_GE(contrast(a, b, profile).mean, kLeast) << one << " and " << other;
    }
  }
}

TEST(VisibleMaterial, OfGlassShowsWhatIsBehind) {
  const Profile profile = profile_for(120);
  Node glass = thing(Archetype::Box, {0.3, 0.05, 0.3});
  glass.material = "glass";
  Node red = thing(Archetype::Box, {0.3, 0.1, 0.3});
  red.id = "thing_2";
  red.color = "red";
  red.pose.position.y() += 0.12;
  Rays rays;
  const Scene alone = before(empty_room(), &glass, profile, glass.pose.position, 0.15);
  Scene both = alone;
  both.nodes.push_back(red);
  const Picture without = picture_of(alone, profile, rays), with = picture_of(both, profile, rays);
  const std::size_t middle = 3 * (60 * 120 + 60);
  EXPECT_GT(int{without.rgb[middle + 2]} - int{with.rgb[middle + 2]}, 20);
}

TEST(VisibleState, OfALiquidInWhatHasNoHollowIsNotABlockAroundIt) {
  for (const char* category : {"kettle", "mug"}) {
    Node node = thing(Archetype::Lidded, {0.2, 0.2, 0.2});
    node.category = category;
    node.states.set({Predicate::Filled, "water"});
    std::vector<Solid> solids;
    add_solids(node, 0, Simulator::Virtualhome, {}, solids);
    const auto liquids =
        std::count_if(solids.begin(), solids.end(), [](const Solid& solid) { return solid.skin == Skin::Liquid; });
    EXPECT_EQ(liquids, std::string(category) == "mug" ? 1 : 0) << category;
  }
}

TEST(VisibleThing, InTheHandIsInACornerAndLeavesTheRest) {
  const Profile profile = profile_for(200);
  Node mug = thing(Archetype::Vessel, {0.1, 0.1, 0.1});
  const Scene empty = before(empty_room(), &mug, profile, mug.pose.position, 0.5);
  Scene held = empty;
  held.agent.held = {mug.id};
  Scene none = empty;
  none.nodes.clear();
  Rays rays;
  const Picture shown = picture_of(held, profile, rays);
  const Picture bare = picture_of(none, profile, rays);
  std::size_t changed = 0, far_from_corner = 0;
  for (std::size_t i = 0; i < bare.rgb.size(); ++i) {
    if (shown.rgb[i] == bare.rgb[i]) continue;
    ++changed;
    const std::size_t x = i / 3 % 200, y = i / 3 / 200;
    far_from_corner += x < 130 || y < 110 ? 1 : 0;
  }
  EXPECT_GT(changed, 600U);
  EXPECT_EQ(far_from_corner, 0U);
}

}  // namespace
}  // namespace unietp
