#include "symbolic/witness.h"

#include <gtest/gtest.h>

#include "generator/specification.h"
#include "logic/evaluate.h"
#include "symbolic/reach.h"
#include "tests/generator/naive_scene.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

using namespace symbolic;

Specification about(Simulator simulator, const std::string& goal, const std::vector<std::string>& init,
                    const Binding& tools = {}) {
  Specification made;
  made.simulator = simulator;
  made.binding = tools;
  auto read = parse_formula("test", goal, FormulaUse::Goal);
  EXPECT_TRUE(read) << format(read.error());
  made.goal = *read;
  for (const auto& text : init) made.init.push_back(*parse_formula("test", text, FormulaUse::State));
  return made;
}

struct Case {
  Simulator simulator;
  const char* goal;
  std::vector<std::string> init;
  Binding tools;
};

/// Goals of shapes that no template may have now, each with what it needs at hand.
TEST(Witness, IsFoundForEachOperatorOfGoals) {
  const std::vector<Case> cases = {
      {Simulator::Ai2thor, "(exists (?a - Mug) (at-end (held ?a)))", {}, {}},
      {Simulator::Ai2thor,
       "(exists (?a - Mug) (exists (?b - CounterTop) (at-end (on ?a ?b))))",
       {"(forall (?a - Mug) (not (exists (?b - CounterTop) (on ?a ?b))))"},
       {}},
      {Simulator::Ai2thor,
       "(exists (?f - Fridge) (at-end (count = 2 (?a - Tomato) (inside ?a ?f))))",
       {"(count >= 3 (?a - Tomato) (and))", "(forall (?a - Tomato) (not (exists (?f - Fridge) (inside ?a ?f))))"},
       {}},
      {Simulator::Ai2thor,
       "(exists (?a - Mug) (before (dirty ?a) (clean ?a)))",
       {"(forall (?a - Mug) (dirty ?a))"},
       {{"T", "Sink"}}},
      {Simulator::Ai2thor,
       "(exists (?f - Fridge) (until (closed ?f) (exists (?a - Mug) (hot ?a))))",
       {"(forall (?f - Fridge) (closed ?f))", "(forall (?a - Mug) (not (hot ?a)))"},
       {{"T", "Microwave"}}},
      {Simulator::Habitat,
       "(and (exists (?a - fridge) (sometime (open ?a))) (exists (?a - fridge) (at-end (closed ?a))))",
       {"(forall (?a - fridge) (closed ?a))"},
       {}},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.goal);
    const auto made = about(one.simulator, one.goal, one.init, one.tools);
    const auto& knowledge = committed_knowledge(one.simulator);
    const NaiveScenes scenes(made, knowledge, Rng(1));
    const auto scene = scenes.draw(Rng(2));
    ASSERT_TRUE(scene);
    const auto plan = find_witness(made.goal, scene->setting, scene->start);
    ASSERT_TRUE(plan);
    EXPECT_TRUE(holds(made.goal, trace_of(scene->setting, replay(scene->setting, scene->start, *plan))));
  }
}

/// Each comparison of a count with a number or another count, from a start in which it does not hold.
TEST(Witness, IsFoundForEachComparisonOfCountsAndDoesNoMoreThanItAsks) {
  const std::string outside = "(forall (?a - Tomato) (not (exists (?f - Fridge) (inside ?a ?f))))";
  const std::string inside = "(forall (?a - Tomato) (exists (?f - Fridge) (inside ?a ?f)))";
  const std::string three = "(count = 3 (?a - Tomato) (and))", two = "(count = 2 (?b - Egg) (and))";
  const std::string eggs = "(forall (?b - Egg) (exists (?f - Fridge) (inside ?b ?f)))";
  const std::string numbers = "(number (?a - Tomato) (inside ?a ?f)) (number (?b - Egg) (inside ?b ?f))";
  struct Count {
    std::string goal, init;
    std::size_t moved;  // the least number of things that go into or out of the fridge
  };
  const std::vector<Count> counts{{"> 1 (?a - Tomato) (inside ?a ?f)", outside, 2},
                                  {">= 1 (?a - Tomato) (inside ?a ?f)", outside, 1},
                                  {"< 2 (?a - Tomato) (inside ?a ?f)", inside, 2},
                                  {"<= 2 (?a - Tomato) (inside ?a ?f)", inside, 1},
                                  {"= 2 (?a - Tomato) (inside ?a ?f)", inside, 1},
                                  {"> " + numbers, outside, 1},
                                  {"< " + numbers, inside, 2}};
  for (const auto& [count, init, moved] : counts) {
    SCOPED_TRACE(count);
    const std::string held =
        count.starts_with("< (number") ? eggs : "(forall (?b - Egg) (not (exists (?f - Fridge) (inside ?b ?f))))";
    const auto made = about(Simulator::Ai2thor, "(exists (?f - Fridge) (at-end (count " + count + ")))",
                            {three, two, "(count = 1 (?f - Fridge) (and))", init, held});
    const NaiveScenes scenes(made, committed_knowledge(Simulator::Ai2thor), Rng(1));
    const auto scene = scenes.draw(Rng(2));
    ASSERT_TRUE(scene);
    const auto plan = find_witness(made.goal, scene->setting, scene->start);
    ASSERT_TRUE(plan);
    EXPECT_TRUE(holds(made.goal, trace_of(scene->setting, replay(scene->setting, scene->start, *plan))));
    const auto picked = static_cast<std::size_t>(
        std::count_if(plan->begin(), plan->end(), [](const Step& step) { return step.action == ActionType::PickUp; }));
    EXPECT_EQ(picked, moved);
  }
}

TEST(Witness, IsNoneWhereTheGoalHoldsAlready) {
  const auto made =
      about(Simulator::Ai2thor, "(exists (?a - Fridge) (at-end (open ?a)))", {"(forall (?a - Fridge) (open ?a))"});
  const NaiveScenes scenes(made, committed_knowledge(Simulator::Ai2thor), Rng(1));
  const auto scene = scenes.draw(Rng(2));
  ASSERT_TRUE(scene);
  EXPECT_FALSE(find_witness(made.goal, scene->setting, scene->start));
}

/// The relaxation may promise too much, never too little: what a walk at random makes true was within reach.
TEST(Reach, CoversWhateverRandomActionsBringAbout) {
  const std::vector<std::pair<Simulator, std::vector<std::string>>> casts = {
      {Simulator::Ai2thor,
       {"Mug", "Apple", "Knife", "Fridge", "Microwave", "SinkBasin", "CoffeeMachine", "CounterTop", "WineBottle",
        "StoveBurner", "Pan", "Bread"}},
      {Simulator::Behavior,
       {"mug", "apple", "carving_knife", "fridge", "microwave", "furniture_sink", "countertop", "rag", "oven",
        "breakfast_table", "bowl"}},
      {Simulator::Virtualhome, {"mug", "apple", "fridge", "microwave", "kitchentable", "plate", "kitchencabinet"}}};
  std::size_t changes = 0;
  for (const auto& [simulator, categories] : casts) {
    Specification made;
    made.simulator = simulator;
    for (const auto& category : categories) {
      ASSERT_NE(committed_knowledge(simulator).find(category), nullptr) << category;
      made.binding.emplace_back(category, category);
    }
    const NaiveScenes scenes(made, committed_knowledge(simulator), Rng(3));
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      Rng rng(seed);
      const auto scene = scenes.draw(rng.fork("scene", 0));
      ASSERT_TRUE(scene);
      const Reach reach(scene->setting, scene->start);
      World world = scene->start;
      const auto things = world.things.size();
      for (int i = 0; i < 300; ++i) {
        const auto target = Id::thing(rng.below(things));
        if (rng.chance(0.6)) perform(scene->setting, world, {ActionType::GoTo, target});
        const auto action = static_cast<ActionType>(rng.below(kActionCount));
        if (action == ActionType::GoTo) continue;
        if (perform(scene->setting, world, {action, target}) == Failure::None) ++changes;
        const auto other = Id::thing(rng.below(things));
        for (const auto& predicate : all_predicates()) {
          Atom atom{predicate.predicate, target, kNobody, kAnySymbol};
          if (predicate.arguments.size() == 2 && predicate.arguments[1] == ArgumentKind::Object) atom.second = other;
          if (predicate.arguments.size() == 2 && predicate.arguments[1] == ArgumentKind::Room)
            atom.second = Id::room(0);
          if (atom.predicate == Predicate::Nearest || atom.second == target) continue;
          const bool now = holds(scene->setting, world, atom.predicate, target, atom.second, kAnySymbol);
          ASSERT_TRUE(reach.may(atom, now)) << predicate.name << " of " << scene->setting.objects.object(target).id
                                            << " is " << now << " on " << name_of(simulator) << " seed " << seed;
        }
      }
    }
  }
  EXPECT_GT(changes, 3000U);
}

}  // namespace
}  // namespace unietp
