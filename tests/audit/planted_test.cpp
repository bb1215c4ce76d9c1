#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "audit/audit.h"
#include "audit/task_questions.h"
#include "logic/formula.h"
#include "planted_set.h"

namespace unietp {
namespace {

using ::testing::Eq;
using ::testing::IsEmpty;
using testing::MadeTask;
using ::testing::Not;
using testing::Plant;

constexpr int kHomes = 50;

std::vector<AuditedTask> audited(const std::vector<MadeTask>& made) {
  std::vector<AuditedTask> tasks;
  for (const MadeTask& one : made) tasks.push_back(audited_task(one.task));
  return tasks;
}

std::vector<AuditedTask> audited(const Plant& plant, bool is_aimed) {
  return audited(planted(testing::made_set(kHomes, Rng(5)), plant, is_aimed, Rng(6)));
}

/// Where the one policy does better than chance, as improbably as if all the others were played too.
std::vector<std::string> leaks_of(std::string_view policy, std::vector<AuditedTask> tasks,
                                  std::vector<AuditedTask> training = {}) {
  AuditSettings settings = whole_audit();
  std::erase_if(settings.policies, [&](const ShortcutPolicy* one) { return one->name != policy; });
  EXPECT_EQ(settings.policies.size(), 1U) << policy;
  std::vector<std::string> found;
  for (const AuditCell& cell : audit(std::move(tasks), std::move(training), settings).cells) {
    if (cell.p * static_cast<double>(shortcut_policies().size()) < kAuditLevel)
      found.push_back(std::string(name_of(cell.mode)) + " " + cell.group);
  }
  return found;
}

std::string name_of_plant(const ::testing::TestParamInfo<Plant>& plant) {
  std::string name(plant.param.policy);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class PlantedLeak : public ::testing::TestWithParam<Plant> {};
INSTANTIATE_TEST_SUITE_P(Policies, PlantedLeak, ::testing::ValuesIn(testing::plants()), name_of_plant);

TEST_P(PlantedLeak, IsFound) { EXPECT_THAT(leaks_of(GetParam().policy, audited(GetParam(), true)), Not(IsEmpty())); }

/// All but those that change what the demonstration begins with, which are done to no thing.
std::vector<Plant> done_to_things() {
  auto plants = testing::plants();
  std::erase_if(plants, [](const Plant& plant) { return plant.policy.find("first-object") != std::string_view::npos; });
  return plants;
}
class DecoyPlant : public ::testing::TestWithParam<Plant> {};
INSTANTIATE_TEST_SUITE_P(Policies, DecoyPlant, ::testing::ValuesIn(done_to_things()), name_of_plant);

/// The same done to things drawn at random gives nothing away.
TEST_P(DecoyPlant, IsNoLeak) { EXPECT_THAT(leaks_of(GetParam().policy, audited(GetParam(), false)), IsEmpty()); }

TEST(Audit, EveryPolicyHasAPlantedLeak) {
  std::vector<std::string_view> policies, planted;
  for (const ShortcutPolicy& policy : shortcut_policies()) policies.push_back(policy.name);
  for (const Plant& plant : testing::plants()) planted.push_back(plant.policy);
  EXPECT_THAT(planted, Eq(policies));
  EXPECT_GE(policies.size(), 20U);
}

GuessOption thing_of(const MadeTask& made, const std::string& id) {
  const auto& nodes = made.task.start.nodes;
  const auto at = std::find_if(nodes.begin(), nodes.end(), [&](const Node& node) { return node.id == id; });
  return audited_task(made.task).things[static_cast<std::size_t>(at - nodes.begin())];
}

/// Whether a thing is clean tells nothing where the instruction says that something is to be cleaned, and it looks then
/// as clean things do in other homes.
TEST(Audit, TakesStatesThatTheGoalSpeaksOfAsTheyAreAtFirst) {
  MadeTask made = testing::made_set(1, Rng(3)).front();
  const auto key = [&](const char* goal, Predicate state) {
    made.task.record.goal_tree = *parse_formula("goal", goal, FormulaUse::Goal);
    edit_node(made.task.start, made.furniture)->states.set({state, ""});
    return thing_of(made, made.furniture).states;
  };
  const char* to_clean = "(exists (?x - Mug) (at-end (clean ?x)))";
  const char* to_hold = "(exists (?x - Mug) (at-end (held ?x)))";
  EXPECT_NE(key(to_hold, Predicate::Dirty), key(to_hold, Predicate::Clean));
  EXPECT_EQ(key(to_clean, Predicate::Dirty), key(to_clean, Predicate::Clean));
  EXPECT_EQ(key(to_clean, Predicate::Dirty), key(to_hold, Predicate::Clean));
}

/// What is poured out is full, so neither being full nor not being empty sets it apart.
TEST(Audit, TakesFullAndEmptyForOneTrait) {
  MadeTask made = testing::made_set(1, Rng(3)).front();
  const auto key = [&](const char* goal, State state) {
    made.task.record.goal_tree = *parse_formula("goal", goal, FormulaUse::Goal);
    Node& node = *edit_node(made.task.start, made.furniture);
    node.states = {};
    for (const State& one : {state, State{Predicate::Intact, ""}}) node.states.set(one);
    return thing_of(made, made.furniture).states;
  };
  const State empty{Predicate::Empty, ""}, full{Predicate::Filled, "water"};
  const char* to_hold = "(exists (?x - Mug) (at-end (held ?x)))";
  EXPECT_NE(key(to_hold, full), key(to_hold, empty));
  for (const char* goal :
       {"(exists (?x - Mug) (at-end (empty ?x)))", "(exists (?x - Mug) (at-end (filled ?x water)))"}) {
    EXPECT_EQ(key(goal, full), key(goal, empty)) << goal;
    EXPECT_EQ(key(goal, full), key(to_hold, empty)) << goal;
  }
}

/// "Leave one mug on the bed" says that mugs are on it.
TEST(Audit, TakesPlacesThatTheGoalNamesForNothingUnusual) {
  MadeTask made = testing::made_set(1, Rng(3)).front();
  const auto is_where_asked = [&](const char* goal, const std::string& id) {
    made.task.record.goal_tree = *parse_formula("goal", goal, FormulaUse::Goal);
    return thing_of(made, id).is_where_asked;
  };
  const Scene& start = made.task.start;
  const auto on = std::find_if(start.edges.begin(), start.edges.end(),
                               [](const Edge& edge) { return edge.relation == Predicate::On; });
  const std::string below = find_node(start, on->to)->category, thing = on->from;
  const std::string named = "(exists (?x - Mug) (exists (?y - " + below + ") (at-end (on ?x ?y))))";
  EXPECT_TRUE(is_where_asked(named.c_str(), thing));
  EXPECT_FALSE(is_where_asked("(exists (?x - Mug) (at-end (held ?x)))", thing));
  EXPECT_TRUE(
      is_where_asked("(exists (?x - Mug) (exists (?r - kitchen) (at-end (not (on_floor ?x ?r)))))", made.furniture));
  EXPECT_FALSE(is_where_asked("(exists (?x - Mug) (exists (?r - kitchen) (at-end (not (on_floor ?x ?r)))))", thing));
}

/// Nothing that stands where the goal speaks of is unusual there.
TEST(Audit, FindsNothingInAPlaceThatTheGoalNames) {
  const auto plant = std::find_if(testing::plants().begin(), testing::plants().end(),
                                  [](const Plant& one) { return one.policy == "unusual-place"; });
  auto made = planted(testing::made_set(kHomes, Rng(5)), *plant, true, Rng(6));
  for (MadeTask& one : made) {
    Formula& goal = one.task.record.goal_tree;
    Formula box = *parse_formula("goal", "(exists (?b - Box) (at-end (closed ?b)))", FormulaUse::Goal);
    goal = conjunction({goal, box});
  }
  EXPECT_THAT(leaks_of("unusual-place", audited(made)), IsEmpty());
}

TEST(Audit, FindsNothingWhereNothingIsPlanted) {
  const auto report = audit(audited(testing::made_set(kHomes, Rng(5))), {}, whole_audit());
  for (const AuditCell& cell : report.cells) {
    EXPECT_FALSE(cell.leaks()) << cell.policy->name << " " << cell.group << " " << cell.right << " of " << cell.asked;
    EXPECT_LE(cell.low, cell.chance);
    EXPECT_LE(cell.chance, cell.high);
  }
  EXPECT_GT(report.cells.size(), 200U);
}

/// Apples and books are what goals are about most often, and the only things that are dirty at times: a model that
/// knows other homes profits by that, and nothing in the home at hand gives anything away.
TEST(Audit, TakesForKnownHowThingsOfAKindAreElsewhere) {
  auto made = testing::made_set(3 * kHomes, Rng(5));
  const auto is_usual = [](const std::string& category) { return category == "Apple" || category == "Book"; };
  std::erase_if(made, [&, number = 0](const MadeTask& one) mutable {
    return !is_usual(find_node(one.task.start, one.small_thing)->category) && ++number % 4 != 0;
  });
  for (MadeTask& one : made) {
    for (std::size_t i = 0; i < one.task.start.nodes.size(); ++i) {
      Node& node = one.task.start.nodes.edit(i);
      if (!is_usual(node.category)) node.states.set({Predicate::Clean, ""});
    }
  }
  const auto tasks = audited(made);
  EXPECT_THAT(leaks_of("list-classifier", tasks), IsEmpty());
  EXPECT_GT(made.size(), 100U);
}

TEST(Audit, IsTheSameWithAnyNumberOfThreads) {
  const auto tasks = audited(testing::made_set(6, Rng(1)));
  AuditSettings settings = whole_audit();
  const std::string one = audit_json(audit(tasks, {}, settings));
  settings.threads = 3;
  EXPECT_EQ(audit_json(audit(tasks, {}, settings)), one);
}

TEST(Audit, LearnsFromATrainingSet) {
  const auto plant = std::find_if(testing::plants().begin(), testing::plants().end(),
                                  [](const Plant& one) { return one.policy == "kind-classifier"; });
  const auto training = audited(*plant, true);
  auto few = planted(testing::made_set(60, Rng(8)), *plant, true, Rng(9));
  for (MadeTask& one : few) one.task.record.layout = "one home";  // no other home to learn from
  EXPECT_THAT(leaks_of("kind-classifier", audited(few)), IsEmpty());
  EXPECT_THAT(leaks_of("kind-classifier", audited(few), training), Not(IsEmpty()));
}

}  // namespace
}  // namespace unietp
