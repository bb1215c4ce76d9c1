// The expert in M2 and M3: the goals of M1 under the rules of the other modes.
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "expert/exploration.h"
#include "expert/explorer.h"
#include "expert/mode_expert.h"
#include "expert/rollout.h"
#include "logic/evaluate.h"
#include "simulation/mode_episode.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

const HouseCase kModeCases[] = {
    {"open", "(exists (?x - Fridge) (at-end (open ?x)))"},
    {"pick_up", "(exists (?x - Mug) (at-end (held ?x)))"},
    {"pick_up_from_a_closed_place",
     "(exists (?x - (Mug :where (exists (?f - Fridge) (inside ?x ?f)))) (at-end (held ?x)))", mug_in_fridge},
    {"place_on", "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))"},
    {"place_inside_a_drawer", "(exists (?x - Apple) (exists (?y - Dresser) (at-end (inside ?x ?y))))"},
    {"heat_without_a_composite_action", "(exists (?x - Potato) (at-end (hot ?x)))"},
    {"cool_and_place_elsewhere", "(exists (?x - Mug) (exists (?b - SideTable) (at-end (and (cool ?x) (on ?x ?b)))))"},
    {"cool_what_lies_in_the_fridge",
     "(exists (?x - (Mug :where (exists (?f - Fridge) (inside ?x ?f)))) (at-end (cool ?x)))", mug_in_fridge},
    {"slice", "(exists (?s - Apple/slice) (exists (?b - SideTable) (at-end (on ?s ?b))))"},
    {"two_kinds",
     "(exists (?c - Fridge) (exists (?x - Mug) (exists (?y - Apple) (at-end (and (inside ?x ?c) (inside ?y ?c))))))"},
    {"in_order",
     "(exists (?c - Fridge) (exists (?x - Apple) (exists (?y - Mug) (and (before (inside ?x ?c) (inside ?y ?c)) "
     "(at-end (and (inside ?x ?c) (inside ?y ?c)))))))"},
    {"the_dirty_one", "(exists (?x - (Plate :where (dirty ?x))) (exists (?b - SideTable) (at-end (on ?x ?b))))",
     [](Scene& scene) { set_state(scene, "plate_1", Predicate::Dirty); }},
};

class InAnotherMode : public ::testing::TestWithParam<std::tuple<Mode, HouseCase>> {
 protected:
  InAnotherMode() : mode_(std::get<0>(GetParam())), goal_(goal(std::get<1>(GetParam()).goal)) {
    Scene scene = house();
    if (std::get<1>(GetParam()).edit != nullptr) std::get<1>(GetParam()).edit(scene);
    start_ = at_rest(std::move(scene));
  }
  /// Truth of the goal after the commands, done one after the other whatever comes of them.
  bool holds_after(const std::vector<Action>& actions) const {
    ModeEpisode episode(*World::create(start_, knowledge_, profile_), mode_);
    std::vector<Delta> changes;
    for (const Action& action : actions) {
      const Scene before = episode.world().scene();
      do_in(episode, action);
      changes.push_back(difference(before, episode.world().scene()));
    }
    return holds(goal_, to_logic(start_, changes, reads_comparisons(goal_)));
  }

  Mode mode_;
  Formula goal_;
  Knowledge knowledge_ = house_knowledge();
  Profile profile_ = house_profile();
  Scene start_;
};

TEST_P(InAnotherMode, IsShownByStepsThatReplayUnderItsRulesAndCannotBeMissed) {
  const auto first = demonstrate(goal_, start_, knowledge_, profile_, {});
  ASSERT_TRUE(std::holds_alternative<Demonstration>(first)) << std::get<Rejection>(first).detail;
  const auto shown = demonstrate_in(mode_, goal_, start_, knowledge_, profile_, std::get<Demonstration>(first));
  ASSERT_TRUE(std::holds_alternative<Demonstration>(shown)) << std::get<Rejection>(shown).detail;
  const auto& demonstration = std::get<Demonstration>(shown);
  SCOPED_TRACE(plan_of(demonstration));
  EXPECT_EQ(demonstration.mode, mode_);

  // A fresh world, and nothing but what the agent said.
  ModeEpisode episode(*World::create(start_, knowledge_, profile_), mode_);
  std::vector<Delta> changes;
  std::vector<Action> actions;
  for (const DemonstrationStep& step : demonstration.steps) {
    EXPECT_EQ(episode.visible(), step.visible);
    const Scene before = episode.world().scene();
    const Outcome outcome = episode.step(step.command);
    EXPECT_TRUE(outcome.success) << to_text(step.command) << ": " << outcome.feedback;
    changes.push_back(difference(before, episode.world().scene()));
    EXPECT_EQ(changes.back(), step.changes);
    actions.push_back(step.action);
  }
  EXPECT_TRUE(episode.world().stopped());
  EXPECT_TRUE(holds(goal_, to_logic(start_, changes, reads_comparisons(goal_))));

  EXPECT_EQ(needless_steps(goal_, start_, demonstration, knowledge_, profile_), std::vector<std::string>());
  for (std::size_t i = 0; i + 1 < actions.size(); ++i) {
    if (demonstration.steps[i].search || demonstration.steps[i].tidying) continue;
    auto without = actions;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(holds_after(without)) << "without step " << i + 1 << " " << to_text(actions[i]);
  }
}

INSTANTIATE_TEST_SUITE_P(All, InAnotherMode,
                         ::testing::Combine(::testing::Values(Mode::M2, Mode::M3), ::testing::ValuesIn(kModeCases)),
                         [](const auto& param) {
                           return std::string(name_of(std::get<0>(param.param))) + "_" + std::get<1>(param.param).name;
                         });

TEST(ModeExpert, LooksInM2ForWhatItUsesAndNamesInM3NothingButRoomsById) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = at_rest(house());
  const Formula placed = goal("(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))");
  const auto first = std::get<Demonstration>(demonstrate(placed, start, knowledge, profile, {}));
  const auto m2 = std::get<Demonstration>(demonstrate_in(Mode::M2, placed, start, knowledge, profile, first));
  std::set<std::string> seen;
  for (const DemonstrationStep& step : m2.steps) {
    for (const VisibleObject& object : step.visible) seen.insert(object.id);
    for (const std::string& id : step.action.args) {
      const Node* node = find_node(start, id);
      EXPECT_TRUE(node == nullptr || !node->movable || seen.contains(id)) << to_text(step.action);
    }
  }
  const auto m3 = std::get<Demonstration>(demonstrate_in(Mode::M3, placed, start, knowledge, profile, first));
  for (const DemonstrationStep& step : m3.steps) {
    for (const Argument& argument : step.command.args)
      EXPECT_TRUE(argument.box || find_room(start, argument.id)) << to_text(step.command);
  }
}

TEST(ModeExpert, SaysWhatStandsInTheWayWhenAModeHasNoDemonstration) {
  const Knowledge knowledge = house_knowledge();
  const Scene start = at_rest(house());
  const Formula held = goal("(exists (?x - Mug) (at-end (held ?x)))");
  const auto first = std::get<Demonstration>(demonstrate(held, start, knowledge, house_profile(), {}));
  Profile blind = house_profile();
  blind.image_width = blind.image_height = 1;
  const auto shown = demonstrate_in(Mode::M3, held, start, knowledge, blind, first);
  ASSERT_TRUE(std::holds_alternative<Rejection>(shown));
  EXPECT_EQ(std::get<Rejection>(shown).reason, RejectionReason::NotInM3);
  EXPECT_NE(std::get<Rejection>(shown).detail.find("nowhere left to look for Mug"), std::string::npos)
      << std::get<Rejection>(shown).detail;
}

TEST(ModeExpert, IsHeldAgainstMutationsUnderTheRulesOfTheMode) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = at_rest(house());
  const Formula placed = goal("(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))");
  const auto first = std::get<Demonstration>(demonstrate(placed, start, knowledge, profile, {}));
  for (const Mode mode : {Mode::M2, Mode::M3}) {
    auto shown = std::get<Demonstration>(demonstrate_in(mode, placed, start, knowledge, profile, first));
    DemonstrationStep look;
    look.action = {ActionType::TurnLeft, {}};
    shown.steps.insert(shown.steps.end() - 1, look);
    EXPECT_EQ(needless_steps(placed, start, shown, knowledge, profile),
              std::vector<std::string>{"without step " + std::to_string(shown.steps.size() - 1) + ": turn_left"});
  }
}

TEST(Exploration, LooksAgainWhereTheBoxOfAThingIsThatOfAnother) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  // Two small slabs that cross each other have one outline from many places.
  Scene scene = house();
  erase_if(scene.nodes, [](const Node& node) { return node.movable; });
  for (const auto& [id, yaw] : {std::pair("potato_1", 0.4), std::pair("potato_2", 0.4 + std::numbers::pi / 2)}) {
    add(scene, knowledge, id, "Potato", 8.5, 3.5, 0, yaw).size = {0.04, 0.01, 0.04};
    move_to(scene, id, 8.5, 3.5, 0.602);
  }
  for (const char* id : {"potato_1", "potato_2"}) {
    ModeEpisode episode(*World::create(scene, knowledge, profile), Mode::M3);
    const auto way = way_to_see(episode, id);
    ASSERT_TRUE(way);
    for (const Action& step : *way) EXPECT_TRUE(do_in(episode, step).success) << to_text(step);
    EXPECT_TRUE(clearly_said(episode, {ActionType::GoTo, {id}})) << id;
  }
}

TEST(Explore, LooksFromWhatIsNearbyWhereLongStepsLeadToFewPlaces) {
  const Knowledge knowledge = house_knowledge();
  Profile profile = house_profile();
  profile.step_m = 1;
  profile.turn_deg = 90;
  profile.image_width = profile.image_height = 200;
  Scene scene = strewn_house(Rng(8));
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].category == "Potato") scene.nodes.edit(i).size *= 0.5;
  }
  const Scene start = at_rest(std::move(scene));
  const Formula each = goal("(forall (?x - Potato) (sometime (held ?x)))");
  const auto first = std::get<Demonstration>(demonstrate(each, start, knowledge, profile, {}));
  std::vector<Action> plan;
  for (const DemonstrationStep& step : first.steps) plan.push_back(step.action);
  auto executions = *ExecutionTree::of(each, start, knowledge, profile);
  const auto done = explore(rules_of(Mode::M3), executions, plan, {.max_steps = 150, .mode = Mode::M3});
  ASSERT_TRUE(std::holds_alternative<std::vector<Action>>(done)) << std::get<Trouble>(done).text;
  EXPECT_GT(std::get<std::vector<Action>>(done).size(), plan.size());
}

TEST(RuledOut, AGoalThatNeedsReadingIsRefusedInM3FromItsTextAlone) {
  for (const char* text : {"(exists (?x - Plate) (at-end (read ?x)))", "(forall (?x - Plate) (sometime (read ?x)))",
                           "(exists (?x - Plate) (and (at-end (held ?x)) (sometime (read ?x))))",
                           "(exists (?x - Plate) (before (open ?x) (read ?x)))"}) {
    const auto why = ruled_out_in(Mode::M3, goal(text));
    ASSERT_TRUE(why) << text;
    EXPECT_EQ(why->reason, RejectionReason::NotInM3);
    EXPECT_EQ(why->failure, Failure::NotOffered);
    EXPECT_EQ(why->detail, "M3 does not offer read, which the goal needs");
    EXPECT_FALSE(ruled_out_in(Mode::M1, goal(text)));
    EXPECT_FALSE(ruled_out_in(Mode::M2, goal(text)));
  }
}

TEST(RuledOut, AGoalThatCanBeMetWithoutReadingIsNot) {
  for (const char* text : {"(exists (?x - Plate) (at-end (or (read ?x) (held ?x))))",
                           "(exists (?x - Plate) (at-end (not (read ?x))))", "(exists (?x - Plate) (at-end (hot ?x)))",
                           "(always (imply (exists (?x - Mug) (held ?x)) (exists (?x - Mug) "
                           "(read ?x))))"}) {
    EXPECT_FALSE(ruled_out_in(Mode::M3, goal(text))) << text;
  }
}

TEST(Exploration, TellsWhatIsNearAThingTheNearestFirst) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const World world = *World::create(at_rest(house()), knowledge, profile);
  const auto near = things_near(world, "lamp_1");
  ASSERT_FALSE(near.empty());
  EXPECT_EQ(near.front(), "plate_2");
  EXPECT_TRUE(things_near(world, "nothing_1").empty());
}

TEST(Exploration, LooksFirstFromWhatCarriesTheObject) {
  const Scene start = at_rest(house());
  const Node* carrier = nullptr;
  for (const Edge& edge : start.edges) {
    if (edge.relation == Predicate::On && edge.from == "mug_1") carrier = find_node(start, edge.to);
  }
  ASSERT_NE(carrier, nullptr);
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const World world = *World::create(start, knowledge, profile);
  const auto lookouts = lookouts_for(world, "mug_1");
  ASSERT_FALSE(lookouts.empty());
  EXPECT_EQ(lookouts.front(), carrier->id);
  EXPECT_TRUE(lookouts_for(world, "nothing_1").empty());
}

}  // namespace
}  // namespace unietp::testing
