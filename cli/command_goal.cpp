#include <algorithm>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/action_page.h"
#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "dataset/formula_json.h"
#include "logic/formula.h"
#include "scene/action.h"

namespace unietp {
namespace {

struct GoalOptions {
  std::string text, simulators;
  bool json = false, page = false;
};

/// Categories of the goal that a simulator does not know.
std::vector<Error> unknown_in(const Formula& goal, const Knowledge& knowledge) {
  std::vector<std::string> names;
  for (const auto& category : knowledge.categories()) names.push_back(category.name);
  std::vector<Error> errors;
  for (const auto& name : categories_of(goal)) {
    if (knowledge.find(name) != nullptr) continue;
    const auto near = nearest_name(name, names);
    errors.push_back({Error::Kind::Schema,
                      "goal",
                      {},
                      std::string(name_of(knowledge.simulator())) + " has no category \"" + name + "\"" +
                          (near.empty() ? "" : ", did you mean \"" + near + "\"") + "; `unietp knowledge show " +
                          std::string(name_of(knowledge.simulator())) + "` lists all"});
  }
  return errors;
}

Exit parse(const GoalOptions& options, const CommandLine& program) {
  const auto goal = parse_formula("goal", options.text, FormulaUse::Goal);
  if (!goal) return refuse(goal.error());
  if (!options.simulators.empty()) {
    const auto simulators = parse_simulators("--simulators", options.simulators);
    if (!simulators) return refuse(simulators.error());
    const auto known = load_backends(program.folders);
    if (!known.errors.empty()) return refuse(known.errors);
    std::vector<Error> errors;
    for (const auto simulator : *simulators) {
      const auto more = unknown_in(*goal, known.backends[static_cast<std::size_t>(simulator)].knowledge);
      errors.insert(errors.end(), more.begin(), more.end());
    }
    if (!errors.empty()) return refuse(errors);
  }
  std::printf("%s\n", options.json ? formula_to_json(*goal).dump(2).c_str() : to_text(*goal).c_str());
  return Exit::Ok;
}

Exit print_action_page(const DataFolders& folders) {
  std::vector<Profile> plain, wide;
  for (const auto simulator : kSimulators) {
    for (const auto actions : {ActionProfile::Unietp, ActionProfile::Wide}) {
      const auto profile = load_profile(folders.profiles(), simulator, actions);
      if (!profile) return refuse(profile.error());
      (actions == ActionProfile::Wide ? wide : plain).push_back(*profile);
    }
  }
  std::fputs(action_page(plain, wide).c_str(), stdout);
  return Exit::Ok;
}

Exit list_actions(const GoalOptions& options, const DataFolders& folders) {
  if (options.page) return print_action_page(folders);
  std::vector<Simulator> simulators(kSimulators.begin(), kSimulators.end());
  if (!options.simulators.empty()) {
    const auto asked = parse_simulators("--simulators", options.simulators);
    if (!asked) return refuse(asked.error());
    simulators = *asked;
  }
  for (const auto& action : all_actions()) {
    const bool offered = std::any_of(simulators.begin(), simulators.end(),
                                     [&](Simulator simulator) { return offers(action, simulator); });
    if (!offered) continue;
    std::string modes;
    for (const auto mode : {Mode::M1, Mode::M2, Mode::M3}) {
      modes += offers(action, mode) ? std::string(name_of(mode)) + " " : "   ";
    }
    std::printf("%-20s %s %s\n", std::string(action.name).c_str(), modes.c_str(), std::string(action.effect).c_str());
  }
  return Exit::Ok;
}

}  // namespace

void add_goal_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<GoalOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("goal", "Check a goal formula and print it in canonical form");
  command->explain(
      "Reports where the formula is wrong, with line and column. With --simulators, its categories must "
      "be known to each of them. docs/logic.md describes the language.",
      {{"unietp goal '(at-end (exists (?m - Mug) (dirty ?m)))' --simulators ai2thor", ""},
       {"unietp goal '(sometime (exists (?m - Mug) (held ?m)))' --json", ""}});
  command->add_option("FORMULA", options->text, "The formula")->required();
  add_simulators_option(*command, options->simulators, "Check that these simulators know its categories");
  command->add_flag("--json", options->json, "Print it as a JSON tree");
  command->callback([options, &program] { program.exit = parse(*options, program); });
}

void add_actions_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<GoalOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("actions", "List the actions with their modes and effects");
  command->explain("", {{"unietp actions", ""},
                        {"unietp actions --simulators habitat", "only what Habitat offers"},
                        {"unietp actions --page", "all details as Markdown (docs/action-table.md)"}});
  add_simulators_option(*command, options->simulators, "Only actions that one of these offers");
  command->add_flag("--page", options->page, "Print needs, limits and profiles of every action as Markdown");
  command->callback([options, &program] { program.exit = list_actions(*options, program.folders); });
}

}  // namespace unietp
