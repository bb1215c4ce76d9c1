// What a stranger's files can do to each command: nothing but be read or refused, with one line that says what is
// wrong, within the bounds of docs/limits.md.
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/digest.h"
#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "interchange/formats.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::Not;

/// What a stranger's file may cost: a GiB, and five seconds of the processor, however busy the machine is.
void expect_modest(const Ended& ended) {
  EXPECT_LT(ended.peak_bytes, std::size_t{1} << 30);
  EXPECT_LT(ended.processor_s, 5);
}

/// Two tasks of a simulator in small homes, made once.
const fs::path& tiny_set() {
  static const ScratchFolder kScratch;
  static const fs::path kFolder = [] {
    const auto ended = run_program({"generate", "--count", "2", "--seed", "3", "--rooms", "5", "--objects", "5",
                                    "--simulators", "behavior", "--splits", "atomic", "--out", kScratch.at("tiny")});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return fs::path(kScratch.at("tiny"));
  }();
  return kFolder;
}

/// A stranger's folder, and beside it what he would like to change.
class Stranger : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(set().parent_path());
    fs::copy(tiny_set(), set(), fs::copy_options::recursive);
    ASSERT_TRUE(write_file(scratch_.at("a/mine.txt"), "mine"));
  }
  fs::path set() const { return scratch_.path() / "a" / "b" / "set"; }
  std::string out(const std::string& name) const { return scratch_.at("a/b/c/" + name); }

  /// Each line of a file changed as JSON; then the checksums are made right again, as a forger would.
  void change(const std::string& file, const std::function<void(Json&)>& damage) const {
    std::string text;
    for (Json& line : lines_of(file)) {
      damage(line);
      text += line.dump() + "\n";
    }
    put(file, text);
  }
  void put(const std::string& file, const std::string& bytes) const {
    ASSERT_TRUE(write_file(set() / file, bytes));
    vouch();
  }
  void vouch() const {
    auto manifest = Json::parse(*read_file(set() / "manifest.json"));
    for (auto& file : manifest["files"]) {
      const auto bytes = read_file(set() / file["path"].get<std::string>());
      if (!bytes) continue;
      file["bytes"] = bytes->size();
      file["sha256"] = sha256(*bytes);
    }
    ASSERT_TRUE(write_file(set() / "manifest.json", manifest.dump(2) + "\n"));
  }
  std::vector<Json> lines_of(const std::string& file) const { return json_lines(set() / file); }

  /// Every command that reads a data set, with what it would write.
  std::vector<std::vector<std::string>> commands(const std::string& task) const {
    const std::string in = set().string();
    std::vector<std::vector<std::string>> all{{"validate", in},
                                              {"stats", in},
                                              {"report", in, "--out", out("report.html")},
                                              {"review", in, "--out", out("review.html")},
                                              {"render", in, task, "--out", out("task.svg")},
                                              {"render", in, task, "--out", out("view.png")},
                                              {"annotate", in, "--phrasings", "benchmark", "--out", out("annotated")}};
    for (const char* format : {"starts", "virtualhome", "pddl", "bddl", "ltlf", "unietp-release", "sft"})
      all.push_back({"export", in, "--format", format, "--out", out(format)});
    return all;
  }

  /// Runs them all: each ends with `code` (validate may find problems, 1) and nothing outside of its --out changes.
  void expect_refused(const std::string& task, const std::string& why) const {
    const auto before = bytes_below(scratch_.path());
    for (const auto& command : commands(task)) {
      SCOPED_TRACE(join(command, " "));
      const auto ended = run_program(command);
      EXPECT_TRUE(ended.code == 2 || (ended.code == 1 && command[0] == "validate")) << ended.code << ended.err;
      EXPECT_THAT(ended.out + ended.err, HasSubstr(why));
      expect_modest(ended);
      for (const char c : ended.out + ended.err) EXPECT_TRUE(c == '\n' || (c >= ' ' && c != '\x7f') || c < 0);
    }
    EXPECT_EQ(bytes_below(scratch_.path()), before);
  }
  ScratchFolder scratch_;
};

void rename_task(Json& line, const std::string& field, const std::string& name) { line[field] = name; }

TEST_F(Stranger, ATaskCannotBeCalledByAPath) {
  for (const std::string name : {"/tmp/unietp-x", "a/b", "-x", "..", "a\x1b[2Jb", "a\nb", "../../x"}) {
    change("tasks.jsonl", [&](Json& line) { rename_task(line, "id", name); });
    change("demonstrations/M1.jsonl", [&](Json& line) { rename_task(line, "task", name); });
    const auto before = bytes_below(scratch_.path());
    for (const char* format : {"starts", "pddl"}) {
      const auto ended = run_program({"export", set().string(), "--format", format, "--out", out("x")});
      EXPECT_EQ(ended.code, 2);
      EXPECT_THAT(ended.err, HasSubstr("letters, digits"));
      EXPECT_EQ(split(trim(ended.err), '\n').size(), 1U) << ended.err;
    }
    EXPECT_EQ(bytes_below(scratch_.path()), before);
  }
  expect_refused("../../x", "letters, digits");
}

TEST_F(Stranger, AStartSceneCannotBeCalledByAPath) {
  const std::string task = lines_of("tasks.jsonl").front()["id"];
  change("tasks.jsonl", [&](Json& line) { rename_task(line, "scene", "../../../mine"); });
  expect_refused(task, "letters, digits");
}

TEST_F(Stranger, AHomeCannotBeCalledByAPath) {
  const std::string task = lines_of("tasks.jsonl").front()["id"];
  change("tasks.jsonl", [&](Json& line) { rename_task(line, "layout", "../../../mine"); });
  expect_refused(task, "letters, digits");
}

TEST_F(Stranger, ASymbolicLinkInTheFolderIsNotFollowed) {
  const std::string task = lines_of("tasks.jsonl").front()["id"];
  for (const char* name : {"tasks.jsonl", "demonstrations", "homes"}) {
    SCOPED_TRACE(name);
    const auto aside = scratch_.path() / "aside";
    fs::rename(set() / name, aside);
    fs::create_symlink(aside, set() / name);
    int refused = 0;
    for (const auto& command : commands(task)) {
      SCOPED_TRACE(join(command, " "));
      const auto ended = run_program(command);
      if (ended.code == 0) continue;  // a format that reads no demonstration
      ++refused;
      EXPECT_TRUE(ended.code == 2 || (ended.code == 1 && command[0] == "validate")) << ended.code << ended.err;
      EXPECT_THAT(ended.out + ended.err, HasSubstr("symbolic link"));
    }
    EXPECT_GE(refused, 10);
    fs::remove(set() / name);
    fs::rename(aside, set() / name);
    fs::remove_all(scratch_.path() / "a" / "b" / "c");
  }
}

TEST_F(Stranger, AFifoAnEndlessDeviceAndALoopInTheFolderAreRefused) {
  const std::string task = lines_of("tasks.jsonl").front()["id"];
  const auto tasks = set() / "tasks.jsonl";
  fs::remove(tasks);
  ASSERT_EQ(::mkfifo(tasks.c_str(), 0600), 0);
  expect_refused(task, "is a FIFO; expected a file");
  fs::remove(tasks);
  fs::create_directory(tasks);
  expect_refused(task, "is a folder; expected a file");
  fs::remove(tasks);
  for (const fs::path& end : {tasks, fs::path("/dev/zero")}) {
    fs::create_symlink(end, tasks);
    expect_refused(task, "symbolic link");
    fs::remove(tasks);
  }
  struct stat zero {};
  ASSERT_EQ(::stat("/dev/zero", &zero), 0);
  if (::mknod(tasks.c_str(), S_IFCHR | 0600, zero.st_rdev) != 0)
    GTEST_SKIP() << "only root may make a device of its own in the folder";
  expect_refused(task, "is a device; expected a file");
}

/// A file that the user names: each command that reads one says in one line why it does not.
class StrangeFile : public ::testing::Test {
 protected:
  void expect_refused(const std::string& file, const std::string& why, bool scene = true) {
    SCOPED_TRACE(file);
    const std::string set = tiny_set().string();
    std::vector<std::vector<std::string>> all{{"scene", "show", file, "--out", folder_.at("x.svg")},
                                              {"scene", "export", "procthor", file, "--out", folder_.at("x.json")},
                                              {"scene", "import", "auto", file, "--out", folder_.at("x")},
                                              {"scene", "stats", file}};
    if (!scene)
      all.insert(all.end(), {{"template", "lint", file}, {"review", set, "--apply", file, "--out", folder_.at("y")}});
    for (const auto& command : all) {
      SCOPED_TRACE(join(command, " "));
      const auto ended = run_program(command);
      EXPECT_EQ(ended.code, 2) << ended.out << ended.err;
      EXPECT_THAT(ended.err, HasSubstr(why));
      EXPECT_EQ(split(trim(ended.err), '\n').size(), 1U) << ended.err;
      expect_modest(ended);
    }
  }
  std::string file(const std::string& name, const std::string& bytes) {
    EXPECT_TRUE(write_file(folder_.at(name), bytes));
    return folder_.at(name);
  }
  ScratchFolder folder_;
};

TEST_F(StrangeFile, WhatIsNoRegularFileIsRefused) {
  ASSERT_EQ(::mkfifo(folder_.at("fifo.json").c_str(), 0600), 0);
  expect_refused(folder_.at("fifo.json"), "is a FIFO; expected a file", false);
  expect_refused("/dev/zero", "is a device; expected a file", false);
  fs::create_symlink(folder_.at("loop.json"), folder_.at("loop.json"));
  expect_refused(folder_.at("loop.json"), "Too many levels of symbolic links");
}

TEST_F(StrangeFile, AGzipFileThatUnpacksToGigabytesIsRefused) {
  const std::string member = gzip(std::string(std::size_t{64} << 20, ' '));
  std::string bomb;
  for (int i = 0; i < 32; ++i) bomb += member;  // 2 GiB
  expect_refused(file("bomb.scene.json.gz", bomb), "unpacks to more than 268435456 bytes");
}

TEST_F(StrangeFile, AHugeFileIsRefused) {
  fs::resize_file(file("huge.scene.json", "{"), std::uintmax_t{1} << 40);  // sparse
  expect_refused(folder_.at("huge.scene.json"), "has more than 268435456 bytes", false);
}

/// `before`, then the item `count` times with commas between, then `after`.
std::string repeated(const std::string& before, const std::string& item, int count, const std::string& after) {
  std::string text = before;
  text.reserve(before.size() + (item.size() + 1) * static_cast<std::size_t>(count) + after.size());
  for (int i = 0; i < count; ++i) text += i == 0 ? item : "," + item;
  return text + after;
}

TEST_F(StrangeFile, TooMuchJsonIsRefused) {
  expect_refused(file("a.scene.json",
                      repeated(R"({"format":"unietp-scene/1","objectId":0,"nodes":[)", "{\"\":0}", 5'000'000, "]}")),
                 "has more than 4000000 JSON values");
  expect_refused(
      file("b.scene.json", R"({"format":"unietp-scene/1","objectId":0,"nodes":)" + std::string(100'000, '[')),
      "nested deeper than 64 levels");
}

TEST_F(StrangeFile, AHomeOfAMillionRoomsOrCornersIsRefused) {
  const std::string head = R"({"format":"unietp-scene/1","id":"x","simulator":"behavior","wall_height":2.5,"rooms":[)";
  const auto show = [&](const std::string& name, const std::string& text, const std::string& why) {
    const auto ended = run_program({"scene", "show", file(name, text), "--out", folder_.at("x.svg")});
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr(why));
    EXPECT_EQ(split(trim(ended.err), '\n').size(), 1U) << ended.err;
    expect_modest(ended);
  };
  const std::string corners = repeated(head + R"({"id":"a","type":"kitchen","polygon":[)", "[0,1]", 1'000'000, "]}]}");
  show("corners.scene.json", corners, "has 1000000 items; expected at most 500");
  const std::string rooms = repeated(head, R"({"id":"a"})", 1'000'000, "]}");
  show("rooms.scene.json", rooms, "has 1000000 items; expected at most 200");

  const std::string house = R"({"objects":[],"walls":[],"rooms":[{"id":"room|1","roomType":"Kitchen","floorPolygon":[)";
  const std::string foreign = repeated(house, R"({"x":0,"y":0,"z":1})", 900'000, "]}]}");
  const auto ended = run_program({"scene", "import", "auto", file("house.json", foreign), "--out", folder_.at("x")});
  EXPECT_EQ(ended.code, 2) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr("has 900000 items; expected at most 500"));
  expect_modest(ended);
}

std::string nested(const std::string& open, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += open;
  return text;
}

/// How a format lists the objects of a home: `#` in `object` stands for the object's number.
struct ForeignFormat {
  std::string format, before, object, after;
};

const std::vector<ForeignFormat>& foreign_formats() {
  static const std::vector<ForeignFormat> kFormats{
      {"ithor", R"({"sceneName":"FloorPlan1","objects":[)",
       R"({"objectId":"Mug|#","objectType":"Mug","position":{"x":0,"y":0,"z":0},"rotation":{"x":0,"y":0,"z":0}})",
       "]}"},
      {"procthor",
       R"({"rooms":[{"id":"room|1","roomType":"Kitchen","floorPolygon":[{"x":0,"y":0,"z":0},{"x":0,"y":0,"z":3},)"
       R"({"x":3,"y":0,"z":3}]}],"walls":[],"doors":[],"windows":[],"objects":[)",
       R"({"id":"Mug|#","assetId":"Mug_1","position":{"x":1,"y":1,"z":1},"rotation":{"x":0,"y":0,"z":0}})", "]}"},
      {"virtualhome", R"({"edges":[],"nodes":[)",
       R"({"id":#,"class_name":"mug","category":"Props","properties":[],"states":[],)"
       R"("bounding_box":{"center":[0,0,0],"size":[1,1,1]}})",
       "]}"},
      {"hssd", R"({"stage_instance":{"template_name":"stages/1"},"object_instances":[)",
       R"({"template_name":"m#","translation":[0,0,0],"rotation":[1,0,0,0]})", "]}"},
      {"replicacad", R"({"stage_instance":{"template_name":"stages/frl_apartment_stage"},"object_instances":[)",
       R"({"template_name":"objects/frl_apartment_cup_#","translation":[0,0,0],"rotation":[1,0,0,0]})", "]}"},
      {"behavior", R"({"state":{"object_registry":{}},"objects_info":{"init_info":{)",
       R"("mug_#":{"class_name":"X","args":{"name":"mug_#","category":"mug","in_rooms":["kitchen_0"],"model":"m"}})",
       "}}}"},
  };
  return kFormats;
}

std::string home_of(const ForeignFormat& format, int objects) {
  std::string text = format.before;
  for (int i = 0; i < objects; ++i)
    text += (i == 0 ? "" : ",") + replace_all(format.object, "#", std::to_string(i + 1));
  return text + format.after;
}

class StrangeHome : public StrangeFile {
 protected:
  /// Nothing is written for it, and it is told in one line.
  void expect_no_import(const std::string& format, const std::string& text, const std::string& why) {
    SCOPED_TRACE(format);
    const auto home = file("home.json", text);
    const auto ended = run_program({"scene", "import", format, home, "--out", folder_.at("out")});
    EXPECT_EQ(ended.code, 2) << ended.out << ended.err;
    EXPECT_THAT(ended.err, ::testing::AllOf(HasSubstr(home), HasSubstr(why)));
    EXPECT_EQ(split(trim(ended.err), '\n').size(), 1U) << ended.err;
    EXPECT_TRUE(!fs::exists(folder_.at("out")) || bytes_below(folder_.at("out")).empty());
    expect_modest(ended);
  }
};

TEST_F(StrangeHome, OfTooManyObjectsIsRefusedByEachImporter) {
  EXPECT_EQ(foreign_formats().size(), scene_format_names().size());
  for (const auto& format : foreign_formats()) {
    expect_no_import(format.format, home_of(format, 100'000), "expected at most 20000");
    // BEHAVIOR's have no place here, and a home without any object is none either.
    expect_no_import(format.format, home_of(format, 5'001),
                     format.format == "behavior" ? "no objects around which to draw one" : "accepted are at most 5000");
  }
}

TEST_F(StrangeHome, ThatIsNestedTooDeeplyIsRefusedByEachImporter) {
  for (const auto& format : foreign_formats()) {
    const auto text = home_of(format, 3);
    expect_no_import(format.format, R"({"x":)" + nested("[", 100'000) + text.substr(1), "nested deeper than 64 levels");
    expect_no_import(format.format, R"({"x":)" + nested(R"({"x":)", 100'000), "nested deeper than 64 levels");
  }
}

TEST_F(StrangeHome, IsNotCalledByAPath) {
  const auto ithor = *read_file(fs::path(UNIETP_SOURCE_DIR) / "tests" / "end_to_end" / "homes" / "kitchen.ithor.json");
  for (const std::string name : {"../../mine", "/tmp/unietp-x", "..", "-x", "a\\u001b[2J"}) {
    const auto home = file("home.json", replace_all(ithor, "FloorPlan9", name));
    const auto before = bytes_below(folder_.path());
    const auto ended = run_program({"scene", "import", "ithor", home, "--no-settle", "--out", folder_.at("a/b/out")});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(bytes_below(folder_.at("a/b/out")).size(), 2U);  // the home and its report
    fs::remove_all(folder_.at("a"));
    EXPECT_EQ(bytes_below(folder_.path()), before);
    for (const char c : ended.out + ended.err) EXPECT_TRUE(c == '\n' || (c >= ' ' && c != '\x7f') || c < 0);
  }
}

TEST_F(StrangeFile, AGoalNestedTooDeeplyIsRefused) {
  const std::string head =
      "(template put-one (name \"put <A>\") (split atomic) (parameters (A - pickupable)) (instruction \"Put "
      "{A:indefinite}.\") (goal ";
  for (const char* open : {"(forall (?a - A) ", "(before ", "(not "}) {
    const auto ended = run_program({"template", "lint", file("put-one.template", head + nested(open, 100'000))});
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr("nested deeper than 200"));
    expect_modest(ended);
  }
  std::string goal = "(open ?v0)";
  for (int i = 0; i < 9; ++i) goal = "(forall (?v" + std::to_string(i) + " - object) " + goal + ")";
  const auto deep = run_program({"goal", "(at-end " + goal + ")"});
  EXPECT_EQ(deep.code, 2);
  EXPECT_THAT(deep.err, HasSubstr("has 9 quantifiers in one another; accepted are at most 8"));
}

/// A home of a simulator that takes minutes to come to rest.
std::string crowded_house() {
  std::string objects;
  for (int i = 0; i < 4000; ++i) {
    objects += (i == 0 ? "" : ",") + std::string(R"({"id":"Apple|)") + std::to_string(i) +
               R"(","assetId":"Apple_1","position":{"x":)" + number_text(1 + 0.01 * (i % 7)) + R"(,"y":)" +
               number_text(0.5 + 0.05 * i) + R"(,"z":1},"rotation":{"x":0,"y":0,"z":0},"kinematic":false})";
  }
  return R"({"rooms":[{"id":"room|1","roomType":"Kitchen","floorPolygon":[{"x":0,"y":0,"z":0},{"x":0,"y":0,"z":3},)"
         R"({"x":3,"y":0,"z":3},{"x":3,"y":0,"z":0}]}],"walls":[],"doors":[],"windows":[],"objects":[)" +
         objects + "]}";
}

/// Sends the signal, and expects an end within two seconds. `is_brief`: the command may also have been about to end, or
/// not yet so far as to say with which code a signal ends it.
void expect_ended_by(RunningProgram& program, int signal, bool is_brief = false) {
  EXPECT_TRUE(is_brief || program.running());
  program.send(signal);
  const auto sent = std::chrono::steady_clock::now();
  const auto ended = program.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(2));
  EXPECT_TRUE(ended.code == 130 || is_brief) << ended.code << ended.err;
}

TEST_F(StrangeFile, ASignalEndsTheImportOfAHomeThatTakesLong) {
  const auto house = file("house.json", crowded_house());
  for (const int signal : {SIGTERM, SIGINT}) {
    RunningProgram program({"scene", "import", "procthor", house, "--out", folder_.at("x")});
    while (program.running() && !fs::exists(folder_.at("x"))) ::usleep(10'000);
    expect_ended_by(program, signal);
    EXPECT_FALSE(fs::exists(folder_.at("x/house.scene.json.gz")));
    fs::remove_all(folder_.at("x"));
  }
}

/// serve_test.cpp and play_test.cpp interrupt those that wait for a client or a person.
TEST_F(StrangeFile, ASignalEndsWhatOnlyReads) {
  const std::string set = tiny_set().string();
  const auto house = file("house.json", crowded_house());
  std::vector<std::string> stats{"stats"};
  stats.resize(200, set);
  const std::vector<std::vector<std::string>> brief{{"validate", set, "--threads", "1"},
                                                    {"validate", set, "--against", set},
                                                    {"audit", set},
                                                    {"scene", "stats", house},
                                                    stats};
  const std::vector<std::vector<std::string>> long_ones{
      {"template", "coverage", "--tries", "20", "--threads", "1"},
      {"template", "try", "place-one-on", "--count", "50"},
      {"scene", "doctor", house},
  };
  for (const bool is_brief : {true, false}) {
    for (const auto& command : is_brief ? brief : long_ones) {
      for (const auto& [signal, after_s] :
           {std::pair{SIGTERM, is_brief ? 0.04 : 0.1}, std::pair{SIGINT, is_brief ? 0.06 : 0.4}}) {
        SCOPED_TRACE(command.front() + " " + command[1] + ", after " + std::to_string(after_s) + " s");
        RunningProgram program(command);
        while (program.running() && program.processor_s() < after_s) ::usleep(1000);
        expect_ended_by(program, signal, is_brief);
      }
    }
  }
}

}  // namespace
}  // namespace unietp
