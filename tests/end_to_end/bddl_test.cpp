// BEHAVIOR's tasks as BDDL, read by a reader of this file alone: objects of declared types, goals of BDDL's words, and
// the same truth as our goal after every step of the demonstration; and the goals that need more than the last state,
// as formulas over literals of BDDL.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "logic/evaluate.h"
#include "record/task_record.h"
#include "scene/scene_json.h"
#include "scene/trace.h"
#include "schema_checker.h"
#include "tests/exports/ltlf_reader.h"
#include "tests/support/needs.h"

namespace unietp::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Tasks of BEHAVIOR alone.
const fs::path& of_behavior() {
  static const ScratchFolder kScratch;
  static const fs::path kFolder = [] {
    const auto ended = run_program({"generate", "--count", "32", "--seed", "5", "--rooms", "5", "--objects", "25",
                                    "--simulators", "behavior", "--splits", "compositional,instance_grounding,logical",
                                    "--out", kScratch.at("behavior"), "--threads", "2"});
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    return fs::path(kScratch.at("behavior"));
  }();
  return kFolder;
}

/// A word, or a list of expressions.
struct Expression {
  std::string word;
  std::vector<Expression> parts;
};

Expression read_expression(const std::string& text, std::size_t& at) {
  while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at])) != 0) ++at;
  Expression read;
  if (text.at(at) != '(') {
    while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at])) == 0 && text[at] != '(' &&
           text[at] != ')')
      read.word += text[at++];
    return read;
  }
  ++at;
  while (true) {
    while (std::isspace(static_cast<unsigned char>(text.at(at))) != 0) ++at;
    if (text[at] == ')') break;
    read.parts.push_back(read_expression(text, at));
  }
  ++at;
  return read;
}

struct BddlProblem {
  std::map<std::string, std::string> ours;                // our id of an object, by its name, as comments tell
  std::map<std::string, std::set<std::string>> of_types;  // objects by type
  std::set<std::vector<std::string>> init;
  Expression goal;
};

BddlProblem read_problem(const std::string& text) {
  BddlProblem problem;
  std::string code;
  for (const auto& line : split(text, '\n')) {
    const auto colon = line.find(": ");
    if (line.starts_with("; ") && line.find(".n.") < colon && colon != std::string::npos)
      problem.ours[line.substr(2, colon - 2)] = line.substr(colon + 2);
    if (!line.starts_with(";")) code += line + "\n";
  }
  std::size_t at = 0;
  const auto root = read_expression(code, at);
  EXPECT_EQ(std::string(trim(code.substr(at))), "");
  EXPECT_EQ(root.parts.at(0).word, "define");
  EXPECT_EQ(root.parts.at(1).parts.at(0).word, "problem");
  EXPECT_EQ(root.parts.at(2).parts.at(0).word, ":domain");
  EXPECT_EQ(root.parts.at(2).parts.at(1).word, "omnigibson");
  std::vector<std::string> waiting;
  const auto& objects = root.parts.at(3).parts;
  EXPECT_EQ(objects.at(0).word, ":objects");
  for (std::size_t i = 1; i < objects.size(); ++i) {
    if (objects[i].word != "-") {
      waiting.push_back(objects[i].word);
      continue;
    }
    const auto& type = objects.at(++i).word;
    for (const auto& name : waiting) {
      EXPECT_EQ(name.substr(0, name.rfind('_')), type) << "BDDL names an object by its synset and a number";
      EXPECT_TRUE(problem.of_types[type].insert(name).second);
    }
    waiting.clear();
  }
  EXPECT_TRUE(waiting.empty());
  const auto& init = root.parts.at(4).parts;
  EXPECT_EQ(init.at(0).word, ":init");
  for (std::size_t i = 1; i < init.size(); ++i) {
    std::vector<std::string> fact;
    for (const auto& part : init[i].parts) fact.push_back(part.word);
    problem.init.insert(fact);
  }
  EXPECT_EQ(root.parts.at(5).parts.at(0).word, ":goal");
  problem.goal = root.parts.at(5).parts.at(1);
  return problem;
}

using Facts = std::set<std::vector<std::string>>;

/// BDDL's truth of a goal among facts; `forn` is exactly so many.
bool goal_holds(const BddlProblem& problem, const Expression& goal, const Facts& facts,
                const std::map<std::string, std::string>& values) {
  const std::string& word = goal.parts.at(0).word;
  const auto part = [&](std::size_t i) { return goal_holds(problem, goal.parts.at(i), facts, values); };
  if (word == "and" || word == "or") {
    std::size_t met = 0;
    for (std::size_t i = 1; i < goal.parts.size(); ++i) met += part(i) ? 1 : 0;
    return word == "and" ? met + 1 == goal.parts.size() : met > 0;
  }
  if (word == "not") return !part(1);
  if (word == "imply") return !part(1) || part(2);
  if (word == "forall" || word == "exists" || word == "forn") {
    const std::size_t shift = word == "forn" ? 1 : 0;
    const auto& bound = goal.parts.at(1 + shift).parts;
    EXPECT_EQ(bound.at(1).word, "-");
    const auto& objects = problem.of_types.at(bound.at(2).word);
    std::size_t met = 0;
    for (const auto& object : objects) {
      auto inner = values;
      inner[bound.at(0).word] = object;
      met += goal_holds(problem, goal.parts.at(2 + shift), facts, inner) ? 1 : 0;
    }
    if (word == "forn") return met == std::stoul(goal.parts.at(1).parts.at(0).word);
    return word == "forall" ? met == objects.size() : met > 0;
  }
  static const std::set<std::string> kWords{
      "ontop",   "inside",    "nextto", "under",    "open", "hot",    "toggled_on", "cooked",  "frozen",  "folded",
      "covered", "saturated", "filled", "contains", "real", "future", "unfolded",   "grasped", "attached"};
  EXPECT_TRUE(kWords.contains(word)) << word;
  std::vector<std::string> fact{word};
  for (std::size_t i = 1; i < goal.parts.size(); ++i) {
    const std::string& term = goal.parts[i].word;
    EXPECT_TRUE(term.starts_with("?"));
    const auto found = values.find(term);
    if (found == values.end()) {
      const auto type = problem.of_types.find(term.substr(1, term.rfind('_') - 1));
      EXPECT_TRUE(type != problem.of_types.end() && type->second.contains(term.substr(1))) << "unbound " << term;
    }
    fact.push_back(found == values.end() ? term.substr(1) : found->second);
  }
  return facts.contains(fact);
}

/// The object of a problem that is a substance of ours.
std::string substance_named(const std::string& ours) {
  static const std::map<std::string, std::string> kSynsets = [] {
    std::map<std::string, std::string> read;
    for (const auto& line : split(*read_file(fs::path(UNIETP_SOURCE_DIR) / "data" / "bddl" / "substances.csv"), '\n')) {
      const auto cells = split(line, ',');
      if (cells.size() == 3) read[cells[0]] = cells[1];
    }
    return read;
  }();
  const auto found = kSynsets.find(ours);
  return found == kSynsets.end() ? "" : found->second + "_1";
}

/// The states of a node, of what is called `name`.
void add_states(const Node& node, const std::string& name, Facts& facts) {
  for (const State& state : node.states.all()) {
    const std::string symbol = substance_named(state.symbol);
    if (state.predicate == Predicate::Dirty) facts.insert({"covered", name, substance_named("stain")});
    if (state.predicate == Predicate::Soaked) facts.insert({"saturated", name, substance_named("water")});
    if (state.predicate == Predicate::Covered) facts.insert({"covered", name, symbol});
    if (state.predicate == Predicate::Filled) {
      facts.insert({"filled", name, symbol});
      facts.insert({"contains", name, symbol});
    }
    if (state.symbol.empty())
      facts.insert(
          {state.predicate == Predicate::PowerOn ? "toggled_on" : std::string(info(state.predicate).name), name});
  }
}

/// What BDDL's predicates are of the problem's objects in a scene. Where the problem has halves of a thing, one that is
/// cut is not there any more: the first half is what remains of it, the second the piece.
Facts facts_of(const BddlProblem& problem, const Scene& scene) {
  std::map<std::string, std::string> names, now;  // by our id; in this scene
  for (const auto& [name, id] : problem.ours) names[id] = name;
  for (const Node& node : scene.nodes) {
    const bool is_cut = names.contains(node.id + "/1") && node.states.has(Predicate::Sliced);
    const auto name = names.find(is_cut ? node.id + "/1" : node.slice_of.empty() ? node.id : node.slice_of + "/2");
    if (name != names.end()) now[node.id] = name->second;
    if (!node.slice_of.empty() && names.contains(node.id)) now[node.id] = names.at(node.id);  // cut before the start
  }
  Facts facts;
  for (const Room& room : scene.rooms) {
    if (!names.contains(room.id)) continue;
    now[room.id] = names.at(room.id);
    facts.insert({"real", now[room.id]});
  }
  for (const Edge& edge : scene.edges) {
    const auto from = now.find(edge.from), to = now.find(edge.to);
    if (from == now.end() || to == now.end()) continue;
    if (edge.relation == Predicate::On || edge.relation == Predicate::OnFloor)
      facts.insert({"ontop", from->second, to->second});
    if (edge.relation == Predicate::Inside) facts.insert({"inside", from->second, to->second});
    if (edge.relation == Predicate::NextTo) facts.insert({"nextto", from->second, to->second});
    if (edge.relation == Predicate::Under) facts.insert({"under", from->second, to->second});
    if (edge.relation == Predicate::Attached) facts.insert({"attached", from->second, to->second});
  }
  for (const Node& node : scene.nodes) {
    const auto name = now.find(node.id);
    if (name == now.end()) continue;
    facts.insert({"real", name->second});
    add_states(node, name->second, facts);
  }
  for (const auto& [id, name] : names) {
    if (!facts.contains({"real", name})) facts.insert({"future", name});
  }
  for (const std::string& id : scene.agent.held) {
    if (now.contains(id)) facts.insert({"grasped", "agent.n.01_1", now.at(id)});
  }
  return facts;
}

/// A task of BEHAVIOR with its demonstration in M1.
struct ShownTask {
  TaskRecord task;
  Scene start;
  DemonstrationRecord demonstration;
};

std::vector<ShownTask> shown_tasks() {
  std::vector<ShownTask> all;
  const auto tasks = json_lines(of_behavior() / "tasks.jsonl");
  const auto demonstrations = json_lines(of_behavior() / "demonstrations" / "M1.jsonl");
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    all.push_back({*read_task("tasks.jsonl", 1, tasks[i].dump()), start_of(of_behavior(), tasks[i]),
                   *read_demonstration("M1.jsonl", 1, demonstrations[i].dump())});
  }
  return all;
}

TEST(ExportBddl, EachGoalHasTheTruthOfOursAfterEveryStep) {
  const ScratchFolder scratch;
  const fs::path out = scratch.at("bddl");
  const auto ended = run_program({"export", of_behavior().string(), "--format", "bddl", "--out", out.string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  std::size_t problems = 0;
  for (const auto& [task, start, shown] : shown_tasks()) {
    const fs::path file = out / (task.id + ".bddl");
    if (!fs::exists(file)) continue;
    SCOPED_TRACE(file);
    ++problems;
    const auto problem = read_problem(*read_file(file));
    Scene scene = start;
    std::vector<Delta> changes;
    const auto at_start = facts_of(problem, scene);
    for (const auto& fact : problem.init) {
      const bool about_rooms = fact[0] == "inroom" || fact.back().starts_with("floor.n.01");
      EXPECT_TRUE(about_rooms || at_start.contains(fact)) << fact[0] << " " << fact[1];
    }
    EXPECT_FALSE(goal_holds(problem, problem.goal, at_start, {}));
    for (const auto& step : shown.steps) {
      changes.push_back(step.changes);
      scene = apply(scene, step.changes);
      EXPECT_EQ(goal_holds(problem, problem.goal, facts_of(problem, scene), {}),
                holds(task.goal_tree, to_logic(start, changes, true)));
    }
    EXPECT_TRUE(goal_holds(problem, problem.goal, facts_of(problem, scene), {}));
  }
  SchemaChecker checker;
  const auto left_out = json_lines(out / "left_out.jsonl");
  for (const auto& line : left_out) EXPECT_EQ(checker.check(line, "left_out.schema.json"), "");
  EXPECT_EQ(problems + left_out.size(), shown_tasks().size());
  EXPECT_GE(2 * problems, shown_tasks().size()) << *read_file(out / "left_out.jsonl");
}

/// The formula over literals of BDDL is the goal, after every step; what the problem asks of the last state follows.
TEST(ExportBehavior, EachFormulaHasTheTruthOfOursAfterEveryStep) {
  const ScratchFolder scratch;
  const fs::path out = scratch.at("behavior");
  const auto ended = run_program({"export", of_behavior().string(), "--format", "behavior", "--out", out.string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  SchemaChecker checker;
  std::size_t expressed = 0, with_time = 0, composite = 0;
  for (const auto& [task, start, shown] : shown_tasks()) {
    const fs::path file = out / (task.id + ".json");
    if (!fs::exists(file)) continue;
    SCOPED_TRACE(file);
    ++expressed;
    const auto json = nlohmann::ordered_json::parse(*read_file(file));
    EXPECT_EQ(checker.check(json, "behavior.schema.json"), "");
    const auto problem = read_problem(*read_file(out / "activity_definitions" / task.id / "problem0.bddl"));
    for (const auto& [id, name] : json["objects"].items()) EXPECT_EQ(problem.ours.at(name), id);
    const std::string sampled = task.id + "_task_" + task.id + "_0_0_template.json";
    const auto home = nlohmann::ordered_json::parse(*read_file(out / "scenes" / task.id / "json" / sampled));
    const auto& instances = home["metadata"]["task"]["inst_to_name"];
    for (const auto& [name, id] : problem.ours) {
      if (id.find('/') != std::string::npos) continue;
      ASSERT_TRUE(instances.contains(name)) << name;
      EXPECT_EQ(instances[name], json["scene_objects"][id]);
      EXPECT_TRUE(home["objects_info"]["init_info"].contains(instances[name].get<std::string>())) << name;
      EXPECT_TRUE(home["state"]["object_registry"].contains(instances[name].get<std::string>())) << name;
    }
    // As OmniGibson's BehaviorTask looks them up: all that is there at the start, the robot and substances included.
    for (const auto& [type, objects] : problem.of_types) {
      for (const std::string& name : objects)
        EXPECT_NE(instances.contains(name), problem.init.contains({"future", name})) << name;
    }
    for (const auto& [substance, name] : json["substances"].items()) EXPECT_EQ(instances[name], substance);
    EXPECT_TRUE(instances.contains("agent.n.01_1"));
    const bool decides = json["last_state_decides"];
    with_time += decides ? 0 : 1;
    Scene scene = start;
    std::vector<Delta> changes;
    LtlfTrace trace;
    const auto see = [&](const Facts& facts) {
      trace.emplace_back();
      for (const auto& one : json["goal"]["propositions"]) {
        const std::string literal = one["bddl"];
        std::size_t at = 0;
        if (goal_holds(problem, read_expression(literal, at), facts, {})) trace.back().insert(one["name"]);
      }
    };
    for (std::size_t n = 0; n <= shown.steps.size(); ++n) {
      if (n > 0) {
        const StepRecord& step = shown.steps[n - 1];
        const auto moments = step.moments.empty() ? std::vector{step.changes} : step.moments;
        const auto& planned = json["plan"][n - 1];
        const auto listed = planned.value("moments", nlohmann::ordered_json::array({planned["holds"]}));
        ASSERT_EQ(listed.size(), moments.size());
        EXPECT_EQ(listed.back(), planned["holds"]);
        composite += moments.size() > 1 ? 1 : 0;
        for (std::size_t i = 0; i < moments.size(); ++i) {
          changes.push_back(moments[i]);
          scene = apply(scene, moments[i]);
          if (i + 1 == moments.size()) continue;
          see(facts_of(problem, scene));
          EXPECT_EQ(trace.back(), std::set<std::string>(listed[i].begin(), listed[i].end())) << "in step " << n;
        }
      }
      const Facts facts = facts_of(problem, scene);
      see(facts);
      const auto& listed = n == 0 ? json["goal"]["holds"] : json["plan"][n - 1]["holds"];
      EXPECT_EQ(trace.back(), std::set<std::string>(listed.begin(), listed.end())) << "after " << n << " steps";
      const bool ours = holds(task.goal_tree, to_logic(start, changes, true));
      EXPECT_EQ(ltlf_holds(json["goal"]["formula"], trace), ours) << "after " << n << " steps";
      const bool theirs = goal_holds(problem, problem.goal, facts, {});
      EXPECT_TRUE(decides ? theirs == ours : theirs || !ours) << "after " << n << " steps";
    }
  }
  EXPECT_GE(10 * expressed, 8 * shown_tasks().size()) << *read_file(out / "left_out.jsonl");
  EXPECT_GE(with_time, 1U);
  EXPECT_GE(composite, 1U) << "actions of several moments";
}

/// The table comes from BEHAVIOR's own; what stands there now is held against it.
TEST(ExportBddl, SynsetsAreThoseOfBehavior) {
  const fs::path upstream = fs::path(UNIETP_UPSTREAM_DIR) / "behavior/category_mapping.csv.gz";
  if (!fs::exists(upstream)) GTEST_SKIP() << needs::kSimulatorFiles;
  const auto theirs_text = read_maybe_gzip(upstream);
  ASSERT_TRUE(theirs_text);
  std::map<std::string, std::string> theirs;
  for (const auto& line : split(*theirs_text, '\n')) {
    const auto cells = split(line, ',');
    if (cells.size() > 3) theirs[cells[1]] = cells[3];
  }
  std::size_t held = 0;
  for (const auto& line : split(*read_file(fs::path(UNIETP_SOURCE_DIR) / "data" / "bddl" / "synsets.csv"), '\n')) {
    const auto cells = split(line, ',');
    if (cells.size() != 3 || cells[0] == "category") continue;
    EXPECT_EQ(theirs[cells[0]], cells[1]);
    ++held;
  }
  EXPECT_GT(held, 1800U);
}

}  // namespace
}  // namespace unietp::testing
