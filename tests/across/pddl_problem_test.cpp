// Drawn scenes in PDDL, beside what the symbols say.
#include "pddl/problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "core/text.h"
#include "logic/evaluate.h"
#include "pddl/domain.h"
#include "pddl/plan.h"
#include "symbolic/witness.h"
#include "templates/template.h"
#include "tests/generator/naive_scene.h"
#include "tests/pddl/reader.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

using testing::PddlFact;
using testing::PddlMachine;

const std::vector<Template>& library() {
  static const auto kRead = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates/library").templates;
  return kRead;
}

const testing::PddlDomain& domain_of(Simulator simulator) {
  static std::map<Simulator, testing::PddlDomain> read;
  auto found = read.find(simulator);
  if (found == read.end())
    found = read.emplace(simulator, testing::read_pddl_domain(pddl::domain_text(committed_knowledge(simulator)))).first;
  return found->second;
}

PddlFact words(const std::string& step) { return testing::read_pddl_plan(step).front(); }

bool is_of_monitors(const PddlFact& fact) {
  static const std::set<std::string> kNames{"watching", "ready",    "to-note", "to-judge",   "now",     "seen",
                                            "missed",   "in-order", "ordered", "kept-until", "not-kept"};
  return kNames.count(fact[0]) > 0 || fact[0].starts_with("watches-");
}

/// What differs between the machine's state and a world's facts.
std::string difference(const PddlMachine& machine, const NaiveScene& scene, const symbolic::World& world,
                       const pddl::Problem& problem) {
  std::set<PddlFact> wanted;
  for (const auto& fact : pddl::facts_of(scene.setting, world, problem)) wanted.insert(words(fact));
  std::string text;
  for (const auto& fact : machine.state()) {
    if (!is_of_monitors(fact) && wanted.count(fact) == 0) text += " too much: " + join(fact, " ");
  }
  for (const auto& fact : wanted) {
    if (machine.state().count(fact) == 0) text += " missing: " + join(fact, " ");
  }
  return text;
}

/// Of how many conjunctions of literals a condition is one of, as planners write it that know no other form.
double cases_of(const testing::PddlList& condition) {
  const auto& op = condition.parts.front().word;
  if (op != "and" && op != "or") return 1;
  double cases = op == "and" ? 1 : 0;
  for (std::size_t i = 1; i < condition.parts.size(); ++i) {
    const double part = cases_of(condition.parts[i]);
    cases = op == "and" ? cases * part : cases + part;
  }
  return cases;
}

struct Drawn {
  Specification specification;
  std::unique_ptr<NaiveScenes> scenes;
  std::optional<NaiveScene> scene;
};

std::unique_ptr<Drawn> draw(const Template& source, Simulator simulator, std::uint64_t seed) {
  const auto& knowledge = committed_knowledge(simulator);
  const Rng rng = Rng(seed).fork(source.name, static_cast<std::uint64_t>(simulator));
  const auto binding = sample_binding(source, knowledge, {}, rng);
  if (!binding) return nullptr;
  auto made = instantiate(source, knowledge, *binding);
  if (!made) return nullptr;
  auto drawn = std::make_unique<Drawn>();
  drawn->specification = std::move(*made);
  drawn->scenes = std::make_unique<NaiveScenes>(drawn->specification, knowledge, rng.fork("bystanders", 0));
  drawn->scene = drawn->scenes->draw(rng.fork("scene", 0));
  return drawn->scene ? std::move(drawn) : nullptr;
}

/// A goal in a drawn scene, and its problem in PDDL.
struct Posed {
  std::unique_ptr<Drawn> drawn;
  symbolic::Goal goal;
  pddl::Problem problem;
  const NaiveScene& scene() const { return *drawn->scene; }
  auto witness() const { return find_witness(drawn->specification.goal, scene().setting, scene().start); }
  auto plan(const std::vector<Action>& actions) const {
    return pddl::plan_for(scene().setting, scene().start, goal, problem, actions, {});
  }
};

Result<Posed> pose(const Template& source, Simulator simulator, std::uint64_t seed) {
  auto drawn = draw(source, simulator, seed);
  if (drawn == nullptr) return Error{Error::Kind::Unsatisfiable, "", {}, "no scene was drawn"};
  const NaiveScene& scene = *drawn->scene;
  symbolic::Goal goal(drawn->specification.goal, scene.setting, scene.start);
  auto problem = pddl::problem_for(source.name, simulator, scene.setting, scene.start, goal);
  if (!problem) return problem.error();
  return Posed{std::move(drawn), std::move(goal), std::move(*problem)};
}

std::vector<Action> actions_of(const std::vector<symbolic::Step>& steps, const symbolic::Setting& setting) {
  std::vector<Action> actions;
  for (const auto& step : steps) {
    actions.push_back({step.action, {}});
    if (step.target.is_room()) actions.back().args.push_back(setting.objects.room(step.target).id);
    if (step.target.is_thing()) actions.back().args.push_back(setting.objects.object(step.target).id);
  }
  return actions;
}

/// Symbols say what is true after each step; the exported actions, read and executed by a reader that knows only PDDL,
/// make the same of it, and reach the goal with the last step and not before.
TEST(PddlProblem, AWitnessIsAPlanOfItAndEachStepDoesWhatTheSymbolsDo) {
  std::size_t written = 0, watching = 0, singly = 0;
  double most_cases = 0;
  std::map<std::string, std::string> left_out;
  for (const auto& source : library()) {
    for (const auto simulator : source.simulators) {
      SCOPED_TRACE(source.name + " " + std::string(name_of(simulator)));
      const auto posed = pose(source, simulator, 1);
      if (!posed) {
        left_out[source.name] = posed.error().message;
        continue;
      }
      const auto& scene = posed->scene();
      const auto* const problem = &posed->problem;
      const auto plan = posed->witness();
      ASSERT_TRUE(plan);
      const auto& domain = domain_of(simulator);
      testing::PddlProblem read;
      ASSERT_NO_THROW(read = testing::read_pddl_problem(problem->text, domain)) << problem->text;
      EXPECT_LE(cases_of(read.goal), 20'000) << problem->text;
      most_cases = std::max(most_cases, cases_of(read.goal));
      PddlMachine machine(domain, read);
      auto world = scene.start;
      ASSERT_EQ(difference(machine, scene, world, *problem), "");
      for (const auto& step : *plan) {
        ASSERT_FALSE(machine.goal_holds()) << "before " << to_text(scene.setting, step);
        for (const auto& one : pddl::written_as(scene.setting, *problem, world, step)) {
          const auto text = pddl::step_text(scene.setting, *problem, world, one);
          ASSERT_TRUE(machine.perform(words(text))) << text;
          ASSERT_EQ(perform(scene.setting, world, one), Failure::None);
          ASSERT_EQ(difference(machine, scene, world, *problem), "") << text;
          for (const char* watch : {"note", "judge"}) ASSERT_EQ(machine.perform({watch}), problem->watching);
          singly += one != step ? 1 : 0;
        }
      }
      ASSERT_TRUE(machine.goal_holds()) << problem->text;
      ++written;
      watching += problem->watching ? 1 : 0;
    }
  }
  for (const auto& [name, why] : left_out) std::cout << "left out " << name << ": " << why << "\n";
  std::cout << written << " problems, " << watching << " with monitors, goals of at most " << most_cases << " cases\n";
  EXPECT_GE(written, 300U);
  EXPECT_GE(watching, 30U);
  EXPECT_GE(singly, 10U) << "too few composite actions came about where each of their moments counts";
}

/// The same of steps drawn at random: the domain is nowhere stricter than the symbols, and does the same.
TEST(PddlProblem, WhateverTheSymbolsAllowTheActionsDo) {
  constexpr int kTries = 10;
  std::map<ActionType, int> done;
  for (const auto& source : library()) {
    for (const auto simulator : source.simulators) {
      SCOPED_TRACE(source.name + " " + std::string(name_of(simulator)));
      const auto posed = pose(source, simulator, 2);
      if (!posed) continue;
      const auto& scene = posed->scene();
      const auto* const problem = &posed->problem;
      const auto& domain = domain_of(simulator);
      const auto read = testing::read_pddl_problem(problem->text, domain);
      PddlMachine machine(domain, read);
      auto world = scene.start;
      const auto take = [&](const symbolic::Step& step) {
        auto then = world;
        const Failure failure = perform(scene.setting, then, step);
        if (failure != Failure::None) return failure;
        for (const auto& one : pddl::written_as(scene.setting, *problem, world, step)) {
          const auto text = pddl::step_text(scene.setting, *problem, world, one);
          EXPECT_TRUE(machine.perform(words(text))) << text;
          for (const char* watch : {"note", "judge"}) EXPECT_EQ(machine.perform({watch}), problem->watching);
          EXPECT_EQ(perform(scene.setting, world, one), Failure::None) << text;
          EXPECT_EQ(difference(machine, scene, world, *problem), "") << text;
        }
        EXPECT_EQ(world.held, then.held);
        ++done[step.action];
        return failure;
      };
      const auto reach = [&](const symbolic::Step& step) {
        const bool in_hand = world.held != symbolic::kNobody && rests_on(world, step.target, world.held);
        if (!world[step.target].exists || (step.action == ActionType::GoTo && in_hand)) return;
        if (take(step) == Failure::TooFar && take({ActionType::GoTo, step.target}) == Failure::None) take(step);
      };
      std::vector<std::pair<symbolic::Id, symbolic::Id>> pairs;  // a tool and what it does something to
      for (std::size_t t = 0; t < world.things.size(); ++t) {
        for (std::size_t i = 0; i < world.things.size(); ++i) {
          const auto tool = symbolic::Id::thing(t), thing = symbolic::Id::thing(i);
          const auto& rules = *scene.setting.rules;
          if (tool != thing &&
              !rules.reactions(scene.setting.kind_number(tool), scene.setting.kind_number(thing)).empty())
            pairs.emplace_back(tool, thing);
        }
      }
      Rng rng = Rng(7).fork(source.name, static_cast<std::uint64_t>(simulator));
      for (int tries = 0; tries < kTries && !HasFailure(); ++tries) {
        const symbolic::Step step{static_cast<ActionType>(rng.below(kActionCount)),
                                  symbolic::Id::thing(rng.below(world.things.size()))};
        const bool of_body = step.action <= ActionType::RotateHand || step.action == ActionType::TurnTo ||
                             step.action == ActionType::Stop;
        if (!of_body) reach(step);  // the others change no symbol
        if (pairs.empty()) continue;
        const auto& [tool, thing] = rng.pick(pairs);
        if (world.held != symbolic::kNobody) take({ActionType::Drop, symbolic::kNobody});
        reach({ActionType::PickUp, rng.chance(0.5) ? thing : tool});
        using enum ActionType;
        for (const auto action : {Open, TurnOn, Close, TurnOff}) {
          if (rng.chance(0.3)) reach({action, tool});
        }
        for (const auto action : {HeatWith, CoolWith, CookWith, BurnWith, WashWith, SoakWith, FillWith, Slice})
          reach({action, world.held == thing ? tool : thing});
        if (world.held == thing) reach({PlaceIn, tool});
      }
      if (HasFailure()) return;
    }
  }
  for (const auto& [action, times] : done) std::cout << info(action).name << " " << times << " ";
  std::cout << "\n";
  for (const auto action : {ActionType::PlaceIn, ActionType::Open, ActionType::TurnOn, ActionType::BurnWith,
                            ActionType::CookWith, ActionType::FillWith, ActionType::WashWith, ActionType::Slice})
    EXPECT_GE(done[action], 1) << info(action).name;
}

/// The shortest plan of the exported problem is no longer than the witness, and there is one.
TEST(PddlProblem, ASearchThatKnowsOnlyPddlFindsAPlan) {
  std::size_t found = 0;
  for (const char* name : {"open-one", "pick-up-one", "close-one", "switch-on-one"}) {
    const auto source = std::find_if(library().begin(), library().end(), [&](const auto& t) { return t.name == name; });
    ASSERT_NE(source, library().end()) << name;
    const auto posed = pose(*source, source->simulators.front(), 3);
    ASSERT_TRUE(posed) << format(posed.error());
    const auto plan = posed->witness();
    ASSERT_TRUE(plan);
    if (plan->size() > 2) continue;  // further is for real planners
    const auto& domain = domain_of(source->simulators.front());
    const auto read = testing::read_pddl_problem(posed->problem.text, domain);
    EXPECT_EQ(testing::shortest_pddl_plan(domain, read, 2), static_cast<int>(plan->size())) << name;
    ++found;
  }
  EXPECT_GE(found, 2U);
}

/// Physics may need what symbols do not, such as a door closed because it stands in the way, and may have within reach
/// from one place what symbols must go to another for. Whatever is done before or after a plan to no effect on the
/// goal, each step of what is written is needed.
TEST(PddlPlan, HasOnlyStepsThatTheGoalNeeds) {
  std::size_t tried = 0, watching = 0, left_out = 0;
  for (const auto& source : library()) {
    const auto simulator = source.simulators.front();
    SCOPED_TRACE(source.name + " " + std::string(name_of(simulator)));
    const auto posed = pose(source, simulator, 4);
    if (!posed) continue;
    const auto& scene = posed->scene();
    const auto witness = posed->witness();
    ASSERT_TRUE(witness);
    const auto actions = actions_of(*witness, scene.setting);
    const auto& domain = domain_of(simulator);
    const auto problem = testing::read_pddl_problem(posed->problem.text, domain);
    for (const auto& thing : scene.setting.objects.things) {
      const auto id = scene.setting.objects.named(thing.id);
      std::vector<Action> longer;
      auto there = scene.start;
      for (const ActionType type : {ActionType::GoTo, ActionType::Open, ActionType::Close}) {
        if (!there[id].exists || perform(scene.setting, there, {type, id}) != Failure::None) break;
        longer.push_back({type, {thing.id}});
      }
      const bool opens_and_closes = longer.size() == 3;
      if (!opens_and_closes && &thing != &scene.setting.objects.things.front()) continue;
      longer.insert(longer.end(), actions.begin(), actions.end());
      const auto plan = posed->plan(longer);
      if (!plan) continue;  // what was done first is against the goal
      const auto steps = testing::read_pddl_plan(join(*plan, "\n"));
      ASSERT_TRUE(reaches_goal(domain, problem, steps)) << join(*plan, "\n");
      EXPECT_EQ(needless_step(domain, problem, steps), "") << thing.id << "\n" << join(*plan, "\n");
      ++tried;
      watching += posed->problem.watching ? 1 : 0;
      left_out += opens_and_closes ? 1 : 0;
    }
  }
  std::cout << tried << " plans, " << watching << " with monitors, " << left_out << " open and close first\n";
  EXPECT_GE(tried, 100U);
  EXPECT_GE(watching, 10U);
  EXPECT_GE(left_out, 30U);
}

/// Physics may have within reach from one place what symbols must go to another for.
TEST(PddlPlan, GoesFromOnePlaceToAnotherThatOnlyPhysicsReachesFromThere) {
  std::size_t tried = 0, absent = 0;
  for (const auto& source : library()) {
    const auto simulator = source.simulators.front();
    SCOPED_TRACE(source.name + " " + std::string(name_of(simulator)));
    const auto posed = pose(source, simulator, 4);
    if (!posed || posed->problem.watching) continue;
    const auto& scene = posed->scene();
    const auto witness = posed->witness();
    if (!witness || witness->size() < 2) continue;
    if ((*witness)[0].action != ActionType::GoTo || (*witness)[1].action == ActionType::GoTo) continue;
    auto actions = actions_of(*witness, scene.setting);
    const auto plan = posed->plan(actions);
    ASSERT_TRUE(plan) << format(plan.error());
    for (const auto& thing : scene.setting.objects.things) {
      auto there = scene.start;
      const auto id = scene.setting.objects.named(thing.id);
      actions.front().args = {thing.id};
      if (!there[id].exists) {  // a piece before the cut
        EXPECT_FALSE(posed->plan(actions)) << thing.id;
        ++absent;
        continue;
      }
      if (perform(scene.setting, there, {ActionType::GoTo, id}) != Failure::None) continue;
      if (perform(scene.setting, there, (*witness)[1]) != Failure::TooFar) continue;
      const auto from_there = posed->plan(actions);
      ASSERT_TRUE(from_there) << format(from_there.error());
      EXPECT_EQ(from_there->size(), plan->size()) << thing.id;
      ++tried;
    }
  }
  EXPECT_GE(tried, 100U);
  EXPECT_GE(absent, 5U);
}

}  // namespace
}  // namespace unietp
