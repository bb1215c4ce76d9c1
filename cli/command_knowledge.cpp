#include "cli/command_knowledge.h"

#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "akb/importers.h"
#include "cli/command_parser.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "What the tables in data/akb/ say of each simulator's categories.\n"
    "\n"
    "  unietp knowledge stats                    how much is known, and from where\n"
    "  unietp knowledge show ai2thor             all categories\n"
    "  unietp knowledge show ai2thor Mug         one category, each fact with its source\n"
    "  unietp knowledge why ai2thor Mug size     where one fact comes from, and how to change it\n"
    "  unietp knowledge diff OLD NEW             what two knowledge bases say differently\n"
    "  unietp knowledge build                    check and compile the tables\n"
    "  unietp knowledge import ../upstream       write the tables anew from the simulators' metadata\n"
    "  unietp knowledge complete ...             ask a language model for what they lack";

Exit build(const CommandLine& program) {
  const auto compiled = compiled_knowledge(program.folders);
  if (!compiled.errors.empty()) return refuse(compiled.errors);
  print_line(compiled.database.string());
  return Exit::Ok;
}

Exit import(const std::filesystem::path& upstream, const CommandLine& program) {
  const auto done = import_all(upstream, program.folders.tables());
  if (!done) return refuse(done.error());
  return print_sizes(program);
}

}  // namespace

std::vector<Knowledge> load_some(const CommandLine& program, const std::vector<Simulator>& simulators,
                                 std::vector<Error>& errors) {
  const auto compiled = compiled_knowledge(program.folders);
  errors.insert(errors.end(), compiled.errors.begin(), compiled.errors.end());
  std::vector<Knowledge> all;
  for (const auto simulator : simulators) {
    if (!errors.empty()) break;
    auto knowledge = load_knowledge(compiled.database, simulator);
    if (!knowledge) {
      errors.push_back(knowledge.error());
    } else {
      all.push_back(std::move(*knowledge));
    }
  }
  return all;
}

Result<const Category*> category_named(const Knowledge& knowledge, std::string_view name) {
  if (const Category* category = knowledge.find(name)) return category;
  std::vector<std::string> names;
  for (const auto& known : knowledge.categories()) names.push_back(known.name);
  const auto near = nearest_name(name, names);
  const std::string simulator(name_of(knowledge.simulator()));
  return Error{Error::Kind::Usage,
               simulator,
               {},
               "has no category \"" + std::string(name) + "\"" +
                   (near.empty() ? "" : ", did you mean \"" + near + "\"") + "; `unietp knowledge show " + simulator +
                   "` lists all"};
}

void print_line(const std::string& text) { std::printf("%s\n", text.c_str()); }

std::string told(const Source& source) {
  return "[" + source.source + ", confidence " + number_text(source.confidence) + "]";
}

nlohmann::ordered_json json_of(const Fact& fact) {
  return {{"fact", fact.name},
          {"value", fact.value},
          {"source", fact.source.source},
          {"confidence", fact.source.confidence}};
}

void add_knowledge_command(CommandParser& app, CommandLine& program) {
  auto* command = app.add_subcommand("knowledge", kHelp);
  command->require_subcommand();
  command->add_subcommand("build", "Check and compile the tables; tells where the database is")->callback([&program] {
    program.exit = build(program);
  });
  add_knowledge_stats_command(*command, program);
  add_knowledge_show_command(*command, program);
  add_knowledge_why_command(*command, program);
  add_knowledge_diff_command(*command, program);
  auto upstream = std::make_shared<std::filesystem::path>();  // shared: the callback below outlives this function
  auto* imported = command->add_subcommand("import", "Write data/akb/ anew from the simulators' metadata");
  imported->add_option("folder", *upstream, "Folder with ai2thor/, virtualhome/, habitat/, behavior/")->required();
  imported->callback([upstream, &program] { program.exit = import(*upstream, program); });
  add_knowledge_complete_command(*command, program);
}

}  // namespace unietp
