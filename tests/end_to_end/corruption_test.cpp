// Data sets in which something was changed: `validate` names what is wrong and with which task. Checksums are made true
// again first, except where they are what is tested, so that the proof must come from what the files mean.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/sqlite_file.h"
#include "core/text.h"
#include "corruptions.h"
#include "data_set.h"
#include "record/home_cache.h"

namespace unietp {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Le;
using ::testing::Not;
using ::testing::UnorderedElementsAreArray;
using Json = nlohmann::ordered_json;

std::vector<DamagedTask> tasks_of(const DamagedCopy& copy) {
  std::vector<DamagedTask> tasks;
  std::map<std::string, Json> demonstrations;
  for (const auto& line : json_lines(copy.folder() / "demonstrations/M1.jsonl")) demonstrations[line["task"]] = line;
  for (const auto& task : json_lines(copy.folder() / "tasks.jsonl"))
    tasks.push_back({task, demonstrations[task["id"]],
                     Json::parse(*read_maybe_gzip(copy.folder() / home_file(task["layout"]))),
                     start_json(copy.folder(), task), "", false});
  return tasks;
}

void write(const DamagedTask& damaged, std::string& tasks, std::string& demonstrations) {
  tasks += (damaged.task_line.empty() ? damaged.line().dump() : damaged.task_line) + "\n";
  if (!damaged.without_demonstration) demonstrations += damaged.demonstration.dump() + "\n";
}

/// Tasks for what fits none of the first set.
const std::filesystem::path& second_data_set() {
  static const ScratchFolder kScratch;
  static const std::filesystem::path kFolder = [] {
    const auto ended = run_program({"generate", "--count", "60", "--seed", "9", "--rooms", "5", "--objects", "25",
                                    "--out", kScratch.at("second"), "--threads", "2"});
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    return std::filesystem::path(kScratch.at("second"));
  }();
  return kFolder;
}

/// Each task of a data set damaged in a way of its own, as far as there are ways that fit, and what is said of all
/// that. Made in as many copies as it takes.
struct Outcome {
  std::map<std::string, std::set<std::string>> kinds_by_corruption;
  std::set<std::string> blamed_falsely;  // tasks that nobody damaged
};

std::vector<Corruption> pickiest_first(const std::vector<DamagedTask>& tasks) {
  const auto fitting = [&tasks](const Corruption& corruption) {
    return std::count_if(tasks.begin(), tasks.end(),
                         [&corruption](DamagedTask task) { return corruption.damage(task); });
  };
  std::vector<std::pair<std::ptrdiff_t, Corruption>> counted;
  for (const auto& corruption : kCorruptions) counted.emplace_back(fitting(corruption), corruption);
  std::stable_sort(counted.begin(), counted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Corruption> all;
  for (const auto& [count, corruption] : counted) all.push_back(corruption);
  return all;
}

const Outcome& outcome() {
  static const Outcome kOutcome = [] {
    Outcome all;
    std::set<std::string> left;
    for (const auto& corruption : kCorruptions) left.insert(corruption.name);
    std::set<std::pair<std::string, std::string>> tried;  // corruption and task
    for (int round = 0; round < 8 && !left.empty(); ++round) {
      if (round == 4) tried.clear();  // other tasks from here on
      DamagedCopy copy(round < 4 ? small_data_set() : second_data_set());
      auto tasks = tasks_of(copy);
      std::map<std::string, std::string> corruption_of;       // by task
      for (const auto& corruption : pickiest_first(tasks)) {  // each takes the first task that fits and is still sound
        if (!left.contains(corruption.name)) continue;
        for (auto& task : tasks) {
          const std::string id = task.task["id"];
          if (corruption_of.contains(id) || tried.contains({corruption.name, id})) continue;
          DamagedTask damaged = task;
          if (!corruption.damage(damaged)) continue;
          task = std::move(damaged);
          corruption_of[id] = corruption.name;
          break;
        }
      }
      std::string lines, shown;
      for (const auto& task : tasks) write(task, lines, shown);
      copy.write("tasks.jsonl", lines);
      copy.write("demonstrations/M1.jsonl", shown);
      copy.vouch();
      for (const auto& problem : validate(copy.folder()).problems) {
        if (problem.task.empty()) continue;
        const auto found = corruption_of.find(problem.task);
        if (found == corruption_of.end()) {
          all.blamed_falsely.insert(problem.task + ": " + problem.kind + " " + problem.message);
        } else {
          all.kinds_by_corruption[found->second].insert(problem.kind);
        }
      }
      for (const auto& [task, name] : corruption_of) tried.insert({name, task});
      for (const auto& corruption : kCorruptions)  // what is told may depend on the home: another task is next
        if (all.kinds_by_corruption[corruption.name].contains(corruption.kind)) left.erase(corruption.name);
    }
    return all;
  }();
  return kOutcome;
}

class TaskCorruption : public ::testing::TestWithParam<Corruption> {};

TEST_P(TaskCorruption, IsNamed) {
  const auto found = outcome().kinds_by_corruption.find(GetParam().name);
  ASSERT_NE(found, outcome().kinds_by_corruption.end()) << "no task could be damaged this way, or nothing was told";
  EXPECT_THAT(found->second, Contains(GetParam().kind));
}

INSTANTIATE_TEST_SUITE_P(Every, TaskCorruption, ::testing::ValuesIn(kCorruptions),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Corruption, NoOtherTaskIsBlamed) { EXPECT_THAT(outcome().blamed_falsely, IsEmpty()); }

TEST(Corruption, AnUnchangedCopyIsProven) {
  DamagedCopy copy;
  copy.vouch();
  const auto verdict = validate(copy.folder());
  EXPECT_EQ(verdict.code, 0);
  EXPECT_TRUE(verdict.problems.empty());
}

std::set<std::pair<std::string, std::string>> reported(const Verdict& verdict) {
  std::set<std::pair<std::string, std::string>> kinds;
  for (const auto& problem : verdict.problems) kinds.emplace(problem.kind, problem.task);
  return kinds;
}

/// What is wrong with the folder as a whole, all at once.
TEST(Corruption, WhatConcernsTheFolderIsNamed) {
  DamagedCopy copy;
  const auto first = Json::parse(split(copy.read("tasks.jsonl"), '\n').at(0));
  const std::string home = home_file(first["layout"]);
  const Json given_up{{"format", "unietp-rejection/1"},
                      {"slot", first["seed"]["slot"]},
                      {"attempt", first["seed"]["attempt"]},
                      {"template", first["template"]},
                      {"simulator", first["simulator"]},
                      {"split", first["split"]},
                      {"stage", "expert"},
                      {"reason", "no-plan"},
                      {"detail", ""}};
  copy.write("rejections.jsonl", copy.read("rejections.jsonl") + given_up.dump() + "\n");
  {
    SqliteFile database(copy.folder() / "dataset.sqlite", SqliteFile::Mode::Create);
    database.run(
        "UPDATE task SET goal = 'other' WHERE rowid = 2;"
        "UPDATE trait SET value = 'nowhere' WHERE task = (SELECT id FROM task WHERE rowid = 3)");
  }
  copy.vouch();
  auto manifest = Json::parse(copy.read("manifest.json"));
  manifest["knowledge_digest"] = "another";
  manifest["counts"]["by_split"]["atomic"] = manifest["counts"]["by_split"]["atomic"].get<int>() + 1;
  manifest["counts"]["balance"][0]["effective"] = 3.5;
  manifest["configuration"]["count"] = kSmallCount + 1;
  copy.write("manifest.json", manifest.dump());
  auto bytes = copy.read(home);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  copy.write(home, bytes);
  copy.write("notes.txt", "mine");
  std::filesystem::remove(copy.folder() / "README.md");
  const auto verdict = validate(copy.folder());
  EXPECT_EQ(verdict.code, 1);
  const auto kinds = reported(verdict);
  for (const char* kind :
       {"other-knowledge", "counts", "balance", "quota", "rejections", "unlisted-file", "missing-file", "changed-file"})
    EXPECT_THAT(kinds, Contains(std::pair(std::string(kind), std::string()))) << kind;
  EXPECT_THAT(kinds, Contains(std::pair(std::string("unreadable"), first["id"].get<std::string>())));
  const std::string second = Json::parse(split(copy.read("tasks.jsonl"), '\n').at(1))["id"];
  EXPECT_THAT(kinds, Contains(std::pair(std::string("database"), second)));
  const std::string third = Json::parse(split(copy.read("tasks.jsonl"), '\n').at(2))["id"];
  EXPECT_THAT(kinds, Contains(std::pair(std::string("database"), third)));
}

TEST(Corruption, RowsOfTheDatabaseAboutNoTaskAreNamedWithTheirTable) {
  for (const std::string table : {"binding", "step", "trait"}) {
    DamagedCopy copy;
    {
      SqliteFile database(copy.folder() / "dataset.sqlite", SqliteFile::Mode::Create);
      const std::string planted = "PRAGMA foreign_keys = OFF; CREATE TEMP TABLE row AS SELECT * FROM " + table +
                                  " LIMIT 1; UPDATE row SET task = 'nobody-00001'; INSERT INTO " + table +
                                  " SELECT * FROM row";
      database.run(planted.c_str());
    }
    copy.vouch();
    const auto verdict = validate(copy.folder());
    EXPECT_EQ(verdict.code, 1);
    EXPECT_THAT(verdict.problems,
                Contains(::testing::Field(&Verdict::Problem::message,
                                          ::testing::HasSubstr("has rows of unknown tasks in the table " + table))));
  }
}

/// What is written from other files is made again and compared.
TEST(Corruption, WhatFollowsFromOtherFilesIsNamed) {
  DamagedCopy copy;
  copy.write("README.md", replace_all(copy.read("README.md"), "# 40 verified", "# 41 verified"));
  copy.write("reviews.jsonl",
             R"({"format":"unietp-review-mark/1","task":"nobody-00001","verdict":"accept","comment":""})"
             "\n");
  const Json first = Json::parse(split(copy.read("tasks.jsonl"), '\n').at(0));
  const std::string home = home_file(first["layout"]);
  auto scene = Json::parse(*read_maybe_gzip(copy.folder() / home));
  scene["wall_height"] = scene["wall_height"].get<double>() + 1;
  copy.write(home, gzip(scene.dump()));
  auto manifest = Json::parse(copy.read("manifest.json"));
  manifest["sources"].erase(0);
  manifest["benchmark"] = "unietp-1.0";
  manifest["files"].push_back({{"path", "reviews.jsonl"}, {"bytes", 0}, {"sha256", ""}});
  std::sort(manifest["files"].begin(), manifest["files"].end(),
            [](const Json& a, const Json& b) { return a["path"] < b["path"]; });
  copy.write("manifest.json", manifest.dump(2) + "\n");
  copy.vouch();
  const auto kinds = reported(validate(copy.folder()));
  for (const char* kind : {"card", "sources", "benchmark", "reviews", "home"})
    EXPECT_THAT(kinds, Contains(std::pair(std::string(kind), std::string()))) << kind;
}

TEST(Corruption, RepeatedTasksAreNamed) {
  DamagedCopy copy;
  auto lines = split(copy.read("tasks.jsonl"), '\n');
  auto shown = split(copy.read("demonstrations/M1.jsonl"), '\n');
  auto twin = Json::parse(lines.at(0));
  // The first task once more under another name, in place of the second; and the fourth has the name of the third.
  const std::string other = Json::parse(lines.at(1))["id"];
  twin["id"] = twin["scene"] = other;
  lines.at(1) = twin.dump();
  auto demonstration = Json::parse(shown.at(0));
  demonstration["task"] = other;
  shown.at(1) = demonstration.dump();
  auto fourth = Json::parse(lines.at(3));
  const std::string third = Json::parse(lines.at(2))["id"];
  fourth["id"] = third;
  lines.at(3) = fourth.dump();
  shown.insert(shown.end() - 1, shown.at(4));  // a demonstration twice
  const std::string fifth = Json::parse(shown.at(4))["task"];
  copy.write("tasks.jsonl", join(lines, "\n"));
  copy.write("demonstrations/M1.jsonl", join(shown, "\n"));
  copy.vouch();
  const auto kinds = reported(validate(copy.folder()));
  EXPECT_THAT(kinds, Contains(std::pair(std::string("repeated-start"), other)));
  EXPECT_THAT(kinds, Contains(std::pair(std::string("repeated-text"), other)));
  EXPECT_THAT(kinds, Contains(std::pair(std::string("repeated-task"), third)));
  EXPECT_THAT(kinds, Contains(std::pair(std::string("stray-demonstration"), fifth)));
}

/// A data set shares all with itself, and a turn of phrase is not of the set that the manifest claims.
TEST(Corruption, LeaksAndPhrasingsOfTheOtherSetAreNamed) {
  DamagedCopy copy;
  auto manifest = Json::parse(copy.read("manifest.json"));
  manifest["configuration"]["phrasings"] = "training";
  copy.write("manifest.json", manifest.dump());
  const auto verdict = validate(copy.folder(), {"--against", small_data_set().string()});
  std::map<std::string, int> counts;
  for (const auto& problem : verdict.problems) ++counts[problem.kind];
  EXPECT_EQ(counts["shared-layout"], kSmallCount);
  EXPECT_EQ(counts["similar-task"], kSmallCount);
  EXPECT_EQ(counts["shared-seed"], 1);
  EXPECT_GT(counts["text-phrasing"], 0);
  EXPECT_EQ(verdict.proven, 0);
}

/// Each home under another name and with one object moved, each instruction with another article.
TEST(Corruption, CopiesWithSmallChangesAreLeaks) {
  DamagedCopy copy;
  auto tasks = json_lines(copy.folder() / "tasks.jsonl");
  std::string lines;
  for (auto& task : tasks) {
    const std::string layout = task["layout"];
    auto home = Json::parse(*read_maybe_gzip(copy.folder() / home_file(layout)));
    auto& x = home["nodes"][0]["position"][0];
    x = x.get<double>() + 0.4;
    task["layout"] = home["id"] = "my-" + layout;
    copy.write(home_file("my-" + layout), gzip(home.dump()));
    auto text = " " + task["instruction"]["text"].get<std::string>();
    text =
        text.find(" the ") != std::string::npos ? replace_all(text, " the ", " a ") : replace_all(text, " a ", " the ");
    task["instruction"]["text"] = text.substr(1);
    lines += task.dump() + "\n";
  }
  copy.write("tasks.jsonl", lines);
  copy.vouch();
  std::map<std::string, int> counts;
  for (const auto& problem : validate(copy.folder(), {"--against", small_data_set().string()}).problems)
    ++counts[problem.kind];
  EXPECT_EQ(counts["shared-layout"], 0);
  EXPECT_EQ(counts["similar-home"], kSmallCount);
  EXPECT_EQ(counts["similar-task"], kSmallCount);
}

TEST(Corruption, SetsThatWereMadeApartAreNotAlike) {
  const auto ended =
      run_program({"validate", data_set_in_all_modes().string(), "--against", small_data_set().string()});
  EXPECT_THAT(ended.out, Not(HasSubstr("similar-")));
  EXPECT_THAT(ended.out, Not(HasSubstr("shared-layout")));  // some homes of the two have the same names
  EXPECT_THAT(ended.out, HasSubstr("likeness to the nearest of " + small_data_set().string()));
  EXPECT_THAT(ended.out, HasSubstr("closest homes\n"));
}

TEST(Corruption, WordingsOfAnotherTaskAreNamed) {
  DamagedCopy copy;
  const auto annotated = run_program({"annotate", copy.folder().string(), "--paired"});
  ASSERT_EQ(annotated.code, 0) << annotated.err;
  auto lines = split(copy.read("wordings.jsonl"), '\n');
  auto first = Json::parse(lines.at(0)), second = Json::parse(lines.at(1)), third = Json::parse(lines.at(2));
  std::swap(first["direct"], second["direct"]);
  third["task"] = "nobody";
  lines.at(0) = first.dump();
  lines.at(1) = second.dump();
  lines.at(2) = third.dump();
  copy.write("wordings.jsonl", join(lines, "\n"));
  copy.vouch();
  const auto kinds = reported(validate(copy.folder()));
  EXPECT_THAT(kinds, Contains(std::pair(std::string("text-meaning"), first["task"].get<std::string>())));
  EXPECT_THAT(kinds, Contains(std::pair(std::string("text-meaning"), second["task"].get<std::string>())));
  EXPECT_THAT(kinds, Contains(std::pair(std::string("wordings"), std::string())));
}

TEST(Corruption, AFolderWithoutTasksOrManifestIsNamed) {
  DamagedCopy copy;
  copy.write("manifest.json", "{");
  std::filesystem::remove(copy.folder() / "tasks.jsonl");
  const auto verdict = validate(copy.folder());
  EXPECT_EQ(verdict.code, 1);
  const auto kinds = reported(verdict);
  EXPECT_THAT(kinds, Contains(std::pair(std::string("manifest"), std::string())));
  EXPECT_THAT(kinds, Contains(std::pair(std::string("unreadable"), std::string())));
}

using Blamed = std::array<std::string, 4>;  // kind, task, where, message

std::vector<Blamed> blamed_in(const Verdict& verdict) {
  std::vector<Blamed> all;
  for (const auto& problem : verdict.problems)
    all.push_back({problem.kind, problem.task, problem.where, problem.message});
  return all;
}

/// The first shard finds what is of the whole set, and each what is of its own tasks.
TEST(Shards, TogetherFindWhatOneValidationFinds) {
  const DamagedCopy copy;
  auto lines = split(copy.read("demonstrations/M1.jsonl"), '\n');
  for (const std::size_t task : {3U, 20U, 39U})
    lines[task] = replace_all(lines[task], "\"success\":true", "\"success\":false");
  copy.write("demonstrations/M1.jsonl", join(lines, "\n"));
  copy.write("stray.txt", "of no data set");
  const auto whole = validate(copy.folder());
  std::vector<Blamed> found;
  int tasks = 0, proven = 0;
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const auto verdict = validate(copy.folder(), {"--shard", shard});
    EXPECT_EQ(verdict.code, 1) << shard;
    EXPECT_THAT(verdict.tasks, AllOf(Ge(13), Le(14))) << shard;
    EXPECT_EQ(verdict.proven, verdict.tasks - 1) << shard;
    const auto own = blamed_in(verdict);
    const bool files = std::any_of(own.begin(), own.end(), [](const Blamed& one) { return one[0] == "changed-file"; });
    EXPECT_EQ(files, std::string(shard) == "1/3") << shard;
    found.insert(found.end(), own.begin(), own.end());
    tasks += verdict.tasks;
    proven += verdict.proven;
  }
  EXPECT_EQ(tasks, kSmallCount);
  EXPECT_EQ(proven, kSmallCount - 3);
  EXPECT_EQ(whole.proven, kSmallCount - 3);
  EXPECT_THAT(found, UnorderedElementsAreArray(blamed_in(whole)));
}

TEST(Shards, OfASoundSetAreSoundAndNonsenseIsRefused) {
  for (const char* shard : {"1/2", "2/2", "41/41"}) {  // the last has the last task alone, or none
    const auto verdict = validate(small_data_set(), {"--shard", shard});
    EXPECT_EQ(verdict.code, 0) << shard;
    EXPECT_EQ(verdict.proven, verdict.tasks) << shard;
  }
  for (const char* shard : {"0/2", "3/2", "2", "1/x"})
    EXPECT_EQ(run_program({"validate", small_data_set().string(), "--shard", shard}).code, 2) << shard;
}

/// No kind of problem is without a corruption that shows it.
TEST(Corruption, EveryKindIsTested) {
  std::set<std::string> tested{"manifest",       "other-knowledge", "missing-file",  "unlisted-file", "changed-file",
                               "counts",         "quota",           "balance",       "rejections",    "database",
                               "repeated-task",  "repeated-start",  "repeated-text", "shared-layout", "shared-seed",
                               "similar-home",   "similar-task",    "text-phrasing", "wordings",      "card",
                               "sources",        "benchmark",       "reviews",       "home",
                               "not-nearest",     // by Potatoes (validator_tests): few goals speak of it
                               "text-unchecked",  // by UncheckedText (fields_tests)
                               "other-version"};  // by AroundValues (fields_tests)
  for (const auto& corruption : kCorruptions) tested.insert(corruption.kind);
  const auto kinds = run_program({"validate", "--kinds"});
  ASSERT_EQ(kinds.code, 0);
  int found = 0;
  for (const auto& line : split(kinds.out, '\n')) {
    if (!line.starts_with("| `")) continue;
    ++found;
    EXPECT_TRUE(tested.contains(line.substr(3, line.find('`', 3) - 3))) << line;
  }
  EXPECT_GT(found, 40);
  const auto page = read_file(std::filesystem::path(UNIETP_SOURCE_DIR) / "docs/validate.md");
  ASSERT_TRUE(page);
  EXPECT_NE(page->find(kinds.out), std::string::npos) << "docs/validate.md has another table than validate --kinds";
}

}  // namespace
}  // namespace unietp
