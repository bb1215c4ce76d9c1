#include "run/ledger.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../resources/committed.h"
#include "core/files.h"
#include "run/block_run.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

class LedgerFile : public ::testing::Test {
 protected:
  void SetUp() override {
    path_ = std::filesystem::path(::testing::TempDir()) /
            (std::string("ledger_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".sqlite");
    TearDown();
  }
  void TearDown() override {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(path_.string() + end);
  }
  std::filesystem::path path_;
};

CandidateRecord full_record() {
  CandidateRecord record;
  record.slot = 3;
  record.attempt = 1;
  record.accepted = true;
  record.template_name = "open-one";
  record.task.row = {"x",
                     "atomic",
                     "ai2thor",
                     "open-one",
                     "scene",
                     "layout",
                     "(goal)",
                     "Open it.",
                     "direct",
                     "grammar",
                     "usual",
                     "virtualhome virtualhome-unity",
                     {{"A", "Fridge"}, {"B", ""}},
                     {{Mode::M1, "go_to", "fridge_1", true, "none"},
                      {Mode::M1, "stop", "", true, "none"},
                      {Mode::M3, "open", "{\"bbox\":[1,2,3,4]}, b", false, "too-far"}}};
  record.task.line = "{\"id\":\"x\"}";
  record.task.shown = {"{}", "{\"mode\":\"M3\"}"};
  record.start_key = "start";
  record.text_key = "text";
  return record;
}

TEST_F(LedgerFile, GivesBackWhatItWasGivenAfterReopening) {
  {
    auto ledger = Ledger::open(path_, "run 1");
    ASSERT_TRUE(ledger) << format(ledger.error());
    ASSERT_TRUE(ledger->add(full_record(), {}));
  }
  auto ledger = Ledger::open(path_, "run 1");
  ASSERT_TRUE(ledger) << format(ledger.error());
  const auto record = ledger->read(3, 1);
  ASSERT_TRUE(record);
  EXPECT_EQ(*record, full_record());
  const auto outlines = ledger->outlines(0, 1000);
  ASSERT_TRUE(outlines);
  ASSERT_EQ(outlines->size(), 1U);
  EXPECT_EQ(outlines->front().text_key, "text");
  EXPECT_EQ(outlines->front().task, WrittenTask());
  EXPECT_EQ(outlines->front(), outline_of(full_record()));
}

TEST_F(LedgerFile, KeepsAHomeOnce) {
  const std::string packed = gzip(std::string("a\0b\xff", 4));  // bytes of all kinds
  int asked = 0;
  const auto pack = [&] {
    ++asked;
    return packed;
  };
  {
    auto ledger = Ledger::open(path_, "run 1");
    ASSERT_TRUE(ledger) << format(ledger.error());
    ASSERT_TRUE(ledger->keep_home("home 1", pack));
    ASSERT_TRUE(ledger->keep_home("home 1", pack));
  }
  EXPECT_EQ(asked, 1);
  auto ledger = Ledger::open(path_, "run 1");
  ASSERT_TRUE(ledger) << format(ledger.error());
  const auto home = ledger->home("home 1");
  ASSERT_TRUE(home) << format(home.error());
  EXPECT_EQ(*home, packed);
  const auto none = ledger->home("home 2");
  ASSERT_FALSE(none);
  EXPECT_THAT(format(none.error()), HasSubstr("lacks the home home 2"));
}

TEST_F(LedgerFile, RefusesAnotherRunAndNamesBoth) {
  ASSERT_TRUE(Ledger::open(path_, "seed 1"));
  const auto other = Ledger::open(path_, "seed 2");
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("seed 1"));
  EXPECT_THAT(other.error().message, HasSubstr("seed 2"));
}

TEST_F(LedgerFile, RefusesACandidateTwiceAndOneThatIsNotThere) {
  auto ledger = Ledger::open(path_, "run");
  ASSERT_TRUE(ledger);
  ASSERT_TRUE(ledger->add(full_record(), {}));
  EXPECT_FALSE(ledger->add(full_record(), {}));
  EXPECT_FALSE(ledger->read(0, 0));
}

TEST_F(LedgerFile, SaysWhenTheFileIsNoLedger) {
  ASSERT_TRUE(write_file(path_, std::string(5000, 'x')));
  const auto ledger = Ledger::open(path_, "run");
  ASSERT_FALSE(ledger);
  EXPECT_EQ(ledger.error().kind, Error::Kind::Io);
}

TEST_F(LedgerFile, AnAttemptThatARunDoesNotMakeIsRefusedWhenTheRunGoesOn) {
  auto ledger = Ledger::open(path_, "run 1");
  ASSERT_TRUE(ledger) << format(ledger.error());
  CandidateRecord record = full_record();
  record.attempt = 1000;
  ASSERT_TRUE(ledger->add(record, {}));
  const RunConfiguration configuration;
  const auto slots = plan_slots(configuration, committed());
  ASSERT_TRUE(slots) << format(slots.error());
  const auto blocks = blocks_of(configuration, committed(), *slots);
  BlockRun run(configuration, committed(), blocks.front(), *ledger, {});
  const auto batch = run.next_batch();
  ASSERT_FALSE(batch);
  EXPECT_THAT(format(batch.error()),
              HasSubstr("slot 3 has an attempt 1000 of " + std::to_string(configuration.attempts)));
}

}  // namespace
}  // namespace unietp
