#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/phrasing_reading.h"
#include "authoring/template_choice.h"
#include "authoring/trial_reasons.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"
#include "cli/common_options.h"
#include "cli/each_home.h"
#include "cli/library_options.h"
#include "cli/sense_folder.h"
#include "core/limits.h"
#include "core/text.h"
#include "run/given_binding.h"
#include "sense/grade_goal.h"

namespace unietp {
namespace {

struct TemplateTryOptions {
  std::string name, simulators;
  std::vector<std::string> binding;
  std::uint64_t seed = 1;
  int count = 2, tries = 12, homes = 3, threads = 1;
  bool json = false;
};

using Json = nlohmann::ordered_json;

std::vector<std::string> steps_of(const Task& task) {
  std::vector<std::string> steps;
  for (const auto& step : task.demonstration.steps) steps.push_back(to_text(step.action));
  return steps;
}

/// How much sense a task of a trial makes.
struct TrialGrader {
  const Resources& resources;
  CommonSense sense;
  WordKinds words;

  TaskSense operator()(const Task& task) const {
    const auto& specification = task.episode.specification;
    return grade_goal(specification.goal, resources.backend(specification.simulator).knowledge, sense, words);
  }
};

Json parts_json(const TaskSense& graded) {
  auto parts = Json::array();
  for (const auto& part : graded.parts)
    parts.push_back({{"part", part.part}, {"grade", name_of(part.sense.grade)}, {"reasons", part.sense.reasons}});
  return parts;
}

Json trial_json(const TemplateTrial& trial, Simulator simulator, const TrialGrader& grade,
                const std::vector<StyleTexts>& texts) {
  auto styles = Json::array();
  for (const auto& style : texts) styles.push_back({{"style", name_of(style.style)}, {"texts", style.texts}});
  auto tasks = Json::array();
  for (const auto& task : trial.tasks) {
    auto binding = Json::object();
    for (const auto& [placeholder, category] : task.episode.specification.binding) binding[placeholder] = category;
    const auto graded = grade(task);
    tasks.push_back({{"binding", std::move(binding)},
                     {"home", task.episode.layout},
                     {"instruction", task.instruction.text},
                     {"goal", to_text(task.episode.specification.goal)},
                     {"steps", steps_of(task)},
                     {"grade", name_of(graded.grade)},
                     {"parts", parts_json(graded)}});
  }
  return {{"simulator", name_of(simulator)},
          {"candidates", trial.candidates},
          {"tasks", std::move(tasks)},
          {"texts", std::move(styles)},
          {"rejections", rejections_json(trial)}};
}

void print_grade(const TaskSense& graded) {
  std::printf("  %s%s\n", std::string(name_of(graded.grade)).c_str(), graded.parts.empty() ? "" : ":");
  for (const auto& part : graded.parts) {
    std::printf("    %s: %s (%s)\n", part.part.c_str(), std::string(name_of(part.sense.grade)).c_str(),
                join(part.sense.reasons, "; ").c_str());
  }
}

/// Three texts for each style, of the goal of the first task.
std::vector<StyleTexts> sample_texts(const Template& source, const TemplateTrial& trial, const TrialGrader& grade) {
  constexpr std::size_t kTexts = 3;
  if (trial.tasks.empty()) return {};
  const Specification& task = trial.tasks.front().episode.specification;
  const Backend& backend = grade.resources.backend(task.simulator);
  const auto plain = instantiate(source, backend.knowledge, task.binding);
  return plain ? texts_by_style(source, *plain, backend, trial.tasks.front().episode.start, kTexts,
                                Rng(trial.tasks.front().seed))
               : std::vector<StyleTexts>();
}

void print_trial(const TemplateTrial& trial, const std::string& name, Simulator simulator, const TrialGrader& grade,
                 const std::vector<StyleTexts>& texts) {
  std::printf("%s on %s: %zu of %d candidates became tasks\n", name.c_str(), std::string(name_of(simulator)).c_str(),
              trial.tasks.size(), trial.candidates);
  for (const auto& task : trial.tasks) {
    std::printf("\n  \"%s\"\n  with %s in %s\n", task.instruction.text.c_str(),
                to_text(task.episode.specification.binding).c_str(), task.episode.layout.c_str());
    print_grade(grade(task));
    int number = 0;
    for (const auto& step : steps_of(task)) std::printf("  %3d  %s\n", ++number, step.c_str());
  }
  for (const auto& style : texts) {
    std::printf("\n  in the style %s\n", std::string(name_of(style.style)).c_str());
    for (const auto& text : style.texts) std::printf("    \"%s\"\n", text.c_str());
  }
  for (const auto& why : trial.reasons) std::printf("\n  %s\n", text_of(why).c_str());
  if (const auto change = likeliest_change(trial); !change.empty()) std::printf("  most likely: %s\n", change.c_str());
  std::printf("\n");
}

Exit try_one(const TemplateTryOptions& options, const CommandLine& program) {
  const auto choice = choose_template(program.folders, options.name, options.binding, options.simulators);
  if (!choice.errors.empty()) return refuse(choice.errors);
  const Template& source = choice.source();
  const auto& simulators = choice.simulators;

  std::vector<Error> errors;
  auto sense = read_common_sense(sense_folder(program), errors);
  auto words = read_word_kinds(sense_folder(program), sense.kinds(), errors);
  if (!errors.empty()) return refuse(errors);
  const TrialGrader grade{choice.resources, std::move(sense), std::move(words)};

  RunConfiguration configuration;
  configuration.seed = options.seed;
  configuration.simulators = simulators;
  configuration.binding = choice.binding;
  LayoutPool layouts(configuration, choice.resources, options.homes);
  std::vector<TemplateTrial> trials(simulators.size());
  const bool whole = for_each_home(
      simulators.size(), options.threads, program,
      [&](std::size_t i) {
        trials[i] = try_template(configuration, choice.resources, layouts, choice.position, simulators[i],
                                 {options.tries, options.count, program.interrupted});
        return true;
      },
      "simulators");
  if (!whole) return Exit::Interrupted;

  bool any = false;
  auto json = Json::array();
  for (std::size_t i = 0; i < trials.size(); ++i) {
    any = any || !trials[i].tasks.empty();
    const auto texts = sample_texts(source, trials[i], grade);
    if (options.json) json.push_back(trial_json(trials[i], simulators[i], grade, texts));
    if (!options.json) print_trial(trials[i], source.name, simulators[i], grade, texts);
  }
  if (options.json)
    std::printf("%s\n",
                Json{{"format", "unietp-try/1"}, {"template", source.name}, {"proven", any}, {"simulators", json}}
                    .dump(2)
                    .c_str());
  return any ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_template_try_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<TemplateTryOptions>();  // shared: the callback outlives this function
  auto* command =
      group.add_subcommand("try", "Make tasks of one template in a few homes, or explain why there are none");
  command->explain(
      "A task is shown when its start was built and is at rest, the expert's plan was executed and reaches "
      "the goal, and no step of the plan can be left out. Each is graded: would anybody want that in a home "
      "(docs/sense.md)? Three texts follow for each style that the goal of the first task can be said in. Exit code 1: "
      "no task on any simulator.",
      {{"unietp template try place-one-on", "on every simulator that it claims"},
       {"unietp template try my.template --simulator ai2thor", "a file that is in no library yet"},
       {"unietp template try place-one-on --count 5 --seed 2", "more tasks in other homes"},
       {"unietp template try place-one-on --bind A=Mug", "with a category of your choice"}});
  command->add_option("TEMPLATE", options->name, "Name of a template, or its file")->required();
  add_simulators_option(*command, options->simulators, "Simulators (default: all that the template claims)",
                        "--simulator,--simulators");
  command->add_option("--bind", options->binding, "Categories for some or all placeholders")
      ->type_name("A=Mug B=Fridge ...");
  command->add_option("--count", options->count, "Tasks per simulator")->within(1, 1000)->shows_default();
  command->add_option("--tries", options->tries, "Most candidates per simulator")
      ->within(1, limits::kAttempts)
      ->shows_default();
  command->add_option("--homes", options->homes, "Homes per simulator")->within(1, 100)->shows_default();
  command->add_option("--seed", options->seed, "Seed of homes and candidates")->shows_default();
  add_threads_option(*command, options->threads, program);
  command->add_flag("--json", options->json, "Print JSON");
  add_library_options(*command, program);
  command->callback([options, &program] { program.exit = try_one(*options, program); });
}

}  // namespace unietp
