#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/template_vocabulary.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Every word that a template may use, with its meaning, from the tables that the reader itself looks them up in.\n"
    "\n"
    "  unietp template vocabulary              a line a word\n"
    "  unietp template vocabulary --json       as a tree, for editors\n"
    "  unietp template vocabulary --markdown   docs/vocabulary.md";

struct Options {
  bool json = false, markdown = false;
};

void print(const std::vector<VocabularyGroup>& groups, int depth) {
  for (const auto& group : groups) {
    std::printf("%*s%s: %s\n", depth * 2, "", group.title.c_str(), group.says.c_str());
    for (const auto& word : group.words) {
      std::printf("%*s%-34s %s\n", depth * 2 + 2, "", word.usage.c_str(), word.meaning.c_str());
    }
    print(group.groups, depth + 1);
  }
}

Exit tell(const Options& options) {
  const auto groups = template_vocabulary();
  if (options.json) {
    std::printf("%s\n", vocabulary_json(groups).dump(2).c_str());
  } else if (options.markdown) {
    std::printf("%s", vocabulary_page(groups).c_str());
  } else {
    print(groups, 0);
  }
  return Exit::Ok;
}

}  // namespace

void add_template_vocabulary_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = group.add_subcommand("vocabulary", kHelp);
  auto* json = command->add_flag("--json", options->json, "Tell it as JSON");
  command->add_flag("--markdown", options->markdown, "Tell it as the page docs/vocabulary.md")->excludes(json);
  command->callback([options, &program] { program.exit = tell(*options); });
}

}  // namespace unietp
