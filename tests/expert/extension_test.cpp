#include <gtest/gtest.h>

#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

/// The house, with what the actions of the profile `wide` need to be known.
Knowledge wide_knowledge() {
  const Knowledge plain = house_knowledge();
  const Source curated{"curated", 1};
  auto affordances = plain.affordances();
  for (const auto& [category, affordance] :
       {std::pair("Dresser", "sittable"), std::pair("Dresser", "lieable"), std::pair("Lamp", "pluggable"),
        std::pair("Plate", "foldable"), std::pair("Plate", "readable"), std::pair("Box", "foldable"),
        std::pair("Mug", "breakable")}) {
    affordances.push_back({category, affordance, curated});
  }
  auto effects = plain.effects();
  effects.push_back({"SideTable", Treatment::Attaches, "Mug", "", 0, {}, curated});
  return Knowledge(Simulator::Ai2thor, plain.categories(), affordances, plain.placements(), effects, plain.aliases());
}

Profile wide_profile() {
  Profile profile = house_profile();
  for (const auto type :
       {ActionType::SitOn, ActionType::LieOn, ActionType::StandUp, ActionType::PlugIn, ActionType::Unplug,
        ActionType::Fold, ActionType::Unfold, ActionType::Break, ActionType::Read}) {
    profile.actions.set(static_cast<std::size_t>(type));
  }
  profile.attaching = profile.power_needs_plug = true;
  return profile;
}

struct Case {
  const char* name;
  const char* goal;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const Case kCases[] = {
    {"sit", "(exists (?x - Dresser) (at-end (sat_on ?x)))"},
    {"lie", "(exists (?x - Dresser) (at-end (lain_on ?x)))"},
    {"sit_with_something_in_hand", "(exists (?x - Dresser) (exists (?y - Mug) (at-end (and (sat_on ?x) (held ?y)))))"},
    {"leave_a_seat", "(exists (?x - Dresser) (exists (?y - Mug) (before (sat_on ?x) (held ?y))))"},
    {"plug_in", "(exists (?x - Lamp) (at-end (plugged_in ?x)))"},
    {"plug_in_to_switch_on", "(exists (?x - Lamp) (at-end (power_on ?x)))"},
    {"fold_and_put_away", "(exists (?x - Plate) (exists (?b - Fridge) (at-end (and (folded ?x) (inside ?x ?b)))))"},
    {"unfold", "(exists (?x - Box) (at-end (unfolded ?x)))"},
    {"break", "(exists (?x - Mug) (at-end (broken ?x)))"},
    {"read", "(exists (?x - Plate) (at-end (read ?x)))"},
    {"read_and_put_away", "(exists (?x - Plate) (exists (?b - Fridge) (at-end (and (read ?x) (inside ?x ?b)))))"},
    {"attach", "(exists (?x - Mug) (exists (?b - SideTable) (at-end (attached ?x ?b))))"},
};

class EveryExtensionAction : public ::testing::TestWithParam<Case> {};

TEST_P(EveryExtensionAction, IsUsedWhereTheGoalNeedsIt) {
  const Knowledge knowledge = wide_knowledge();
  const Profile profile = wide_profile();
  Scene start = house();
  for (std::size_t i = 0; i < start.nodes.size(); ++i) {
    Node& node = start.nodes.edit(i);
    if (node.category == "Lamp") node.states.set({Predicate::Unplugged, ""});
    if (node.category == "Plate") node.states.set({Predicate::Unfolded, ""});
    if (node.category == "Box") node.states.set({Predicate::Folded, ""});
    if (node.category == "Mug") node.states.set({Predicate::Intact, ""});
  }
  const Formula formula = goal(GetParam().goal);
  const auto result = demonstrate(formula, start, knowledge, profile, {});
  ASSERT_TRUE(std::holds_alternative<Demonstration>(result))
      << name_of(std::get<Rejection>(result).reason) << ": " << std::get<Rejection>(result).detail;
  const Demonstration& demonstration = std::get<Demonstration>(result);
  SCOPED_TRACE(plan_of(demonstration));
  EXPECT_EQ(replay(formula, start, demonstration, knowledge, profile), "");
  EXPECT_EQ(needless_steps(formula, start, demonstration, knowledge, profile), std::vector<std::string>());
}

TEST_P(EveryExtensionAction, IsNotUsedWhereTheProfileLacksIt) {
  Profile profile = house_profile();
  const Formula formula = goal(GetParam().goal);
  if (std::string(GetParam().name) == "plug_in_to_switch_on") return;  // without `wide` a lamp needs no plug
  const auto result = demonstrate(formula, house(), wide_knowledge(), profile, {});
  EXPECT_TRUE(std::holds_alternative<Rejection>(result));
}

INSTANTIATE_TEST_SUITE_P(Wide, EveryExtensionAction, ::testing::ValuesIn(kCases),
                         [](const auto& about) { return std::string(about.param.name); });

}  // namespace
}  // namespace unietp::testing
