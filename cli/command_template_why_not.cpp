#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/template_choice.h"
#include "authoring/trial_reasons.h"
#include "authoring/verdict_text.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"
#include "cli/common_options.h"
#include "cli/library_options.h"
#include "core/limits.h"
#include "core/text.h"
#include "run/given_binding.h"
#include "run/sense_of_binding.h"

namespace unietp {
namespace {

struct TemplateWhyNotOptions {
  std::string name, simulators;
  std::vector<std::string> binding;
  std::uint64_t seed = 1;
  int tries = 12, homes = 4;
  bool in_homes = false, json = false;
};

using Json = nlohmann::ordered_json;

Json json_of(const BindingVerdict& verdict) {
  auto binding = Json::object();
  for (const auto& [placeholder, category] : verdict.binding) binding[placeholder] = category;
  Json json{{"binding", std::move(binding)}, {"passed", !verdict.refusal.has_value()}};
  if (!verdict.refusal) return json;
  auto alternatives = Json::object();
  for (const auto& one : verdict.alternatives) alternatives[one.placeholder] = one.categories;
  json["gate"] = name_of(verdict.refusal->gate);
  json["about"] = verdict.refusal->about;
  json["reason"] = verdict.refusal->reason;
  json["fact"] = verdict.fact;
  json["remedy"] = verdict.refusal->remedy;
  json["alternatives"] = std::move(alternatives);
  return json;
}

Json json_of(const TemplateTrial& trial) {
  return {{"candidates", trial.candidates}, {"proven", trial.tasks.size()}, {"rejections", rejections_json(trial)}};
}

/// How much sense the task makes, with the part that decides: "  sense             tolerable: bowl in fridge".
std::string sense_text(const Template& source, const Resources& resources, Simulator simulator,
                       const Binding& binding) {
  const auto made = instantiate(source, resources.backend(simulator).knowledge, binding);
  if (!made) return "";
  const TaskSense sense = sense_of_task(*made, resources);
  std::string text = "  sense             " + std::string(name_of(sense.grade));
  if (!sense.parts.empty()) text += ":  " + sense.parts.front().part;
  return text + "\n";
}

/// One task is asked for, with the binding that the gates passed, whatever sense it makes.
TemplateTrial in_homes(const TemplateWhyNotOptions& options, const TemplateChoice& choice, Simulator simulator,
                       const Binding& binding, const CommandLine& program) {
  RunConfiguration configuration;
  configuration.seed = options.seed;
  configuration.binding = binding;
  configuration.sense = Grade::Senseless;
  LayoutPool layouts(configuration, choice.resources, options.homes);
  return try_template(configuration, choice.resources, layouts, choice.position, simulator,
                      {options.tries, 1, program.interrupted});
}

Exit why_not(const TemplateWhyNotOptions& options, const CommandLine& program) {
  const auto choice = choose_template(program.folders, options.name, options.binding, options.simulators);
  if (!choice.errors.empty()) return refuse(choice.errors);
  const Template& source = choice.source();
  const auto& simulators = choice.simulators;

  bool refused = false;
  auto json = Json::array();
  for (const auto simulator : simulators) {
    const auto verdict = why_not(source, choice.resources.backend(simulator).knowledge, choice.binding);
    std::optional<TemplateTrial> trial;
    if (!verdict.refusal && options.in_homes) trial = in_homes(options, choice, simulator, verdict.binding, program);
    refused = refused || verdict.refusal || (trial && trial->tasks.empty());
    if (options.json) {
      auto one = json_of(verdict);
      if (trial) one["homes"] = json_of(*trial);
      one["simulator"] = name_of(simulator);
      json.push_back(std::move(one));
    } else {
      std::printf("%s", verdict_text(source, simulator, verdict).c_str());
      if (!verdict.refusal) std::printf("%s", sense_text(source, choice.resources, simulator, verdict.binding).c_str());
      if (trial) std::printf("%s", trial_text(*trial).c_str());
    }
  }
  if (options.json)
    std::printf("%s\n",
                Json{{"format", "unietp-why-not/1"}, {"template", source.name}, {"simulators", json}}.dump(2).c_str());
  return refused ? Exit::Wrong : Exit::Ok;
}

}  // namespace

void add_template_why_not_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<TemplateWhyNotOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("why-not", "Explain why a template refuses some categories");
  command->explain(
      "Checks the binding in the order of generation, before any home is built, and says which check fails "
      "and what would have to change; of a binding that passes, also how much sense it makes. With --try, the binding "
      "then goes through a few homes. Exit code 1: "
      "refused on some simulator.",
      {{"unietp template why-not place-one-inside --bind A=Fridge B=Mug", ""},
       {"unietp template why-not place-one-inside --bind A=Mug", "other placeholders are filled in"},
       {"unietp template why-not my.template --bind A=Mug B=Fridge --simulator ai2thor --try", ""}});
  command->add_option("TEMPLATE", options->name, "Name of a template, or its file")->required();
  command->add_option("--bind", options->binding, "Categories for some or all placeholders")
      ->required()
      ->type_name("A=Mug B=Fridge ...");
  add_simulators_option(*command, options->simulators,
                        "Simulators (default: all that the template claims and that know the categories)",
                        "--simulator,--simulators");
  command->add_flag("--try", options->in_homes, "Also build starts in a few homes and run the expert");
  command->add_option("--tries", options->tries, "Most candidates")->within(1, limits::kAttempts)->shows_default();
  command->add_option("--homes", options->homes, "Homes per simulator")->within(1, 100)->shows_default();
  command->add_option("--seed", options->seed, "Seed of homes and candidates")->shows_default();
  command->add_flag("--json", options->json, "Print JSON");
  add_library_options(*command, program);
  command->callback([options, &program] { program.exit = why_not(*options, program); });
}

}  // namespace unietp
