#include "dataset/candidate.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dataset/lines.h"

namespace unietp {
namespace {

TEST(NormalizedText, ForgetsCasePunctuationAndBlanksButNoWord) {
  EXPECT_EQ(normalized_text("  Put the Mug,  on the table! "), "put the mug on the table");
  EXPECT_EQ(normalized_text("put 2 mugs"), "put 2 mugs");
  EXPECT_NE(normalized_text("put a mug on a table"), normalized_text("put a mug on the table"));
  EXPECT_EQ(normalized_text(""), "");
}

TEST(RecordOf, ARejectedCandidateKeepsStageReasonAndWhatItWasGoingToBe) {
  const RejectedCandidate rejected{
      {RejectionReason::NoFreePlace, "Mug hits \"Table_1\""}, "place-one-on", Simulator::Habitat, Split::Logical, 4, 2};
  const auto record = record_of(rejected);
  EXPECT_FALSE(record.accepted);
  EXPECT_EQ(record.slot, 4);
  EXPECT_EQ(record.attempt, 2);
  const auto line = nlohmann::ordered_json::parse(line_of(record.rejection));
  EXPECT_EQ(line["stage"], "grounding");
  EXPECT_EQ(line["reason"], "no-free-place");
  EXPECT_EQ(line["detail"], "Mug hits \"Table_1\"");
  EXPECT_EQ(line["simulator"], "habitat");
  EXPECT_EQ(line["split"], "logical");
}

}  // namespace
}  // namespace unietp
