#include "scene/action.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "scene/states.h"
#include "scene/treatment.h"

namespace unietp {
namespace {

long count_offered(Mode mode) {
  return std::count_if(all_actions().begin(), all_actions().end(),
                       [&](const ActionInfo& action) { return offers(action, mode); });
}

std::vector<std::string> lines_of(const char* file) {
  const auto page = read_file(std::string(UNIETP_SOURCE_DIR) + file);
  return page ? split(*page, '\n') : std::vector<std::string>();
}

/// The paper's numbers: "M1/M2/M3 contains 38/32/32 actions types".
TEST(Actions, EachModeOffersAsManyAsThePaperSays) {
  EXPECT_EQ(all_actions().size(), 38u);
  EXPECT_EQ(count_offered(Mode::M1), 38);
  EXPECT_EQ(count_offered(Mode::M2), 32);
  EXPECT_EQ(count_offered(Mode::M3), 32);
}

TEST(Actions, TheWideProfileHasTheExtensionInPlaceOfSmallMoves) {
  ActionSet plain, wide, wide_atomic;
  for (const Simulator simulator : kSimulators) {
    plain |= actions_of(simulator);
    wide |= actions_of(simulator, ActionProfile::Wide);
  }
  EXPECT_EQ(plain.count(), 38u);
  EXPECT_EQ(wide.count(), plain.count() - 7 + extension_actions().size());
  EXPECT_EQ((plain & wide).count(), 31u);
  for (const ActionInfo& action : extension_actions()) {
    EXPECT_TRUE(wide[static_cast<std::size_t>(action.type)]) << action.name;
    EXPECT_FALSE(plain[static_cast<std::size_t>(action.type)]) << action.name;
    EXPECT_TRUE(action.m1 && action.m2) << action.name;
    EXPECT_EQ(action.m3, action.type != ActionType::Read) << action.name << ": M3 cannot name what is held";
  }
  EXPECT_EQ(action_profile_named("wide"), ActionProfile::Wide);
  EXPECT_EQ(action_profile_named(name_of(ActionProfile::Unietp)), ActionProfile::Unietp);
  EXPECT_EQ(action_profile_named("wider"), std::nullopt);
}

TEST(Actions, ClassesHaveTheirSizes) {
  std::map<std::string, int> sizes;
  for (const ActionInfo& action : all_actions()) ++sizes[std::string(name_of(action.group))];
  EXPECT_EQ(sizes, (std::map<std::string, int>{
                       {"movement", 15}, {"reach", 2}, {"manipulation", 14}, {"composite", 6}, {"control", 1}}));
}

TEST(Actions, NamesLeadBackToTheirType) {
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      EXPECT_EQ(action_named(action.name), action.type);
      EXPECT_EQ(&info(action.type), &action);
    }
  }
  EXPECT_EQ(action_named("fly"), std::nullopt);
  EXPECT_EQ(action_named(""), std::nullopt);
}

TEST(Actions, OnlyTheCompositesAndSoakingTakeATool) {
  for (const ActionInfo& action : all_actions()) {
    const bool tool = action.group == ActionClass::Composite || action.type == ActionType::SoakWith;
    EXPECT_EQ(action.argument == ActionArgument::Tool, tool) << action.name;
  }
}

TEST(Actions, EveryDirectActionIsFoundByItsStateAndNeedsOneAffordance) {
  std::set<Predicate> states;
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      if (!action.direct) continue;
      const Predicate state = action.changes.front().state;
      EXPECT_TRUE(states.insert(state).second) << action.name << ": another action is for this state";
      EXPECT_EQ(direct_action(state), action.type) << action.name;
      EXPECT_EQ(action.changes.front().only_if, std::nullopt) << action.name;
      EXPECT_NE(affordance_for(action), "") << action.name;
      if (!info(state).group.empty()) {
        EXPECT_EQ(affordance_for(action), info(state).group) << action.name;
      }
    }
  }
  EXPECT_EQ(direct_action(Predicate::Hot), std::nullopt);
  EXPECT_EQ(direct_action(Predicate::Empty), std::nullopt) << "breaking empties, but is not for that";
}

TEST(Actions, NeedsWithARuleOrAStateOfAnotherGroupCanBeMetByAnotherAction) {
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      for (const ActionNeed& need : action.needs) {
        if (need.kind != ActionNeed::Kind::IsNot || need.rule == ActionRule::Always || !action.direct) continue;
        const auto other = opposite_of(need.state);
        ASSERT_TRUE(other) << action.name;
        EXPECT_TRUE(direct_action(*other)) << action.name << " cannot be made ready";
      }
    }
  }
}

TEST(Actions, FailuresFollowFromTheNeedsInOrderWithoutRepeats) {
  using enum Failure;
  EXPECT_EQ(failures_of(info(ActionType::Slice)),
            (std::vector{NotSliceable, NoKnife, InsideClosed, TooFar, NotVisible}));
  EXPECT_EQ(failures_of(info(ActionType::Open)),
            (std::vector{NotOpenable, InsideClosed, TooFar, NotVisible, AlreadyOpen, AlreadyOn, Blocked}));
  EXPECT_EQ(failures_of(info(ActionType::Stop)), std::vector<Failure>());
}

TEST(Treatments, NamesLeadBackAndThoseThatTreatWhatIsHeldSetAState) {
  for (const TreatmentInfo& row : all_treatments()) {
    EXPECT_EQ(treatment_named(row.name), row.treatment);
    EXPECT_EQ(row.treats.has_value(), !row.states.empty()) << row.name;
    if (row.treats) {
      EXPECT_EQ(info(*row.treats).argument, ActionArgument::Tool) << row.name;
    }
  }
  EXPECT_EQ(treatment_named("tickles"), std::nullopt);
}

TEST(Actions, TextNamesTheArguments) {
  EXPECT_EQ(to_text({ActionType::PlaceIn, {"sink_1"}}), "place_in(sink_1)");
  EXPECT_EQ(to_text({ActionType::Stop, {}}), "stop");
}

TEST(Failures, NamesAreDistinctAndLeadBackAndThePageListsThemInOrder) {
  std::vector<std::string> names;
  for (int i = 0; i < static_cast<int>(kFailureCount); ++i) {
    const auto failure = static_cast<Failure>(i);
    EXPECT_EQ(failure_named(name_of(failure)), failure);
    names.emplace_back(name_of(failure));
  }
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(name_of(Failure::TooFar), "too_far");
  EXPECT_EQ(name_of(Failure::NoKnife), "no_knife");
  EXPECT_EQ(name_of(Failure::NotReady), "not_ready");
  EXPECT_EQ(failure_named("bored"), std::nullopt);

  std::vector<std::string> listed;
  for (const std::string& line : lines_of("/docs/actions.md")) {
    const auto cells = split(line, '|');
    if (cells.size() == 4 && failure_named(trim(cells[1]))) listed.emplace_back(trim(cells[1]));
  }
  EXPECT_EQ(listed, names);
}

}  // namespace
}  // namespace unietp
