#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>
#include <sstream>

#include "optimum.h"
#include "pddl/plan.h"
#include "pddl/problem_objects.h"
#include "symbolic/from_scene.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

const char* const kSmallGoals[] = {
    "(exists (?x - Fridge) (at-end (open ?x)))",
    "(exists (?x - Lamp) (at-end (power_on ?x)))",
    "(exists (?x - Mug) (at-end (held ?x)))",
    "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))",
    "(exists (?x - Apple) (exists (?y - Fridge) (at-end (inside ?x ?y))))",
    "(exists (?x - Apple) (exists (?y - Dresser) (at-end (inside ?x ?y))))",
    "(exists (?x - (Mug :where (dirty ?x))) (at-end (clean ?x)))",
    "(exists (?x - Potato) (at-end (hot ?x)))",
    "(exists (?x - Mug) (at-end (cool ?x)))",
    "(exists (?x - Apple) (at-end (sliced ?x)))",
    "(exists (?c - SideTable) (exists (?x - Mug) (exists (?y - Apple) (at-end (and (on ?x ?c) (on ?y ?c))))))",
    "(exists (?x - Apple) (exists (?b - Fridge) (at-end (and (inside ?x ?b) (closed ?b)))))",
    "(exists (?x - Laptop) (exists (?b - DiningTable) (at-end (and (open ?x) (on ?x ?b)))))",
    "(exists (?x - Fridge) (exists (?y - Mug) (at-end (and (open ?x) (inside ?y ?x)))))",
    "(exists (?x - Lamp) (exists (?b - DiningTable) (at-end (and (power_on ?x) (on ?x ?b)))))",
    "(exists (?x - Fridge) (exists (?y - Television) (at-end (and (open ?x) (power_on ?y)))))",
    "(exists (?x - (Mug :where (dirty ?x))) (at-end (and (clean ?x) (held ?x))))",
    "(exists (?x - (Plate :where (dirty ?x))) (exists (?b - CounterTop) (at-end (and (clean ?x) (on ?x ?b)))))",
    "(exists (?x - Potato) (exists (?b - SideTable) (at-end (and (hot ?x) (on ?x ?b)))))",
    "(exists (?x - Mug) (exists (?b - DiningTable) (at-end (and (cool ?x) (on ?x ?b)))))",
    "(exists (?f - Fridge) (exists (?l - Lamp) (and (before (open ?f) (power_on ?l)) (at-end (power_on ?l)))))",
    "(exists (?x - Mug) (and (sometime (cool ?x)) (at-end (held ?x))))",
};

/// The demonstration as a plan in symbols: actions of the body are left out, and what physics had within reach anyway
/// is gone to. So it is held against a search that has to go everywhere, too.
TEST(Optimality, TheExpertsPlansAreOnAverageWithin15PercentOfTheShortest) {
  const auto knowledge = house_knowledge();
  const auto profile = house_profile();
  const auto start = house();
  std::ostringstream table;
  double ratios = 0;
  int compared = 0;
  for (const auto* text : kSmallGoals) {
    SCOPED_TRACE(text);
    const auto wanted = goal(text);
    const auto made = demonstrate(wanted, start, knowledge, profile, {});
    ASSERT_TRUE(std::holds_alternative<Demonstration>(made)) << std::get<Rejection>(made).detail;
    std::vector<Action> actions;
    std::vector<std::string> handled;
    std::vector<std::pair<std::string, std::string>> pieces;
    for (const auto& step : std::get<Demonstration>(made).steps) {
      if (!step.outcome.success) continue;
      actions.push_back(step.action);
      handled.insert(handled.end(), step.action.args.begin(), step.action.args.end());
    }
    const symbolic::SceneSymbols symbols(start, knowledge, ActionProfile::Unietp,
                                         pddl::problem_objects(start, knowledge, wanted, handled));
    const auto written = symbols.goal(wanted);
    const auto problem = pddl::problem_for("small", Simulator::Ai2thor, symbols.setting, symbols.start, written);
    ASSERT_TRUE(problem) << format(problem.error());
    const auto plan = pddl::plan_for(symbols.setting, symbols.start, written, *problem, actions, pieces);
    ASSERT_TRUE(plan) << format(plan.error());
    int length = 0;
    for (const auto& step : *plan) length += step == "(note)" || step == "(judge)" ? 0 : 1;
    const auto shortest = optimum(symbols.setting, symbols.start, written, length, 60'000);
    ASSERT_TRUE(shortest.exhausted) << "too much to search: " << shortest.worlds << " worlds";
    const double ratio = static_cast<double>(length) / shortest.length.value_or(length);
    ratios += ratio;
    ++compared;
    table << std::fixed << std::setprecision(2) << ratio << "  " << length << " of " << shortest.length.value_or(length)
          << "  " << text << "\n";
  }
  EXPECT_LE(ratios / compared, 1.15) << table.str();
  RecordProperty("average_ratio", std::to_string(ratios / compared));
  std::cout << "on average " << ratios / compared << " times the shortest, of " << compared << " tasks\n";
}

}  // namespace
}  // namespace unietp::testing
