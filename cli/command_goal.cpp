#include <algorithm>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/action_page.h"
#include "cli/command_parser.h"
#include "cli/commands.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "dataset/formula_json.h"
#include "logic/formula.h"
#include "scene/action.h"

namespace unietp {
namespace {

struct Options {
  std::string text, simulators;
  bool json = false, page = false;
};

/// A category that a goal names must be known to the simulator it is asked of.
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

Exit parse(const Options& options, const CommandLine& program) {
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

Exit list_actions(const Options& options, const DataFolders& folders) {
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
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand(
      "goal",
      "Read a goal formula and print it in canonical form, or say where it is wrong.\n"
      "\n"
      "  unietp goal '(at-end (exists (?m - Mug) (exists (?t - DiningTable) (on ?m ?t))))' --simulators ai2thor");
  command->add_option("formula", options->text, "The formula")->required();
  command->add_option("--simulators", options->simulators, "Check that these know its categories");
  command->add_flag("--json", options->json, "Print it as a tree");
  command->callback([options, &program] { program.exit = parse(*options, program); });
}

void add_actions_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("actions", "List the actions, the modes that offer them, and what they do");
  command->add_option("--simulators", options->simulators, "Only those that one of these offers");
  command->add_flag("--page", options->page,
                    "Print docs/action-table.md: every action, simulator, mode and profile, needs and limits");
  command->callback([options, &program] { program.exit = list_actions(*options, program.folders); });
}

}  // namespace unietp
