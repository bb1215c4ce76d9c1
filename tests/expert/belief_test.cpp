// The expert of M2 and M3: what it does follows from what it knew at the start and has seen.
#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/belief.h"
#include "expert/belief_expert.h"
#include "expert/execution.h"
#include "expert/known_home.h"
#include "expert/mode_expert.h"
#include "expert/search_marks.h"
#include "expert/search_needs.h"
#include "expert/witness.h"
#include "grounding/reachability.h"
#include "simulation/relations.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;

void knife_in_fridge(Scene& scene) { move_to(scene, "knife_1", 4.4, 3.55, 0.9); }
void mug_in_running_microwave(Scene& scene) {
  move_to(scene, "mug_1", 1.5, 3.65, 0.92);
  set_state(scene, "microwave_1", Predicate::PowerOn);
}

const HouseCase kBeliefCases[] = {
    {"a_mug_on_a_table", "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))"},
    {"the_mug_in_the_fridge", "(exists (?x - (Mug :where (exists (?f - Fridge) (inside ?x ?f)))) (at-end (held ?x)))",
     mug_in_fridge},
    {"a_hot_potato", "(exists (?x - Potato) (at-end (hot ?x)))"},
    {"a_slice", "(exists (?s - Apple/slice) (exists (?b - SideTable) (at-end (on ?s ?b))))"},
    {"the_dirty_plate", "(exists (?x - (Plate :where (dirty ?x))) (exists (?b - SideTable) (at-end (on ?x ?b))))"},
    {"in_order",
     "(exists (?c - Fridge) (exists (?x - Apple) (exists (?y - Mug) (and (before (inside ?x ?c) (inside ?y ?c)) "
     "(at-end (and (inside ?x ?c) (inside ?y ?c)))))))"},
    {"slices_with_a_hidden_knife", "(exists (?s - Potato/slice) (exists (?b - SideTable) (at-end (on ?s ?b))))",
     knife_in_fridge},
    {"a_mug_in_a_machine_that_runs",
     "(exists (?x - (Mug :where (exists (?m - Microwave) (inside ?x ?m)))) (at-end (held ?x)))",
     mug_in_running_microwave},
    {"every_mug", "(exists (?y - Fridge) (forall (?x - Mug) (at-end (inside ?x ?y))))"},
    {"two_kinds",
     "(exists (?c - Fridge) (exists (?x - Mug) (exists (?y - Apple) (at-end (and (inside ?x ?c) (inside ?y ?c))))))"},
};

std::vector<std::string> texts_of(const std::vector<Action>& actions) {
  std::vector<std::string> texts;
  for (const Action& action : actions) texts.push_back(to_text(action));
  return texts;
}

struct Belief : ::testing::TestWithParam<std::tuple<Mode, HouseCase>> {
  Belief() {
    Scene scene = house();
    if (std::get<1>(GetParam()).edit != nullptr) std::get<1>(GetParam()).edit(scene);
    start = at_rest(std::move(scene));
  }
  SearchProblem problem() const { return {wanted, knowledge, profile, nullptr, mode}; }
  /// What the expert is shown and does in a start of its own.
  Witnessed in(const Scene& scene) const {
    auto executions = *ExecutionTree::of(wanted, scene, knowledge, profile);
    EpisodeWindow window(executions, mode);
    WitnessWindow witness(window);
    (void)reach_by_belief(problem(), witness);
    return witness.seen();
  }
  /// On the ids of the home.
  std::vector<Action> done_in(const Scene& scene) const {
    auto executions = *ExecutionTree::of(wanted, scene, knowledge, profile);
    EpisodeWindow window(executions, mode);
    EXPECT_FALSE(reach_by_belief(problem(), window));
    return window.done();
  }
  Demonstration shown() const {
    const auto first = demonstrate(wanted, start, knowledge, profile, {});
    auto made = demonstrate_in(mode, wanted, start, knowledge, profile, std::get<Demonstration>(first));
    if (const auto* why = std::get_if<Rejection>(&made)) {
      ADD_FAILURE() << why->detail;
      return {};
    }
    return std::get<Demonstration>(std::move(made));
  }

  const Mode mode = std::get<0>(GetParam());
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Formula wanted = goal(std::get<1>(GetParam()).goal);
  Scene start;
};

TEST_P(Belief, IsAllThatTheExpertActsOn) {
  const Witnessed seen = in(start);
  ASSERT_THAT(seen.actions, Not(IsEmpty()));
  EXPECT_EQ(seen.actions.back().type, ActionType::Stop);
  RecordedWindow record(seen);  // there is no world behind it
  EXPECT_FALSE(reach_by_belief(problem(), record));
  EXPECT_TRUE(record.same());
}

/// The same home under other ids, whose order is the reverse.
Scene called_otherwise(Scene scene) {
  const std::size_t count = scene.nodes.size();
  for (std::size_t i = 0; i < count; ++i) scene.nodes.edit(i).id = "thing_" + std::to_string(1000 + count - i);
  scene.edges = EdgeSet(read_relations(scene));
  return scene;
}

/// What each thing of the one is called in the other, and back.
std::map<std::string, std::string> other_ids(const Scene& one, const Scene& other) {
  std::map<std::string, std::string> ids;
  for (std::size_t i = 0; i < one.nodes.size(); ++i) {
    ids[one.nodes[i].id] = other.nodes[i].id;
    ids[other.nodes[i].id] = one.nodes[i].id;
  }
  return ids;
}

TEST_P(Belief, OfM3DoesNotDependOnWhatThingsAreCalled) {
  if (mode != Mode::M3) GTEST_SKIP() << "M2 tells ids";
  const Scene renamed = called_otherwise(start);
  const auto ids = other_ids(start, renamed);
  std::vector<Action> expected = done_in(start);
  for (Action& action : expected) {
    for (std::string& id : action.args) {
      if (const auto other = ids.find(id); other != ids.end()) id = other->second;
    }
  }
  // Slices are made on the way, with ids of their own.
  EXPECT_THAT(texts_of(done_in(renamed)), ::testing::ElementsAreArray(texts_of(expected)));
}

/// Shows now one home and now the other, which is the same but for its ids.
class Alternating : public Window {
 public:
  /// `renamed`: what a thing of the one home is called in the other, and back.
  Alternating(EpisodeWindow& one, EpisodeWindow& other, std::map<std::string, std::string> renamed)
      : windows_{&one, &other}, renamed_(std::move(renamed)) {}
  const Scene& known_scene() const override { return windows_[0]->known_scene(); }
  std::vector<Node> view() const override { return windows_[shown_]->view(); }
  const Agent& body() const override { return windows_[shown_]->body(); }
  Outcome act(const Action& action) override {
    Action there = action;  // a box may differ where two things touch a pixel
    for (std::string& name : there.args) name = name_there(name);
    const Outcome outcome = windows_[shown_]->act(action);
    shown_ = 1 - shown_;
    EXPECT_EQ(windows_[shown_]->act(there).success, outcome.success) << to_text(there);
    return outcome;
  }

 private:
  std::string name_there(const std::string& name) const {
    const auto& here = windows_[shown_]->meant();
    const auto id = here.find(name);
    if (id == here.end()) return name;
    for (const auto& [other, meant] : windows_[1 - shown_]->meant()) {
      if (meant == renamed_.find(id->second)->second) return other;
    }
    return name;
  }
  std::array<EpisodeWindow*, 2> windows_;
  std::map<std::string, std::string> renamed_;
  std::size_t shown_ = 0;
};

TEST_P(Belief, OfM3DoesNotNoticeThatIdsChangeBetweenLooks) {
  if (mode != Mode::M3) GTEST_SKIP() << "M2 tells ids";
  const Scene renamed = called_otherwise(start);
  auto ones = *ExecutionTree::of(wanted, start, knowledge, profile);
  auto others = *ExecutionTree::of(wanted, renamed, knowledge, profile);
  EpisodeWindow one(ones, mode), other(others, mode);
  Alternating both(one, other, other_ids(start, renamed));
  EXPECT_FALSE(reach_by_belief(problem(), both));
  EXPECT_TRUE(one.reaches_goal());
  EXPECT_EQ(texts_of(one.done()), texts_of(done_in(start)));
}

TEST_P(Belief, LeadsToTheSameActionsInAWorldThatLooksTheSame) {
  const Witnessed seen = in(start);
  const auto twin = twin_of(start, shown());
  if (!twin) GTEST_SKIP() << "everything that is used is in view at the start";
  EXPECT_NE(twin->nodes.size(), start.nodes.size());
  const Witnessed other = in(*twin);
  EXPECT_TRUE(acted_alike(seen, other));
  EXPECT_LT(same_moments(seen, other), seen.moments.size()) << "the twin has to differ";
}

TEST_P(Belief, APlanIsRefusedWhoseBeginningDoesNotWork) {
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  const std::vector<Action> impossible(40, {ActionType::PickUp, {"nothing_1"}});
  const auto plan = find_plan_from(executions, {impossible, {}, false}, {});
  ASSERT_TRUE(std::holds_alternative<Rejection>(plan));
  EXPECT_EQ(std::get<Rejection>(plan).detail, "what was done does not fit what is believed of the home");
}

TEST_P(Belief, StepsThatOnlyServeToSeeAreMarkedAndNoOthers) {
  const Demonstration demonstration = shown();
  std::vector<Action> without;
  for (const DemonstrationStep& step : demonstration.steps) {
    EXPECT_TRUE(!step.search || may_be_search(step.action.type)) << to_text(step.action);
    EXPECT_TRUE(step.outcome.success) << to_text(step.action);
  }
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  ModeRules told = rules_of(Mode::M1);
  told.limits = rules_of(mode).limits;
  for (const DemonstrationStep& left_out : demonstration.steps) {
    if (!may_be_search(left_out.action.type)) continue;
    Rollout rollout(executions, told);
    for (const DemonstrationStep& step : demonstration.steps) {
      if (&step != &left_out) (void)rollout.go_on(step.action);
    }
    EXPECT_EQ(rollout.reaches_goal(), left_out.search || left_out.tidying) << to_text(left_out.action);
  }
}

TEST_P(Belief, KeepsAPlanOfOneWhoIsToldEverythingBesideIt) {
  const Demonstration demonstration = shown();
  EXPECT_LE(demonstration.shortest.size(), demonstration.steps.size());
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  Rollout rollout(executions, rules_of(Mode::M1));
  rollout.go_on(demonstration.shortest);
  EXPECT_EQ(rollout.done(), demonstration.shortest);
  EXPECT_TRUE(rollout.reaches_goal());
  for (const Action& action : demonstration.shortest) EXPECT_TRUE(offers(info(action.type), mode));
}

INSTANTIATE_TEST_SUITE_P(All, Belief,
                         ::testing::Combine(::testing::Values(Mode::M2, Mode::M3), ::testing::ValuesIn(kBeliefCases)),
                         [](const auto& param) {
                           return std::string(name_of(std::get<0>(param.param))) + "_" + std::get<1>(param.param).name;
                         });

/// Shows the television only to who turns to it.
class TelevisionInTheBack : public EpisodeWindow {
 public:
  using EpisodeWindow::EpisodeWindow;
  std::vector<Node> view() const override {
    auto seen = EpisodeWindow::view();
    if (!turned_to_) std::erase_if(seen, [](const Node& node) { return node.id == "television_1"; });
    return seen;
  }
  Outcome act(const Action& action) override {
    turned_to_ = turned_to_ || action == Action{ActionType::TurnTo, {"television_1"}};
    return EpisodeWindow::act(action);
  }

 private:
  bool turned_to_ = false;
};

TEST(BeliefExpert, LooksAtFurnitureBeforeItIsSwitched) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene scene = house();
  set_state(scene, "microwave_1", Predicate::PowerOn);  // the television is off already
  const Scene start = at_rest(std::move(scene));
  const Formula off = goal("(forall (?x - (either Microwave Television)) (at-end (power_off ?x)))");
  auto executions = *ExecutionTree::of(off, start, knowledge, profile);
  TelevisionInTheBack window(executions, Mode::M2);
  const auto trouble = reach_by_belief({off, knowledge, profile}, window);
  EXPECT_FALSE(trouble) << trouble->text;
  EXPECT_TRUE(window.reaches_goal());
  EXPECT_THAT(window.done(), ::testing::Contains(Action{ActionType::TurnTo, {"television_1"}}));
}

/// What is looked for is told apart by its color alone, and is in the other room.
TEST(BeliefExpert, DoesNotKnowWhichFurnitureLooksHowBeforeItHasSeenIt) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Formula wanted =
      goal("(exists (?x - Apple) (exists (?y - (SideTable :where (colour ?y red))) (at-end (on ?x ?y))))");
  std::vector<Witnessed> seen;
  std::vector<std::string> put_down;
  for (const auto& [first, second] : {std::pair("red", "blue"), std::pair("blue", "red")}) {
    Scene scene = house();
    edit_node(scene, "sidetable_1")->color = first;
    edit_node(scene, "sidetable_2")->color = second;
    const Scene start = at_rest(std::move(scene));
    auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
    EpisodeWindow window(executions, Mode::M2);
    WitnessWindow witness(window);
    const auto trouble = reach_by_belief({wanted, knowledge, profile}, witness);
    EXPECT_FALSE(trouble) << trouble->text;
    EXPECT_TRUE(window.reaches_goal());
    seen.push_back(witness.seen());
    for (const Action& action : window.done())
      if (action.type == ActionType::PlaceOn) put_down.push_back(action.args.front());
  }
  EXPECT_TRUE(acted_alike(seen[0], seen[1]));
  EXPECT_LT(same_moments(seen[0], seen[1]), seen[0].moments.size());
  EXPECT_THAT(put_down, ::testing::ElementsAre("sidetable_1", "sidetable_2"));
}

/// When all is done it looks once more for what the goal speaks of all of, in what is shut, too.
TEST(BeliefExpert, ClosesWhatItOpenedForItsLastLooks) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene scene = house();
  int number = 1;  // so many that not all are opened before anything is done
  for (const double x : {5.5, 6.35, 7.2}) {
    add(scene, knowledge, "fridge_" + std::to_string(++number), "Fridge", x, 0.4, 0, std::numbers::pi);
    if (x < 6.5) add(scene, knowledge, "fridge_" + std::to_string(++number), "Fridge", x, 3.55, 0);
  }
  add(scene, knowledge, "fridge_7", "Fridge", 0.6, 0.4, 0, std::numbers::pi);
  add(scene, knowledge, "fridge_8", "Fridge", 4.2, 0.4, 0, std::numbers::pi);
  const Scene start = at_rest(std::move(scene));
  const Formula wanted = goal("(exists (?y - DiningTable) (forall (?x - Apple) (at-end (on ?x ?y))))");
  for (const Mode mode : {Mode::M2, Mode::M3}) {
    auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
    EpisodeWindow window(executions, mode);
    const auto trouble = reach_by_belief({wanted, knowledge, profile, nullptr, mode}, window);
    EXPECT_FALSE(trouble) << trouble->text;
    EXPECT_TRUE(window.reaches_goal());
    std::set<std::string> open;
    std::size_t opened = 0;
    for (const Action& action : window.done()) {
      if (action.type == ActionType::Open) ++opened, open.insert(action.args.front());
      if (action.type == ActionType::Close) open.erase(action.args.front());
    }
    EXPECT_GT(opened, 0U) << name_of(mode);
    EXPECT_THAT(open, IsEmpty()) << ::testing::PrintToString(texts_of(window.done()));
  }
}

TEST(ActedAlike, FindsWhoActsOnWhatWasNotShown) {
  Witnessed one;
  one.moments.resize(3);
  one.actions = {{ActionType::TurnLeft, {}}, {ActionType::Stop, {}}};
  one.outcomes.assign(2, Outcome{.success = true, .failure = Failure::None, .feedback = ""});
  Witnessed other = one;
  EXPECT_TRUE(acted_alike(one, other));
  other.actions[1] = {ActionType::TurnRight, {}};
  EXPECT_FALSE(acted_alike(one, other));
  other.moments[1].body.yaw = 1;  // which may be why
  EXPECT_TRUE(acted_alike(one, other));
  other.actions[0] = {ActionType::TurnRight, {}};
  EXPECT_FALSE(acted_alike(one, other));
}

TEST(KnownHome, IsOfABelievedHomeWhatIsComputedOfThatAlone) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = at_rest(house());
  const Formula wanted = goal("(exists (?x - Mug) (at-end (held ?x)))");
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  EpisodeWindow window(executions, Mode::M2);
  KnownHome home(window.known_scene(), profile);
  Scene believed = window.known_scene();
  for (const Node& node : start.nodes) {
    if (node.movable) believed.nodes.push_back(node);
  }
  set_state(believed, "fridge_1", Predicate::Open);  // its door is in the way
  edit_node(believed, "fridge_1")->opening = 1;
  believed.agent.position += Vec2(0.2, 0);
  Scene alone = believed;
  alone.edges = EdgeSet(read_relations(alone));
  const Walk walk = walk_in(alone, profile);
  const KnownStart known = home.of(believed);
  EXPECT_EQ(std::vector<Edge>(believed.edges.begin(), believed.edges.end()),
            std::vector<Edge>(alone.edges.begin(), alone.edges.end()));
  EXPECT_EQ(known.walk->grid.digest(), walk.grid.digest());
  EXPECT_EQ(known.walk->grid.free_cells(), walk.grid.free_cells());
  EXPECT_EQ(known.walk->reached, walk.reached);
  EXPECT_NE(walk.grid.digest(), home.start().walk->grid.digest());
  Scene shorter = window.known_scene();  // and with less furniture
  shorter.nodes.pop_back();
  const Walk less = walk_in(shorter, profile);
  EXPECT_EQ(home.of(shorter).walk->grid.digest(), less.grid.digest());
}

TEST(KnownHome, IsTheSameWhateverWasBelievedBefore) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = at_rest(house());
  auto executions = *ExecutionTree::of(goal("(exists (?x - Mug) (at-end (held ?x)))"), start, knowledge, profile);
  EpisodeWindow window(executions, Mode::M2);
  const Scene& bare = window.known_scene();
  Scene full = bare;
  for (const Node& node : start.nodes) {
    if (node.movable) full.nodes.push_back(node);
  }
  Scene opened = full;
  set_state(opened, "fridge_1", Predicate::Open);
  edit_node(opened, "fridge_1")->opening = 1;
  Scene fewer = full;  // all but one, so that others take its place in the list
  std::string gone;
  erase_if(fewer.nodes, [&](const Node& node) {
    if (node.movable && gone.empty()) return gone = node.id, true;
    return false;
  });
  Scene holding = full;
  holding.agent.held = {gone};
  KnownHome home(bare, profile);
  for (const Scene* believed :
       std::vector<const Scene*>{&full, &opened, &fewer, &full, &holding, &bare, &fewer, &opened}) {
    Scene one = *believed, other = *believed;
    KnownHome new_home(bare, profile);
    const KnownStart after = home.of(one), alone = new_home.of(other);
    EXPECT_EQ(std::vector<Edge>(one.edges.begin(), one.edges.end()),
              std::vector<Edge>(other.edges.begin(), other.edges.end()));
    EXPECT_EQ(after.walk->grid.digest(), alone.walk->grid.digest());
    EXPECT_EQ(after.walk->reached, alone.walk->reached);
    ASSERT_EQ(after.links.has_value(), alone.links.has_value());
    for (std::size_t i = 0; after.links && i < one.nodes.size(); ++i) {
      EXPECT_EQ(after.links->of(i), alone.links->of(i)) << one.nodes[i].id;
      EXPECT_EQ(after.links->carried(i), alone.links->carried(i)) << one.nodes[i].id;
    }
    for (std::size_t i = 0; i < start.nodes.size() + 1; ++i)
      EXPECT_EQ(after.physics.has(BodyId::node(i)), alone.physics.has(BodyId::node(i)));
  }
}

TEST(BeliefOfFurniture, IsWhatTheGoalPresupposesUntilItIsSeen) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = at_rest(house());
  const Formula off = goal("(exists (?x - Television) (at-end (power_off ?x)))");
  auto executions = *ExecutionTree::of(off, start, knowledge, profile);
  EpisodeWindow window(executions, Mode::M2);
  unietp::Belief belief(window.known_scene(), search_needs(off), {"Television"});
  EXPECT_TRUE(belief.find("television_1")->states.has(Predicate::PowerOn));
  EXPECT_FALSE(belief.has_seen("television_1"));
  Node seen = *find_node(start, "fridge_1");
  const int before = belief.news();
  belief.see({seen}, start.agent);
  EXPECT_EQ(belief.news(), before) << "a fridge is no news for who has to do with televisions";
  EXPECT_TRUE(belief.has_seen("fridge_1"));
  seen = *find_node(start, "television_1");
  belief.see({seen}, start.agent);
  EXPECT_EQ(belief.find("television_1")->states, seen.states);
  EXPECT_GT(belief.news(), before);
}

}  // namespace
}  // namespace unietp::testing
