#include <algorithm>
#include <iterator>
#include <map>
#include <system_error>

#include "core/files.h"
#include "templates/template_files.h"

namespace unietp {

TemplateFiles template_files(const std::filesystem::path& place, const std::string& library) {
  namespace fs = std::filesystem;
  std::error_code failure;
  std::vector<fs::path> paths;
  if (!fs::is_directory(place, failure)) {  // reading says what is wrong with anything but a file
    paths.push_back(place);
  } else {
    failure.clear();
    for (fs::recursive_directory_iterator entry(place, failure), end; !failure && entry != end;
         entry.increment(failure)) {
      if (entry->is_regular_file() && entry->path().extension() == ".template") paths.push_back(entry->path());
    }
  }
  if (failure) {
    return {{}, {{Error::Kind::Io, place.string(), {}, "cannot list the folder of templates: " + failure.message()}}};
  }
  std::sort(paths.begin(), paths.end());
  TemplateFiles found;
  for (const auto& path : paths) {
    auto text = read_file(path);
    if (text) {
      found.files.push_back({path.string(), std::move(*text), library});
    } else {
      found.errors.push_back(text.error());
    }
  }
  return found;
}

TemplateReading parse_files(const std::vector<TemplateFile>& files) {
  TemplateReading all;
  std::map<std::string, std::string> file_of;  // name -> file that holds it
  for (const auto& file : files) {
    auto reading = parse_template(file.path, file.text);
    std::move(reading.errors.begin(), reading.errors.end(), std::back_inserter(all.errors));
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

TemplateReading load_templates(const std::filesystem::path& folder) {
  auto found = template_files(folder, "library");
  auto all = parse_files(found.files);
  all.errors.insert(all.errors.begin(), found.errors.begin(), found.errors.end());
  return all;
}

}  // namespace unietp
