#include "report/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/charts.h"
#include "report/figure_table.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Histogram of(std::initializer_list<int> values) {
  Histogram histogram;
  for (const int value : values) histogram.add(value);
  return histogram;
}

DatasetStatistics small(const std::string& name) {
  DatasetStatistics set;
  set.name = name;
  set.tasks = 3;
  set.by_simulator_and_split = {{{"ai2thor", "atomic"}, 2}, {{"habitat", "logical"}, 1}};
  set.templates = {{"open-one", 2}, {"close-one", 1}};
  set.instruction_words = of({4, 5, 12});
  set.plan_lengths = {{"M1", of({3, 4, 8})}};
  set.actions = {{"M1", {{"go_to", 7}, {"stop", 3}}}};
  set.failed_steps = {{"M1", 0}};
  set.funnel = {{"close-one", 1, {{"expert: action-failed", 2}}}, {"open-one", 2, {}}};
  set.evenness = {{"template", {{"open-one", 2}, {"close-one", 1}}, 1.8, 1.89, 0.33}};
  return set;
}

TEST(Histogram, KnowsItsMiddle) {
  EXPECT_DOUBLE_EQ(of({4, 5, 12}).mean(), 7);
  EXPECT_DOUBLE_EQ(of({4, 5, 12}).median(), 5);
  EXPECT_DOUBLE_EQ(of({1, 2, 4, 9}).median(), 3);
  EXPECT_EQ(of({4, 5, 12}).most(), 12);
  EXPECT_DOUBLE_EQ(Histogram().mean(), 0);
  EXPECT_DOUBLE_EQ(Histogram().median(), 0);
}

TEST(FunnelRow, AddsUp) { EXPECT_EQ(small("a").candidates(), 5); }

TEST(Tables, OneSetHasACrossTableAndSeveralStandSideBySide) {
  const std::vector<DatasetStatistics> sets{small("a"), small("b")};
  const auto one = table_text(tables_of({sets.data(), 1}), 100);
  EXPECT_THAT(one, HasSubstr("  simulator  atomic  logical  all\n  ai2thor         2        0    2\n"));
  EXPECT_THAT(one, HasSubstr("close-one               1 of 3  expert: action-failed (2)"));
  const auto two = table_text(tables_of(sets), 100);
  EXPECT_THAT(two, HasSubstr("                       a       b\n  tasks                3       3\n"));
  EXPECT_THAT(two, HasSubstr("  ai2thor, atomic"));
}

TEST(Tables, ALongOneSaysWhatItLeavesOut) {
  auto set = small("a");
  for (const auto& word : {"a1", "a2", "a3"}) set.words[word] = 1;
  EXPECT_THAT(table_text(tables_of({&set, 1}), 2), HasSubstr("… and 1 more; --json prints all"));
}

TEST(Numbers, AreWrittenForPeople) {
  EXPECT_EQ(count_text(1234567), "1,234,567");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(decimal_text(3), "3.0");
  EXPECT_EQ(percent_text(0.8163), "81.6 %");
}

TEST(Charts, EachHasATableAndAsManyValuesAsLabels) {
  const auto set = small("a");
  std::vector<std::string> tables;
  for (const auto& table : tables_of({&set, 1})) tables.push_back(table.id);
  for (const auto& section : chart_sections(set)) {
    for (const auto& chart : section.charts) {
      EXPECT_THAT(tables, ::testing::Contains(chart.table));
      for (const auto& series : chart.series) EXPECT_EQ(series.values.size(), chart.labels.size()) << chart.id;
    }
  }
}

TEST(Charts, BinsAreWideEnoughForAllValues) {
  auto set = small("a");
  set.objects = of({3, 250});
  for (const auto& section : chart_sections(set)) {
    for (const auto& chart : section.charts) {
      if (chart.id != "objects") continue;
      EXPECT_LE(chart.labels.size(), 24U);
      EXPECT_EQ(chart.labels.front(), "0–19");
      EXPECT_EQ(chart.series[0].values.front(), 1);
      EXPECT_EQ(chart.series[0].values.back(), 1);
    }
  }
}

}  // namespace
}  // namespace unietp
