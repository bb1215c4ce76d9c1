#include "writing_commands.h"

#include <gtest/gtest.h>

#include "../llm/wording_model.h"
#include "core/files.h"
#include "data_set.h"
#include "file_watch.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kTiny =
    "--count 3 --seed 3 --rooms 5 --objects 5 --simulators habitat --splits atomic --threads 2";
constexpr const char* kConfiguration = R"({
  "format": "unietp-run/1", "seed": 4, "homes": "benchmark", "block": 2,
  "quotas": {"splits": {"atomic": 4}, "simulators": {"ai2thor": 4}}})";
constexpr const char* kTraining = R"({
  "format": "unietp-run/1", "seed": 4, "block": 2, "quotas": {"splits": {"atomic": 3}, "simulators": {"habitat": 3}}})";

/// Words tasks as long as this process lives.
const std::string& url_of_a_model() {
  static test::WordingModel model;
  static const test::ChatServer kServer([](const test::Received& received) { return model(received); });
  return kServer.url;
}

/// Answers are kept outside of the workbenches: a cache is not what the command makes.
std::string annotate_by_model() {
  static const ScratchFolder kAnswers;
  return "annotate data --writer llm --llm-model tiny --llm-wait 0.001 --seed 5 --cache " + kAnswers.at("answers") +
         " --llm-url " + url_of_a_model();
}

void run_here(const fs::path& folder, const std::string& arguments) {
  const auto ended = run_script("unietp " + arguments, folder);
  EXPECT_EQ(ended.code, 0) << arguments << "\n" << ended.out << ended.err;
}

/// Made once for all workbenches of this process.
const fs::path& material() {
  static const ScratchFolder kFolder;
  static const bool kMade = [] {
    const fs::path& folder = kFolder.path();
    EXPECT_TRUE(write_file(folder / "small.json", kConfiguration));
    EXPECT_TRUE(write_file(folder / "training.json", kTraining));
    run_here(folder, std::string("generate ") + kTiny + " --out data");
    for (const char* part : {"1", "2"})
      run_here(folder, std::string("benchmark --config small.json --shard ") + part + "/2 --out part-" + part);
    for (const char* policy : {"replay", "stop"})
      run_here(folder, std::string("evaluate data --policy ") + policy + " --out run-" + policy);
    for (const auto& home : fs::directory_iterator(folder / "data" / "homes")) {
      fs::copy_file(home.path(), folder / "home.scene.json.gz");
      break;
    }
    run_here(folder, "scene export habitat home.scene.json.gz --out foreign.json");
    const auto tasks = json_lines(folder / "data" / "tasks.jsonl");
    Json reviews = Json::array();
    for (const auto& [i, verdict] : {std::pair{0, "accept"}, std::pair{1, "reject"}, std::pair{2, "edit"}}) {
      const auto& task = tasks.at(static_cast<std::size_t>(i));
      reviews.push_back(
          {{"task", task["id"]}, {"verdict", verdict}, {"instruction", task["instruction"]["text"]}, {"comment", ""}});
    }
    reviews[2]["text"] = "Do what I mean.";
    const Json review{{"format", "unietp-review/1"}, {"set", "data"}, {"tasks_sha256", "x"}, {"reviews", reviews}};
    EXPECT_TRUE(write_file(folder / "review.json", review.dump()));
    return true;
  }();
  EXPECT_TRUE(kMade);
  return kFolder.path();
}

}  // namespace

std::vector<WritingCommand> writing_commands() {
  std::vector<WritingCommand> commands{
      {"generate", std::string("generate ") + kTiny + " --out out --resume", "out"},
      {"benchmark", "benchmark --config small.json --shard 1/2 --out out --resume", "out"},
      {"training", "training --config training.json --out out --resume", "out"},
      {"merge", "merge part-1 part-2 --out out", "out"},
      {"annotate", "annotate data --seed 5 --paired", "data"},
      {"annotate by model", annotate_by_model(), "data"},
      {"annotate elsewhere", "annotate data --seed 5 --out out", "out"},
      {"review", "review data --apply review.json --accept-unchecked", "data"},
      {"review elsewhere", "review data --apply review.json --accept-unchecked --out out", "out"},
      {"review page", "review data --view 32 --out out.html", "out.html"},
      {"report", "report data --examples 1 --out out.html", "out.html"},
      {"render", "render data habitat-00001 --out out.svg", "out.svg"},
      {"render view", "render data habitat-00001 --step 1 --out out.png", "out.png"},
      {"altered plans", "validate data --altered-plans out.jsonl", "out.jsonl"},
      {"compare", "compare run-replay run-stop --out out", "out"},
      {"shape show", "shape show mug --out out.png", "out.png"},
      {"shape quiz", "shape quiz states --count 3 --seed 3 --out out", "out", true},
      {"scene show", "scene show home.scene.json.gz --out out.svg", "out.svg"},
      {"scene report", "scene report home.scene.json.gz --views 0 --width 64 --out out.html", "out.html"},
      {"scene import", "scene import auto foreign.json --out out", "out", true},
      {"scene export", "scene export habitat home.scene.json.gz --out out.json", "out.json"},
      {"knowledge build", "knowledge build --out out", "out", true},
      {"scene make", "scene make --simulator habitat --count 2 --seed 3 --out out", "out", true},
      {"template new", "template new mine --like place-one-on --out out", "out", true},
  };
  const fs::path upstream = UNIETP_UPSTREAM_DIR;
  if (const fs::path activities = upstream / "behavior" / "activity_definitions"; fs::exists(activities)) {
    commands.push_back({"scene fit", "scene fit " + upstream.string() + " --out out", "out", true});
    commands.push_back(
        {"knowledge fit-sense",
         "knowledge fit-sense " + upstream.string() + " --activities " + activities.string() + " --out out", "out",
         true});
  }
  for (const char* format : {"sft", "unietp-release", "bddl", "pddl", "ltlf", "virtualhome", "virtualhome-unity",
                             "habitat", "ai2thor", "behavior", "starts", "forms"})
    commands.push_back(
        {std::string("export ") + format, std::string("export data --format ") + format + " --out out", "out"});
  return commands;
}

std::string small_run(const std::string& seed) {
  return "generate --count 2 --rooms 5 --objects 5 --simulators habitat --splits atomic --threads 1 --seed " + seed;
}

Workbench::Workbench() { fs::copy(material(), path(), fs::copy_options::recursive); }

Ended Workbench::run(const std::string& arguments) const { return run_script("unietp " + arguments, path()); }

std::vector<std::string> Workbench::words(const WritingCommand& command) const {
  return {"-c", "exec unietp " + command.arguments};
}

std::map<std::string, std::string> Workbench::files(const std::string& name) const {
  const auto place = path() / name;
  if (fs::is_directory(place)) return bytes_below(place);
  if (!fs::exists(place)) return {};
  return {{name, *read_file(place)}};
}

std::map<std::string, std::string> Workbench::others(const WritingCommand& command) const {
  auto all = bytes_below(path());
  std::erase_if(all, [&](const auto& file) {
    return file.first == command.makes || file.first.starts_with(command.makes + "/");
  });
  return all;
}

Undisturbed undisturbed(const WritingCommand& command) {
  const Workbench bench;
  Undisturbed found;
  found.before = bench.files(command.makes);
  const auto others = bench.others(command);
  FileWatch watch(bench.path());
  RunningProgram program("/bin/sh", bench.words(command), bench.path());
  while (program.running()) (void)watch.count();
  found.changes = watch.count();
  const auto ended = program.wait();
  EXPECT_EQ(ended.code, 0) << command.name << "\n" << ended.out << ended.err;
  found.after = bench.files(command.makes);
  EXPECT_NE(found.before, found.after) << command.name;
  EXPECT_EQ(bench.others(command), others) << command.name;
  return found;
}

}  // namespace unietp
