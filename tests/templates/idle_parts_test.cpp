#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "templates/phrasing_counts.h"
#include "templates/template.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

struct Parts {
  std::string parameters = "(A - pickupable) (B - furniture receptacle)";
  std::string constraints = "(distinct A B) (fits-on A B)";
  std::string init = "(exists (?a - A) (and)) (exists (?b - B) (and))";
  std::string goal = "(exists (?a - A) (exists (?b - B) (at-end (on ?a ?b))))";
  std::string instruction = "\"Put {A:indefinite} {B:on}.\"";
  std::string name = "\"put <A> on <B>\"";
};

std::vector<Error> problems_of(const Parts& parts) {
  return parse_template("t.template", "(template t (name " + parts.name + ") (split atomic) (parameters " +
                                          parts.parameters + ") (constraints " + parts.constraints + ") (init " +
                                          parts.init + ") (goal " + parts.goal + ") (instruction " + parts.instruction +
                                          "))")
      .errors;
}

void expect_one(const Parts& parts, const char* message) {
  const auto errors = problems_of(parts);
  ASSERT_EQ(errors.size(), 1U) << message;
  EXPECT_THAT(errors[0].message, HasSubstr(message));
}

TEST(IdleParts, WhatSaysNothingOrTheSameAgainIsRefused) {
  EXPECT_TRUE(problems_of({}).empty());
  expect_one({.parameters = "(A - pickupable pickupable) (B - furniture receptacle)"}, "duplicate 'pickupable'");
  expect_one({.parameters = "(A - pickupable any) (B - furniture receptacle)"}, "'any' must be the only word");
  expect_one({.parameters = "(A - pickupable) (B - furniture movable)"}, "no category is both");
  expect_one({.constraints = "(distinct A B) (fits-on A B) (fits-on A B)"}, "duplicate constraint");
  expect_one({.constraints = "(distinct A A) (fits-on A B)"}, "duplicate 'A' in this constraint");
  expect_one({.constraints = "(fits-on A B 02)"}, "leading zeros");
  expect_one({.init = "(exists (?a - A) (and)) (exists (?b - B) (and)) (exists (?a - A)   (and))"},
             "duplicate start constraint");
  expect_one({.goal = "(exists (?a - A) (exists (?b - B) (at-end (and (on ?a ?b) (on ?a ?b)))))"},
             "duplicate part of 'and'");
  expect_one({.goal = "(exists (?a - A) (exists (?b - B) (exists (?c - B) (at-end (on ?a ?b)))))"},
             "?c is bound here but never used");
  expect_one({.instruction = "\"Put {A} {B:on}.\" \"Put {A} {B:on}.\""}, "duplicate phrasing");
  expect_one({.instruction = "\"Put {A}\n {B:on}.\""}, "must be on one line");
  expect_one({.name = "\" \""}, "title is empty");
}

Template counting(const std::string& phrasing) {
  Template source;
  source.goal = *parse_formula("", "(exists (?b - B) (at-end (count >= 2 (?a - A) (on ?a ?b))))", FormulaUse::Goal);
  source.instructions = {phrasing};
  return source;
}

TEST(DoubtfulPhrasings, ANumberThatTheGoalCountsIsToBeSaid) {
  EXPECT_TRUE(doubtful_phrasings(counting("Put two {A:plural} {B:on}.")).empty());
  EXPECT_TRUE(doubtful_phrasings(counting("A pair of {A:plural} belongs {B:on}.")).empty());
  EXPECT_TRUE(doubtful_phrasings(counting("At least 2 {A:plural} {B:on}, please.")).empty());
  const auto doubtful = doubtful_phrasings(counting("Put {A:plural} {B:on}."));
  ASSERT_EQ(doubtful.size(), 1U);
  EXPECT_THAT(doubtful[0].message, HasSubstr("such as 'two'"));
}

TEST(DoubtfulPhrasings, AllIsToBeSaid) {
  Template source;
  source.goal = *parse_formula("", "(at-end (forall (?a - A) (open ?a)))", FormulaUse::Goal);
  source.instructions = {"Open {A:plural}.", "Open every {A}.", "Open the {A:plural}."};
  const auto doubtful = doubtful_phrasings(source);
  ASSERT_EQ(doubtful.size(), 1U);
  EXPECT_EQ(doubtful[0].index, 0U);
}

}  // namespace
}  // namespace unietp
