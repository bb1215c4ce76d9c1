#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <iterator>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../json_mutator.h"
#include "../sqlite_mutator.h"
#include "../support.h"
#include "akb/knowledge.h"
#include "broken.h"
#include "core/files.h"
#include "core/text.h"
#include "record/task_record.h"

namespace unietp {
namespace {

std::string seed_bytes(const std::string& name) {
  const auto bytes = read_file(std::filesystem::path(UNIETP_SOURCE_DIR) / "tests/fuzz/seeds" / name);
  EXPECT_TRUE(bytes) << name;
  return bytes ? *bytes : std::string();
}

/// A reason without the names and numbers in it, so that it stands for the line of code that gives it.
std::string without_details(const std::string& reason) {
  std::string plain;
  bool quoted = false;
  for (const char c : reason) {
    if (c == '"' || c == '\'') quoted = !quoted;
    if (!quoted && std::isdigit(static_cast<unsigned char>(c)) == 0) plain += c;
  }
  return plain;
}

/// What a reader says of a text that it refuses; "" for one that it takes, and for one that its parser refuses.
using Reason = std::function<std::string(const std::string&)>;

/// The different reasons for which changes of a text are refused.
std::set<std::string> reasons_of(int tries, const Reason& reason, const std::function<std::string(Rng)>& change) {
  std::set<std::string> reasons;
  for (int i = 0; i < tries; ++i) reasons.insert(without_details(reason(change(Rng(static_cast<std::uint64_t>(i))))));
  return reasons;
}

/// What one way of changing a text reaches that another does not.
std::set<std::string> without(const std::set<std::string>& some, const std::set<std::string>& others) {
  std::set<std::string> left;
  std::set_difference(some.begin(), some.end(), others.begin(), others.end(), std::inserter(left, left.end()));
  return left;
}

TEST(JsonMutator, KeepsATextJsonAndReachesReasonsThatBytesDoNot) {
  const std::string task = seed_bytes("task/ai2thor.json"), donor = seed_bytes("task/behavior.json");
  const Reason reason = [](const std::string& text) {
    const auto read = read_task("task", 1, text);
    return read || read.error().kind == Error::Kind::Parse ? std::string() : read.error().message;
  };
  constexpr int kTries = 1000;
  int json = 0;
  const auto by_tree = reasons_of(kTries, reason, [&](Rng rng) {
    const auto changed = fuzz::mutate_json(task, donor, rng).value_or("");
    json += nlohmann::json::accept(changed) ? 1 : 0;
    return changed;
  });
  EXPECT_EQ(json, kTries);
  const auto by_bytes = reasons_of(kTries, reason, [&](Rng rng) { return fuzz::broken(task, rng); });
  EXPECT_GE(without(by_tree, by_bytes).size(), 10U);
  EXPECT_GT(without(by_tree, by_bytes).size(), 5 * without(by_bytes, by_tree).size())
      << ::testing::PrintToString(by_tree) << "\n"
      << ::testing::PrintToString(by_bytes);
}

TEST(SqliteMutator, KeepsADatabaseOneAndReachesReasonsThatBytesDoNot) {
  const std::string database = seed_bytes("knowledge/small.sqlite");
  const fuzz::Folder folder("mutator");
  const Reason reason = [&](const std::string& bytes) {
    folder.write("k.sqlite", bytes);
    const auto knowledge = load_knowledge(folder.path() / "k.sqlite", Simulator::Ai2thor);
    if (knowledge) return std::string();
    for (const char* damage : {"malformed", "not a database", "disk I/O"}) {
      if (knowledge.error().message.find(damage) != std::string::npos) return std::string();
    }
    return knowledge.error().message;
  };
  constexpr int kTries = 200;
  const auto by_rows =
      reasons_of(kTries, reason, [&](Rng rng) { return fuzz::mutate_sqlite(database, database, rng).value_or(""); });
  const auto by_bytes = reasons_of(kTries, reason, [&](Rng rng) { return fuzz::broken(database, rng); });
  EXPECT_GE(without(by_rows, by_bytes).size(), 10U);
  EXPECT_GT(without(by_rows, by_bytes).size(), 5 * without(by_bytes, by_rows).size())
      << ::testing::PrintToString(by_rows) << "\n"
      << ::testing::PrintToString(by_bytes);
}

TEST(Mutators, GiveTheSameAgainAndNothingForWhatTheyCannotRead) {
  const std::string scene = seed_bytes("scene/home.json"), ledger = seed_bytes("ledger/two.sqlite");
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    EXPECT_EQ(fuzz::mutate_json(scene, scene, Rng(seed)), fuzz::mutate_json(scene, scene, Rng(seed)));
    EXPECT_EQ(fuzz::mutate_sqlite(ledger, ledger, Rng(seed)), fuzz::mutate_sqlite(ledger, ledger, Rng(seed)));
  }
  EXPECT_FALSE(fuzz::mutate_json("{\"a\": ", scene, Rng(1)));
  EXPECT_FALSE(fuzz::mutate_sqlite("SQLite format 3", ledger, Rng(1)));
  EXPECT_FALSE(fuzz::mutate_sqlite(scene, ledger, Rng(1)));
}

TEST(JsonMutator, ChangesOneLineOfSeveral) {
  const std::string lines = "====\n{\"a\": [1, 2, 3]}\n{\"a\": [4, 5, 6]}\n";
  int changed_first = 0, changed_second = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto changed = fuzz::mutate_json(lines, "", Rng(seed));
    ASSERT_TRUE(changed);
    const auto parts = split(*changed, '\n');
    ASSERT_EQ(parts.size(), 4U);
    EXPECT_EQ(parts[0], "====");
    changed_first += parts[1] != "{\"a\": [1, 2, 3]}" ? 1 : 0;
    changed_second += parts[2] != "{\"a\": [4, 5, 6]}" ? 1 : 0;
  }
  EXPECT_EQ(changed_first + changed_second, 40);
  EXPECT_GT(std::min(changed_first, changed_second), 5);
}

}  // namespace
}  // namespace unietp
