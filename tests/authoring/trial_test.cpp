#include "authoring/trial.h"

#include <thread>

#include <gtest/gtest.h>

#include "../resources/committed.h"

#include "authoring/coverage.h"
#include "authoring/expert_success.h"
#include "authoring/verdict_text.h"

namespace unietp {
namespace {

RunConfiguration small_homes() {
  RunConfiguration configuration;
  configuration.rooms = 5;
  configuration.objects = 30;
  return configuration;
}

/// The whole table is `unietp template coverage`; here one simulator of those that a template claims is enough, and
/// each template begins with another one.
TEST(TryTemplate, EveryTemplateGivesAProvenTaskOnASimulatorThatItClaims) {
  const auto& templates = committed().templates;
  const auto configuration = small_homes();
  LayoutPool layouts(configuration, committed(), 8);
  const RunConfiguration whole;  // few small homes have a freezer
  LayoutPool whole_homes(whole, committed(), 24);
  std::vector<std::string> failures(templates.size());
  const auto work = [&](std::size_t first) {
    for (std::size_t i = first; i < templates.size(); i += 2) {
      const auto& claimed = templates[i].simulators;
      for (std::size_t k = 0; k < claimed.size(); ++k) {
        const auto simulator = claimed[(i + k) % claimed.size()];
        auto trial = try_template(configuration, committed(), layouts, i, simulator, {8, 1, nullptr});
        if (trial.tasks.empty()) trial = try_template(whole, committed(), whole_homes, i, simulator, {48, 1, nullptr});
        if (!trial.tasks.empty()) {
          failures[i].clear();
          break;
        }
        failures[i] += templates[i].name + " on " + std::string(name_of(simulator)) + "\n" + trial_text(trial);
      }
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  for (const auto& failure : failures) EXPECT_EQ(failure, "");
}

TEST(TryTemplate, DoesNotDependOnWhatElseTheLibraryHolds) {
  const auto configuration = small_homes();
  Resources alone = committed();
  alone.templates = {committed().templates[3]};
  LayoutPool many(configuration, committed(), 1), one(configuration, alone, 1);
  const auto simulator = alone.templates[0].simulators.front();
  const auto among = try_template(configuration, committed(), many, 3, simulator, {2, 0, nullptr});
  const auto single = try_template(configuration, alone, one, 0, simulator, {2, 0, nullptr});
  ASSERT_EQ(among.tasks.size(), single.tasks.size());
  for (std::size_t i = 0; i < among.tasks.size(); ++i)
    EXPECT_EQ(among.tasks[i].instruction.text, single.tasks[i].instruction.text);
}

TEST(Coverage, CountsWhatIsClaimedAndWhatIsEmpty) {
  std::vector<CoverageRow> rows(2);
  rows[0].name = "a";
  rows[0].predicates = {"inside", "on"};
  rows[0].cells[0] = {true, 10, 7, "", {}};
  rows[0].cells[2] = {true, 10, 0, "", {{RejectionReason::NoPlan, 10, "no way"}}};
  rows[1].name = "b";
  rows[1].predicates = {"on"};
  rows[1].cells[0] = {true, 0, 0, "", {}};
  EXPECT_EQ(claimed_cells(rows).size(), 3U);
  EXPECT_EQ(empty_cells(rows).size(), 2U);
  EXPECT_EQ(to_text(rows[0].cells[0]), "7/10");
  EXPECT_EQ(to_text(rows[0].cells[1]), "");
  EXPECT_EQ(to_text(rows[1].cells[0]), "yes");
  for (const auto& use : predicate_uses(rows)) {
    const auto expected = use.predicate == "on"       ? std::array<int, 4>{2, 0, 1, 0}
                          : use.predicate == "inside" ? std::array<int, 4>{1, 0, 1, 0}
                                                      : std::array<int, 4>{};
    EXPECT_EQ(use.templates, expected) << use.predicate;
  }
  const auto page = coverage_page(rows, {Mode::M1, Mode::M3}, 10, 1);
  EXPECT_NE(page.find("| a | atomic | 7/10 |  | 0/10 |  | inside on |"), std::string::npos) << page;
  EXPECT_NE(page.find("- `a` on habitat: expert no-plan (10), such as: no way."), std::string::npos) << page;
  EXPECT_NE(page.find("--modes M1,M3"), std::string::npos) << page;
}

TEST(Coverage, SaysHowManyOfTheCandidatesWithAStartTheExpertShowed) {
  std::vector<CoverageRow> rows(1);
  rows[0].name = "a";
  rows[0].cells[0] = {true,
                      10,
                      4,
                      "",
                      {{RejectionReason::NoSpot, 2, ""},
                       {RejectionReason::ActionFailed,
                        3,
                        "",
                        {"for a: b(c_1): No room on c_1.", "no way", "for d: b(c_2): No room on c_2."},
                        {{Failure::NoFreePlace, 2}}},
                       {RejectionReason::NoWords, 1, ""}}};
  rows[0].cells[1] = {true, 10, 10, "", {}};
  const auto success = expert_success(rows[0].cells[0]);
  EXPECT_EQ(success.grounded, 8);
  EXPECT_EQ(success.shown, 5);
  const auto tables = expert_success_tables(rows);
  EXPECT_NE(tables.find("| ai2thor | 8 | 5 | 62 % | action-failed 1, action-failed (no_free_place) 2 |"),
            std::string::npos)
      << tables;
  EXPECT_NE(tables.find("| virtualhome | 10 | 10 | 100 % |  |"), std::string::npos) << tables;
  EXPECT_EQ(tables.find("`a` on virtualhome"), std::string::npos) << tables;
  EXPECT_NE(tables.find("| `a` on ai2thor | 8 | 5 | 62 % | action-failed 1, "), std::string::npos) << tables;
  EXPECT_NE(coverage_page(rows, {Mode::M1}, 10, 1).find("| grounding | `no-spot` | 2 |  |  |  |"), std::string::npos);
}

}  // namespace
}  // namespace unietp
