#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/template_vocabulary.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"

namespace unietp {
namespace {

struct TemplateVocabularyOptions {
  bool json = false, markdown = false;
};

void print_groups(const std::vector<VocabularyGroup>& groups, int depth) {
  for (const auto& group : groups) {
    std::printf("%*s%s: %s\n", depth * 2, "", group.title.c_str(), group.says.c_str());
    for (const auto& word : group.words) {
      std::printf("%*s%-34s %s\n", depth * 2 + 2, "", word.usage.c_str(), word.meaning.c_str());
    }
    print_groups(group.groups, depth + 1);
  }
}

Exit print_vocabulary(const TemplateVocabularyOptions& options) {
  const auto groups = template_vocabulary();
  if (options.json) {
    std::printf("%s\n", vocabulary_json(groups).dump(2).c_str());
  } else if (options.markdown) {
    std::printf("%s", vocabulary_page(groups).c_str());
  } else {
    print_groups(groups, 0);
  }
  return Exit::Ok;
}

}  // namespace

void add_template_vocabulary_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<TemplateVocabularyOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("vocabulary", "List every word that a template may use");
  command->explain("The words and meanings come from the tables that the template parser itself uses.",
                   {{"unietp template vocabulary", ""},
                    {"unietp template vocabulary --json", "a tree, for editors"},
                    {"unietp template vocabulary --markdown", "docs/vocabulary.md"}});
  auto* json = command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--markdown", options->markdown, "Print Markdown")->excludes(json);
  command->callback([options, &program] { program.exit = print_vocabulary(*options); });
}

}  // namespace unietp
