#include "cli/help_topics.h"

#include "cli/help_text.h"
#include "exports/formats.h"

namespace unietp {
namespace {

constexpr const char* kModesTopic =
    "Every task can be given to an agent in three modes. They differ in what the agent\n"
    "is told and how it names things; the world behaves the same.\n"
    "\n"
    "                     M1                  M2                  M3\n"
    "  told at the start  rooms, furniture,   rooms, furniture    rooms\n"
    "                     movable objects\n"
    "  sees each step     picture, boxes      picture, boxes      picture\n"
    "                     with ids            with ids\n"
    "  names objects by   id                  id                  a box in the picture\n"
    "  actions            all 38              the 32 basic ones   the 32 basic ones\n"
    "  limits             50 steps,           50 steps,           150 steps,\n"
    "                     10 failures         10 failures         30 failures\n"
    "\n"
    "`unietp generate --modes M1,M2,M3` keeps a task only if the expert can demonstrate\n"
    "it in all of them. `unietp actions` lists the actions of each mode. Details:\n"
    "docs/modes.md.\n";

constexpr const char* kHomesTopic =
    "A home is a file *.scene.json or *.scene.json.gz: rooms, furniture, objects with\n"
    "their states and poses, and the agent. Tasks can be made in\n"
    "\n"
    "  new homes              the default of `unietp generate`; --rooms and --objects set\n"
    "                         their size. `unietp scene make` writes them as files\n"
    "  the benchmark's homes  170 fixed ones; `unietp scene list` names them\n"
    "  simulators' homes      AI2-THOR, ProcTHOR, VirtualHome, Habitat (ReplicaCAD, HSSD)\n"
    "                         and BEHAVIOR files, converted by `unietp scene import`\n"
    "\n"
    "  unietp scene import auto FloorPlan1.json --out out/homes\n"
    "  unietp generate --scenes out/homes --count 20 --out out/tasks\n"
    "\n"
    "`unietp scene show` draws a home, `unietp scene stats` compares sets of homes, and\n"
    "`unietp scene export` writes a home for a simulator. Details: docs/scenes.md and\n"
    "docs/scenes-in-and-out.md.\n";

constexpr const char* kExitCodesTopic =
    "  0    done\n"
    "  1    finished, but something is wrong: a task could not be made, a check failed,\n"
    "       two things differ, an answer is missing\n"
    "  2    bad input: a wrong option, or a file that cannot be read or written\n"
    "  130  interrupted by Ctrl-C or SIGTERM; `--resume` continues a run\n"
    "\n"
    "`unietp COMMAND --help` says what 1 means for a command.\n";

constexpr const char* kFilesTopic =
    "A data set is a folder:\n"
    "\n"
    "  tasks.jsonl              one task per line: goal, instruction, start, home\n"
    "  homes/*.scene.json.gz    the homes of the tasks\n"
    "  demonstrations/M1.jsonl  one demonstration per line; also M2 and M3 if asked for\n"
    "  manifest.json            configuration, counts, checksums, sources, licenses\n"
    "  rejections.jsonl         candidates that were given up, with the reason\n"
    "  dataset.sqlite           tables of tasks, bindings, steps and rejections\n"
    "  README.md                the data set card\n"
    "\n"
    "A configuration file (`--config`) is JSON: \"format\": \"unietp-run/1\" and any of\n"
    "seed, count, quotas, simulators, splits, templates, without, extended, modes,\n"
    "phrasings, homes, attempts and block. data/runs/ has those of the benchmark and of\n"
    "the training data.\n"
    "\n"
    "Every file format has a JSON Schema: `unietp schemas` prints where they are, and\n"
    "`unietp schemas --page` lists every field. Details: docs/files.md.\n";

constexpr const char* kModelsTopic =
    "No command needs a language model. Where one can help, any server with the OpenAI\n"
    "chat completions API works:\n"
    "\n"
    "  unietp annotate DATASET --writer llm     have a model write the instructions\n"
    "  unietp annotate DATASET --writer batch   the same through request and answer files\n"
    "  unietp knowledge complete                ask for facts that the tables lack\n"
    "\n"
    "Give --llm-url (such as http://localhost:8080/v1) and --llm-model. The environment\n"
    "variable UNIETP_LLM_KEY holds the key, if the server wants one; it is never stored\n"
    "or shown. --dry-run prints the prompts and sends nothing. Every answer is checked\n"
    "before it is used. Details: docs/llm.md.\n";

constexpr const char* kEvaluationTopic =
    "`unietp evaluate DATASET --out FOLDER` plays every task with an agent and writes\n"
    "tables of its success:\n"
    "\n"
    "  --model NAME --llm-url URL      any OpenAI-compatible server; its key is read from\n"
    "                                  UNIETP_LLM_KEY. --images none for models that\n"
    "                                  cannot see\n"
    "  --policy COMMAND                a program that speaks JSON lines\n"
    "  --policy python:module.Class    a Python class with act(observation)\n"
    "  --policy replay                 the stored demonstrations; also expert, random,\n"
    "                                  stop and noisy:P\n"
    "\n"
    "Malformed answers count as the model's. Errors of the server or the program do not:\n"
    "the episode is errored, the run incomplete, the exit code 1, and the same command\n"
    "with --resume plays what is missing. --dry-run shows the plan and the first prompt,\n"
    "--show-prompt TASK:STEP any other.\n"
    "\n"
    "FOLDER then holds report.html with a viewer of the episodes, tables.md, .tex and\n"
    ".csv, results.json, lm_eval.json, and episodes.jsonl, from which they follow:\n"
    "\n"
    "  unietp validate FOLDER --dataset DATASET    executes all episodes again\n"
    "  unietp compare FOLDER FOLDER --out BOARD    ranks, pairs and a leaderboard\n"
    "\n"
    "Details: docs/evaluation.md and docs/results.md.\n";

std::string formats_text() {
  std::string text = "`unietp export DATASET --format NAME --out FOLDER` writes:\n\n";
  for (const auto& format : export_formats()) {
    std::string row = "  " + format.name;
    row.resize(std::max<std::size_t>(row.size() + 1, 18), ' ');
    text += row + wrapped(format.help, 18, 80, true);
    for (const auto& option : format.options) {
      text += std::string(18, ' ') + "--" + option.name;
      for (const auto& choice : option.choices) text += (&choice == &option.choices.front() ? " " : "|") + choice;
      text += "\n";
    }
  }
  return text +
         "\n`unietp scene import` and `unietp scene export` convert homes of the simulators.\n"
         "Details: docs/exports.md and docs/scene-formats.md.\n";
}

std::string settings_text(const CommandPage& program) {
  CommandPage global = program;
  global.commands.clear();
  global.examples.clear();
  const std::string text = help_text(global);
  return "These options can be given with every command:\n" + text.substr(text.find("\nOptions:\n") + 9) +
         "\nEnvironment variables:\n"
         "  UNIETP_DATA             The program's data folder, unless --data is given. By\n"
         "                          default it is share/unietp of the installation, or the\n"
         "                          source checkout that the program lies in\n"
         "  UNIETP_LLM_KEY          Key for the language model server\n"
         "  XDG_CACHE_HOME          Where unietp/ with compiled knowledge and answers of\n"
         "                          language models is kept (default: ~/.cache)\n";
}

std::string listing(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string text;
  for (const auto& [name, summary] : rows) {
    std::string row = "  " + name;
    row.resize(std::max<std::size_t>(row.size() + 1, 15), ' ');
    text += row + wrapped(summary, 15, 80, true);
  }
  return text;
}

}  // namespace

std::string main_screen() {
  return "unietp makes and verifies embodied-planning tasks for AI2-THOR, VirtualHome,\n"
         "Habitat and BEHAVIOR, offline.\n"
         "\n"
         "Usage: unietp COMMAND [OPTIONS]\n"
         "\n"
         "  unietp generate --count 40 --out out/mine           make a data set\n"
         "  unietp validate out/mine                            verify it from its files\n"
         "  unietp report out/mine --out report.html            see charts and examples\n"
         "  unietp export out/mine --format sft --out out/sft   convert it for training\n"
         "  unietp template new my-task --like place-one-on     add a kind of task\n"
         "\n"
         "Commands:\n"
         "  make      generate, benchmark, training, merge\n"
         "  check     validate, audit, review\n"
         "  look      stats, report, render, shape, actions, schemas\n"
         "  convert   export, annotate\n"
         "  extend    template, knowledge, scene, goal, sense\n"
         "  act       play, serve, evaluate, compare\n"
         "  shell     help, completion\n"
         "\n"
         "  unietp COMMAND --help    options and examples of a command\n"
         "  unietp help              what each command does, and topics: modes, homes, ...\n"
         "  unietp --version         version, knowledge digest and build\n";
}

std::string help_index(const CommandPage& program) {
  std::vector<std::pair<std::string, std::string>> commands, topics;
  for (const auto& command : program.commands)
    commands.emplace_back(command.name.substr(command.name.find(' ') + 1), command.summary);
  for (const auto& topic : help_topics(program)) topics.emplace_back(topic.name, topic.summary);
  return "Commands (`unietp help COMMAND`):\n" + listing(commands) + "\nTopics (`unietp help TOPIC`):\n" +
         listing(topics);
}

std::vector<HelpTopic> help_topics(const CommandPage& program) {
  return {{"modes", "What an agent is told, sees and may do in modes M1, M2 and M3", kModesTopic},
          {"homes", "Where homes come from", kHomesTopic},
          {"formats", "Export formats with their options", formats_text()},
          {"files", "What is in a data set, and configuration files", kFilesTopic},
          {"models", "Using a language model", kModelsTopic},
          {"evaluation", "Evaluating a model or a policy", kEvaluationTopic},
          {"settings", "Options of every command, and environment variables", settings_text(program)},
          {"exit-codes", "What the exit codes mean", kExitCodesTopic}};
}

}  // namespace unietp
