// Counts in BDDL, which knows only `forn`: exactly so many.
#include "exports/bddl_goal.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace unietp {
namespace {

constexpr int kMugs = 3;

Category category(const std::string& name) {
  Category one;
  one.name = name;
  one.movable = true;
  one.size = Vec3::Ones();
  return one;
}

std::string exported(const std::string& goal) {
  Scene scene;
  for (int i = 1; i <= kMugs; ++i) {
    Node mug;
    mug.id = "mug_" + std::to_string(i);
    mug.category = "mug";
    scene.nodes.push_back(std::move(mug));
  }
  const Knowledge knowledge(Simulator::Behavior, {category("mug")}, {}, {}, {}, {});
  const auto formula = parse_formula("goal", goal, FormulaUse::Goal);
  EXPECT_TRUE(formula) << format(formula.error());
  const auto text = bddl_goal(*formula, scene, knowledge, {{{"mug", "mug.n.04"}}, {}}, {});
  EXPECT_TRUE(text) << format(text.error());
  return text ? text->text : "";
}

std::string exactly(int number) { return "(forn (" + std::to_string(number) + ") (?x - mug.n.04) (open ?x))"; }

/// BDDL for one of these numbers of open mugs; one that there never is for none.
std::string one_of(const std::vector<int>& numbers) {
  if (numbers.empty()) return exactly(kMugs + 1);
  std::string text;
  for (const int number : numbers) text += " " + exactly(number);
  return numbers.size() == 1 ? text.substr(1) : "(or" + text + ")";
}

TEST(BddlGoal, ACountIsTheNumbersThatMeetItsComparison) {
  for (const std::string sign : {"=", ">=", "<=", ">", "<"}) {
    for (int n = 0; n <= kMugs + 1; ++n) {
      const auto goal = "(at-end (count " + sign + " " + std::to_string(n) + " (?x - mug) (open ?x)))";
      SCOPED_TRACE(goal);
      std::vector<int> expected;
      for (int k = 0; k <= kMugs; ++k) {
        if (sign == "=" ? k == n : sign == ">=" ? k >= n : sign == "<=" ? k <= n : sign == ">" ? k > n : k < n)
          expected.push_back(k);
      }
      EXPECT_EQ(exported(goal), one_of(expected));
    }
  }
}

}  // namespace
}  // namespace unietp
