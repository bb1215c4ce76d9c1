#include <algorithm>
#include <iterator>
#include <map>
#include <system_error>

#include "core/files.h"
#include "templates/template.h"

namespace unietp {
namespace {

void append(std::vector<Error>& to, std::vector<Error> more) {
  std::move(more.begin(), more.end(), std::back_inserter(to));
}

}  // namespace

TemplateReading load_templates(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (entry->is_regular_file() && entry->path().extension() == ".template") files.push_back(entry->path());
  }
  if (failure) {
    return {{}, {{Error::Kind::Io, folder.string(), {}, "cannot list the folder of templates: " + failure.message()}}};
  }
  std::sort(files.begin(), files.end());

  TemplateReading all;
  std::map<std::string, std::string> file_of;  // name -> file that holds it
  for (const auto& file : files) {
    const auto text = read_file(file);
    if (!text) {
      all.errors.push_back(text.error());
      continue;
    }
    auto reading = parse_template(file.string(), *text);
    append(all.errors, std::move(reading.errors));
    for (auto& source : reading.templates) {
      const auto [first, added] = file_of.emplace(source.name, source.file);
      if (added) {
        all.templates.push_back(std::move(source));
      } else {
        all.errors.push_back({Error::Kind::Schema,
                              source.file,
                              {1, 1},
                              "template '" + source.name + "' is already defined in " + first->second});
      }
    }
  }
  return all;
}

}  // namespace unietp
