// Branches of one episode share what was computed; none may notice.
#include <set>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "scene/trace.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

/// A moment that was reached, with all that a world of its own would say there.
struct Reached {
  World world;
  std::vector<Action> actions;
  Scene scene;
  Facts facts;
};

Action random_action(const Profile& profile, const Scene& scene, Rng& rng) {
  std::vector<const ActionInfo*> offered;
  for (const ActionInfo& action : all_actions()) {
    if (profile.offers(action.type) && action.type != ActionType::Stop) offered.push_back(&action);
  }
  const std::string id = scene.nodes[rng.below(scene.nodes.size())].id;
  if (rng.chance(0.3)) return {ActionType::GoTo, {id}};
  const ActionInfo* action = rng.pick(offered);
  return action->argument == ActionArgument::None ? Action{action->type, {}} : Action{action->type, {id}};
}

class Branching : public ::testing::TestWithParam<int> {
 protected:
  Simulator simulator_ = kSimulators[static_cast<std::size_t>(GetParam() % 4)];
  Knowledge knowledge_ = testing::kitchen_knowledge(simulator_);
  Profile profile_ = testing::kitchen_profile(simulator_);

  World start() const { return *World::create(testing::full_kitchen(simulator_), knowledge_, profile_); }
  World alone(const std::vector<Action>& actions) const {
    World world = start();
    for (const Action& action : actions) (void)world.step(action);
    return world;
  }
};

TEST_P(Branching, OneThingIsAskedForAsTheWholeViewTells) {
  Rng rng = Rng(5).fork("one thing", static_cast<std::uint64_t>(GetParam()));
  World world = start();
  const auto at_the_start = World(world).visible();
  for (int i = 0; i < 20; ++i) {
    (void)world.step(random_action(profile_, world.scene(), rng));
    std::set<std::string> seen;
    for (const VisibleObject& object : world.visible()) seen.insert(object.id);
    for (const Node& node : world.scene().nodes) EXPECT_EQ(world.shows(node.id), seen.contains(node.id)) << node.id;
    EXPECT_EQ(world.at(MomentId()).visible(), at_the_start);
  }
}

TEST_P(Branching, EveryBranchIsAsIfItHadBeenTakenAlone) {
  Rng rng = Rng(3).fork("branches", static_cast<std::uint64_t>(GetParam()));
  const World first = start();
  FactReader reader;
  std::vector<Reached> reached{{first, {}, first.scene(), reader.read(first.scene())}};
  for (int i = 0; i < 90; ++i) {
    const std::size_t from = rng.chance(0.6) ? reached.size() - 1 : rng.below(reached.size());
    World world = reached[from].world;
    const Action action = random_action(profile_, reached[from].scene, rng);
    SCOPED_TRACE(to_text(action));
    if (!world.step(action).success) {
      ASSERT_EQ(world.moment(), reached[from].world.moment());
      ASSERT_TRUE(world.changes().empty());
      continue;
    }
    Reached next{world, reached[from].actions, {}, reader.read(reached[from].facts, world.changes())};
    next.actions.push_back(action);
    next.scene = world.scene();
    ASSERT_TRUE(apply(reached[from].scene, world.changes()) == next.scene);
    ASSERT_TRUE(difference(reached[from].scene, next.scene) == world.changes());
    const World twin = alone(next.actions);
    ASSERT_TRUE(twin.scene() == next.scene);
    ASSERT_TRUE(reader.read(next.scene) == next.facts);
    World again = reached[from].world;
    ASSERT_TRUE(again.step(action).success);
    ASSERT_EQ(again.moment(), world.moment());
    reached.push_back(std::move(next));
  }
  EXPECT_GT(reached.size(), 15U);
  for (const Reached& one : reached) {
    EXPECT_TRUE(World(one.world).scene() == one.scene) << "going back to a moment gives another scene";
  }
}

TEST_P(Branching, AWorldThatWasSteppedEqualsOneThatIsMadeOfItsScene) {
  Rng rng = Rng(5).fork("steps", static_cast<std::uint64_t>(GetParam()));
  World world = start();
  for (int i = 0; i < 60; ++i) {
    const World before = world;
    if (!world.step(random_action(profile_, world.scene(), rng)).success) continue;
    if (rng.chance(0.2)) world = before;  // the walk grid has to follow both ways
    const auto made = World::create(world.scene(), knowledge_, profile_);
    ASSERT_TRUE(made);
    ASSERT_TRUE(made->scene() == world.scene());
    for (const Node& node : made->nodes()) {
      ASSERT_EQ(world.standing_place_for(node.id), made->standing_place_for(node.id)) << node.id;
      ASSERT_EQ(world.walking_distance(node.id), made->walking_distance(node.id)) << node.id;
      ASSERT_EQ(world.in_reach(node.id), made->in_reach(node.id)) << node.id;
      ASSERT_EQ(world.closed_around(node.id), made->closed_around(node.id)) << node.id;
    }
    ASSERT_TRUE(world.visible() == made->visible());
  }
}

INSTANTIATE_TEST_SUITE_P(AnySeed, Branching, ::testing::Range(0, 12));

TEST(Moments, ACompositeActionLeadsThroughThoseOfItsSteps) {
  const Knowledge knowledge = testing::kitchen_knowledge();
  const Profile profile = testing::kitchen_profile();
  World world = *World::create(testing::kitchen(), knowledge, profile);
  for (const auto& [type, id] :
       {std::pair{ActionType::GoTo, "potato_1"}, {ActionType::PickUp, "potato_1"}, {ActionType::GoTo, "microwave_1"}}) {
    ASSERT_TRUE(world.step({type, {id}}).success);
    EXPECT_TRUE(world.passed().empty());
    EXPECT_EQ(world.changes_by_moment(), std::vector{world.changes()});
  }
  const World before = world;
  ASSERT_TRUE(world.step({ActionType::HeatWith, {"microwave_1"}}).success);
  Scene scene = before.scene();
  std::string seen;
  for (const PassedMoment& one : world.passed()) {
    scene = apply(std::move(scene), one.changes);
    EXPECT_TRUE(scene == World(world.at(one.moment)).scene());
    const Node& microwave = *find_node(scene, "microwave_1");
    seen += microwave.states.has(Predicate::Open) ? " open" : " closed";
    if (microwave.states.has(Predicate::PowerOn)) seen += "+on";
    if (scene.edges.contains({Predicate::Inside, "potato_1", "microwave_1"})) seen += "+inside";
    if (find_node(scene, "potato_1")->states.has(Predicate::Hot)) seen += "+hot";
  }
  EXPECT_EQ(seen,
            " open open+inside closed+inside closed+on+inside+hot closed+inside+hot open+inside+hot open+hot "
            "closed+hot");
  EXPECT_TRUE(scene == world.scene());
  EXPECT_EQ(world.passed().back().moment, world.moment());
  EXPECT_TRUE(apply(before.scene(), world.changes()) == world.scene());
  // From a moment on the way the rest can be done step by step.
  World between = world.at(world.passed().front().moment);
  ASSERT_TRUE(between.step({ActionType::Close, {"microwave_1"}}).success);
  EXPECT_TRUE(World(world.at(before.moment())).scene() == before.scene());
}

TEST(Moments, ACompositeActionThatFailsLeadsThroughNone) {
  const Knowledge knowledge = testing::kitchen_knowledge();
  const Profile profile = testing::kitchen_profile();
  World world = *World::create(testing::kitchen(), knowledge, profile);
  ASSERT_TRUE(world.step({ActionType::GoTo, {"microwave_1"}}).success);
  const Scene before = world.scene();
  ASSERT_FALSE(world.step({ActionType::HeatWith, {"microwave_1"}}).success);
  EXPECT_TRUE(world.passed().empty());
  EXPECT_TRUE(world.scene() == before);
}

TEST(Moments, MomentsThatAreAlikeAreOneMoment) {
  const Knowledge knowledge = testing::kitchen_knowledge();
  const Profile profile = testing::kitchen_profile();
  World world = *World::create(testing::kitchen(), knowledge, profile);
  const auto run = [&](ActionType type) { ASSERT_TRUE(world.step({type, {"fridge_1"}}).success); };
  run(ActionType::GoTo);
  run(ActionType::Open);
  const auto open = world.moment();
  run(ActionType::Close);
  const auto closed = world.moment();
  EXPECT_NE(open, closed);
  run(ActionType::Open);
  EXPECT_EQ(world.moment(), open);
  run(ActionType::Close);
  EXPECT_EQ(world.moment(), closed);
}

TEST(Moments, AskedOfOneWorldNothingChangesInItsCopies) {
  const Knowledge knowledge = testing::kitchen_knowledge();
  const Profile profile = testing::kitchen_profile();
  const World first = *World::create(testing::kitchen(), knowledge, profile);
  const Scene& start = first.scene();
  World other = first;
  ASSERT_TRUE(other.step({ActionType::GoTo, {"mug_1"}}).success);
  ASSERT_TRUE(other.step({ActionType::PickUp, {"mug_1"}}).success);
  EXPECT_TRUE(start.agent.held.empty());
  EXPECT_TRUE(first.agent().held.empty());
  EXPECT_EQ(other.agent().held, std::vector<std::string>{"mug_1"});
  EXPECT_FALSE(start == other.scene());
  EXPECT_TRUE(first.linked("mug_1", Predicate::On, "diningtable_1"));
  EXPECT_FALSE(other.linked("mug_1", Predicate::On, "diningtable_1"));
}

}  // namespace
}  // namespace unietp
