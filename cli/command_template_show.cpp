#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/purpose_fit.h"
#include "authoring/template_choice.h"
#include "authoring/template_in_words.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"
#include "cli/library_options.h"
#include "core/text.h"
#include "generator/binding_summary.h"
#include "templates/constraint_kinds.h"
#include "templates/phrasing.h"
#include "templates/purposes.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBindings = 5000;  // counted exactly
constexpr std::size_t kMostNamed = 12;       // categories that a line names

struct TemplateShowOptions {
  std::string name;
  bool json = false;
};

std::string count_text(const BindingSummary& summary) {
  if (summary.more) return "more than " + std::to_string(summary.count);
  return std::to_string(summary.count);
}

std::string listed(std::vector<std::string> names) {
  const auto all = names.size();
  if (all > kMostNamed) names.resize(kMostNamed);
  return join(names, ", ") + (all > kMostNamed ? ", ... (" + std::to_string(all) + ")" : "");
}

std::string bound_text(const Binding& binding) {
  std::vector<std::string> parts;
  for (const auto& [placeholder, category] : binding) parts.push_back(join({placeholder, category}, "="));
  return join(parts, " ");
}

struct ShownTemplate {
  Template source;
  std::optional<std::string> goal;  // in words
  std::vector<std::pair<const Backend*, BindingSummary>> simulators;
};

std::vector<std::string> phrasings_of(const ShownTemplate& shown) {
  for (const auto& [backend, summary] : shown.simulators) {
    if (summary.examples.empty()) continue;
    std::vector<std::string> filled;
    for (const auto& text : shown.source.instructions) {
      filled.push_back(fill_phrasing(text, summary.examples.front(), backend->knowledge));
    }
    return filled;
  }
  return {};
}

void print_purpose(const Purpose& purpose) {
  const auto* kind = purpose_kind(purpose.name);
  if (kind == nullptr) return;
  std::printf("purpose\n  %s: %s\n", purpose.name.c_str(), std::string(kind->says).c_str());
  std::vector<std::string> needs;
  for (const auto& need : purpose.needs) needs.push_back(need_in_words(need));
  if (!needs.empty()) std::printf("  because %s\n", join(needs, " and ").c_str());
  std::printf("\n");
}

void print(const ShownTemplate& shown) {
  const auto& source = shown.source;
  std::printf("%s: %s\n  %s%s\n\n", source.name.c_str(), source.title.c_str(),
              std::string(name_of(source.split)).c_str(),
              source.refinement.empty() ? "" : (", " + source.refinement).c_str());
  print_purpose(source.purpose);
  std::printf("goal\n");
  if (shown.goal) std::printf("  %s\n", shown.goal->c_str());
  std::printf("  %s\n\nplaceholders\n", to_text(source.goal).c_str());
  for (const auto& parameter : source.parameters) {
    std::printf("  <%s> %s: %s\n", parameter.name.c_str(), join(parameter.affordances, " ").c_str(),
                parameter_in_words(parameter).c_str());
  }
  for (const auto& constraint : source.constraints) {
    std::printf("  %s\n", to_text(constraint).c_str());
  }
  std::printf("\nstart\n");
  for (const auto& start : source.init) std::printf("  %s\n", start_in_words(start).c_str());
  std::printf("\nsimulators\n");
  for (const auto& [backend, summary] : shown.simulators) {
    std::printf("  %s: %s %s\n", std::string(name_of(backend->knowledge.simulator())).c_str(),
                count_text(summary).c_str(), summary.count == 1 && !summary.more ? "binding" : "bindings");
    for (const auto& [placeholder, categories] : summary.fills) {
      std::printf("    <%s> %s\n", placeholder.c_str(), listed(categories).c_str());
    }
    for (const auto& example : summary.examples) std::printf("    such as %s\n", bound_text(example).c_str());
  }
  std::printf("\nphrasings\n");
  const auto filled = phrasings_of(shown);
  for (std::size_t i = 0; i < source.instructions.size(); ++i) {
    std::printf("  %s\n", source.instructions[i].c_str());
    if (i < filled.size()) std::printf("    %s\n", filled[i].c_str());
  }
}

Json json_of(const ShownTemplate& shown) {
  const auto& source = shown.source;
  Json json = {{"format", "unietp-template/1"},
               {"name", source.name},
               {"title", source.title},
               {"purpose", source.purpose.name},
               {"because", Json::array()},
               {"split", name_of(source.split)},
               {"refinement", source.refinement},
               {"goal", to_text(source.goal)},
               {"goal_in_words", shown.goal ? Json(*shown.goal) : Json()},
               {"placeholders", Json::array()},
               {"constraints", Json::array()},
               {"start", Json::array()},
               {"simulators", Json::array()},
               {"phrasings", source.instructions},
               {"filled", phrasings_of(shown)}};
  for (const auto& need : source.purpose.needs) json["because"].push_back(need_in_words(need));
  for (const auto& parameter : source.parameters) {
    json["placeholders"].push_back(
        {{"name", parameter.name}, {"affordances", parameter.affordances}, {"says", parameter_in_words(parameter)}});
  }
  for (const auto& constraint : source.constraints) {
    json["constraints"].push_back(to_text(constraint));
  }
  for (const auto& start : source.init) {
    json["start"].push_back({{"formula", to_text(start)}, {"in_words", start_in_words(start)}});
  }
  for (const auto& [backend, summary] : shown.simulators) {
    Json fills = Json::object();
    for (const auto& [placeholder, categories] : summary.fills) fills[placeholder] = categories;
    Json examples = Json::array();
    for (const auto& example : summary.examples) examples.push_back(bound_text(example));
    json["simulators"].push_back({{"simulator", name_of(backend->knowledge.simulator())},
                                  {"bindings", summary.count},
                                  {"more", summary.more},
                                  {"fills", std::move(fills)},
                                  {"examples", std::move(examples)}});
  }
  return json;
}

Exit show(const TemplateShowOptions& options, const CommandLine& program) {
  const auto choice = choose_template(program.folders, options.name);
  if (!choice.errors.empty()) return refuse(choice.errors);
  const auto& source = choice.source();
  ShownTemplate shown{source, goal_in_words(source), {}};
  for (const auto simulator : source.simulators) {
    const auto& backend = choice.resources.backend(simulator);
    shown.simulators.emplace_back(&backend, summarize_bindings(source, backend.knowledge, kMostBindings));
  }
  if (options.json) {
    std::printf("%s\n", json_of(shown).dump(2, ' ', false, Json::error_handler_t::replace).c_str());
  } else {
    print(shown);
  }
  return Exit::Ok;
}

}  // namespace

void add_template_show_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<TemplateShowOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("show", "Explain one template in words");
  command->explain(
      "Shows the goal, the start, the categories that can fill each placeholder on each simulator, the "
      "number of possible bindings, and the phrasings.",
      {{"unietp template show place-one-on", ""}, {"unietp template show mine/my-task.template", ""}});
  command->add_option("TEMPLATE", options->name, "Name of a template, or its file")->required();
  command->add_flag("--json", options->json, "Print JSON");
  add_library_options(*command, program);
  command->callback([options, &program] { program.exit = show(*options, program); });
}

}  // namespace unietp
