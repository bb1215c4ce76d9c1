// Tables of runs with planted outcomes.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "scores/comparison.h"
#include "scores/figures.h"
#include "scores/result_files.h"
#include "scores/result_tables.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

constexpr std::array<int, 5> kTasks{42, 123, 130, 115, 126};  // of the benchmark's splits, as in its tables

std::vector<std::vector<std::string>> published(const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line :
       split(*read_file(UNIETP_SOURCE_DIR "/tests/scores/data/published_" + name + ".csv"), '\n')) {
    if (!line.empty()) rows.push_back(split(line, ','));
  }
  rows.erase(rows.begin());
  return rows;
}

/// A run in which the first `solved[mode][split]` tasks of each split are solved.
ScoredRun planted(const std::string& name, const std::vector<std::array<int, 5>>& solved) {
  ScoredRun run;
  run.name = name;
  run.manifest.setup.agent = {AgentKind::Model, name};
  run.manifest.setup.dataset = {"benchmark", "unietp-1.0", std::string(64, 'a'), 536};
  run.manifest.setup.program_version = "0.1.0";
  for (std::size_t mode = 0; mode < solved.size(); ++mode) {
    run.manifest.setup.settings[kModes[mode]] = settings_for(kModes[mode]);
    int number = 0;
    for (std::size_t s = 0; s < kTasks.size(); ++s) {
      for (int i = 0; i < kTasks[s]; ++i, ++number) {
        EpisodeScore score;
        score.key = {"task-" + std::to_string(number), kModes[mode], 1};
        score.simulator = name_of(kSimulators[static_cast<std::size_t>(number % 4)]);
        score.split = split_columns()[s].split;
        score.template_name = "t" + std::to_string(number % 9);
        score.layout = "home-" + std::to_string(number % 170);
        score.held_out = number % 3 == 0;
        score.success = i < solved[mode][s];
        score.progress = score.success ? 1 : 0;
        score.steps = 5 + number % 40;
        score.actions = score.replies = score.steps;
        if (!score.success) score.classes = {"goal: untouched"};
        run.scores.push_back(std::move(score));
      }
    }
  }
  run.manifest.totals.episodes = static_cast<int>(run.scores.size());
  return run;
}

const ResultTable& named(const std::vector<ResultTable>& tables, const std::string& id) {
  for (const ResultTable& table : tables) {
    if (table.id == id) return table;
  }
  throw std::runtime_error("no table " + id);
}

TEST(Tables, ReproduceThePublishedCellsToTheDigitAndTheirAverages) {
  for (const auto& row : published("main")) {
    SCOPED_TRACE(row[0]);
    std::vector<std::array<int, 5>> solved(2);
    for (std::size_t mode = 0; mode < 2; ++mode) {
      for (std::size_t s = 0; s < 5; ++s)
        solved[mode][s] = static_cast<int>(std::lround(std::stoi(row[1 + 6 * mode + s]) * kTasks[s] / 100.0));
    }
    const ScoredRun run = planted(row[0], solved);
    const auto tables = result_tables(std::span(&run, 1));
    const ResultTable& main = named(tables, "main");
    ASSERT_EQ(main.rows.size(), 1U);
    for (std::size_t mode = 0; mode < 2; ++mode) {
      int all = 0;
      for (std::size_t s = 0; s < 5; ++s) {
        EXPECT_EQ(main.rows[0][1 + 6 * mode + s].text, row[1 + 6 * mode + s]) << main.columns[1 + 6 * mode + s];
        all += solved[mode][s];
      }
      const std::string& average = main.rows[0][6 + 6 * mode].text;
      EXPECT_EQ(average, std::to_string(percent_of(all, 536)));
      EXPECT_NEAR(std::stoi(average), std::stoi(row[6 + 6 * mode]), 1);
    }
  }
}

TEST(Tables, WeightAsThePublishedAveragesDo) {
  const auto average = [](const std::vector<std::string>& row, std::size_t first, const auto& weights) {
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * std::stod(row[first + i]);
    return sum / 536;
  };
  for (const auto& row : published("main")) {
    for (const std::size_t first : {1U, 7U}) EXPECT_NEAR(average(row, first, kTasks), std::stod(row[first + 5]), 1);
  }
  // The heads of Li. and In. stand in the other order than the numbers below them, which are the main table's.
  for (const auto& row : published("feedback")) {
    for (const std::size_t first : {2U, 8U}) EXPECT_NEAR(average(row, first, kTasks), std::stod(row[first + 5]), 1);
  }
  const auto feedback = published("feedback").back(), main = published("main")[7];
  EXPECT_EQ(std::vector(feedback.begin() + 2, feedback.end()), std::vector(main.begin() + 1, main.end()));
  for (const auto& row : published("simulators")) {
    for (const std::size_t first : {1U, 6U})
      EXPECT_NEAR(average(row, first, std::array{182, 82, 82, 190}), std::stod(row[first + 4]), 1);
  }
}

TEST(Tables, StateOnWhatTheyWereMadeAndWhatIsMissing) {
  ScoredRun run = planted("m", {{40, 100, 100, 60, 90}});
  const std::string before = results_json(run, "d");
  for (const ResultTable& table : result_tables(std::span(&run, 1)))
    EXPECT_THAT(table.note, HasSubstr("Benchmark unietp-1.0, backend unietp, preset paper, unietp 0.1.0."));
  for (int i = 0; i < 2; ++i) {
    EpisodeScore& one = run.scores[static_cast<std::size_t>(i)];
    one.end = EpisodeOutcome::Errored;
    one.success = false;
    one.classes = {"errored: rate_limit"};
  }
  run.scores.pop_back();
  const auto tables = result_tables(std::span(&run, 1));
  EXPECT_THAT(named(tables, "main").note, HasSubstr("Incomplete: m, of 536 episodes 2 errored, 1 missing."));
  // 38 of the 40 that ended; 38 to 40 of 42.
  const ResultCell& cell = named(tables, "main").rows[0][1];
  EXPECT_EQ(cell.text, "95");
  EXPECT_THAT(cell.aside, HasSubstr("{90–95; 2 errored}"));
  EXPECT_NE(results_json(run, "d"), before);
}

TEST(Tables, AreTheSameInEachForm) {
  const std::vector<ScoredRun> runs{planted("first_model", {{40, 100, 100, 60, 90}}),
                                    planted("a|b", {{10, 20, 30, 40, 50}})};
  const auto tables = result_tables(runs);
  const std::string markdown = to_markdown(tables), latex = to_latex(tables), csv = to_csv(tables);
  EXPECT_THAT(markdown, HasSubstr("| a\\|b | 24 "));
  EXPECT_THAT(latex, HasSubstr("first\\_model & \\textbf{95} {\\tiny [84, 99]}"));
  EXPECT_THAT(csv, HasSubstr("first_model,95,\"[84, 99]\""));
  EXPECT_THAT(to_plain_text(tables), HasSubstr("95 [84, 99]"));
}

TEST(Comparison, TellsRunsApartOnlyWhereTheyDiffer) {
  const std::vector<ScoredRun> runs{planted("good", {{40, 100, 100, 60, 90}}),
                                    planted("alike", {{40, 99, 100, 61, 91}}), planted("bad", {{10, 20, 30, 10, 20}})};
  const auto pairs = compare_pairs(runs, Mode::M1);
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_FALSE(pairs[0].differ());
  EXPECT_TRUE(pairs[1].differ() && pairs[2].differ());
  const auto places = ranks(3, pairs);
  EXPECT_EQ(places[0].best, 1);
  EXPECT_EQ(places[0].worst, 2);
  EXPECT_EQ(places[1].worst, 2);
  EXPECT_EQ(places[2].best, 3);
  EXPECT_THAT(to_markdown(comparison_tables(runs)), HasSubstr("cannot be told apart"));
}

TEST(Comparison, RefusesToMixBenchmarks) {
  std::vector<ScoredRun> runs{planted("a", {{1, 1, 1, 1, 1}}), planted("b", {{1, 1, 1, 1, 1}})};
  EXPECT_TRUE(check_comparable(runs));
  runs[1].manifest.setup.dataset.version = "unietp-1.1";
  EXPECT_THAT(format(check_comparable(runs).error()), HasSubstr("was made on unietp-1.1, but \"a\" on unietp-1.0"));
  runs[1] = runs[0];
  runs[1].manifest.setup.dataset.digest[0] = 'b';
  EXPECT_FALSE(check_comparable(runs));
  runs[1] = runs[0];
  runs[1].manifest.setup.backend = "other";
  EXPECT_FALSE(check_comparable(runs));
}

TEST(Figures, CountRepeats) {
  ScoredRun run = planted("m", {{40, 100, 100, 60, 90}});
  const std::size_t tasks = run.scores.size();
  for (std::size_t i = 0; i < tasks; ++i) {
    EpisodeScore again = run.scores[i];
    again.key.repeat = 2;
    again.success = i % 2 == 0;
    run.scores.push_back(std::move(again));
  }
  const auto passes = pass_figures(episodes_where(run, [](const auto&) { return true; }));
  ASSERT_EQ(passes.size(), 2U);
  EXPECT_NEAR(passes[0].at, (390 + 268) / 1072.0, 1e-12);
  EXPECT_NEAR(passes[0].at, passes[0].all, 1e-12);
  EXPECT_NEAR(passes[1].at + passes[1].all, 2 * passes[0].at, 1e-12);
  EXPECT_EQ(percent_of(1, 200), 1);  // half a percent is rounded up
  EXPECT_EQ(percent_of(0, 0), 0);
}

TEST(Scores, AreReadAsTheyAreWritten) {
  const ScoredRun run = planted("m", {{40, 100, 100, 60, 90}});
  for (std::size_t i = 0; i < run.scores.size(); i += 37) {
    const auto read = read_score("scores.jsonl", 1, score_line(run.scores[i]));
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(*read, run.scores[i]);
  }
}

}  // namespace
}  // namespace unietp
