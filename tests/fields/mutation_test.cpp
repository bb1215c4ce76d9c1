// Every field of every file of a data set is changed in turn, with the checksums made right again, as a forger would:
// `validate` refuses them, but for a few fields that are named here.
#include <algorithm>
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text.h"
#include "forger.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// Changes of a field of a kind of file that may pass; `how`: "" for all ways.
struct Passing {
  std::string_view file, field, how;
  auto operator<=>(const Passing&) const = default;
};

/// What may pass, all that there is (docs/trust.md). Beside it, only changes of the card's prose do.
constexpr Passing kMayPass[] = {
    {"manifest.json", "configuration.attempts", ""},       // above the number that was needed, it leaves no trace
    {"manifest.json", "configuration.block", ""},          // how many tasks were planned together: likewise
    {"reviews.jsonl", "comment", ""},                      // a person's words
    {"demonstrations/M1.jsonl", "tempting[]", "swapped"},  // of two steps either may come first: as good a plan
};

struct Tally {
  int tried = 0, refused = 0;
  std::map<Passing, int> passed;    // of those above
  std::vector<std::string> faults;  // what passed and should have been refused
};

Tally try_all(const std::vector<Forgery>& all) {
  Tally tally;
  for (const Forgery& forgery : all) {
    ++tally.tried;
    if (!forgery.validate(forged_set()).problems.empty()) {
      ++tally.refused;
      continue;
    }
    const auto named = std::find_if(std::begin(kMayPass), std::end(kMayPass), [&](const Passing& one) {
      return one.file == forgery.file && one.field == forgery.field && (one.how.empty() || one.how == forgery.how);
    });
    if (named != std::end(kMayPass)) ++tally.passed[*named];
    if (named == std::end(kMayPass))
      tally.faults.push_back(forgery.file + " " + forgery.field + ", " + forgery.how + ": " + forgery.where);
  }
  std::printf("%d changes, %d refused\n", tally.tried, tally.refused);
  for (const auto& [named, count] : tally.passed)
    std::printf("passed, as it may: %s %s %s, %d times\n", std::string(named.file).c_str(),
                std::string(named.field).c_str(), std::string(named.how).c_str(), count);
  return tally;
}

void expect_sound(const ValidationReport& report) {
  for (const Problem& problem : report.problems)
    ADD_FAILURE() << name_of(problem.kind) << " " << problem.task << " " << format(problem.error);
  EXPECT_EQ(report.counts.proven, 19);
}

/// What only some tasks have must be there to be changed.
TEST(Mutation, TheSetHasWhatIsRare) {
  using ::testing::HasSubstr;
  const auto& set = forged_set();
  for (const char* field : {"\"tempting\":[", "\"moments\":[", "\"tidying\":true"})
    EXPECT_THAT(set.text("demonstrations/M1.jsonl"), HasSubstr(field));
  for (const char* file : {"demonstrations/M2.jsonl", "demonstrations/M3.jsonl"})
    EXPECT_THAT(set.text(file), HasSubstr("\"search\":true"));
  for (const char* field : {"\"others\":[", "\"complex\":{", "\"contrast\":{", "\"referring\":{"})
    EXPECT_THAT(set.text("wordings.jsonl"), HasSubstr(field));
}

TEST(Mutation, TheSetItselfIsSound) { expect_sound(forged_set().unchanged()); }

/// What the forger does besides its changes is no reason to refuse a file: it writes lines anew, with other digits of
/// the same numbers where its library takes a digit more than the shortest text.
TEST(Mutation, TheSetWrittenAgainIsSound) {
  for (const auto& file : forged_set().files()) {
    SCOPED_TRACE(file);
    const std::string& text = forged_set().text(file);
    if (file.ends_with(".gz")) {
      const auto scene = scene_from_json(file, Json::parse(text).dump());
      EXPECT_TRUE(scene && scene_to_json(*scene) == text);
    }
    if (!file.ends_with(".jsonl")) continue;
    auto lines = split(text, '\n');
    for (auto& line : lines) {
      if (!line.empty()) line = Json::parse(line).dump();
    }
    expect_sound(forged_set().with(file, join(lines, "\n")));
  }
}

/// Tasks would then be in other homes.
TEST(Mutation, BlocksThatTheHomesDoNotFitAreRefused) {
  auto manifest = Json::parse(forged_set().text("manifest.json"));
  for (const int block : {3, 8}) {
    manifest["configuration"]["block"] = block;
    const auto problems = forged_set().with("manifest.json", manifest.dump(2) + "\n").problems;
    EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const Problem& problem) {
      return problem.kind == ProblemKind::HomeFile;
    })) << block;
  }
}

/// The outermost field; of the manifest and of tables each field.
std::string part_of(const Forgery& forgery) {
  const bool each = forgery.file == "dataset.sqlite" || forgery.file == "manifest.json";
  return forgery.file + " " + (each ? forgery.field : forgery.field.substr(0, forgery.field.find_first_of(".[")));
}

/// A change of each part of each file, in turn another way.
TEST(Mutation, ASampleIsRefused) {
  std::map<std::string, std::vector<Forgery>> by_part;
  for (auto& forgery : forgeries(forged_set(), 1)) by_part[part_of(forgery)].push_back(std::move(forgery));
  std::vector<Forgery> sample;
  for (auto& [part, changes] : by_part) sample.push_back(std::move(changes[sample.size() % changes.size()]));
  EXPECT_GT(sample.size(), 100U);
  EXPECT_THAT(try_all(sample).faults, ::testing::IsEmpty());
}

/// Minutes: run it with UNIETP_THOROUGH=1.
TEST(Mutation, EveryFieldIsChecked) {
  if (std::getenv("UNIETP_THOROUGH") == nullptr) GTEST_SKIP() << "a long run: set UNIETP_THOROUGH=1";
  const auto tally = try_all(forgeries(forged_set(), 2));
  EXPECT_GE(tally.tried, 2000);
  EXPECT_THAT(tally.faults, ::testing::IsEmpty());
  for (const auto& named : kMayPass)
    EXPECT_TRUE(tally.passed.contains(named)) << named.file << " " << named.field << " is always refused";
}

}  // namespace
}  // namespace unietp
