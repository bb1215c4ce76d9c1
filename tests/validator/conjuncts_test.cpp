#include "validator/conjuncts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Formula goal(const std::string& text) {
  const auto formula = parse_formula("test", text, FormulaUse::Goal);
  EXPECT_TRUE(formula) << (formula ? "" : format(formula.error()));
  return formula ? *formula : Formula{};
}

std::vector<std::string> conjuncts(const std::string& text) {
  std::vector<std::string> texts;
  for (const auto& part : conjuncts_of(goal(text))) texts.push_back(to_text(part));
  return texts;
}

TEST(ConjunctsOf, EachKeepsTheQuantifiersThatBindIt) {
  EXPECT_THAT(conjuncts("(exists (?a - Mug) (at-end (and (clean ?a) (held ?a))))"),
              ElementsAre("(exists (?a - Mug) (at-end (clean ?a)))", "(exists (?a - Mug) (at-end (held ?a)))"));
  EXPECT_THAT(conjuncts("(exists (?a - Mug) (and (at-end (clean ?a)) (exists (?b - Bowl) (at-end (dirty ?b)))))"),
              ElementsAre("(exists (?a - Mug) (at-end (clean ?a)))", "(exists (?b - Bowl) (at-end (dirty ?b)))"));
}

TEST(ConjunctsOf, WhatOnlyHasToStayIsNone) {
  EXPECT_THAT(conjuncts("(always (forall (?a - Mug) (clean ?a)))"), IsEmpty());
  EXPECT_THAT(conjuncts("(at-end (and (forall (?a - object) (not (held ?a))) (exists (?m - Mug) (dirty ?m))))"),
              ElementsAre("(at-end (exists (?m - Mug) (dirty ?m)))"));
}

TEST(ConjunctsOf, OpenedAndClosedAgainIsOne) {
  EXPECT_THAT(conjuncts("(exists (?a - Fridge) (and (sometime (open ?a)) (at-end (closed ?a))))"),
              ElementsAre("(exists (?a - Fridge) (and (sometime (open ?a)) (at-end (closed ?a))))"));
}

TEST(ReferringDomains, AreThoseThatNeedNoOtherVariable) {
  const auto domains =
      referring_domains(goal("(exists (?t - Table) (or (at-end (exists (?a - (Mug :where (dirty ?a))) (on ?a ?t)))"
                             " (at-end (exists (?b - (Mug :where (on ?b ?t))) (held ?b)))))"));
  ASSERT_EQ(domains.size(), 1U);
  EXPECT_EQ(domains[0].variable, "a");
  EXPECT_FALSE(domains[0].certain);
}

}  // namespace
}  // namespace unietp
