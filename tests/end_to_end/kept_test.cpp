// Whatever happens to a command that writes, what was there before is there afterwards, or the new, whole.
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/rng.h"
#include "core/sqlite_file.h"
#include "core/text.h"
#include "file_watch.h"
#include "tests/support/refused_calls.h"
#include "tests/support/thorough.h"
#include "writing_commands.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::tries;
using ::testing::HasSubstr;
using Files = std::map<std::string, std::string>;

/// Of a folder that gets its files one by one: those that are there are whole.
bool are_whole(const Files& files, const Undisturbed& known) {
  return std::all_of(files.begin(), files.end(), [&](const auto& file) {
    const auto found = known.after.find(file.first);
    return file.first.ends_with(".tmp") || (found != known.after.end() && found->second == file.second);
  });
}

void expect_old_or_new(const Workbench& bench, const WritingCommand& command, const Undisturbed& known) {
  const auto files = bench.files(command.makes);
  EXPECT_TRUE(files == known.before || files == known.after || (command.in_parts && are_whole(files, known)));
}

/// Kills the command after so many changes to files, looks, and runs it again. Whether it was still running.
bool survives_a_kill(const WritingCommand& command, const Undisturbed& known, int changes) {
  SCOPED_TRACE(command.name + ", killed after " + std::to_string(changes) + " of " + std::to_string(known.changes));
  const Workbench bench;
  const auto others = bench.others(command);
  bool killed = false;
  {
    FileWatch watch(bench.path());
    RunningProgram program("/bin/sh", bench.words(command), bench.path());
    killed = killed_after(program, watch, changes);
  }
  expect_old_or_new(bench, command, known);
  for (const auto& [name, bytes] : others) {
    EXPECT_EQ(read_file(bench / name).value(), bytes) << name;
  }
  const bool was_done = bench.files(command.makes) == known.after;
  const auto again = bench.run(command);
  // What stands there complete may be refused as such; nothing else may be.
  EXPECT_TRUE(again.code == 0 || (was_done && again.code == 2)) << again.code << again.out << again.err;
  auto files = bench.files(command.makes);
  if (command.in_parts) std::erase_if(files, [](const auto& file) { return file.first.ends_with(".tmp"); });
  EXPECT_EQ(files, known.after);
  if (!command.in_parts && !was_done) {
    EXPECT_EQ(bench.others(command), others);  // nothing lies about
  }
  return killed;
}

class KilledAtRandom : public ::testing::TestWithParam<WritingCommand> {};

TEST_P(KilledAtRandom, LosesNothing) {
  const int wanted = tries(2, 9);  // of each command; 9 are more than 200 of all
  const WritingCommand& command = GetParam();
  const auto known = undisturbed(command);
  Rng rng(static_cast<std::uint64_t>(known.changes));
  int kills = 0;
  for (int runs = 0; kills < wanted && runs < 10 * wanted && !HasFailure(); ++runs) {
    if (survives_a_kill(command, known, 1 + static_cast<int>(rng.below(static_cast<std::uint64_t>(known.changes)))))
      ++kills;
  }
  EXPECT_EQ(kills, wanted);
}

/// Interrupts the command after so many changes to files. Whether it was still running.
bool ends_in_time(const WritingCommand& command, const Undisturbed& known, int signal, int changes) {
  using Clock = std::chrono::steady_clock;
  SCOPED_TRACE(command.name + ", interrupted after " + std::to_string(changes) + " of " +
               std::to_string(known.changes));
  const Workbench bench;
  FileWatch watch(bench.path());
  RunningProgram program("/bin/sh", bench.words(command), bench.path());
  while (program.running() && watch.count() < changes) continue;
  const bool running = program.running();
  program.send(signal);
  const auto sent = Clock::now();
  const auto ended = program.wait();
  EXPECT_LT(Clock::now() - sent, std::chrono::seconds(2));
  EXPECT_TRUE(ended.code == 130 || ended.code == 0) << ended.code << ended.err;  // 0: it was about to end
  if (ended.code == 0) {
    EXPECT_EQ(bench.files(command.makes), known.after);
  }
  expect_old_or_new(bench, command, known);
  return running;
}

TEST_P(KilledAtRandom, EndsWithinTwoSecondsOfASignal) {
  const WritingCommand& command = GetParam();
  const auto known = undisturbed(command);
  Rng rng(static_cast<std::uint64_t>(known.changes) + 1);
  int interrupted = 0;
  for (int runs = 0; interrupted < 2 && runs < 20 && !HasFailure(); ++runs) {
    const int changes = 1 + static_cast<int>(rng.below(static_cast<std::uint64_t>(known.changes)));
    if (ends_in_time(command, known, interrupted == 0 ? SIGTERM : SIGINT, changes)) ++interrupted;
  }
  EXPECT_EQ(interrupted, 2);
}

std::string case_name(const ::testing::TestParamInfo<WritingCommand>& one) {
  std::string name = one.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char sign) { return sign == ' ' || sign == '-'; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Every, KilledAtRandom, ::testing::ValuesIn(writing_commands()), case_name);

/// It takes seconds, so it is none of the commands above.
TEST(Kept, AGalleryIsTheOldOneUntilItIsWhole) {
  const WritingCommand gallery{"shape gallery", "shape gallery --out out.html", "out.html"};
  const Workbench bench;
  ASSERT_TRUE(write_file(bench / "out.html", "old"));
  const auto all = bytes_below(bench.path());
  {
    RunningProgram program("/bin/sh", bench.words(gallery), bench.path());
    while (program.running() && program.processor_s() < 0.5) std::this_thread::yield();
    EXPECT_TRUE(program.running());
    program.send(SIGTERM);
    const auto sent = std::chrono::steady_clock::now();
    EXPECT_EQ(program.wait().code, 130);
    EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(2));
  }
  EXPECT_EQ(bytes_below(bench.path()), all);
  FileWatch watch(bench.path());
  RunningProgram program("/bin/sh", bench.words(gallery), bench.path());
  EXPECT_TRUE(killed_after(program, watch, 1));  // as soon as it writes
  EXPECT_EQ(*read_file(bench / "out.html"), "old");
}

TEST(Kept, FilesThatCannotGrowBeyondASizeLoseNothing) {
  for (const auto& command : writing_commands()) {
    if (command.in_parts) continue;
    const auto known = undisturbed(command);
    std::size_t largest = 0;
    for (const auto& [name, bytes] : known.after) largest = std::max(largest, bytes.size());
    Rng rng(largest);
    int refused = 0;
    const int sizes = command.makes == "data" || command.name == "export sft" ? tries(4, 50) : tries(2, 4);
    for (int i = 0; i < sizes && !::testing::Test::HasFailure(); ++i) {
      const auto size = i == 0 ? 0 : rng.below(largest);  // so that the largest file does not fit
      SCOPED_TRACE(command.name + ", files of at most " + std::to_string(size));
      const Workbench bench;
      Ended ended;
      {
        const RefusedGrowth growth(size);
        ended = bench.run(command);
      }
      EXPECT_EQ(ended.code, 2) << ended.err;
      refused += ended.code == 2 ? 1 : 0;
      EXPECT_EQ(bench.files(command.makes), known.before);
    }
    EXPECT_EQ(refused, sizes);
  }
}

/// In a name space of its own, so that nothing is left mounted.
bool can_mount_a_disk() {
  const ScratchFolder folder;
  return run_script("unshare -Urm mount -t tmpfs none " + folder.at(""), folder.path()).code == 0;
}

TEST(Kept, ADiskThatIsFullLosesNothing) {
  if (!can_mount_a_disk()) GTEST_SKIP() << "needs to mount a small disk: run as root, or allow user namespaces";
  const Workbench bench;
  fs::create_directory(bench / "disk");
  // The disk has room for the data set and 0 to 196 KiB more. Failed runs must leave it as it is to the byte.
  const int sizes = tries(8, 50);
  const std::string script = R"sh(
cp -r data after; unietp annotate after --seed 5 > said
MAKE --out whole > said
mount -t tmpfs -o size=100m none disk; cp -r data disk/data
used=$(df --output=used -k disk | tail -1)
for more in $(seq 0 STEP 196); do
  mount -o remount,size=$((used + more))k disk
  code=0; unietp annotate disk/data --seed 5 > said 2> message || code=$?
  echo $code >> codes
  if [ $code = 0 ]; then
    diff -r after disk/data; mount -o remount,size=100m disk; rm -r disk/data; cp -r data disk/data
  else
    diff -r data disk/data; test "$(ls disk)" = data; test -s message
  fi
  code=0; unietp export disk/data --format pddl --out disk/out > said 2> message || code=$?
  echo $code >> codes
  if [ $code = 0 ]; then rm -r disk/out; else test "$(ls disk)" = data; test -s message; fi
  code=0; MAKE --out disk/out > said 2> message || code=$?
  echo $code >> codes
  if [ $code != 0 ]; then
    test -s message; test ! -e disk/out; test ! -e disk/out.lock
    mount -o remount,size=100m disk; MAKE --resume --out disk/out > said
  fi
  diff -r whole disk/out; rm -r disk/out
done
)sh";
  ASSERT_TRUE(write_file(bench / "script", replace_all(replace_all(script, "STEP", std::to_string(196 / (sizes - 1))),
                                                       "MAKE", "unietp " + small_run("4"))));
  const auto ended = run_script("unshare -Urm sh -e script", bench.path());
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const auto codes = split(*read_file(bench / "codes"), '\n');
  EXPECT_EQ(codes.size(), 3U * static_cast<unsigned>(sizes) + 1);
  for (std::size_t command = 0; command < 3; ++command) {
    int full = 0;
    for (std::size_t i = command; i < codes.size(); i += 3) full += codes[i] == "2" ? 1 : 0;
    EXPECT_GT(full, sizes / 10) << command;
    EXPECT_LT(full, sizes + (command == 0 ? 1 : 0)) << command;
  }
}

TEST(Kept, AnExportDoesNotRemoveAnUnfinishedRunOfTheSameName) {
  const Workbench bench;
  ASSERT_TRUE(write_file(bench / "out.partial/run.json", "{}"));
  ASSERT_TRUE(write_file(bench / "out.partial/ledger.sqlite", "days of work"));
  EXPECT_EQ(bench.run("export data --format ltlf --out out").code, 0);
  EXPECT_EQ(bench.run("merge part-1 part-2 --out out").code, 2);
  fs::remove_all(bench / "out");
  const auto merged = bench.run("merge part-1 part-2 --out out");
  EXPECT_EQ(merged.code, 2);
  EXPECT_THAT(merged.err, HasSubstr("unfinished run"));
  EXPECT_EQ(*read_file(bench / "out.partial/ledger.sqlite"), "days of work");
}

/// The folder `data` is none, so that a command that looks at it first would say so instead.
TEST(Kept, APlaceThatCannotBeWrittenIsToldBeforeTheWork) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("file"), ""));
  ASSERT_TRUE(write_file(folder.path() / "data/tasks.jsonl", ""));
  for (const char* arguments :
       {"report data --out file/below.html", "report data --out data", "review data --out file/below.html",
        "annotate data --out file/below", "export data --format sft --out file/below",
        "generate --count 9000 --out file/below", "training --out file/below",
        "generate --count 9000 --out out --ledger file/below", "scene make --benchmark --out file/below"}) {
    SCOPED_TRACE(arguments);
    const auto ended = run_script(std::string("unietp ") + arguments, folder.path());
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, ::testing::AnyOf(HasSubstr("file/below"), HasSubstr("is a folder")));
    EXPECT_FALSE(fs::exists(folder.at("out")));
  }
}

/// With another place than `--out NAME`; "" for a command that has no such option.
std::string with_output(const std::string& arguments, const std::string& place) {
  for (const std::string_view option : {" --out ", " --altered-plans "}) {
    const auto at = arguments.find(option);
    if (at == std::string::npos) continue;
    const auto name = at + option.size(), end = arguments.find(' ', name);
    return arguments.substr(0, name) + place + (end == std::string::npos ? "" : arguments.substr(end));
  }
  return "";
}

/// It would be found only when what was made gets its name.
TEST(Kept, ALinkThatLeadsNowhereIsToldBeforeTheWork) {
  const Workbench bench;
  int tried = 0;
  for (const auto& command : writing_commands()) {
    const auto arguments = with_output(command.arguments, "nowhere");
    if (arguments.empty()) continue;
    SCOPED_TRACE(arguments);
    fs::create_symlink("gone/away", bench / "nowhere");
    for (const char* place : {"nowhere", "nowhere/below"}) {
      const auto ended = bench.run(with_output(command.arguments, place));
      EXPECT_EQ(ended.code, 2) << ended.out;
      EXPECT_THAT(ended.err, HasSubstr("nowhere is a symbolic link that leads nowhere"));
    }
    EXPECT_TRUE(fs::is_symlink(bench / "nowhere"));
    EXPECT_FALSE(fs::exists(bench / "nowhere"));
    fs::remove(bench / "nowhere");
    for (const auto& entry : fs::directory_iterator(bench.path()))
      EXPECT_FALSE(entry.path().filename().string().starts_with("nowhere")) << entry.path();
    ++tried;
  }
  EXPECT_GT(tried, 25);
}

TEST(Kept, NoCommandWritesInsideOfADataSetAndTheLike) {
  const Workbench bench;
  ASSERT_TRUE(write_file(bench / "out.partial/run.json", "{}"));
  fs::create_directory_symlink("data", bench / "link");
  int tried = 0;
  for (const auto& command : writing_commands()) {
    const auto arguments = with_output(command.arguments, "data/homes/" + command.makes);
    if (arguments.empty()) continue;
    SCOPED_TRACE(arguments);
    const auto before = bytes_below(bench.path());
    const auto ended = bench.run(arguments);
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr("is inside the data set"));
    EXPECT_EQ(bytes_below(bench.path()), before);
    ++tried;
  }
  EXPECT_GT(tried, 25);
  for (const auto& [folder, kind] : {std::pair{"link", "data set"}, std::pair{"part-1", "shard"},
                                     std::pair{"run-stop", "evaluation"}, std::pair{"out.partial", "unfinished run"}}) {
    for (const std::string command : {"shape show mug --out ", "generate --count 1 --out new --ledger ",
                                      "evaluate data --policy stop --out new --cache "}) {
      SCOPED_TRACE(command + folder);
      const auto ended = bench.run(command + folder + "/below/file.png");
      EXPECT_EQ(ended.code, 2) << ended.out;
      EXPECT_THAT(ended.err, HasSubstr(std::string("is inside the ") + kind));
      EXPECT_FALSE(fs::exists(bench / folder / "below") || fs::exists(bench / "new"));
    }
  }
}

TEST(Kept, ALedgerReplacesOnlyALedger) {
  const Workbench bench;
  ASSERT_TRUE(write_file(bench / "notes.txt", "mine"));
  ASSERT_TRUE(write_file(bench / "empty", ""));
  fs::copy(bench / "data/dataset.sqlite", bench / "other.sqlite");
  fs::create_symlink("nowhere", bench / "link");
  ASSERT_EQ(::mkfifo((bench / "fifo").c_str(), 0600), 0);
  const std::string make =
      "generate --count 1 --seed 3 --rooms 5 --objects 5 --simulators habitat --splits atomic --out new --ledger ";
  const auto files = [&] {
    auto all = bench.files("data");
    for (const char* name : {"notes.txt", "empty", "other.sqlite"}) all.merge(bench.files(name));
    return all;
  };
  const auto before = files();
  for (const std::string name : {"notes.txt", "empty", "other.sqlite", "link", "fifo", "data/tasks.jsonl", "data"}) {
    SCOPED_TRACE(name);
    const auto ended = bench.run(make + name);
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, ::testing::AnyOf(HasSubstr("no ledger of this program"), HasSubstr("is inside the"),
                                            HasSubstr("leads nowhere")));
    EXPECT_FALSE(fs::exists(bench / "new") || fs::exists(bench / "new.partial"));
    EXPECT_EQ(files(), before);
  }
  EXPECT_TRUE(fs::is_fifo(bench / "fifo") && fs::is_symlink(bench / "link"));
  EXPECT_EQ(bench.run(make + "kept.sqlite").code, 0);
  const auto first = *read_file(bench / "kept.sqlite");
  fs::remove_all(bench / "new");
  EXPECT_EQ(bench.run(replace_all(make, "--seed 3", "--seed 4") + "kept.sqlite").code, 0);
  EXPECT_NE(*read_file(bench / "kept.sqlite"), first);
}

/// The ledger of a run tells what each stage cost, so equal runs have equal candidates but not equal bytes.
TEST(Kept, ALedgerIsTheOldOrTheNewWhateverKillsTheRun) {
  const std::string make =
      "generate --count 2 --seed 4 --rooms 5 --objects 5 --simulators habitat --splits atomic --threads 1 --resume "
      "--out new --ledger kept.sqlite";
  const auto candidates = [](const fs::path& ledger) {
    std::vector<std::string> rows;
    SqliteFile file(ledger, SqliteFile::Mode::Read);
    auto row =
        file.prepare("SELECT slot || ' ' || attempt || ' ' || accepted || ' ' || task FROM candidate ORDER BY 1");
    while (row.step()) rows.emplace_back(row.text(0));
    return rows;
  };
  const WritingCommand command{"ledger", make, "kept.sqlite"};
  int changes = 0;
  std::vector<std::string> whole;
  {
    const Workbench bench;
    FileWatch watch(bench.path());
    RunningProgram program("/bin/sh", bench.words(command), bench.path());
    while (program.running()) (void)watch.count();
    changes = watch.count();
    ASSERT_EQ(program.wait().code, 0);
    whole = candidates(bench / "kept.sqlite");
    ASSERT_GE(whole.size(), 2U);
  }
  Rng rng(3);
  for (int i = 0; i < tries(4, 20) && !HasFailure(); ++i) {
    const Workbench bench;
    ASSERT_EQ(bench.run(replace_all(replace_all(make, "--seed 4", "--seed 5"), "--out new", "--out other")).code, 0);
    const auto older = *read_file(bench / "kept.sqlite");
    {
      FileWatch watch(bench.path());
      RunningProgram program("/bin/sh", bench.words(command), bench.path());
      // Half of them in the last part of the run, where the ledger is written.
      const int from = i % 2 == 0 ? 1 : changes * 3 / 4;
      (void)killed_after(program, watch,
                         from + static_cast<int>(rng.below(static_cast<std::uint64_t>(changes - from))));
    }
    EXPECT_TRUE(*read_file(bench / "kept.sqlite") == older || candidates(bench / "kept.sqlite") == whole);
    // A run that was killed after its data set was in place and before its folder was gone only tidies up.
    const bool was_done = fs::exists(bench / "new") && !fs::exists(bench / "new.partial");
    EXPECT_EQ(bench.run(make).code, was_done ? 2 : 0);
    EXPECT_EQ(candidates(bench / "kept.sqlite"), whole);
    EXPECT_FALSE(fs::exists(bench / "kept.sqlite.tmp"));
  }
}

TEST(Kept, ACacheIsNotMadeOfAnotherDatabase) {
  const Workbench bench;
  fs::copy(bench / "data/dataset.sqlite", bench / "other.sqlite");
  const auto before = *read_file(bench / "other.sqlite");
  const auto ended = bench.run(
      "annotate data --writer llm --llm-model m --llm-url http://127.0.0.1:9/v1 --llm-attempts 1 --cache other.sqlite");
  EXPECT_EQ(ended.code, 2) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr("cannot be used as a cache: it has tables of another program or purpose"));
  EXPECT_EQ(*read_file(bench / "other.sqlite"), before);
}

TEST(Kept, AHomeThatCannotBeWrittenIsTold) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("file"), ""));
  ASSERT_TRUE(write_file(folder.at("own.csv"), "simulator,category,fact,value,reason\n"));
  for (const char* home : {"file/home", "/proc/unietp"}) {
    // A fact of one's own makes the knowledge another one than what the program came with.
    const auto ended = run_script(
        std::string("HOME=") + home + " XDG_CACHE_HOME= unietp --overrides own.csv generate --count 1 --out out",
        folder.path());
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr(home));
    EXPECT_FALSE(fs::exists(folder.at("out")));
  }
}

TEST(Output, WhatCannotBePrintedGivesAnErrorAndACode) {
  const ScratchFolder folder;
  const auto codes = [&](const std::string& script) {
    const auto ended = run_script(script, folder.path());
    EXPECT_EQ(ended.signal, 0);
    return std::pair{ended.code, ended.err};
  };
  const auto [full, why_full] = codes("unietp template list > /dev/full");
  EXPECT_EQ(full, 2);
  EXPECT_THAT(why_full, HasSubstr("standard output: file error: cannot write: No space left"));
  const auto [closed, why_closed] = codes("unietp template list >&-");
  EXPECT_EQ(closed, 2);
  EXPECT_THAT(why_closed, HasSubstr("standard output: usage error: is closed"));
  const auto [piped, why_piped] =
      codes("{ unietp template list 2> why || echo $? > code; } | true; cat why >&2; cat code");
  EXPECT_EQ(piped, 0);
  EXPECT_EQ(*read_file(folder.at("code")), "2\n");
  EXPECT_THAT(why_piped, HasSubstr("Broken pipe"));
  EXPECT_EQ(codes("unietp help modes > /dev/full").first, 2);
  EXPECT_EQ(codes("unietp template list > /dev/null 2>&- <&-").first, 0);
  EXPECT_EQ(codes("ulimit -f 0; unietp template list > said").first, 2);
}

}  // namespace
}  // namespace unietp
