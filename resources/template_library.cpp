#include "resources/template_library.h"

#include <algorithm>
#include <iterator>

#include "core/digest.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

template <class T>
void append(std::vector<T>& to, std::vector<T> more) {
  std::move(more.begin(), more.end(), std::back_inserter(to));
}

/// Someone may give a name of a template here, which belongs to --template.
Error no_such_folder(const fs::path& place, const std::vector<Template>& known) {
  const auto is_name = [&](const Template& source) { return source.name == place.string(); };
  const bool name = std::any_of(known.begin(), known.end(), is_name);
  return {Error::Kind::Usage,
          "--templates",
          {},
          "\"" + place.string() + "\" is not a file or folder; --templates takes a folder of your own templates" +
              (name ? ", and `--template " + place.string() + "` selects one by name"
                    : ", and --template NAME selects templates by name")};
}

LibraryReading complete(std::vector<TemplateFile> files, const DataFolders& folders) {
  std::erase_if(files,
                [&](const TemplateFile& file) { return file.library == "extended" && !folders.extended_library; });
  LibraryReading library;
  std::vector<fs::path> absent;
  std::vector<TemplateFile> own;
  for (const auto& place : folders.templates) {
    if (std::error_code code; !fs::exists(place, code)) {
      absent.push_back(place);
      continue;
    }
    auto found = template_files(place, "own");
    if (found.files.empty() && found.errors.empty())
      library.errors.push_back(
          {Error::Kind::Usage, "--templates", {}, "\"" + place.string() + "\" contains no file *.template"});
    append(own, std::move(found.files));
    append(library.errors, std::move(found.errors));
  }
  files.insert(files.end(), own.begin(), own.end());
  auto parsed = parse_files(files);
  append(library.errors, std::move(parsed.errors));
  library.templates = std::move(parsed.templates);
  for (const auto& place : absent) library.errors.push_back(no_such_folder(place, library.templates));
  for (const auto& source : library.templates) {
    for (const auto& file : own) {
      if (file.path == source.file) library.own.push_back(source.name + " " + sha256(file.text));
    }
  }
  return library;
}

}  // namespace

TemplateFiles built_in_templates(const DataFolders& folders) {
  auto all = template_files(folders.library(), "library");
  if (std::error_code code; !fs::exists(folders.extended(), code)) return all;
  auto extended = template_files(folders.extended(), "extended");
  append(all.files, std::move(extended.files));
  append(all.errors, std::move(extended.errors));
  return all;
}

LibraryReading library_of(const DataFolders& folders) {
  auto files = built_in_templates(folders);
  auto library = complete(std::move(files.files), folders);
  library.errors.insert(library.errors.begin(), files.errors.begin(), files.errors.end());
  return library;
}

LibraryReading library_in(const fs::path& database, const DataFolders& folders) {
  auto files = stored_templates(database, folders.root);
  if (!files) return {{}, {}, {files.error()}};
  return complete(std::move(*files), folders);
}

}  // namespace unietp
