// A data set whose lines are damaged or do not belong together is refused by every command that reads it, with the same
// words, the same file and the same line.
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text.h"
#include "data_set.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Lines = std::vector<std::string>;

constexpr std::size_t kTasks = 3;

/// The first tasks of a data set with what belongs to them.
class FewTasks : public ::testing::Test {
 protected:
  FewTasks() : folder_(scratch_.at("few")) {
    fs::copy(data_set_in_all_modes(), folder_, fs::copy_options::recursive);
    for (const char* mode : {"M2", "M3"}) fs::remove(folder_ / "demonstrations" / (std::string(mode) + ".jsonl"));
    for (const char* file : {"tasks.jsonl", "demonstrations/M1.jsonl"}) {
      auto lines = split(read(file), '\n');
      lines.resize(kTasks);
      if (std::string_view(file) == "tasks.jsonl") {
        for (auto& line : lines) line = in_m1_alone(line);
      }
      write(file, lines);
    }
  }
  static std::string in_m1_alone(const std::string& line) {
    auto json = nlohmann::ordered_json::parse(line);
    json["expert"].erase("M2");
    json["expert"].erase("M3");
    return json.dump();
  }
  std::string read(const std::string& file) const { return bytes_below(folder_).at(file); }
  Lines lines(const std::string& file) const {
    auto lines = split(read(file), '\n');
    lines.pop_back();
    return lines;
  }
  void write_bytes(const std::string& file, const std::string& bytes) const {
    std::ofstream(folder_ / file, std::ios::binary) << bytes;
  }
  void write(const std::string& file, const Lines& lines) const { write_bytes(file, join(lines, "\n") + "\n"); }
  std::string id(std::size_t task) const {
    return nlohmann::ordered_json::parse(lines("tasks.jsonl").at(task))["id"].get<std::string>();
  }

  /// Every command that reads these files, but for `without`; each refuses the folder with this error.
  void expect_refused(const std::string& file_and_line, const std::string& message,
                      const std::set<std::string>& without = {}) {
    const std::string folder = folder_.string(), error = file_and_line + ": schema error: " + message;
    write_bytes("../review.json", R"({"format":"unietp-review/1","set":"few","tasks_sha256":"x","reviews":[]})");
    const std::vector<std::pair<std::string, Lines>> commands{
        {"export", {"export", folder, "--format", "sft", "--out", scratch_.at("sft")}},
        {"stats", {"stats", folder}},
        {"report", {"report", folder, "--out", scratch_.at("report.html")}},
        {"annotate", {"annotate", folder, "--out", scratch_.at("annotated")}},
        {"review", {"review", folder, "--out", scratch_.at("review.html")}},
        {"apply", {"review", folder, "--apply", scratch_.at("review.json"), "--out", scratch_.at("reviewed")}},
        {"render", {"render", folder, id(kTasks - 1), "--out", scratch_.at("task.svg")}}};
    for (const auto& [name, arguments] : commands) {
      if (without.contains(name)) continue;
      const auto ended = run_program(arguments);
      EXPECT_EQ(ended.code, 2) << name;
      EXPECT_THAT(ended.err, HasSubstr("/" + error)) << name;
    }
    std::vector<std::string> problems;
    for (const auto& problem : validate(folder_).problems)
      problems.push_back(problem.where + ": schema error: " + problem.message);
    EXPECT_THAT(problems, Contains(StartsWith(error)));
    for (const auto& made : {"sft", "report.html", "annotated", "review.html", "reviewed", "task.svg"})
      EXPECT_FALSE(fs::exists(scratch_.at(made))) << made;
  }

  ScratchFolder scratch_;
  fs::path folder_;
};

constexpr const char* kM1 = "demonstrations/M1.jsonl";
constexpr const char* kEmpty = "is empty; expected a JSON object on every line";

TEST_F(FewTasks, AnEmptyLineAmongTheTasks) {
  auto all = lines("tasks.jsonl");
  all.insert(all.begin() + 1, "");
  write("tasks.jsonl", all);
  expect_refused("tasks.jsonl:2", kEmpty);
}

TEST_F(FewTasks, AnEmptyLineAmongTheDemonstrations) {
  auto all = lines(kM1);
  all.insert(all.begin() + 1, "");
  write(kM1, all);
  expect_refused("demonstrations/M1.jsonl:2", kEmpty);
}

TEST_F(FewTasks, LinesThatEndInCarriageReturns) {
  write_bytes("tasks.jsonl", join(lines("tasks.jsonl"), "\r\n") + "\r\n");
  expect_refused("tasks.jsonl:1", "ends in CR LF; expected only LF");
}

TEST_F(FewTasks, ALastLineThatIsCutOff) {
  const auto bytes = read(kM1);
  write_bytes(kM1, bytes.substr(0, bytes.size() - 20));
  expect_refused("demonstrations/M1.jsonl:3", "does not end in a line feed: the file is cut off");
}

TEST_F(FewTasks, AnUnknownFieldOfTheLastTask) {
  auto all = lines("tasks.jsonl");
  all.back().insert(1, "\"surprise\":1,");
  write("tasks.jsonl", all);
  expect_refused("tasks.jsonl:3#/surprise", "unknown field \"surprise\"");
}

TEST_F(FewTasks, DemonstrationsInAnotherOrder) {
  auto all = lines(kM1);
  std::swap(all[0], all[1]);
  write(kM1, all);
  expect_refused("demonstrations/M1.jsonl:1", "expected the demonstration of " + id(0) + ", not of " + id(1));
}

TEST_F(FewTasks, ADemonstrationThatIsMissing) {
  auto all = lines(kM1);
  all.erase(all.begin() + 1);
  write(kM1, all);
  expect_refused("demonstrations/M1.jsonl:2", "expected the demonstration of " + id(1) + ", not of " + id(2));
}

TEST_F(FewTasks, ADemonstrationOfNoTask) {
  auto all = lines(kM1);
  all.insert(all.begin() + 1, replace_all(all[0], id(0), "nobody"));
  write(kM1, all);
  expect_refused("demonstrations/M1.jsonl:2", "expected the demonstration of " + id(1) + ", not of nobody");
}

TEST_F(FewTasks, ADemonstrationBehindTheLast) {
  auto all = lines(kM1);
  all.push_back(all[0]);
  write(kM1, all);
  expect_refused("demonstrations/M1.jsonl:4", "expected the end of the file, not the demonstration of " + id(0),
                 {"render"});  // which reads no farther than its task
}

TEST_F(FewTasks, AnEmptyLineAmongTheRejections) {
  auto all = lines("rejections.jsonl");
  all.insert(all.begin(), "");
  write("rejections.jsonl", all);
  expect_refused("rejections.jsonl:1", kEmpty, {"export", "annotate", "render", "review"});  // which do not read them
}

}  // namespace
}  // namespace unietp
