// Every field of every file of a data set is changed in turn, with the checksums made right again, as a forger would:
// `validate` refuses them, but for free text, for settings that leave no trace, and for starts that are as sound.
#include <cstdio>
#include <cstdlib>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text.h"
#include "forger.h"
#include "scene/scene_json.h"
#include "validator/field_rules.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct Tally {
  int tried = 0, refused = 0, free = 0, settings = 0;
  std::vector<std::string> passed;  // what should have been refused
};

bool has_rule(const Forgery& forgery, FieldRule rule) {
  constexpr std::string_view kRun = "configuration.";
  const std::string_view field = forgery.field;
  const auto* found = forgery.file == "reviews.jsonl"   ? rule_of("review-mark", field)
                      : forgery.file == "tasks.jsonl"   ? rule_of("task", field)
                      : forgery.file != "manifest.json" ? nullptr
                      : field.starts_with(kRun)         ? rule_of("run", field.substr(kRun.size()))
                                                        : rule_of("manifest", field);
  return found != nullptr && found->rule == rule;
}

std::string name_of_forgery(const Forgery& forgery) {
  return forgery.file + " " + forgery.field + ", " + forgery.how + ": " + forgery.where;
}

Tally try_all(const std::vector<Forgery>& all) {
  Tally tally;
  for (const Forgery& forgery : all) {
    ++tally.tried;
    if (!forgery.validate(forged_set()).problems.empty()) {
      ++tally.refused;
    } else if (has_rule(forgery, FieldRule::Free)) {
      ++tally.free;
    } else if (has_rule(forgery, FieldRule::Setting)) {
      ++tally.settings;
    } else {
      tally.passed.push_back(name_of_forgery(forgery));
    }
  }
  std::printf("%d changes: %d refused, %d of free text, %d of settings, %zu others passed\n", tally.tried,
              tally.refused, tally.free, tally.settings, tally.passed.size());
  for (const auto& passed : tally.passed) std::printf("passed: %s\n", passed.c_str());
  return tally;
}

TEST(Mutation, TheSetItselfIsSoundAndSoIsItsTextWrittenAgain) {
  const auto report = forged_set().unchanged();
  for (const Problem& problem : report.problems)
    ADD_FAILURE() << name_of(problem.kind) << " " << problem.task << " " << format(problem.error);
  EXPECT_EQ(report.counts.proven, 19);
  for (const auto& file : forged_set().files()) {
    const std::string& text = forged_set().text(file);
    if (file.ends_with(".gz")) {
      const auto scene = scene_from_json(file, Json::parse(text).dump());
      EXPECT_TRUE(scene && scene_to_json(*scene) == text) << file;
    }
    if (!file.ends_with(".jsonl")) continue;
    for (const auto& line : split(text, '\n')) {
      if (line.empty()) continue;
      EXPECT_EQ(Json::parse(Json::parse(line).dump()), Json::parse(line)) << file;
    }
  }
}

/// A change of each field, whichever way comes first.
TEST(Mutation, ASampleIsRefused) {
  std::set<std::string> seen;
  std::vector<Forgery> sample;
  std::size_t number = 0;
  for (auto& forgery : forgeries(forged_set(), 1)) {
    if (++number % 12 == 0) sample.push_back(std::move(forgery));
  }
  EXPECT_GT(sample.size(), 60U);
  const auto tally = try_all(sample);
  EXPECT_LE(tally.passed.size() * 50, sample.size());
}

/// Minutes: run it with UNIETP_EVERY_FIELD=1.
TEST(Mutation, EveryFieldIsChecked) {
  if (std::getenv("UNIETP_EVERY_FIELD") == nullptr) GTEST_SKIP() << "a long run: set UNIETP_EVERY_FIELD=1";
  const auto tally = try_all(forgeries(forged_set(), 4));
  EXPECT_GE(tally.tried, 2000);
  EXPECT_LE(tally.passed.size() * 100, static_cast<std::size_t>(tally.tried));
}

}  // namespace
}  // namespace unietp
