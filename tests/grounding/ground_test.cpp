#include "grounding/ground.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/text.h"
#include "generator/fixed_start.h"
#include "grounding/check_start.h"
#include "homes.h"
#include "logic/evaluate.h"
#include "scene/scene_json.h"
#include "scene/trace.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

/// Its relations are those that a reading of the whole scene gives, and its text reads back to the same bits.
void expect_read_and_written_exactly(const Scene& start) {
  EXPECT_EQ(start.edges, read_relations(start));
  const auto again = scene_from_json("start", scene_to_json(start));
  ASSERT_TRUE(again) << format(again.error());
  EXPECT_EQ(*again, start);
}

const std::string kHoldAMug = "(exists (?a - Mug) (at-end (held ?a)))";

class Ground : public ::testing::Test {
 protected:
  void SetUp() override {
    style_ = style_of(Simulator::Ai2thor);
    ASSERT_TRUE(style_);
    auto home = home_of(*style_, 16);
    ASSERT_TRUE(home) << format(home.error());
    home_ = std::move(*home);
  }
  std::variant<Grounded, Rejection> grounded(const Specification& spec, std::uint64_t seed = 0) const {
    return ground(spec, prepare_home(home_, style_->profile), style_->knowledge, style_->profile, {}, Rng(seed));
  }
  /// The episode, whose start is read anew from physics and held against the specification by the evaluator alone.
  Episode sound(const Specification& spec, std::uint64_t seed = 0) const {
    const auto result = grounded(spec, seed);
    if (const auto* rejection = std::get_if<Rejection>(&result)) {
      ADD_FAILURE() << name_of(rejection->reason) << ": " << rejection->detail;
      return {};
    }
    Episode episode = std::get<Grounded>(result).episode;
    expect_read_and_written_exactly(episode.start);
    const Trace trace = to_logic(episode.start, {}, true);
    for (const Formula& constraint : spec.init) EXPECT_TRUE(holds_in(constraint, trace, 0)) << to_text(constraint);
    EXPECT_FALSE(holds(spec.goal, trace));
    EXPECT_EQ(episode.layout, home_.id);
    return episode;
  }
  std::string reason(const Specification& spec) const {
    const auto result = grounded(spec);
    const auto* rejection = std::get_if<Rejection>(&result);
    if (rejection == nullptr) return "accepted";
    EXPECT_EQ(stage_of(rejection->reason), RejectionStage::Grounding);
    EXPECT_NE(rejection->detail.find("by-hand"), std::string::npos);
    return std::string(name_of(rejection->reason));
  }
  int count(const Scene& scene, const std::string& category) const {
    return static_cast<int>(std::count_if(scene.nodes.begin(), scene.nodes.end(),
                                          [&](const Node& node) { return node.category == category; }));
  }

  std::optional<Surroundings> style_;
  Scene home_;
};

TEST_F(Ground, AddsWhatIsMissingAwayFromWhereTheGoalWantsIt) {
  const auto spec = specification("(exists (?a - Mug) (exists (?b - DiningTable) (at-end (on ?a ?b))))",
                                  {"(count >= 4 (?a - Mug) (and))", "(exists (?b - DiningTable) (and))",
                                   "(forall (?a - Mug) (not (exists (?b - DiningTable) (on ?a ?b))))"});
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Episode episode = sound(spec, seed);
    EXPECT_GE(count(episode.start, "Mug"), 4);
  }
}

TEST_F(Ground, TakesAwayWhatIsTooMuch) {
  const auto several = specification(kHoldAMug, {"(count >= 3 (?a - Mug) (and))"});
  home_ = sound(several).start;
  const Episode episode = sound(specification(kHoldAMug, {"(count = 1 (?a - Mug) (and))"}));
  EXPECT_EQ(count(episode.start, "Mug"), 1);
  EXPECT_TRUE(std::any_of(episode.edits.begin(), episode.edits.end(),
                          [](const std::string& edit) { return edit.starts_with("removed mug_"); }));
}

TEST_F(Ground, OpensDoorsInPhysicsNotOnlyInWords) {
  const Episode episode = sound(specification("(exists (?f - Fridge) (at-end (closed ?f)))",
                                              {"(exists (?f - Fridge) (and))", "(forall (?f - Fridge) (open ?f))"}));
  for (std::size_t i = 0; i < episode.start.nodes.size(); ++i) {
    const Node& node = episode.start.nodes[i];
    if (node.category != "Fridge") continue;
    EXPECT_EQ(node.opening, 1);
    EXPECT_TRUE(node.states.has(Predicate::Open));
    const PhysicsWorld world = physics_of(episode.start);
    const BodyId self[] = {BodyId::node(i)};
    EXPECT_EQ(world.overlap(shape_of(node), node.pose, 1, self, 0.002), std::nullopt);
  }
}

TEST_F(Ground, PutsThingsIntoDrawersThatRideAlongWhenOpened) {
  const auto spec = specification(
      "(exists (?d - Drawer) (at-end (closed ?d)))",
      {"(count >= 1 (?a - Pen) (exists (?d - Drawer) (inside ?a ?d)))", "(forall (?d - Drawer) (open ?d))"});
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Episode episode = sound(spec, seed);
    const bool inside = std::any_of(episode.start.edges.begin(), episode.start.edges.end(), [](const Edge& edge) {
      return edge.relation == Predicate::Inside && edge.from.starts_with("pen_") && edge.to.starts_with("drawer_");
    });
    EXPECT_TRUE(inside);
  }
}

TEST_F(Ground, PutsThingsUnderFurniture) {
  const auto spec = specification(
      "(exists (?a - Boots) (exists (?t - DiningTable) (at-end (not (under ?a ?t)))))",
      {"(count = 1 (?a - Boots) (exists (?t - DiningTable) (under ?a ?t)))", "(count = 1 (?a - Boots) (and))"});
  const Episode episode = sound(spec);
  EXPECT_TRUE(std::any_of(episode.start.edges.begin(), episode.start.edges.end(),
                          [](const Edge& edge) { return edge.relation == Predicate::Under; }));
}

TEST_F(Ground, LeavesADistractorThatTheReferringConstraintExcludes) {
  auto spec = specification("(exists (?a - (Mug :where (dirty ?a))) (exists (?b - DiningTable) (at-end (on ?a ?b))))",
                            {"(exists (?b - DiningTable) (and))", "(count = 1 (?a - Mug) (dirty ?a))",
                             "(forall (?a - Mug) (not (exists (?b - DiningTable) (on ?a ?b))))"});
  spec.split = Split::InstanceGrounding;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Episode episode = sound(spec, seed);
    int dirty = 0, clean = 0;
    for (const Node& node : episode.start.nodes) {
      if (node.category == "Mug") ++(node.states.has(Predicate::Dirty) ? dirty : clean);
    }
    EXPECT_EQ(dirty, 1);
    EXPECT_GE(clean, 1);
  }
}

TEST_F(Ground, MovesWhatStandsWhereItMustNot) {
  const auto on_table = specification(kHoldAMug, {"(count >= 2 (?a - Mug) (exists (?t - CoffeeTable) (on ?a ?t)))"});
  home_ = sound(on_table).start;
  const auto spec = specification("(exists (?a - Mug) (exists (?t - CoffeeTable) (at-end (on ?a ?t))))",
                                  {"(count >= 2 (?a - Mug) (and))"});
  const Episode episode = sound(spec);  // the goal itself holds at first, and has to be undone
  EXPECT_GE(count(episode.start, "Mug"), 2);
}

TEST_F(Ground, GivesTheSameBytesForTheSameSeed) {
  const auto spec =
      specification(kHoldAMug, {"(count >= 3 (?a - Mug) (dirty ?a))", "(count >= 2 (?a - Mug) (clean ?a))"});
  EXPECT_EQ(scene_to_json(sound(spec, 7).start), scene_to_json(sound(spec, 7).start));
  EXPECT_EQ(sound(spec, 7).edits, sound(spec, 7).edits);
}

TEST_F(Ground, RejectsWithAReasonFromTheClosedList) {
  EXPECT_EQ(reason(specification(kHoldAMug, {"(count >= 1 (?a - Spaceship) (and))"})), "unknown-category");
  EXPECT_EQ(reason(specification("(exists (?r - sauna) (at-end (in_room agent ?r)))", {"(exists (?r - sauna) (and))"})),
            "lacks-room");
  EXPECT_EQ(reason(specification(kHoldAMug, {"(exists (?a - Mug) (and))", "(count = 7 (?r - kitchen) (and))"})),
            "lacks-room");
  EXPECT_EQ(reason(specification(kHoldAMug, {"(count >= 15 (?b - Bed) (and))"})), "lacks-furniture");
  EXPECT_EQ(reason(specification(kHoldAMug, {"(count >= 1 (?a - TennisRacket) (exists (?b - Mug) (inside ?a ?b)))"})),
            "no-free-place");
  EXPECT_EQ(reason(specification(kHoldAMug, {"(exists (?a - Mug) (folded ?a))"})), "state-not-possible");
  EXPECT_EQ(reason(specification("(exists (?a - Mug) (at-end (clean ?a)))", {"(exists (?a - Mug) (held ?a))"})),
            "cannot-enforce");
  EXPECT_EQ(reason(specification(kHoldAMug, {"(exists (?a - Mug) (and))", "(forall (?a - Mug) (dirty ?a))",
                                             "(forall (?a - Mug) (clean ?a))"})),
            "start-not-met");
  EXPECT_EQ(reason(specification("(exists (?a - Mug) (at-end (not (held ?a))))", {"(exists (?a - Mug) (and))"})),
            "goal-holds-at-start");
  EXPECT_EQ(reason(specification("(exists (?f - Sofa) (exists (?r - living_room) (at-end (in_room ?f ?r))))",
                                 {"(count = 1 (?f - Sofa) (and))"})),
            "part-of-goal-holds-at-start");
}

TEST_F(Ground, RejectsAStartThatIsNestedTooDeepToBeMade) {
  std::string shallow = "(dirty ?a)", deep = shallow;
  for (int i = 0; i < 4; ++i) shallow = "(not " + shallow + ")";
  for (int i = 0; i < 16; ++i) deep = "(not " + deep + ")";
  EXPECT_EQ(reason(specification(kHoldAMug, {"(exists (?a - Mug) " + shallow + ")"})), "accepted");
  const auto refused = grounded(specification(kHoldAMug, {"(exists (?a - Mug) " + deep + ")"}));
  const auto* rejection = std::get_if<Rejection>(&refused);
  ASSERT_NE(rejection, nullptr);
  EXPECT_EQ(rejection->reason, RejectionReason::CannotEnforce);
  EXPECT_NE(rejection->detail.find("is nested too deep"), std::string::npos) << rejection->detail;
}

TEST_F(Ground, RejectsAGoalAboutNothing) {
  std::string absent;
  for (const Category& category : style_->knowledge.categories()) {
    if (category.movable && count(home_, category.name) == 0) absent = category.name;
  }
  ASSERT_FALSE(absent.empty());
  EXPECT_EQ(reason(specification("(at-end (count >= 1 (?a - " + absent + ") (held ?a)))", {})), "empty-domain");
}

/// Reason that check_start gives for a start, or "sound".
std::string verdict(const Specification& spec, const Home& home, Scene start, const std::set<std::string>& touched,
                    const Surroundings& style) {
  start.edges = read_relations(start);
  const auto problem = check_start(spec, home, start, read_grown(home, start), touched, style.knowledge, style.profile);
  return problem ? std::string(name_of(problem->reason)) : "sound";
}

TEST_F(Ground, CheckFindsEachFaultPlantedInASoundStart) {
  auto spec = specification("(exists (?a - (Mug :where (dirty ?a))) (at-end (held ?a)))",
                            {"(count = 1 (?a - Mug) (dirty ?a))"});
  spec.split = Split::InstanceGrounding;
  const Home home = prepare_home(home_, style_->profile);
  const Scene start = sound(spec).start;
  EXPECT_EQ(verdict(spec, home, start, {}, *style_), "sound");
  std::string dirty;
  for (const Node& node : start.nodes) {
    if (node.category == "Mug" && node.states.has(Predicate::Dirty)) dirty = node.id;
  }

  Scene clean = start;
  edit_node(clean, dirty)->states.set({Predicate::Clean, {}});
  EXPECT_EQ(verdict(spec, home, clean, {}, *style_), "start-not-met");
  auto without_init = spec;
  without_init.init.clear();
  EXPECT_EQ(verdict(without_init, home, clean, {}, *style_), "no-referent");

  Scene all_dirty = start;
  for (std::size_t i = 0; i < all_dirty.nodes.size(); ++i) {
    Node& node = all_dirty.nodes.edit(i);
    if (node.category == "Mug") node.states.set({Predicate::Dirty, {}});
  }
  EXPECT_EQ(verdict(without_init, home, all_dirty, {}, *style_), "no-distractor");

  Scene high = start;
  edit_node(high, dirty)->pose.position.z() = 4.5;
  EXPECT_EQ(verdict(spec, home, high, {}, *style_), "not-reachable");

  Scene hovering = start;
  edit_node(hovering, dirty)->pose.position.z() += 0.1;
  EXPECT_EQ(verdict(spec, home, hovering, {dirty}, *style_), "not-calm");

  Scene misread = start;
  misread.edges.erase(*misread.edges.begin());
  EXPECT_TRUE(check_start(spec, home, misread, read_grown(home, misread), {}, style_->knowledge, style_->profile));
}

TEST_F(Ground, BringsOneClearlyNearestAndLeavesAnotherFurtherAway) {
  const auto spec =
      specification("(exists (?a - (Mug :where (exists (?b - Fridge) (nearest ?a ?b)))) (at-end (held ?a)))",
                    {"(count = 1 (?b - Fridge) (and))", "(count = 1 (?a - Mug) (exists (?b - Fridge) (nearest ?a ?b)))",
                     "(count >= 1 (?a - Mug) (not (exists (?b - Fridge) (nearest ?a ?b))))"});
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Episode episode = sound(spec, seed);
    const auto fridge = std::find_if(episode.start.nodes.begin(), episode.start.nodes.end(),
                                     [](const Node& node) { return node.category == "Fridge"; });
    std::vector<double> distances;
    for (const Node& node : episode.start.nodes) {
      if (node.category == "Mug") distances.push_back((node.pose.position - fridge->pose.position).norm());
    }
    std::sort(distances.begin(), distances.end());
    ASSERT_GE(distances.size(), 2U);
    EXPECT_GE(distances[1] - distances[0], std::max(0.25, 0.2 * distances[0]));
  }
}

TEST_F(Ground, MakesOneOfTwoLargerAndLetsItStand) {
  const auto spec = specification("(exists (?a - (Apple :where (size ?a large))) (at-end (held ?a)))",
                                  {"(count = 2 (?a - Apple) (and))", "(count = 1 (?a - Apple) (size ?a large))"});
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Episode episode = sound(spec, seed);
    std::vector<double> volumes;
    for (const Node& node : episode.start.nodes) {
      if (node.category == "Apple") volumes.push_back(node.size.prod());
      if (node.category == "Apple" && !node.asset.empty()) {
        EXPECT_EQ(style_->knowledge.asset(node.asset)->size, node.size) << "a size that no model has";
      }
    }
    std::sort(volumes.begin(), volumes.end());
    ASSERT_EQ(volumes.size(), 2U);
    EXPECT_GE(volumes[1], 1.3 * volumes[0]);
  }
}

TEST_F(Ground, GivesColorsThatAreTold) {
  const auto spec = specification("(exists (?a - (Mug :where (colour ?a red))) (at-end (held ?a)))",
                                  {"(forall (?a - Mug) (colour ?a any))", "(count = 1 (?a - Mug) (colour ?a red))",
                                   "(count >= 1 (?a - Mug) (not (colour ?a red)))"});
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Episode episode = sound(spec, seed);
    auto written = scene_from_json("start", scene_to_json(episode.start));
    ASSERT_TRUE(written);
    EXPECT_EQ(std::count_if(written->nodes.begin(), written->nodes.end(),
                            [](const Node& node) { return node.category == "Mug" && node.color == "red"; }),
              1);
  }
}

TEST_F(Ground, FurnitureGetsANeighborSetDownBesideIt) {
  const auto spec = specification(
      "(exists (?b - (SideTable :where (exists (?c - Box) (next_to ?b ?c)))) (exists (?a - Mug) (at-end (on ?a ?b))))",
      {"(count = 1 (?b - SideTable) (exists (?c - Box) (next_to ?b ?c)))",
       "(count >= 1 (?b - SideTable) (not (exists (?c - Box) (next_to ?b ?c))))", "(exists (?a - Mug) (and))",
       "(forall (?a - Mug) (not (exists (?b - SideTable) (on ?a ?b))))"});
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Episode episode = sound(spec, seed);
    const auto is = [&](const std::string& id, std::string_view category) {
      const Node* node = find_node(episode.start, id);
      return node != nullptr && node->category == category;
    };
    std::set<std::string> beside;  // side tables that a box stands next to
    for (const Edge& edge : episode.start.edges) {
      if (edge.relation != Predicate::NextTo) continue;
      if (is(edge.from, "SideTable") && is(edge.to, "Box")) beside.insert(edge.from);
      if (is(edge.to, "SideTable") && is(edge.from, "Box")) beside.insert(edge.to);
    }
    EXPECT_EQ(beside.size(), 1U);
    EXPECT_GE(count(episode.start, "SideTable"), 2);
  }
}

TEST_F(Ground, LeavesTheFurnitureOfTheHomeAsItIs) {
  const auto fixed = [](const Scene& scene) {
    std::vector<std::string> ids;
    for (const Node& node : scene.nodes) {
      if (!node.movable) ids.push_back(node.id);
    }
    std::sort(ids.begin(), ids.end());
    return ids;
  };
  // Every coffee table has two mugs at the start: where one has no room, it is not taken away.
  const auto spec = specification("(exists (?b - CoffeeTable) (at-end (count <= 1 (?a - Mug) (on ?a ?b))))",
                                  {"(count >= 2 (?a - Mug) (exists (?b - CoffeeTable) (on ?a ?b)))"});
  for (std::uint64_t seed = 0; seed < 3; ++seed) EXPECT_EQ(fixed(sound(spec, seed).start), fixed(home_));
  const int tables = count(home_, "SideTable");
  ASSERT_GE(tables, 1);
  EXPECT_EQ(reason(specification(kHoldAMug, {"(count = " + std::to_string(tables + 1) + " (?b - SideTable) (and))"})),
            "lacks-furniture");
  EXPECT_EQ(reason(specification(kHoldAMug, {"(count = " + std::to_string(tables) + " (?b - SideTable) (and))",
                                             "(exists (?a - Mug) (and))"})),
            "accepted");
}

TEST_F(Ground, ARoomThatNobodyCanWalkToIsNoReasonToMakeNoTasksInTheOthers) {
  double far = 0;
  for (const Room& room : home_.rooms) far = std::max(far, room_bounds(room, 1).high.x());
  home_.rooms.push_back({"shed_1", "bedroom", {{far + 1, 0}, {far + 4, 0}, {far + 4, 3}, {far + 1, 3}}});
  const auto spec = specification(kHoldAMug, {"(exists (?a - Mug) (and))"});
  const Home home = prepare_home(home_, style_->profile);
  EXPECT_EQ(home.cut_off, std::vector<std::string>{"shed_1"});
  EXPECT_EQ(reason(spec), "accepted");
}

TEST_F(Ground, SetsUpWhatTheHomeLacksAltogetherWhereItUsuallyStands) {
  erase_if(home_.nodes, [](const Node& node) { return node.category == "Bed"; });
  const auto spec = specification(kHoldAMug, {"(exists (?a - Mug) (and))", "(exists (?b - Bed) (and))"});
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Episode episode = sound(spec, seed);
    const auto bed = std::find_if(episode.start.nodes.begin(), episode.start.nodes.end(),
                                  [](const Node& node) { return node.category == "Bed"; });
    ASSERT_NE(bed, episode.start.nodes.end());
    const Room* room = room_at(episode.start, bed->pose.position.head<2>());
    ASSERT_NE(room, nullptr);
    EXPECT_EQ(room->type, "bedroom");
  }
}

TEST_F(Ground, TellsTheNetEffectOfItsEdits) {
  auto spec = specification(
      "(exists (?a - (Mug :where (dirty ?a))) (exists (?b - CoffeeTable) (at-end (on ?a ?b))))",
      {"(exists (?b - CoffeeTable) (and))", "(count = 1 (?a - Mug) (dirty ?a))", "(count >= 4 (?a - Mug) (and))",
       "(forall (?d - Drawer) (open ?d))", "(forall (?a - Mug) (not (exists (?b - CoffeeTable) (on ?a ?b))))"});
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Episode episode = sound(spec, seed);
    std::set<std::string> said, told;  // whose place or presence, and all
    for (const std::string& edit : episode.edits) {
      const auto words = split(edit, ' ');
      ASSERT_GE(words.size(), 2U) << edit;
      const std::string id = words[0] == "added" ? words[2] : words[1];
      told.insert(id);
      if (words[0] == "made") continue;
      EXPECT_TRUE(said.insert(id).second) << edit << " is not the only one of " << id;
      EXPECT_EQ(words[0] == "added", find_node(home_, id) == nullptr) << edit;
      EXPECT_EQ(words[0] == "removed", find_node(episode.start, id) == nullptr) << edit;
    }
    for (const Node& node : episode.changes.nodes) {
      const Node* before = find_node(home_, node.id);
      EXPECT_TRUE(before != nullptr || told.contains(node.id)) << node.id;
      if (before == nullptr || before->states == node.states) continue;
      EXPECT_TRUE(std::any_of(episode.edits.begin(), episode.edits.end(), [&](const std::string& edit) {
        return edit.starts_with("made " + node.id + " ");
      })) << node.id;
    }
  }
}

TEST(GroundTheLibrary, FindsStartsForMostTemplatesOnEverySimulator) {
  const auto library = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates/library");
  ASSERT_FALSE(library.templates.empty());
  for (const Simulator simulator : kSimulators) {
    const auto style = style_of(simulator);
    ASSERT_TRUE(style);
    auto scene = home_of(*style, 1, 6);
    ASSERT_TRUE(scene) << format(scene.error());
    const Home home = prepare_home(std::move(*scene), style->profile);
    std::vector<std::string> offered;
    for (const Category& category : style->knowledge.categories()) {
      if (category.movable || !home.places.of(category.name).empty()) offered.push_back(category.name);
    }
    for (const Room& room : home.scene.rooms) offered.push_back(room.type);
    int tried = 0, found = 0;
    std::string rejections;
    for (const Template& source : library.templates) {
      if (std::count(source.simulators.begin(), source.simulators.end(), simulator) == 0) continue;
      if (!source.refinement.empty()) continue;  // what can be referred to depends on the home
      const Rng rng = Rng(5).fork(source.name, 0);
      const auto binding = sample_binding(source, style->knowledge, offered, rng);
      if (!binding) continue;
      const auto spec = instantiate(source, style->knowledge, *binding);
      if (!spec || misfit(spec->init, style->knowledge, home.now) != nullptr) continue;
      ++tried;
      const auto result = ground(*spec, home, style->knowledge, style->profile, {}, rng);
      if (const auto* rejection = std::get_if<Rejection>(&result)) {
        rejections += "\n" + std::string(name_of(rejection->reason)) + ": " + rejection->detail;
        continue;
      }
      ++found;
      expect_read_and_written_exactly(std::get<Grounded>(result).episode.start);
      const Trace trace = to_logic(std::get<Grounded>(result).episode.start, {}, true);
      for (const Formula& constraint : spec->init) EXPECT_TRUE(holds_in(constraint, trace, 0)) << to_text(constraint);
      EXPECT_FALSE(holds(spec->goal, trace)) << to_text(spec->goal);
    }
    EXPECT_GE(tried, 30) << name_of(simulator);
    EXPECT_GE(found * 10, tried * 8) << name_of(simulator) << ": " << found << " of " << tried << rejections;
  }
}

}  // namespace
}  // namespace unietp
