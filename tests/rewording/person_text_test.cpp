#include "rewording/person_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Scene home_with(const std::vector<std::string>& categories) {
  Scene home;
  for (const std::string& category : categories) {
    Node node;
    node.id = category + "_1";
    node.category = category;
    home.nodes.push_back(node);
  }
  return home;
}

std::vector<std::string> faults(const std::string& text, const std::string& category, const Scene& home) {
  // Where "a slice of bread" is one that is there or one that is to be cut.
  static const Backend backend = [] {
    const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
    return Backend{knowledge, Profile{}, NounTable(knowledge, committed_names())};
  }();
  WordedTask task;
  task.specification.simulator = Simulator::Ai2thor;
  task.specification.goal = *parse_formula(
      "goal", "(exists (?a - " + category + ") (exists (?b - Plate) (at-end (on ?a ?b))))", FormulaUse::Goal);
  return check_person_text(text, task, backend, English::Us, home).faults;
}

TEST(TextsOfPeople, AreReadInTheirHome) {
  constexpr const char* kText = "Put a slice of bread on the plate.";
  EXPECT_THAT(faults(kText, "Bread/slice", home_with({"Bread", "Plate"})), IsEmpty());
  EXPECT_THAT(faults(kText, "BreadSliced", home_with({"BreadSliced", "Plate"})), IsEmpty());
  EXPECT_THAT(faults(kText, "Bread/slice", home_with({"BreadSliced", "Plate"})),
              ElementsAre(HasSubstr("the text asks for (exists (?v0 - BreadSliced)")));
}

TEST(TextsOfPeople, MayNotSpeakOfWhatTheirHomeLacks) {
  constexpr const char* kText = "Put a mug on the plate.";
  EXPECT_THAT(faults(kText, "Mug", home_with({"Mug", "Plate"})), IsEmpty());
  EXPECT_THAT(faults(kText, "Bread/slice", home_with({"Bread", "Mug", "Plate"})),
              ElementsAre(HasSubstr("the text asks for (exists (?v0 - Mug)")));
}

}  // namespace
}  // namespace unietp
