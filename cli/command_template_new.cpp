#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>

#include "authoring/ask_template.h"
#include "authoring/template_choice.h"
#include "authoring/template_draft.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"
#include "cli/library_options.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Write a new template file, each section with a line on what it is for. What the options do not say is asked for "
    "when\nthe program stands at a terminal. The file lints without errors or is not written; none is overwritten.\n"
    "\n"
    "  unietp template new my-task                       asks for everything\n"
    "  unietp template new my-task --like place-one-on   starts from a template of the library\n"
    "  unietp template new unlock-one --out mine --parameter 'A - furniture openable' \\\n"
    "      --init '(exists (?a - A) (closed ?a))' --init '(forall (?a - A) (closed ?a))' \\\n"
    "      --goal '(exists (?a - A) (at-end (open ?a)))' --instruction 'Open {A:indefinite}.'";

struct Options {
  TemplateDraft draft;
  std::string like, simulators;
  std::filesystem::path out = ".";
  bool ask = false;
};

/// A value that was given wins over that of the template it is like.
template <class Value>
void prefer(Value& value, const Value& other) {
  if (value.empty()) value = other;
}

Result<TemplateDraft> with_like(const Options& options, const CommandLine& program) {
  auto draft = options.draft;
  for (const auto& name : split(options.simulators, ',')) {
    if (!name.empty()) draft.simulators.push_back(name);
  }
  if (options.like.empty()) return draft;
  const auto choice = choose_template(program.folders, options.like);
  if (!choice.errors.empty()) return choice.errors.front();
  const auto other = draft_like(choice.source(), draft.name);
  prefer(draft.title, other.title);
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

Exit create(const Options& options, const CommandLine& program) {
  const auto file = (options.out / (options.draft.name + ".template")).lexically_normal();
  if (std::error_code code; std::filesystem::exists(file, code)) {
    return refuse(Error{Error::Kind::Usage, file.string(), {}, "this file exists already; take another name or --out"});
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
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  options->draft.split = "";
  auto& draft = options->draft;
  auto* command = group.add_subcommand("new", kHelp);
  command->add_option("name", draft.name, "a-z, 0-9 and '-'; the file is NAME.template")->required();
  command->add_option("--out", options->out, "Folder to write it into (default: here)");
  command->add_option("--like", options->like, "A template, or its file, to take what is not given from");
  command->add_option("--title", draft.title, "Such as 'open one <A>' (default: the name)");
  command->add_option("--class", draft.split, "atomic, compositional or logical (default: atomic)");
  command->add_option("--refinement", draft.refinement, "by-state, alias, ... (default: none)");
  command->add_option("--simulators", options->simulators, "Such as ai2thor,behavior (default: all four)");
  const auto many = [&](const char* name, std::vector<std::string>& into, const char* says) {
    command->add_option(name, into, says)->one_each();  // one each time it is given
  };
  many("--parameter", draft.parameters, "Such as 'A - pickupable'; once a placeholder");
  many("--constraint", draft.constraints, "Such as '(fits-on A B 2)'");
  many("--init", draft.init, "A start constraint");
  command->add_option("--goal", draft.goal, "The goal formula");
  many("--instruction", draft.phrasings, "A phrasing with slots, such as 'Open {A:indefinite}.'");
  command->add_flag("--ask", options->ask, "Ask for what is not given, also when the answers come from a file");
  add_library_options(*command, program);
  command->callback([options, &program] { program.exit = create(*options, program); });
}

}  // namespace unietp
