#include "cli/held_out_templates.h"

#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

/// One name per line; # starts a comment. Errors: Io.
Result<std::vector<std::string>> names_in(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<std::string> names;
  for (const auto& line : split(*text, '\n')) {
    if (const auto name = trim(std::string_view(line).substr(0, line.find('#'))); !name.empty())
      names.emplace_back(name);
  }
  return names;
}

}  // namespace

Result<std::vector<std::string>> held_out_templates(const DataFolders& folders) {
  return names_in(folders.runs() / "held_out_templates.txt");
}

}  // namespace unietp
