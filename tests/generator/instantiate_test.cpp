#include <gtest/gtest.h>

#include <algorithm>

#include "generator/specification.h"
#include "small_home.h"

namespace unietp {
namespace {

TEST(Instantiate, PutsCategoriesForPlaceholders) {
  const auto knowledge = small_home(Simulator::Behavior);
  const auto made =
      instantiate(library_template("wash-and-place-on"), knowledge, {{"A", "Mug"}, {"B", "Table"}, {"T", "Sink"}});
  ASSERT_TRUE(made) << format(made.error());
  EXPECT_EQ(made->template_name, "wash-and-place-on");
  EXPECT_EQ(made->split, Split::Compositional);
  EXPECT_EQ(made->simulator, Simulator::Behavior);
  EXPECT_EQ(made->style, Style::Direct);
  EXPECT_EQ(to_text(made->goal), "(exists (?a - Mug) (exists (?b - Table) (at-end (and (clean ?a) (on ?a ?b)))))");
}

TEST(Instantiate, DemandsSomethingOfEveryCategoryThatIsBound) {
  auto source = library_template("wash-and-place-on");
  source.init = {source.init[3], source.init[4]};  // only the two foralls
  const auto made = instantiate(source, small_home(Simulator::Ai2thor), {{"A", "Mug"}, {"B", "Table"}, {"T", "Sink"}});
  ASSERT_TRUE(made) << format(made.error());
  for (const auto* text : {"(exists (?a - Mug) (and))", "(exists (?b - Table) (and))", "(exists (?t - Sink) (and))"}) {
    EXPECT_TRUE(std::any_of(made->init.begin(), made->init.end(), [&](const Formula& f) { return to_text(f) == text; }))
        << text;
  }
}

void expect_refusal(const std::string& name, const Binding& binding, const std::string& words) {
  const auto made = instantiate(library_template(name), small_home(Simulator::Ai2thor), binding);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, Error::Kind::Unsatisfiable);
  EXPECT_NE(made.error().message.find(words), std::string::npos) << made.error().message;
}

TEST(Instantiate, NamesTheConstraintThatABindingBreaks) {
  expect_refusal("place-all-inside", {{"A", "Mug"}, {"B", "Microwave"}}, "(fits-inside Mug Microwave 3)");
  expect_refusal("wash-one", {{"A", "Mug"}, {"T", "Fridge"}}, "(washes Fridge Mug)");
  expect_refusal("open-one-close-other", {{"A", "Fridge"}, {"B", "Fridge"}}, "(distinct Fridge Fridge)");
  expect_refusal("place-one-on", {{"A", "Mug"}, {"B", "Fridge"}}, "'Fridge' cannot be B");
  expect_refusal("place-one-on", {{"A", "Table"}, {"B", "Table"}}, "'Table' cannot be A");
  expect_refusal("place-one-on", {{"A", "Mug"}}, "placeholder B");
}

TEST(Instantiate, RefusesASimulatorThatTheTemplateIsNotMeantFor) {
  const auto made =
      instantiate(library_template("heat-one"), small_home(Simulator::Virtualhome), {{"A", "Mug"}, {"T", "Microwave"}});
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("virtualhome"), std::string::npos);
}

}  // namespace
}  // namespace unietp
