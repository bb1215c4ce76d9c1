#include <algorithm>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "pipeline/commands.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "The task templates.\n"
    "\n"
    "  unietp template list                      what the library has\n"
    "  unietp template lint my.template          check files or folders before they join the library";

struct Options {
  std::vector<std::filesystem::path> paths;
  bool json = false;
};

std::string simulators_of(const Template& source) {
  std::vector<std::string> names;
  for (const auto simulator : source.simulators) names.emplace_back(name_of(simulator));
  return join(names, ",");
}

Exit list(const Options& options, const CommandLine& program) {
  const auto library = load_templates(program.folders.library());
  auto json = nlohmann::ordered_json::array();
  for (const auto& source : library.templates) {
    if (options.json) {
      json.push_back({{"name", source.name},
                      {"split", name_of(source.split)},
                      {"simulators", simulators_of(source)},
                      {"title", source.title},
                      {"goal", to_text(source.goal)}});
    } else {
      std::printf("%-36s %-14s %-38s %s\n", source.name.c_str(), std::string(name_of(source.split)).c_str(),
                  simulators_of(source).c_str(), source.title.c_str());
    }
  }
  if (options.json) std::printf("%s\n", json.dump(2).c_str());
  return library.errors.empty() ? Exit::Ok : refuse(library.errors);
}

TemplateReading read_one(const std::filesystem::path& path) {
  if (std::error_code code; std::filesystem::is_directory(path, code)) return load_templates(path);
  const auto text = read_file(path);
  if (!text) return {{}, {text.error()}};
  return parse_template(path.string(), *text);
}

Exit lint(const Options& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  std::vector<Error> errors = known.errors;
  std::size_t sound = 0;
  for (const auto& path : options.paths) {
    const auto reading = read_one(path);
    errors.insert(errors.end(), reading.errors.begin(), reading.errors.end());
    for (const auto& source : reading.templates) {
      if (!known.errors.empty()) continue;
      const auto unknown = unknown_categories(source, known.backends);
      errors.insert(errors.end(), unknown.begin(), unknown.end());
      sound += unknown.empty() ? 1 : 0;
    }
  }
  std::printf("%zu sound\n", sound);
  return errors.empty() ? Exit::Ok : refuse(errors);
}

}  // namespace

void add_template_command(CLI::App& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callbacks below outlive this function
  auto* command = app.add_subcommand("template", kHelp);
  command->require_subcommand(1);
  auto* listed = command->add_subcommand("list", "Names, splits, simulators and titles");
  listed->add_flag("--json", options->json, "As JSON, with the goals");
  listed->callback([options, &program] { program.exit = list(*options, program); });
  auto* linted = command->add_subcommand("lint", "Check templates; every problem with file, line and column");
  linted->add_option("paths", options->paths, "Template files or folders")->required();
  linted->callback([options, &program] { program.exit = lint(*options, program); });
}

}  // namespace unietp
