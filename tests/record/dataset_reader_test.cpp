// The reader of finished data sets: what it refuses, and how much memory it takes.
#include "record/dataset_reader.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <new>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/limits.h"
#include "core/text.h"
#include "small_set.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The ids of the tasks that are read before the error, if there is one, and then the error.
std::vector<std::string> read_strictly(const SmallSet& set, int threads = 1) {
  auto reader = DatasetReader::open(set.folder(), {.modes = {Mode::M1}}, FileNames::InFolder);
  if (!reader) return {format(reader.error())};
  std::vector<std::string> found;
  const auto done = for_each_task<std::string>(
      std::move(*reader), threads, [](const FinishedTask& task) -> Result<std::string> { return task.record.id; },
      [&](std::string&& id) -> Result<Done> {
        found.push_back(id);
        return Done{};
      });
  if (!done) found.push_back(format(done.error()));
  return found;
}

/// Of each task, its id and that of its demonstration's line; then each line that is of no task.
std::vector<std::string> read_leniently(const SmallSet& set) {
  auto reader = DatasetReader::open(set.folder(), {.modes = {Mode::M1}}, FileNames::InFolder);
  if (!reader) return {format(reader.error())};
  std::vector<std::string> found;
  while (const auto lines = reader->lines().next()) {
    for (const auto& stray : lines->strays) found.push_back("stray " + stray.task);
    const auto& shown = lines->shown_in(Mode::M1);
    const auto own = shown.line ? reader->demonstration(*lines, Mode::M1) : Result<DemonstrationRecord>(shown.missing);
    found.push_back(lines->id + (own ? " shown " + own->task : " not shown"));
  }
  while (const auto stray = reader->lines().next_stray()) found.push_back("left over " + stray->task);
  return found;
}

std::vector<std::string> tasks(std::initializer_list<const char*> ids) {
  std::vector<std::string> lines;
  for (const char* id : ids) lines.push_back(*id == '\0' ? "" : task_line(id));
  return lines;
}
std::vector<std::string> shown(std::initializer_list<const char*> ids) {
  std::vector<std::string> lines;
  for (const char* id : ids) lines.push_back(*id == '\0' ? "" : shown_line(id));
  return lines;
}

TEST(DatasetReader, ReadsASoundSetInOrderWithAnyNumberOfThreads) {
  const SmallSet set;
  set.write(tasks({"a", "b", "c"}), shown({"a", "b", "c"}));
  EXPECT_THAT(read_strictly(set), ElementsAre("a", "b", "c"));
  EXPECT_THAT(read_strictly(set, 8), ElementsAre("a", "b", "c"));
  EXPECT_THAT(read_leniently(set), ElementsAre("a shown a", "b shown b", "c shown c"));
}

TEST(DatasetReader, AnEmptyLineIsRefusedWhereItStands) {
  const SmallSet set;
  set.write(tasks({"a", "", "b"}), shown({"a", "b"}));
  EXPECT_THAT(read_strictly(set),
              ElementsAre("a", "tasks.jsonl:2: schema error: is empty; expected a JSON object on every line"));
  set.write(tasks({"a", "b"}), shown({"a", "", "b"}));
  EXPECT_THAT(read_strictly(set), ElementsAre("a",
                                              "demonstrations/M1.jsonl:2: schema error: is empty; expected a JSON "
                                              "object on every line"));
  EXPECT_THAT(read_leniently(set), ElementsAre("a shown a", "stray ", "b shown b"));
}

TEST(DatasetReader, ACarriageReturnIsRefused) {
  const SmallSet set;
  set.write({task_line("a") + "\r"}, shown({"a"}));
  EXPECT_THAT(read_strictly(set), ElementsAre("tasks.jsonl:1: schema error: ends in CR LF; expected only LF"));
}

TEST(DatasetReader, ALastLineWithoutItsEndIsRefused) {
  const SmallSet set;
  set.write(tasks({"a", "b"}), shown({"a", "b"}));
  set.write_bytes("demonstrations/M1.jsonl", shown_line("a") + "\n" + shown_line("b"));
  const auto cut = "demonstrations/M1.jsonl:2: schema error: does not end in a line feed: the file is cut off";
  EXPECT_THAT(read_strictly(set), ElementsAre("a", cut));
  set.write_bytes("demonstrations/M1.jsonl", shown_line("a") + "\n" + shown_line("b").substr(0, 90));
  EXPECT_THAT(read_strictly(set), ElementsAre("a", cut));
}

TEST(DatasetReader, SwappedDemonstrationsAreRefusedAndTheNextTaskHasItsOwn) {
  const SmallSet set;
  set.write(tasks({"a", "b", "c", "d"}), shown({"a", "c", "b", "d"}));
  EXPECT_THAT(read_strictly(set),
              ElementsAre("a", "demonstrations/M1.jsonl:2: schema error: expected the demonstration of b, not of c"));
  EXPECT_THAT(read_leniently(set), ElementsAre("a shown a", "stray c", "b shown b", "c not shown", "d shown d"));
}

TEST(DatasetReader, AMissingDemonstrationIsRefusedAndTheNextTaskHasItsOwn) {
  const SmallSet set;
  set.write(tasks({"a", "b", "c"}), shown({"a", "c"}));
  EXPECT_THAT(read_strictly(set),
              ElementsAre("a", "demonstrations/M1.jsonl:2: schema error: expected the demonstration of b, not of c"));
  EXPECT_THAT(read_leniently(set), ElementsAre("a shown a", "b not shown", "c shown c"));
  set.write(tasks({"a", "b"}), shown({"a"}));
  EXPECT_THAT(read_strictly(set), ElementsAre("a",
                                              "demonstrations/M1.jsonl:2: schema error: expected the demonstration "
                                              "of b, not the end of the file"));
}

TEST(DatasetReader, ALineOfNoTaskIsRefused) {
  const SmallSet set;
  set.write(tasks({"a", "b"}), shown({"a", "x", "b", "b"}));
  EXPECT_THAT(read_strictly(set),
              ElementsAre("a", "demonstrations/M1.jsonl:2: schema error: expected the demonstration of b, not of x"));
  EXPECT_THAT(read_leniently(set), ElementsAre("a shown a", "stray x", "b shown b", "left over b"));
  set.write(tasks({"a"}), shown({"a", "x"}));
  EXPECT_THAT(read_strictly(set), ElementsAre("a",
                                              "demonstrations/M1.jsonl:2: schema error: expected the end of the "
                                              "file, not the demonstration of x"));
}

TEST(DatasetReader, AMissingFileIsRefused) {
  const SmallSet set;
  EXPECT_THAT(read_strictly(set), ElementsAre("tasks.jsonl: file error: is missing; expected a finished data set"));
}

TEST(DatasetReader, ALineBeyondTheBoundIsRefused) {
  const SmallSet set;
  set.write({task_line("a", limits::kLineBytes)}, {});
  EXPECT_THAT(read_strictly(set), ElementsAre("tasks.jsonl:1: schema error: is longer than " +
                                              std::to_string(limits::kLineBytes) + " bytes; nothing after it is read"));
}

std::size_t count_tasks(const SmallSet& set, int threads) {
  auto reader = DatasetReader::open(set.folder(), {.modes = {Mode::M1}});
  if (!reader) return 0;
  std::size_t tasks = 0;
  const auto done = for_each_task<Done>(
      std::move(*reader), threads, [](const FinishedTask&) -> Result<Done> { return Done{}; },
      [&tasks](Done&&) -> Result<Done> {
        ++tasks;
        return Done{};
      });
  return done ? tasks : 0;
}

/// Reads with `threads` in a process that may take so much memory more than it has; its exit code.
int read_within(const SmallSet& set, int threads, std::size_t more_bytes) {
  const pid_t child = fork();
  if (child == 0) {
    std::ifstream sizes("/proc/self/statm");
    std::size_t pages = 0;
    sizes >> pages;
    const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more_bytes;
    const rlimit limit{most, most};
    if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(3);
    try {
      _exit(count_tasks(set, threads) == 20'000 ? 0 : 1);
    } catch (const std::bad_alloc&) {
      _exit(2);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(DatasetReader, ALineThatIsNoTaskIsToldWithItsFileAndNumber) {
  const SmallSet set;
  set.write({task_line("a"), replace_all(task_line("b"), "\"split\"", "\"splits\"")}, shown({"a", "b"}));
  EXPECT_THAT(read_strictly(set), ElementsAre("a", StartsWith("tasks.jsonl:2:")));
}

TEST(CheckCombinations, CountsWhatTheGoalRangesOverAndNothingElse) {
  Scene start;
  for (int i = 0; i < 402; ++i) {
    Node node;
    node.category = i < 2 ? "Mug" : "Plate";
    start.nodes.push_back(node);
  }
  const auto check = [&](const std::string& category) {
    std::string text = "(at-end (on ?x ?y))";
    for (const char* variable : {"?z", "?y", "?x"})
      text = std::string("(exists (") + variable + " - " + category + ") " + text + ")";
    const auto goal = parse_formula("goal", text, FormulaUse::Goal);
    EXPECT_TRUE(goal) << format(goal.error());
    return check_combinations("tasks.jsonl:3", *goal, start);
  };
  EXPECT_TRUE(check("Mug")) << "8 combinations";
  const auto many = check("Plate");
  ASSERT_FALSE(many) << "400 to the third";
  EXPECT_EQ(many.error().where, "tasks.jsonl:3");
  EXPECT_THAT(many.error().message, HasSubstr("combinations of objects"));
}

TEST(DatasetReader, TakesNoMoreMemoryForMoreTasks) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer takes address space of its own";
#endif
  const SmallSet set;
  {
    std::ofstream task_file(set.folder() / "tasks.jsonl"), shown_file(set.folder() / "demonstrations/M1.jsonl");
    for (int i = 0; i < 20'000; ++i) {
      const std::string id = "task-" + std::to_string(i);
      task_file << task_line(id, 4000) << '\n';
      shown_file << shown_line(id) << '\n';
    }
  }
  EXPECT_EQ(read_within(set, 1, std::size_t{12} << 20), 0);  // of 100 MB
}

}  // namespace
}  // namespace unietp
