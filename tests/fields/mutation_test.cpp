// Every field of every file of a data set is changed in turn, with the checksums made right again, as a forger would:
// `validate` refuses each of them, but for what is free text.
#include <cstdio>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text.h"
#include "forger.h"
#include "validator/field_rules.h"

namespace unietp {
namespace {

using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;

struct Tally {
  int tried = 0, refused = 0, free = 0;
  std::vector<std::string> passed;  // what should have been refused
};

/// Whether people wrote what stands there, or it is written for them.
bool is_free_text(const Forgery& forgery) {
  const auto* rule = forgery.file == "reviews.jsonl" ? rule_of("review-mark", forgery.field)
                     : forgery.file == "tasks.jsonl" ? rule_of("task", forgery.field)
                                                     : nullptr;
  return rule != nullptr && rule->rule == FieldRule::Free;
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
    } else if (is_free_text(forgery)) {
      ++tally.free;
    } else {
      tally.passed.push_back(name_of_forgery(forgery));
    }
  }
  std::printf("%d changes: %d refused, %d of free text, %zu passed\n", tally.tried, tally.refused, tally.free,
              tally.passed.size());
  return tally;
}

TEST(Mutation, TheSetItselfIsSoundAndSoIsItsTextWrittenAgain) {
  const auto report = forged_set().unchanged();
  for (const Problem& problem : report.problems)
    ADD_FAILURE() << name_of(problem.kind) << " " << problem.task << " " << format(problem.error);
  EXPECT_EQ(report.counts.proven, 19);
  for (const auto& file : forged_set().files()) {
    const std::string& text = forged_set().text(file);
    if (file.ends_with(".gz")) EXPECT_EQ(Json::parse(text).dump(), std::string(trim(text))) << file;
    if (!file.ends_with(".jsonl")) continue;
    for (const auto& line : split(text, '\n')) {
      if (!line.empty()) EXPECT_EQ(Json::parse(line).dump(), line) << file;
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
  EXPECT_THAT(try_all(sample).passed, IsEmpty());
}

TEST(Mutation, EveryFieldIsChecked) {
  const auto tally = try_all(forgeries(forged_set(), 4));
  EXPECT_GE(tally.tried, 2000);
  EXPECT_EQ(tally.passed.size(), 0U);
  for (const auto& passed : tally.passed) std::printf("passed: %s\n", passed.c_str());
}

}  // namespace
}  // namespace unietp
