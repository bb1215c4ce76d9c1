// What a quiz draws: evenly over simulators, and pairs that differ in one thing.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "simulation/portrait_quiz.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

std::vector<const Knowledge*> all_knowledge() {
  std::vector<const Knowledge*> all;
  for (const Simulator simulator : kSimulators) all.push_back(&committed_knowledge(simulator));
  return all;
}

std::vector<std::string> names_of(const std::vector<QuizItem>& items) {
  std::vector<std::string> names;
  for (const QuizItem& item : items)
    names.push_back(std::string(name_of(item.knowledge->simulator())) + " " + item.category->name);
  return names;
}

TEST(PortraitQuiz, DrawsThingsEvenlyOverTheSimulatorsAndTheSameOnesForASeed) {
  const auto items = quiz_of_things(all_knowledge(), 40, 20, 3);
  ASSERT_EQ(items.size(), 60U);
  std::map<Simulator, int> movable, furniture;
  for (const QuizItem& item : items) {
    EXPECT_EQ(item.category->movable, item.question == "movable");
    EXPECT_EQ(item.answer, item.category->display);
    ++(item.category->movable ? movable : furniture)[item.knowledge->simulator()];
  }
  for (const Simulator simulator : kSimulators) {
    EXPECT_EQ(movable[simulator], 10);
    EXPECT_EQ(furniture[simulator], 5);
  }
  EXPECT_EQ(names_of(items), names_of(quiz_of_things(all_knowledge(), 40, 20, 3)));
  EXPECT_NE(names_of(items), names_of(quiz_of_things(all_knowledge(), 40, 20, 4)));
  auto names = names_of(items);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());  // each once
}

TEST(PortraitQuiz, AsksOfAsManyStatesAsWantedWhichOfTwoPicturesHasThem) {
  const auto items = quiz_of_states(all_knowledge(), 96, 3);
  ASSERT_EQ(items.size(), 96U);
  std::map<std::string, int> asked;
  int first = 0;
  for (const QuizItem& item : items) {
    ASSERT_EQ(item.shown.size(), 2U);
    EXPECT_NE(item.shown[0].states, item.shown[1].states);
    EXPECT_EQ(item.shown[0].id, item.shown[1].id);
    const auto with = item.question.substr(0, item.question.find(" or "));
    const auto word = with.substr(0, with.find(' '));
    ++asked[word];
    const auto state = predicate_named(word);
    ASSERT_TRUE(state) << item.question;
    EXPECT_EQ(item.shown[0].states.has(*state), item.answer == with) << item.question;
    first += item.answer == with ? 1 : 0;
  }
  EXPECT_GE(asked.size(), 14U);
  for (const auto& [word, count] : asked) EXPECT_LE(count, 96 / 12) << word;
  EXPECT_GT(first, 30);
  EXPECT_LT(first, 66);
}

TEST(PortraitQuiz, AsksForMaterialsThatTheCategoryUsuallyHas) {
  const auto items = quiz_of_materials(all_knowledge(), 60, 3);
  ASSERT_EQ(items.size(), 60U);
  for (const QuizItem& item : items) {
    EXPECT_EQ(item.shown[0].material, item.answer);
    EXPECT_NE(item.shown[1].material, item.answer);
    EXPECT_EQ(item.shown[0].color, item.shown[1].color);
    for (const Node& node : item.shown) {
      const auto& usual = item.category->materials;
      EXPECT_NE(std::find(usual.begin(), usual.end(), node.material), usual.end());
    }
  }
}

}  // namespace
}  // namespace unietp
