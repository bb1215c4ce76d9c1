#include "cli/sense_folder.h"

#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "cli/common_options.h"
#include "dataset/configuration.h"
#include "record/dataset_reader.h"
#include "sense/grade_goal.h"
#include "sense/question.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct SenseOptions {
  std::string question, simulator;
  std::filesystem::path tasks;
  bool json = false;
};

/// All that grading needs.
struct Grader {
  std::vector<Knowledge> knowledge;  // of the simulators asked for
  CommonSense sense;
  WordKinds words;

  const Knowledge* of(std::string_view simulator) const {
    for (const auto& each : knowledge) {
      if (name_of(each.simulator()) == simulator) return &each;
    }
    return nullptr;
  }
};

Json json_of(const TaskSense& task) {
  Json parts = Json::array();
  for (const auto& part : task.parts)
    parts.push_back({{"part", part.part}, {"grade", name_of(part.sense.grade)}, {"reasons", part.sense.reasons}});
  return {{"grade", name_of(task.grade)}, {"parts", std::move(parts)}};
}

void print_task(const TaskSense& task) {
  print_line(std::string(name_of(task.grade)));
  for (const auto& part : task.parts) {
    print_line("  " + part.part + ": " + std::string(name_of(part.sense.grade)));
    for (const auto& reason : part.sense.reasons) print_line("    " + reason);
  }
}

Exit answer(const SenseOptions& options, const Grader& grader) {
  Json all = Json::array();
  for (const auto& knowledge : grader.knowledge) {
    const auto goal = options.question.starts_with('(') ? parse_formula("question", options.question, FormulaUse::Goal)
                                                        : read_question(options.question, knowledge);
    if (!goal) return refuse(goal.error());
    if (const auto known = check_names(*goal, knowledge, grader.words); !known) return refuse(known.error());
    const auto task = grade_goal(*goal, knowledge, grader.sense, grader.words);
    if (options.json) {
      Json json{{"simulator", name_of(knowledge.simulator())}, {"goal", to_text(*goal)}};
      json.update(json_of(task));
      all.push_back(std::move(json));
    } else {
      print_task(task);
    }
  }
  if (options.json) print_line((all.size() == 1 ? all.front() : all).dump(2));
  return Exit::Ok;
}

Exit grade_tasks(const SenseOptions& options, const Grader& grader) {
  auto reader = DatasetReader::open(options.tasks, {});
  if (!reader) return refuse(reader.error());
  while (const auto lines = reader->lines().next()) {
    const auto task = reader->task(*lines);
    if (!task) return refuse(task.error());
    const auto* knowledge = grader.of(task->simulator);
    if (knowledge == nullptr) continue;
    const auto graded = grade_goal(task->goal_tree, *knowledge, grader.sense, grader.words);
    if (options.json) {
      Json json{{"id", task->id}, {"template", task->template_name}, {"instruction", task->instruction}};
      json.update(json_of(graded));
      print_line(json.dump());
    } else {
      print_line(task->id + ": " + std::string(name_of(graded.grade)) + ": " + task->instruction +
                 (graded.parts.empty() ? "" : " (" + graded.parts.front().part + ")"));
    }
  }
  return Exit::Ok;
}

Exit run(const SenseOptions& options, const CommandLine& program) {
  if (options.question.empty() == options.tasks.empty())
    return refuse({Error::Kind::Usage, "sense", {}, "expected a question, or --tasks FOLDER"});
  std::vector<Simulator> simulators(kSimulators.begin(), kSimulators.end());
  if (!options.simulator.empty()) {
    const auto named = parse_simulators("--simulator", options.simulator);
    if (!named) return refuse(named.error());
    simulators = *named;
  } else if (options.tasks.empty()) {
    return refuse({Error::Kind::Usage, "--simulator", {}, "expected one of ai2thor, virtualhome, habitat, behavior"});
  }
  std::vector<Error> errors;
  auto knowledge = load_some(program, simulators, errors);
  auto sense = read_common_sense(sense_folder(program), errors);
  auto words = read_word_kinds(sense_folder(program), sense.kinds(), errors);
  if (!errors.empty()) return refuse(errors);
  const Grader grader{std::move(knowledge), std::move(sense), std::move(words)};
  return options.tasks.empty() ? answer(options, grader) : grade_tasks(options, grader);
}

}  // namespace

void add_sense_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<SenseOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("sense", "Grade how much sense a task makes in a home");
  command->explain(
      "Answers usual, tolerable or senseless, with the reasons: rules, judgments of kinds of things, and what people "
      "wrote. A question is a sentence such as those below, or a goal formula (docs/sense.md).",
      {{"unietp sense 'place Mug on CounterTop' --simulator ai2thor", ""},
       {"unietp sense 'cook Potato then place Potato on Plate' --simulator ai2thor", ""},
       {"unietp sense 'fill Mug with coffee' --simulator ai2thor --json", ""},
       {"unietp sense '(exists (?b - Book) (at-end (soaked ?b)))' --simulator ai2thor", ""},
       {"unietp sense --tasks out/mine", "one line for each task of a data set"}});
  command->add_option("QUESTION", options->question, "What is asked about");
  command->add_option("--simulator", options->simulator, "The simulator whose categories are named");
  command->add_option("--tasks", options->tasks, "A data set whose tasks are graded")->folder();
  command->add_flag("--json", options->json, "Print JSON; for --tasks one line per task");
  command->callback([options, &program] { program.exit = run(*options, program); });
}

}  // namespace unietp
