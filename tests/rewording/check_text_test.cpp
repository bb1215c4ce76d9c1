#include "rewording/check_text.h"
#include "tests/support/committed_names.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::IsEmpty;

/// Texts that are to ask for an open fridge.
class CheckText : public ::testing::Test {
 protected:
  static Backend backend() {
    Category fridge;
    fridge.name = "Fridge";
    fridge.display = "fridge";
    fridge.plural = "fridges";
    fridge.archetype = Archetype::Cabinet;
    fridge.size = {0.7, 0.65, 1.7};
    Knowledge knowledge(Simulator::Ai2thor, {fridge}, {{"Fridge", "openable", {"curated", 1}}}, {}, {}, {});
    NounTable nouns(knowledge, committed_names());
    return {std::move(knowledge), Profile{}, std::move(nouns)};
  }
  std::vector<ProblemKind> problems(const std::string& text, const std::string& writer,
                                    const std::string& style = "direct") const {
    StatedGoal stated;
    stated.text = text;
    stated.writer = writer;
    stated.style = style;
    stated.template_name = "open-one";
    stated.goal = *parse_formula("goal", "(exists (?a - Fridge) (at-end (open ?a)))", FormulaUse::Goal);
    stated.around = {"Fridge"};
    stated.phrasings = "all";
    std::vector<ProblemKind> kinds;
    for (const Problem& problem : check_text(stated, backend_)) kinds.push_back(problem.kind);
    return kinds;
  }

  const Backend backend_ = backend();
};

TEST_F(CheckText, WhatAPersonVouchesForIsHeldAgainstItsFormAlone) {
  EXPECT_THAT(problems("Close the fridge, please.", "person:unchecked"), IsEmpty());
  EXPECT_THAT(problems("Close fridge_1.", "person:unchecked"), ::testing::Contains(ProblemKind::TextForm));
  EXPECT_THAT(problems("Close the fridge, please.", "person"), ::testing::Contains(ProblemKind::TextMeaning));
  EXPECT_THAT(problems("Open the fridge.", "person"), ::testing::Not(::testing::Contains(ProblemKind::TextMeaning)));
}

TEST_F(CheckText, AnUnknownStyleIsAProblemOfItsOwn) {
  EXPECT_THAT(problems("Open the fridge.", "grammar", "sung"), ::testing::ElementsAre(ProblemKind::TextStyle));
}

}  // namespace
}  // namespace unietp
