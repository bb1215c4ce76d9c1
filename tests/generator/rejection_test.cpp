#include "generator/rejection.h"

#include <set>

#include <gtest/gtest.h>

#include "generator/gate.h"
#include "generator/referring.h"
#include "generator/style.h"
#include "templates/refinement_kinds.h"

namespace unietp {
namespace {

TEST(RejectionReason, EachHasANameOfItsOwnThatReadsBack) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kRejectionReasonCount; ++i) {
    const auto reason = static_cast<RejectionReason>(i);
    EXPECT_TRUE(names.insert(name_of(reason)).second) << name_of(reason);
    EXPECT_EQ(rejection_reason_named(name_of(reason)), reason);
  }
  EXPECT_EQ(rejection_reason_named("no-such-reason"), std::nullopt);
}

TEST(RejectionReason, BelongsToTheStageThatGivesIt) {
  EXPECT_EQ(stage_of(RejectionReason::NoWording), RejectionStage::Generator);
  EXPECT_EQ(stage_of(RejectionReason::NoLayout), RejectionStage::Grounding);
  EXPECT_EQ(stage_of(RejectionReason::NotSeen), RejectionStage::Grounding);
  EXPECT_EQ(stage_of(RejectionReason::NoWords), RejectionStage::Annotator);
  EXPECT_EQ(stage_of(RejectionReason::NotInM3), RejectionStage::Expert);
  EXPECT_EQ(stage_of(RejectionReason::DuplicateText), RejectionStage::Pipeline);
  EXPECT_EQ(name_of(stage_of(RejectionReason::Rejected)), "review");
}

TEST(RejectionReason, OfAGateIsNamedAfterIt) {
  for (int i = 0; i <= static_cast<int>(Gate::Reachable); ++i) {
    const auto gate = static_cast<Gate>(i);
    std::string name = "gate-" + std::string(name_of(gate));
    for (char& c : name) c = c == '_' ? '-' : c;
    EXPECT_EQ(name_of(rejection_of(gate)), name);
    EXPECT_EQ(stage_of(rejection_of(gate)), RejectionStage::Generator);
    EXPECT_NE(hint_for(rejection_of(gate)), "");
  }
}

TEST(Referring, EachButNoneIsARefinementOfGrounding) {
  for (std::size_t i = 0; i < kReferringCount; ++i) {
    const auto kind = static_cast<Referring>(i);
    EXPECT_EQ(referring_named(name_of(kind)), kind);
    const auto* info = refinement_kind(name_of(kind));
    EXPECT_EQ(info != nullptr && info->split == Split::InstanceGrounding, kind != Referring::None) << name_of(kind);
  }
  for (const auto& info : refinement_kinds())
    EXPECT_EQ(info.split == Split::InstanceGrounding, referring_named(info.name).has_value()) << info.name;
}

TEST(Style, EachButTheDirectOneIsALinguisticRefinement) {
  for (std::size_t i = 0; i < kStyleCount; ++i) {
    const auto style = static_cast<Style>(i);
    EXPECT_EQ(style_named(name_of(style)), style);
    const auto* kind = refinement_kind(name_of(style));
    EXPECT_EQ(kind != nullptr && kind->split == Split::Linguistic, style != Style::Direct) << name_of(style);
  }
  for (const auto& kind : refinement_kinds())
    EXPECT_EQ(kind.split == Split::Linguistic, style_named(kind.name).has_value());
}

}  // namespace
}  // namespace unietp
