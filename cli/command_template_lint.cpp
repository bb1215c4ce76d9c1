#include <cstdio>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/lint_template.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"
#include "templates/template_files.h"

namespace unietp {
namespace {

struct TemplateLintOptions {
  std::vector<std::filesystem::path> paths;
  bool json = false;
};

std::vector<LintedFile> lint_all(const TemplateLintOptions& options, const std::vector<Backend>& backends) {
  std::vector<LintedFile> all;
  std::map<std::string, std::string> file_of;  // name -> file that has it
  for (const auto& path : options.paths) {
    auto found = template_files(path, "own");
    for (auto& error : found.errors) all.push_back({path.string(), "", "", {{std::move(error), false}}});
    for (auto& file : found.files) {
      auto linted = lint_template(file.path, std::move(file.text), backends);
      if (!linted.name.empty()) {
        const auto [first, added] = file_of.emplace(linted.name, linted.path);
        if (!added && first->second != linted.path) {
          linted.problems.push_back({{Error::Kind::Schema,
                                      linted.path,
                                      {1, 1},
                                      "'" + linted.name + "' is already the name of " + first->second},
                                     false});
        }
      }
      all.push_back(std::move(linted));
    }
  }
  return all;
}

nlohmann::ordered_json json_of(const LintProblem& problem, std::string_view text) {
  const auto [line, column] = problem.error.pos;
  return {{"file", problem.error.where},
          {"line", line},
          {"column", column},
          {"severity", problem.warning ? "warning" : "error"},
          {"message", problem.error.message},
          {"source", line < 1 ? "" : std::string(line_of(text, line))}};
}

/// Of phrasings that no instruction has: "my.template:17: no instruction has this phrasing: …".
void print_unread(const LintedFile& file) {
  for (const auto& [line, reading] : file.phrasings) {
    if (reading.readable) continue;
    const std::string text = reading.text.empty() ? "" : " (\"" + reading.text + "\")";
    std::printf("%s:%d: no instruction has this phrasing: %s%s\n", file.path.c_str(), line, reading.why.c_str(),
                text.c_str());
  }
}

Exit lint(const TemplateLintOptions& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t sound = 0;
  std::size_t readable = 0;
  std::size_t phrasings = 0;
  auto problems = nlohmann::ordered_json::array();
  auto readings = nlohmann::ordered_json::array();
  for (const auto& file : lint_all(options, known.backends)) {
    const auto before = errors;
    for (const auto& problem : file.problems) {
      ++(problem.warning ? warnings : errors);
      if (options.json) {
        problems.push_back(json_of(problem, file.text));
      } else {
        (void)std::fprintf(stderr, "%s", problem_text(problem, file.text, program.terminal).c_str());
      }
    }
    sound += errors == before ? 1 : 0;
    phrasings += file.phrasings.size();
    for (const auto& [line, reading] : file.phrasings) {
      readable += reading.readable ? 1 : 0;
      readings.push_back({{"file", file.path},
                          {"line", line},
                          {"readable", reading.readable},
                          {"text", reading.text},
                          {"why", reading.why}});
    }
    if (!options.json) print_unread(file);
  }
  if (options.json) {
    const nlohmann::ordered_json json = {
        {"format", "unietp-lint/1"}, {"sound", sound}, {"problems", problems}, {"phrasings", readings}};
    std::printf("%s\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  } else {
    if (phrasings > 0)
      std::printf("%zu of %zu phrasings are read back and come first in instructions\n", readable, phrasings);
    std::printf("%zu sound, %zu %s, %zu %s\n", sound, errors, errors == 1 ? "error" : "errors", warnings,
                warnings == 1 ? "warning" : "warnings");
  }
  return errors == 0 ? Exit::Ok : Exit::BadInput;
}

}  // namespace

void add_template_lint_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<TemplateLintOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("lint", "Check template files");
  command->explain(
      "Reports every problem with its place, what is accepted and the nearest known name. Warnings are for "
      "what is accepted but doubtful, such as a phrasing that leaves out a number of the goal, or a "
      "simulator without suitable categories. Phrasings that the grammar cannot read back as the goal are listed with "
      "the reason; no instruction has them. Exit code 2: a file has errors.",
      {{"unietp template lint my-task.template", ""},
       {"unietp template lint templates/library", "all files of a folder"}});
  command->add_option("PATH", options->paths, "Template files or folders")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &program] { program.exit = lint(*options, program); });
}

}  // namespace unietp
