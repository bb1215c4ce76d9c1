#include "authoring/template_choice.h"

#include <algorithm>

#include "core/text.h"
#include "dataset/configuration.h"
#include "resources/template_library.h"
#include "run/given_binding.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

bool same_file(const fs::path& one, const fs::path& other) {
  std::error_code code;
  return fs::equivalent(one, other, code) && !code;
}

bool is_in(const std::vector<Template>& templates, const fs::path& file) {
  return std::any_of(templates.begin(), templates.end(),
                     [&](const Template& source) { return same_file(source.file, file); });
}

}  // namespace

TemplateChoice choose_template(const DataFolders& folders, const std::string& name_or_file) {
  std::error_code code;
  const bool file = fs::is_regular_file(name_or_file, code);
  auto wide = folders;
  if (file && !is_in(library_of(folders).templates, name_or_file)) wide.templates.emplace_back(name_or_file);
  auto reading = load_resources(wide);
  TemplateChoice choice;
  choice.resources = std::move(reading.resources);
  choice.errors = std::move(reading.errors);
  if (!choice.errors.empty()) return choice;

  std::vector<std::string> names;
  const auto& templates = choice.resources.templates;
  for (const auto& source : templates) {
    if (file ? same_file(source.file, name_or_file) : source.name == name_or_file) return choice;
    names.push_back(source.name);
    ++choice.position;
  }
  const auto near = nearest_name(name_or_file, names);
  choice.errors.push_back({Error::Kind::Usage,
                           "template",
                           {},
                           "no template or file \"" + name_or_file + "\"" +
                               (near.empty() ? "" : ", did you mean \"" + near + "\"") +
                               "; see `unietp template list`"});
  return choice;
}

TemplateChoice choose_template(const DataFolders& folders, const std::string& name_or_file,
                               const std::vector<std::string>& binding, const std::string& simulators) {
  auto choice = choose_template(folders, name_or_file);
  if (!choice.errors.empty()) return choice;
  auto read = read_binding(binding, choice.source());
  if (!read) {
    choice.errors.push_back(read.error());
    return choice;
  }
  choice.binding = std::move(*read);
  choice.simulators = simulators_for(choice.source(), choice.binding, choice.resources.backends);
  if (simulators.empty()) return choice;
  auto asked = parse_simulators("--simulator", simulators);
  if (asked)
    choice.simulators = std::move(*asked);
  else
    choice.errors.push_back(asked.error());
  return choice;
}

}  // namespace unietp
