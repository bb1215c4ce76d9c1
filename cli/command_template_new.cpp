#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>

#include "authoring/ask_template.h"
#include "authoring/template_choice.h"
#include "authoring/template_draft.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"
#include "cli/common_options.h"
#include "cli/library_options.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

struct TemplateNewOptions {
  TemplateDraft draft;
  std::string like, simulators;
  std::filesystem::path out = ".";
  bool ask = false;
};

/// Takes the other value only where none was given.
template <class Value>
void prefer(Value& value, const Value& other) {
  if (value.empty()) value = other;
}

Result<TemplateDraft> with_like(const TemplateNewOptions& options, const CommandLine& program) {
  auto draft = options.draft;
  for (const auto& name : split(options.simulators, ',')) {
    if (!name.empty()) draft.simulators.push_back(name);
  }
  if (options.like.empty()) return draft;
  const auto choice = choose_template(program.folders, options.like);
  if (!choice.errors.empty()) return choice.errors.front();
  const auto other = draft_like(choice.source(), draft.name);
  prefer(draft.title, other.title);
  prefer(draft.purpose, other.purpose);
  prefer(draft.split, other.split);
  prefer(draft.refinement, other.refinement);
  prefer(draft.simulators, other.simulators);
  prefer(draft.parameters, other.parameters);
  prefer(draft.constraints, other.constraints);
  prefer(draft.init, other.init);
  prefer(draft.goal, other.goal);
  prefer(draft.phrasings, other.phrasings);
  return draft;
}

std::set<std::string> sections_in(const TemplateDraft& draft) {
  std::set<std::string> given;
  if (!draft.title.empty()) given.insert("name");
  if (!draft.purpose.empty()) given.insert("purpose");
  if (!draft.split.empty()) given.insert("split");
  if (!draft.refinement.empty()) given.insert("refinement");
  if (!draft.simulators.empty()) given.insert("simulators");
  if (!draft.parameters.empty()) given.insert("parameters");
  if (!draft.constraints.empty()) given.insert("constraints");
  if (!draft.init.empty()) given.insert("init");
  if (!draft.goal.empty()) given.insert("goal");
  if (!draft.phrasings.empty()) given.insert("instruction");
  return given;
}

Exit create(const TemplateNewOptions& options, const CommandLine& program) {
  const auto file = (options.out / (options.draft.name + ".template")).lexically_normal();
  if (std::error_code code; std::filesystem::exists(file, code)) {
    return refuse(
        Error{Error::Kind::Usage, file.string(), {}, "this file already exists; choose another name or --out"});
  }
  auto draft = with_like(options, program);
  if (!draft) return refuse(draft.error());
  const auto given = sections_in(*draft);
  const bool complete = given.contains("parameters") && given.contains("goal") && given.contains("instruction");
  if (options.ask || (!complete && ::isatty(STDIN_FILENO) != 0)) {
    draft = ask_template(*draft, given, std::cin, std::cout);
    if (!draft) return refuse(draft.error());
  }
  if (draft->split.empty()) draft->split = name_of(Split::Atomic);
  const auto text = draft_text(*draft);
  const auto problems = draft_problems(*draft, file.string());
  for (const auto& [problem, section] : problems) {
    (void)std::fprintf(stderr, "%s", problem_text(problem, text, program.terminal).c_str());
  }
  if (!problems.empty()) {
    return refuse(Error{Error::Kind::Usage, file.string(), {}, "not written: the template would have these problems"});
  }
  if (const auto written = write_file(file, text); !written) return refuse(written.error());
  std::printf("%s\n", file.string().c_str());
  return Exit::Ok;
}

}  // namespace

void add_template_new_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<TemplateNewOptions>();  // shared: the callback outlives this function
  options->draft.split = "";
  auto& draft = options->draft;
  auto* command = group.add_subcommand("new", "Write a new template file");
  command->explain(
      "Each section of the file gets a line that explains it. At a terminal, the program asks for what the "
      "options leave out. A file with errors is not written, and no file is overwritten.",
      {{"unietp template new my-task", "asks for everything"},
       {"unietp template new my-task --like place-one-on", "starts from a template of the library"},
       {"unietp template new unlock-one --parameter 'A - furniture openable' --purpose preparing \\\n"
        "      --init '(exists (?a - A) (closed ?a))' --init '(forall (?a - A) (closed ?a))' \\\n"
        "      --goal '(exists (?a - A) (at-end (open ?a)))' --instruction 'Open {A:indefinite}.'",
        ""}});
  command->add_option("NAME", draft.name, "Name of a-z, 0-9 and '-'; the file is NAME.template")->required();
  command->add_option("--out", options->out, "Folder to write the file to (default: the current one)")
      ->folder()
      ->output();
  command->add_option("--like", options->like, "Template name or file that provides what is not given");
  command->add_option("--title", draft.title, "Title, such as 'open one <A>' (default: the name)");
  command->add_option("--purpose", draft.purpose, "What it is for, such as 'cleaning (because (dirty A))'");
  command->add_option("--class", draft.split, "atomic, compositional or logical (default: atomic)")
      ->suggests({"atomic", "compositional", "logical"});
  command->add_option("--refinement", draft.refinement, "by-state, alias, ... (default: none)");
  add_simulators_option(*command, options->simulators, "Simulators (default: all)");
  const auto repeated = [&](const char* name, std::vector<std::string>& into, const char* help) {
    command->add_option(name, into, help)->one_each();
  };
  repeated("--parameter", draft.parameters, "A placeholder, such as 'A - pickupable'; may be repeated");
  repeated("--constraint", draft.constraints, "A constraint, such as '(fits-on A B 2)'; may be repeated");
  repeated("--init", draft.init, "A constraint on the start; may be repeated");
  command->add_option("--goal", draft.goal, "The goal formula");
  repeated("--instruction", draft.phrasings, "A phrasing, such as 'Open {A:indefinite}.'; may be repeated");
  command->add_flag("--ask", options->ask, "Ask for what is not given, even when stdin is not a terminal");
  add_library_options(*command, program);
  command->callback([options, &program] { program.exit = create(*options, program); });
}

}  // namespace unietp
