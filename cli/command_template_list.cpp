#include <algorithm>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/command_template.h"
#include "cli/common_options.h"
#include "cli/library_options.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "resources/template_library.h"
#include "templates/rooms_needed.h"

namespace unietp {
namespace {

struct TemplateListOptions {
  std::string splits, simulators;
  bool json = false;
};

std::vector<std::string> claimed_by(const Template& source) {
  std::vector<std::string> names;
  for (const auto simulator : source.simulators) names.emplace_back(name_of(simulator));
  return names;
}

/// Templates of one of the splits that claim one of the simulators; an empty list matches all.
std::vector<Template> chosen(std::vector<Template> all, const std::vector<Split>& splits,
                             const std::vector<Simulator>& simulators) {
  const auto has = [](const auto& list, const auto& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  std::erase_if(all, [&](const Template& source) {
    if (!splits.empty() && !has(splits, source.split) && !has(splits, split_of_tasks(source))) return true;
    return !simulators.empty() && std::none_of(simulators.begin(), simulators.end(),
                                               [&](Simulator one) { return has(source.simulators, one); });
  });
  return all;
}

/// One letter per simulator, each in its own column: "A V - B".
std::string letters_of(const Template& source) {
  std::string text;
  for (const auto simulator : kSimulators) {
    const auto& list = source.simulators;
    const bool claimed = std::find(list.begin(), list.end(), simulator) != list.end();
    text += claimed ? static_cast<char>(name_of(simulator).front() - 'a' + 'A') : '-';
    text += ' ';
  }
  return text;
}

/// "atomic", "atomic/by-state"
std::string class_of(const Template& source) {
  const std::string split(name_of(source.split));
  return source.refinement.empty() ? split : split + "/" + source.refinement;
}

void print_templates(const std::vector<Template>& templates) {
  std::size_t widest = 0;
  std::size_t widest_class = 0;
  for (const auto& source : templates) {
    widest = std::max(widest, source.name.size());
    widest_class = std::max(widest_class, class_of(source).size());
  }
  for (const auto& source : templates) {
    std::printf("%-*s  %-*s  %s %s%s\n", static_cast<int>(widest), source.name.c_str(), static_cast<int>(widest_class),
                class_of(source).c_str(), letters_of(source).c_str(), source.title.c_str(),
                needs_several_rooms(source) ? " (several rooms)" : "");
  }
  std::printf("%zu templates\n", templates.size());
}

Exit list(const TemplateListOptions& options, const CommandLine& program) {
  std::vector<Split> splits;
  std::vector<Simulator> simulators;
  if (!options.splits.empty()) {
    const auto asked = parse_splits("--class", options.splits);
    if (!asked) return refuse(asked.error());
    splits = *asked;
  }
  if (!options.simulators.empty()) {
    const auto asked = parse_simulators("--simulators", options.simulators);
    if (!asked) return refuse(asked.error());
    simulators = *asked;
  }
  auto library = library_of(program.folders);
  const auto templates = chosen(std::move(library.templates), splits, simulators);
  if (options.json) {
    auto json = nlohmann::ordered_json::array();
    for (const auto& source : templates) {
      json.push_back({{"name", source.name},
                      {"purpose", source.purpose.name},
                      {"split", name_of(source.split)},
                      {"refinement", source.refinement},
                      {"simulators", claimed_by(source)},
                      {"several_rooms", needs_several_rooms(source)},
                      {"title", source.title},
                      {"goal", to_text(source.goal)},
                      {"file", source.file}});
    }
    std::printf("%s\n", json.dump(2).c_str());
  } else {
    print_templates(templates);
  }
  return library.errors.empty() ? Exit::Ok : refuse(library.errors);
}

}  // namespace

void add_template_list_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<TemplateListOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("list", "List the templates with their classes, simulators and titles");
  command->explain("", {{"unietp template list", "the default library"},
                        {"unietp template list --all", "with the extended library"},
                        {"unietp template list --class logical --simulators habitat", ""}});
  command->add_flag("--json", options->json, "Print JSON, with the goals");
  command->add_option("--class", options->splits, "Only these classes")->type_name("NAME,...")->suggests(split_names());
  add_simulators_option(*command, options->simulators, "Only templates that claim one of these");
  add_library_options(*command, program);
  command->callback([options, &program] { program.exit = list(*options, program); });
}

}  // namespace unietp
