#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "core/files.h"
#include "data_set.h"
#include "logic/evaluate.h"
#include "program.h"
#include "record/task_record.h"
#include "scene/scene_json.h"
#include "scene/telling_order.h"
#include "schema_checker.h"
#include "tests/exports/ltlf_reader.h"
#include "tests/pddl/reader.h"

namespace unietp::testing {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::map<std::string, std::string>& files, const std::string& name) {
  const auto found = files.find(name);
  return found == files.end() ? "" : found->second;
}

/// Each demonstration, as a plan, is valid in its exported problem and reaches the goal, and not without any of its
/// steps, read by code of the tests alone.
TEST(ExportPddl, EveryDemonstrationIsAPlanOfItsProblemAndEachStepIsNeeded) {
  const ScratchFolder folder;
  const auto out = folder.at("pddl");
  const auto ended = run_program({"export", "--format", "pddl", small_data_set().string(), "--out", out});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto files = bytes_below(out);
  std::map<std::string, PddlDomain> domains;
  std::size_t valid = 0;
  for (const auto& [name, bytes] : files) {
    if (name.ends_with("/domain.pddl")) domains[fs::path(name).parent_path()] = read_pddl_domain(bytes);
  }
  for (const auto& [name, bytes] : files) {
    if (!name.ends_with(".pddl") || name.ends_with("/domain.pddl")) continue;
    SCOPED_TRACE(name);
    const auto& domain = domains.at(fs::path(name).parent_path());
    const auto problem = read_pddl_problem(bytes, domain);
    PddlMachine machine(domain, problem);
    EXPECT_FALSE(machine.goal_holds());
    const auto plan = read_pddl_plan(text_of(files, fs::path(name).replace_extension(".plan")));
    for (const auto& step : plan)
      ASSERT_TRUE(machine.perform(step)) << step[0] << (step.size() > 1 ? " " + step[1] : "");
    EXPECT_TRUE(machine.goal_holds());
    EXPECT_EQ(needless_step(domain, problem, plan), "");
    ++valid;
  }
  const auto left_out = text_of(files, "left_out.jsonl");
  SchemaChecker checker;
  for (const auto& line : json_lines(fs::path(out) / "left_out.jsonl"))
    EXPECT_EQ(checker.check(line, "left_out.schema.json"), "");
  EXPECT_GE(3 * valid, 2 * json_lines(small_data_set() / "tasks.jsonl").size()) << left_out;

  const auto again = run_program({"export", "--format", "pddl", small_data_set().string(), "--out", out});
  EXPECT_EQ(again.code, 2) << "a folder that is there is not written over";
}

TEST(ExportStarts, EachStartIsWrittenWhole) {
  const ScratchFolder folder;
  const auto out = folder.at("starts");
  const auto ended = run_program({"export", "--format", "starts", small_data_set().string(), "--out", out});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto tasks = json_lines(small_data_set() / "tasks.jsonl");
  SchemaChecker checker;
  for (const auto& task : tasks) {
    const auto file = fs::path(out) / (task["scene"].get<std::string>() + ".scene.json.gz");
    const auto text = read_maybe_gzip(file);
    ASSERT_TRUE(text) << format(text.error());
    EXPECT_EQ(checker.check(nlohmann::ordered_json::parse(*text), "scene.schema.json"), "");
    const auto scene = scene_from_json(file.string(), *text);
    ASSERT_TRUE(scene) << format(scene.error());
    EXPECT_EQ(*scene, in_telling_order(start_of(small_data_set(), task)));
  }
  EXPECT_EQ(bytes_below(out).size(), tasks.size() + 1);  // and left_out.jsonl
}

LtlfTrace states_of(const nlohmann::ordered_json& states) {
  LtlfTrace trace;
  for (const auto& state : states) {
    trace.emplace_back();
    for (const auto& name : state) trace.back().insert(name.get<std::string>());
  }
  return trace;
}

/// Each formula is held against the data set's goal on every beginning of the demonstration, by a reader of the tests.
TEST(ExportLtlf, EveryFormulaMeansItsGoalOnEveryPrefixOfTheDemonstration) {
  const ScratchFolder folder;
  const auto out = fs::path(folder.at("ltlf"));
  const auto ended = run_program({"export", "--format", "ltlf", small_data_set().string(), "--out", out.string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  std::map<std::string, nlohmann::ordered_json> tasks;
  for (const auto& task : json_lines(small_data_set() / "tasks.jsonl")) tasks[task["id"]] = task;
  std::map<std::string, std::vector<Delta>> changes;
  const auto shown = small_data_set() / "demonstrations" / "M1.jsonl";
  int number = 0;
  for (const auto& line : json_lines(shown)) {
    const auto record = read_demonstration(shown.string(), ++number, line.dump());
    ASSERT_TRUE(record) << format(record.error());
    changes[record->task] = changes_by_moment(*record);
  }
  SchemaChecker checker;
  const auto lines = json_lines(out / "goals.jsonl");
  for (const auto& line : lines) {
    SCOPED_TRACE(line.dump());
    EXPECT_EQ(checker.check(line, "ltlf.schema.json"), "");
    const std::string id = line["task"], formula = line["formula"];
    const auto goal = parse_formula("goal", line["goal"].get<std::string>(), FormulaUse::Goal);
    ASSERT_TRUE(goal);
    const auto trace = states_of(line["traces"]["M1"]);
    const auto start = start_of(small_data_set(), tasks.at(id));
    ASSERT_EQ(trace.size(), changes[id].size() + 1);
    for (std::size_t n = 0; n < trace.size(); ++n) {
      const std::vector<Delta> before(changes[id].begin(), changes[id].begin() + static_cast<std::ptrdiff_t>(n));
      EXPECT_EQ(ltlf_holds(formula, {trace.begin(), trace.begin() + static_cast<std::ptrdiff_t>(n) + 1}),
                holds(*goal, to_logic(start, before, true)))
          << "after " << n << " steps";
    }
    EXPECT_TRUE(ltlf_holds(formula, trace));
  }
  EXPECT_GE(2 * lines.size(), tasks.size());
  EXPECT_EQ(lines.size() + json_lines(out / "left_out.jsonl").size(), tasks.size());
}

/// What is said of a task is what the format itself does with it, and each task is in the counts of the table once.
TEST(ExportForms, ATaskHasAFormExactlyWhereThatExportWritesIt) {
  const ScratchFolder folder;
  const auto out = fs::path(folder.at("forms"));
  const auto ended = run_program({"export", "--format", "forms", small_data_set().string(), "--out", out.string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto lines = json_lines(out / "forms.jsonl");
  EXPECT_EQ(bytes_below(out).size(), 1U);
  SchemaChecker checker;
  for (const auto& line : lines) EXPECT_EQ(checker.check(line, "forms.schema.json"), "");
  const std::set<std::string> of_simulators{"virtualhome", "virtualhome-unity", "habitat", "ai2thor", "behavior"};
  const auto tasks_of_set = json_lines(small_data_set() / "tasks.jsonl");
  ASSERT_EQ(lines.size(), tasks_of_set.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {  // what the task itself says
    std::set<std::string> there;
    for (const std::string form : lines[i]["forms"]) {
      if (of_simulators.contains(form)) there.insert(form);
    }
    EXPECT_EQ(tasks_of_set[i].at("forms").get<std::set<std::string>>(), there) << lines[i]["task"];
  }
  for (const std::string form : {"unietp-release", "bddl", "pddl", "ltlf", "virtualhome", "virtualhome-unity",
                                 "habitat", "ai2thor", "behavior"}) {
    const auto own = fs::path(folder.at(form));
    ASSERT_EQ(run_program({"export", "--format", form, small_data_set().string(), "--out", own.string()}).code, 0);
    std::map<std::string, std::string> left_out;
    for (const auto& line : json_lines(own / "left_out.jsonl")) left_out[line["task"]] = line["reason"];
    std::map<std::string, std::size_t> tasks, expressed;  // by simulator
    for (const auto& line : lines) {
      const std::string task = line["task"];
      const auto& forms = line["forms"];
      EXPECT_EQ(std::find(forms.begin(), forms.end(), form) == forms.end(), left_out.contains(task)) << task << form;
      const auto reason = left_out.find(task);
      const bool is_refused = line["refused"].contains(form);
      if (is_refused) {
        ASSERT_NE(reason, left_out.end()) << task << form;
        EXPECT_EQ(line["refused"][form], reason->second) << task;
      } else if (reason != left_out.end()) {
        EXPECT_TRUE(reason->second.starts_with("not a task of")) << task << form << reason->second;
        continue;
      }
      ++tasks[line["simulator"]];
      expressed[line["simulator"]] += is_refused ? 0 : 1;
    }
    for (const auto& [simulator, count] : tasks) {
      const auto row = simulator + " +" + form + " +" + std::to_string(count) + " +" +
                       std::to_string(expressed[simulator]) + " +[0-9.]+ %\n";
      EXPECT_TRUE(std::regex_search(ended.out, std::regex(row))) << row << ended.out;
    }
  }
}

TEST(Export, ReasonsAreCountedInTheSummaryAndAsJson) {
  const ScratchFolder folder;
  for (const std::string form : {"ai2thor", "virtualhome-unity", "bddl", "unietp-release", "forms"}) {
    SCOPED_TRACE(form);
    const auto text = run_program({"export", "--format", form, small_data_set().string(), "--out", folder.at(form)});
    const auto json = run_program(
        {"export", "--json", "--format", form, small_data_set().string(), "--out", folder.at(form + "-json")});
    ASSERT_EQ(text.code, 0) << text.err;
    ASSERT_EQ(json.code, 0) << json.err;
    const auto summary = nlohmann::json::parse(json.out);
    std::map<std::string, std::size_t> counted, lines;  // without the numbers of objects
    const auto plain = [](const std::string& reason) {
      return std::regex_replace(reason, std::regex("([^ ])_[0-9]+"), "$1");
    };
    if (form == "forms") {
      for (const auto& row : summary["forms"])
        for (const auto& one : row["reasons"])
          counted[row["form"].get<std::string>() + one["reason"].get<std::string>()] += one["tasks"].get<std::size_t>();
      for (const auto& line : json_lines(fs::path(folder.at(form)) / "forms.jsonl"))
        for (const auto& [name, reason] : line["refused"].items()) ++lines[name + plain(reason.get<std::string>())];
    } else {
      EXPECT_EQ(summary["tasks"].get<std::size_t>() + summary["left_out"].get<std::size_t>(),
                json_lines(small_data_set() / "tasks.jsonl").size());
      for (const auto& one : summary["reasons"]) counted[one["reason"]] = one["tasks"];
      for (const auto& line : json_lines(fs::path(folder.at(form)) / "left_out.jsonl"))
        ++lines[plain(line["reason"].get<std::string>())];
      for (const auto& [reason, count] : counted)
        EXPECT_NE(text.out.find("\n  " + std::to_string(count) + ": " + reason + "\n"), std::string::npos) << reason;
    }
    EXPECT_FALSE(lines.empty());
    EXPECT_EQ(counted, lines);
  }
}

TEST(Export, AnOptionOfAnotherFormatIsRefused) {
  const ScratchFolder folder;
  const auto ended = run_program(
      {"export", "--format", "pddl", "--unit", "step", small_data_set().string(), "--out", folder.at("pddl")});
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("--unit"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder.at("pddl")));
}

}  // namespace
}  // namespace unietp::testing
