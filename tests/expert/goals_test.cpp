#include <gtest/gtest.h>

#include <set>

#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

void open_fridge(Scene& s) { set_state(s, "fridge_1", Predicate::Open); }
void mugs_in_fridge(Scene& s) {
  move_to(s, "mug_1", 4.25, 3.55, 0.9);
  move_to(s, "mug_2", 4.5, 3.55, 0.9);
}
void lamp_on(Scene& s) { set_state(s, "lamp_1", Predicate::PowerOn); }
void all_on(Scene& s) {
  lamp_on(s);
  set_state(s, "laptop_1", Predicate::PowerOn);
  set_state(s, "television_1", Predicate::PowerOn);
}
void laptop_open(Scene& s) { set_state(s, "laptop_1", Predicate::Open); }
void microwave_on(Scene& s) { set_state(s, "microwave_1", Predicate::PowerOn); }
void box_open(Scene& s) { set_state(s, "box_1", Predicate::Open); }
void dresser_open(Scene& s) { set_state(s, "dresser_1", Predicate::Open); }
void cooled_mug(Scene& s) { set_state(s, "mug_1", Predicate::Cool); }

// One for each shape of the goal catalog that the actions of this backend can reach.
const HouseCase kGoalCases[] = {
    {"open", "(exists (?x - Fridge) (at-end (open ?x)))"},
    {"close", "(exists (?x - Fridge) (at-end (closed ?x)))", open_fridge},
    {"turn_on", "(exists (?x - Lamp) (at-end (power_on ?x)))"},
    {"turn_off", "(exists (?x - Lamp) (at-end (power_off ?x)))", lamp_on},
    {"pick_up", "(exists (?x - Mug) (at-end (held ?x)))"},
    {"pick_up_from_a_closed_place",
     "(exists (?x - (Mug :where (exists (?f - Fridge) (inside ?x ?f)))) (at-end (held ?x)))", mug_in_fridge},
    {"place_on", "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))"},
    {"place_inside", "(exists (?x - Apple) (exists (?y - Fridge) (at-end (inside ?x ?y))))"},
    {"place_inside_a_drawer", "(exists (?x - Apple) (exists (?y - Dresser) (at-end (inside ?x ?y))))"},
    {"wash", "(exists (?x - Mug) (at-end (clean ?x)))", all_dirty},
    {"heat", "(exists (?x - Potato) (at-end (hot ?x)))"},
    {"cool", "(exists (?x - Mug) (at-end (cool ?x)))"},
    {"slice", "(exists (?x - Apple) (at-end (sliced ?x)))"},
    {"two_kinds_inside",
     "(exists (?c - Fridge) (exists (?x - Mug) (exists (?y - Apple) (at-end (and (inside ?x ?c) (inside ?y ?c))))))"},
    {"two_kinds_on",
     "(exists (?c - SideTable) (exists (?x - Mug) (exists (?y - Apple) (at-end (and (on ?x ?c) (on ?y ?c))))))"},
    {"three_kinds_inside",
     "(exists (?d - Fridge) (exists (?x - Mug) (exists (?y - Apple) (exists (?z - Potato) (at-end (and (inside ?x ?d) "
     "(inside ?y ?d) (inside ?z ?d)))))))"},
    {"three_kinds_on",
     "(exists (?d - SideTable) (exists (?x - Mug) (exists (?y - Apple) (exists (?z - Potato) (at-end (and (on ?x ?d) "
     "(on "
     "?y ?d) (on ?z ?d)))))))"},
    {"on_and_inside",
     "(exists (?x - Mug) (exists (?y - Apple) (exists (?c - SideTable) (exists (?d - Fridge) (at-end (and (on ?x ?c) "
     "(inside ?y ?d)))))))"},
    {"one_and_another",
     "(exists (?x - Mug) (exists (?y - Mug) (exists (?b - SideTable) (exists (?c - Dresser) (at-end (and (not (= ?x "
     "?y)) "
     "(on ?x ?b) (on ?y ?c)))))))"},
    {"on_a_carried_thing",
     "(exists (?x - Apple) (exists (?b - Plate) (exists (?c - CounterTop) (at-end (and (on ?x ?b) (on ?b ?c))))))",
     [](Scene& s) {
       move_to(s, "apple_1", 8.5, 0.7, 0.601);
       edit_node(s, "apple_1")->archetype = Archetype::Box;
       edit_node(s, "apple_2")->archetype = Archetype::Box;
     }},
    {"inside_and_closed", "(exists (?x - Apple) (exists (?b - Fridge) (at-end (and (inside ?x ?b) (closed ?b)))))",
     open_fridge},
    {"inside_and_closed_from_closed",
     "(exists (?x - Apple) (exists (?b - Fridge) (at-end (and (inside ?x ?b) (closed ?b)))))"},
    {"open_and_place", "(exists (?x - Laptop) (exists (?b - DiningTable) (at-end (and (open ?x) (on ?x ?b)))))"},
    {"close_and_place_inside",
     "(exists (?x - Laptop) (exists (?b - Fridge) (at-end (and (closed ?x) (inside ?x ?b)))))", laptop_open},
    {"inside_and_left_open", "(exists (?x - Fridge) (exists (?y - Mug) (at-end (and (open ?x) (inside ?y ?x)))))"},
    {"switch_on_and_place", "(exists (?x - Lamp) (exists (?b - DiningTable) (at-end (and (power_on ?x) (on ?x ?b)))))"},
    {"one_on_one_off", "(exists (?x - Television) (exists (?y - Lamp) (at-end (and (power_on ?x) (power_off ?y)))))",
     lamp_on},
    {"one_open_one_closed", "(exists (?x - Fridge) (exists (?y - Dresser) (at-end (and (open ?x) (closed ?y)))))",
     dresser_open},
    {"wash_and_hold", "(exists (?x - Mug) (at-end (and (clean ?x) (held ?x))))", all_dirty},
    {"wash_and_place", "(exists (?x - Plate) (exists (?b - CounterTop) (at-end (and (clean ?x) (on ?x ?b)))))",
     all_dirty},
    {"wash_and_place_inside",
     "(exists (?x - (Mug :where (dirty ?x))) (exists (?b - Fridge) (at-end (and (clean ?x) (inside ?x ?b)))))"},
    {"wash_two_kinds",
     "(exists (?x - (Mug :where (dirty ?x))) (exists (?y - (Plate :where (dirty ?y))) (at-end (and (clean ?x) (clean "
     "?y)))))"},
    {"heat_and_place", "(exists (?x - Potato) (exists (?b - SideTable) (at-end (and (hot ?x) (on ?x ?b)))))"},
    {"cool_and_place_inside", "(exists (?x - Mug) (exists (?b - Dresser) (at-end (and (cool ?x) (inside ?x ?b)))))"},
    {"heat_one_cool_one",
     "(exists (?x - Potato) (exists (?y - Mug) (exists (?c - SideTable) (at-end (and (hot ?x) (cool ?y) (on ?x ?c) (on "
     "?y ?c))))))"},
    {"slice_on", "(exists (?s - Apple/slice) (exists (?b - SideTable) (at-end (on ?s ?b))))"},
    {"slice_inside", "(exists (?s - Apple/slice) (exists (?b - Fridge) (at-end (inside ?s ?b))))"},
    {"two_kinds_of_slices",
     "(exists (?s - Apple/slice) (exists (?u - Potato/slice) (exists (?c - SideTable) (at-end (and (on ?s ?c) (on ?u "
     "?c))))))"},
    {"two_slices", "(exists (?b - SideTable) (at-end (count = 2 (?s - Apple/slice) (on ?s ?b))))"},
    {"slice_after_cooling",
     "(exists (?x - Potato) (exists (?s - Potato/slice) (exists (?b - SideTable) (and (before (cool ?x) (sliced ?x)) "
     "(at-end (and (slice_of ?s ?x) (on ?s ?b)))))))"},
    {"at_least_two_and_one",
     "(exists (?c - Fridge) (at-end (and (count >= 2 (?x - Mug) (inside ?x ?c)) (count >= 1 (?y - Apple) (inside ?y "
     "?c)))))"},
    {"exactly_two", "(exists (?b - SideTable) (at-end (count = 2 (?x - Mug) (on ?x ?b))))"},
    {"exactly_three", "(exists (?b - Fridge) (at-end (count = 3 (?x - Mug) (inside ?x ?b))))"},
    {"at_least_and_at_most",
     "(exists (?b - DiningTable) (at-end (and (count >= 2 (?x - Apple) (on ?x ?b)) (count <= 1 (?z - Mug) (on ?z "
     "?b)))))"},
    {"all_on", "(exists (?b - SideTable) (forall (?x - Mug) (at-end (on ?x ?b))))"},
    {"all_inside_and_closed",
     "(exists (?b - Fridge) (and (forall (?x - Mug) (at-end (inside ?x ?b))) (at-end (closed ?b))))"},
    {"remove_all",
     "(and (forall (?b - DiningTable) (at-end (count = 0 (?x - Mug) (on ?x ?b)))) (at-end (count = 0 (?y - Mug) (held "
     "?y))))"},
    {"take_out_and_close", "(exists (?b - Fridge) (at-end (and (count = 0 (?x - Mug) (inside ?x ?b)) (closed ?b))))",
     mugs_in_fridge},
    {"either_place",
     "(forall (?x - Apple) (at-end (or (exists (?b - Fridge) (inside ?x ?b)) (exists (?c - Dresser) (on ?x ?c)))))"},
    {"distribute",
     "(exists (?b - SideTable) (exists (?c - Dresser) (and (forall (?x - Mug) (at-end (or (on ?x ?b) (on ?x ?c)))) "
     "(at-end "
     "(count >= 1 (?x - Mug) (on ?x ?b))) (at-end (count >= 1 (?y - Mug) (on ?y ?c))))))"},
    {"one_or_the_other",
     "(exists (?c - Fridge) (at-end (or (exists (?x - Mug) (inside ?x ?c)) (exists (?y - Apple) (inside ?y ?c)))))"},
    {"wash_all", "(forall (?x - Mug) (at-end (clean ?x)))"},
    {"turn_off_all_in_a_room",
     "(exists (?r - living_room) (forall (?x - ((either Lamp Laptop Television) :where (in_room ?x ?r))) (at-end "
     "(power_off ?x))))",
     all_on},
    {"open_all", "(forall (?x - (either Fridge Dresser)) (at-end (open ?x)))"},
    {"wash_then_heat", "(exists (?x - Mug) (and (before (clean ?x) (hot ?x)) (at-end (and (clean ?x) (hot ?x)))))",
     all_dirty},
    {"one_first",
     "(exists (?c - Fridge) (exists (?x - Apple) (exists (?y - Mug) (and (before (inside ?x ?c) (inside ?y ?c)) "
     "(at-end "
     "(and (inside ?x ?c) (inside ?y ?c)))))))"},
    {"move_on",
     "(exists (?x - Mug) (exists (?b - SideTable) (exists (?c - Dresser) (and (before (on ?x ?b) (on ?x ?c)) (at-end "
     "(on "
     "?x ?c))))))"},
    {"place_then_switch_on",
     "(exists (?x - Lamp) (exists (?b - DiningTable) (and (before (on ?x ?b) (power_on ?x)) (at-end (and (on ?x ?b) "
     "(power_on ?x))))))"},
    {"on_then_off", "(exists (?x - Lamp) (and (sometime (power_on ?x)) (at-end (power_off ?x))))"},
    {"open_then_close", "(exists (?x - Fridge) (and (sometime (open ?x)) (at-end (closed ?x))))"},
    {"fill_then_run",
     "(exists (?x - Potato) (exists (?b - Microwave) (and (before (inside ?x ?b) (power_on ?b)) (at-end (and (inside "
     "?x "
     "?b) (power_on ?b))))))"},
    {"off_before_open",
     "(exists (?x - Microwave) (and (before (power_off ?x) (open ?x)) (at-end (and (power_off ?x) (open ?x)))))",
     microwave_on},
    {"closed_until",
     "(exists (?x - Fridge) (exists (?y - Apple) (exists (?c - SideTable) (and (until (closed ?x) (on ?y ?c)) (at-end "
     "(and "
     "(on ?y ?c) (open ?x)))))))"},
    {"all_of_one_before_any_of_the_other",
     "(exists (?c - SideTable) (and (until (count = 0 (?y - Apple) (on ?y ?c)) (forall (?x - Mug) (on ?x ?c))) (at-end "
     "(and "
     "(forall (?x - Mug) (on ?x ?c)) (forall (?y - Apple) (on ?y ?c))))))"},
    {"as_many_here_as_there",
     "(exists (?b - DiningTable) (exists (?c - Dresser) (at-end (and (count >= 1 (?x - Mug) (on ?x ?b)) (count = "
     "(number "
     "(?x - Mug) (on ?x ?b)) (number (?y - Mug) (on ?y ?c)))))))"},
    {"more_than",
     "(exists (?c - Fridge) (at-end (count > (number (?x - Apple) (inside ?x ?c)) (number (?y - Mug) (inside ?y "
     "?c)))))",
     mug_in_fridge},
    {"without_ever_opening",
     "(exists (?b - SideTable) (and (forall (?c - Fridge) (always (closed ?c))) (forall (?x - Mug) (at-end (on ?x "
     "?b)))))"},
    {"exactly_one_left",
     "(exists (?b - DiningTable) (at-end (and (count = 1 (?x - Mug) (on ?x ?b)) (count = 0 (?y - Mug) (held ?y)))))"},
    {"if_open_here",
     "(or (exists (?a - (Fridge :where (open ?a))) (exists (?y - Apple) (exists (?c - SideTable) (at-end (on ?y "
     "?c))))) "
     "(exists (?a - (Fridge :where (closed ?a))) (exists (?y - Apple) (exists (?d - Dresser) (at-end (inside ?y "
     "?d))))))"},
    {"implication",
     "(imply (exists (?a - (Fridge :where (closed ?a))) (at-end (= ?a ?a))) (exists (?y - Apple) (exists (?d - "
     "Dresser) "
     "(at-end (inside ?y ?d)))))"},
    {"the_dirty_one", "(exists (?x - (Plate :where (dirty ?x))) (exists (?b - SideTable) (at-end (on ?x ?b))))"},
    {"the_one_inside",
     "(exists (?x - (Mug :where (exists (?c - Fridge) (inside ?x ?c)))) (exists (?b - SideTable) (at-end (on ?x ?b))))",
     mug_in_fridge},
    {"the_one_on",
     "(exists (?x - (Apple :where (exists (?c - CounterTop) (on ?x ?c)))) (exists (?b - Dresser) (at-end (inside ?x "
     "?b))))"},
    {"the_place_that_holds",
     "(exists (?b - (SideTable :where (exists (?l - Laptop) (on ?l ?b)))) (exists (?x - Mug) (at-end (on ?x ?b))))"},
    {"the_one_in_the_room",
     "(exists (?x - ((either Lamp Microwave) :where (exists (?r - living_room) (in_room ?x ?r)))) (at-end (power_on "
     "?x)))"},
    {"wash_the_one_on", "(exists (?x - (Mug :where (exists (?b - DiningTable) (on ?x ?b)))) (at-end (clean ?x)))"},
    {"slice_the_one_inside",
     "(exists (?x - (Apple :where (exists (?b - Fridge) (inside ?x ?b)))) (at-end (sliced ?x)))",
     [](Scene& s) { move_to(s, "apple_1", 4.4, 3.55, 0.9); }},
    {"the_nearest", "(exists (?x - (Mug :where (exists (?b - Fridge) (nearest ?x ?b)))) (at-end (held ?x)))"},
    {"swap",
     "(exists (?x - (Mug :where (exists (?b - CounterTop) (on ?x ?b)))) (exists (?y - (Plate :where (exists (?c - "
     "SideTable) (on ?y ?c)))) (exists (?b - CounterTop) (exists (?c - (SideTable :where (exists (?l - Lamp) (on ?l "
     "?c)))) "
     "(at-end (and (on ?x ?c) (on ?y ?b)))))))"},
    {"touch_no_other",
     "(and (exists (?x - (Dresser :where (open ?x))) (at-end (closed ?x))) (forall (?y - (Fridge :where (closed ?y))) "
     "(always (closed ?y))))",
     dresser_open},
    {"never_hot", "(and (not (sometime (exists (?p - Potato) (hot ?p)))) (exists (?x - Mug) (at-end (hot ?x))))"},
    {"not_cool_any_more", "(exists (?x - (Mug :where (cool ?x))) (at-end (not (cool ?x))))", cooled_mug},
    {"go_to_a_room", "(exists (?r - living_room) (at-end (in_room agent ?r)))"},
    {"on_the_floor", "(exists (?x - Mug) (exists (?r - living_room) (at-end (in_room ?x ?r))))"},
    {"into_a_carried_box",
     "(exists (?x - Mug) (exists (?b - Box) (exists (?c - CounterTop) (at-end (and (inside ?x ?b) (on ?b ?c) (closed "
     "?b))))))",
     box_open},
};

class EveryGoalShape : public ::testing::TestWithParam<HouseCase> {};

TEST_P(EveryGoalShape, IsDemonstratedWithoutAFailedOrNeedlessStep) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene start = house();
  if (GetParam().edit != nullptr) {
    GetParam().edit(start);
    start = at_rest(std::move(start));
  }
  const Formula formula = goal(GetParam().goal);
  const auto result = demonstrate(formula, start, knowledge, profile, {});
  ASSERT_TRUE(std::holds_alternative<Demonstration>(result))
      << name_of(std::get<Rejection>(result).reason) << ": " << std::get<Rejection>(result).detail;
  const Demonstration& demonstration = std::get<Demonstration>(result);
  SCOPED_TRACE(plan_of(demonstration));
  RecordProperty("plan", plan_of(demonstration));
  EXPECT_EQ(replay(formula, start, demonstration, knowledge, profile), "");
  EXPECT_LE(demonstration.steps.size(), 50u);
  EXPECT_EQ(needless_steps(formula, start, demonstration, knowledge, profile), std::vector<std::string>());
  for (const DemonstrationStep& step : demonstration.steps) EXPECT_TRUE(step.outcome.success);
}

TEST(AnyStart, GivesASoundDemonstrationOrAKnownReason) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  using enum RejectionReason;
  const std::set<RejectionReason> reasons{NoPlan, ActionFailed, TooManySteps, TooManyFailures, GoalNotMet};
  int asked = 0, shown = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    const Scene start = strewn_house(rng.fork("house", seed));
    for (int i = 0; i < 4; ++i) {
      const HouseCase& about = kGoalCases[rng.below(std::size(kGoalCases))];
      SCOPED_TRACE(std::to_string(seed) + " " + about.name);
      const Formula formula = goal(about.goal);
      const auto result = demonstrate(formula, start, knowledge, profile, {});
      ++asked;
      if (const auto* rejection = std::get_if<Rejection>(&result)) {
        EXPECT_TRUE(reasons.contains(rejection->reason)) << name_of(rejection->reason);
        EXPECT_FALSE(rejection->detail.empty());
        continue;
      }
      ++shown;
      const Demonstration& demonstration = std::get<Demonstration>(result);
      SCOPED_TRACE(plan_of(demonstration));
      EXPECT_EQ(replay(formula, start, demonstration, knowledge, profile), "");
      EXPECT_EQ(needless_steps(formula, start, demonstration, knowledge, profile), std::vector<std::string>());
    }
  }
  EXPECT_GT(shown, asked * 3 / 4) << "of " << asked;
}

INSTANTIATE_TEST_SUITE_P(Catalog, EveryGoalShape, ::testing::ValuesIn(kGoalCases),
                         [](const auto& about) { return std::string(about.param.name); });

}  // namespace
}  // namespace unietp::testing
