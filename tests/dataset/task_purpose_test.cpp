#include "dataset/task_purpose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Template of(const Purpose& purpose) {
  Template source;
  source.purpose = purpose;
  return source;
}

TEST(TaskPurpose, SaysItsReasonsOfTheCategoriesThatAreBound) {
  const auto& knowledge = committed_knowledge(Simulator::Behavior);
  const Binding binding{{"A", "bottom_cabinet"}, {"B", "kitchen"}, {"S", "soy_sauce"}};
  const auto purpose = purpose_of(of({"safety",
                                      {{true, Predicate::Open, "A", "", {}},
                                       {true, Predicate::InRoom, "A", "B", {}},
                                       {true, Predicate::Covered, "A", "S", {}},
                                       {false, Predicate::InRoom, "agent", "B", {}},
                                       {true, Predicate::Filled, "A", "water", {}}}}),
                                  binding, knowledge);
  EXPECT_EQ(purpose.name, "safety");
  EXPECT_THAT(purpose.because, ElementsAre(knowledge.find("bottom_cabinet")->display + " is open",
                                           knowledge.find("bottom_cabinet")->display + " is in kitchen",
                                           knowledge.find("bottom_cabinet")->display + " is covered with soy sauce",
                                           "the agent is not in kitchen",
                                           knowledge.find("bottom_cabinet")->display + " is filled with water"));
}

TEST(TaskPurpose, OfATemplateWithoutOneIsEmpty) {
  const auto purpose = purpose_of(of({}), {}, committed_knowledge(Simulator::Habitat));
  EXPECT_EQ(purpose.name, "");
  EXPECT_THAT(purpose.because, IsEmpty());
}

}  // namespace
}  // namespace unietp
