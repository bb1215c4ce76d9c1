#include "run/selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

CandidateRecord accepted(int slot, int attempt, const std::string& start, const std::string& text) {
  CandidateRecord record;
  record.slot = slot;
  record.attempt = attempt;
  record.accepted = true;
  record.start_key = start;
  record.text_key = text;
  return record;
}

TEST(Selection, FillsSlotsAndTurnsRepeatsAway) {
  Selection selection(0, 3);
  EXPECT_THAT(selection.open_slots(), ElementsAre(0, 1, 2));
  EXPECT_EQ(selection.offer(accepted(0, 0, "a", "A")), Selection::Verdict::Taken);
  EXPECT_EQ(selection.offer(accepted(1, 0, "a", "B")), Selection::Verdict::SameStart);
  EXPECT_EQ(selection.offer(accepted(2, 0, "c", "A")), Selection::Verdict::SameText);
  EXPECT_THAT(selection.open_slots(), ElementsAre(1, 2));
  EXPECT_EQ(selection.offer(accepted(1, 1, "b", "B")), Selection::Verdict::Taken);
  EXPECT_EQ(selection.offer(accepted(2, 1, "c", "C")), Selection::Verdict::Taken);
  EXPECT_THAT(selection.open_slots(), IsEmpty());
  EXPECT_EQ(selection.chosen(1), 1);
  EXPECT_EQ(selection.taken(), 3);
}

TEST(Selection, RemembersWhatAnyCandidateOfItsSlotsRepeated) {
  Selection selection(10, 2);
  selection.offer_all({accepted(10, 0, "a", "A"), accepted(11, 0, "a", "B"), accepted(10, 1, "b", "B"),
                       accepted(11, 1, "b", "A"), accepted(11, 2, "c", "C"), accepted(11, 3, "d", "D")});
  EXPECT_EQ(selection.chosen(10), 0);
  EXPECT_EQ(selection.chosen(11), 2);
  EXPECT_EQ(selection.verdict(11, 0), Selection::Verdict::SameStart);
  EXPECT_EQ(selection.verdict(11, 1), Selection::Verdict::SameText);
  EXPECT_EQ(selection.verdict(11, 2), Selection::Verdict::Taken);
}

}  // namespace
}  // namespace unietp
