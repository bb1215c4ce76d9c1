#include <exception>

#include "core/digest.h"
#include "core/sqlite_file.h"
#include "core/text.h"
#include "templates/template_files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSchema =
    "CREATE TABLE template(path TEXT PRIMARY KEY, library TEXT NOT NULL, name TEXT NOT NULL, class TEXT NOT NULL,"
    " simulators TEXT NOT NULL, parameters TEXT NOT NULL, title TEXT NOT NULL, digest TEXT NOT NULL,"
    " text TEXT NOT NULL, place INTEGER NOT NULL) STRICT, WITHOUT ROWID";

std::string below(const fs::path& root, const std::string& path) {
  return fs::path(path).lexically_relative(root).generic_string();
}

/// What a reader of the table sees of a template; all of it empty for a file that cannot be parsed.
struct StoredColumns {
  std::string name, kind, simulators, parameters, title;
};

StoredColumns columns_of(const TemplateFile& file) {
  const auto reading = parse_template(file.path, file.text);
  if (reading.templates.empty()) return {};
  const Template& source = reading.templates.front();
  std::vector<std::string> simulators, parameters;
  for (const auto simulator : source.simulators) simulators.emplace_back(name_of(simulator));
  for (const auto& parameter : source.parameters)
    parameters.push_back(parameter.name + ": " + join(parameter.affordances, " "));
  return {source.name, std::string(name_of(source.split)), join(simulators, "|"), join(parameters, "|"), source.title};
}

}  // namespace

Result<Done> store_templates(const fs::path& database, const fs::path& root, const std::vector<TemplateFile>& files) {
  try {
    SqliteFile file(database, SqliteFile::Mode::Create);
    file.run("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; BEGIN");
    file.run(kSchema);
    auto row = file.prepare("INSERT INTO template VALUES(?,?,?,?,?,?,?,?,?,?)");
    std::int64_t place = 0;
    for (const auto& source : files) {
      const auto columns = columns_of(source);
      int at = 0;
      for (const auto& value : {below(root, source.path), source.library, columns.name, columns.kind,
                                columns.simulators, columns.parameters, columns.title, sha256(source.text)})
        row.bind(++at, value);
      row.bind(++at, source.text);
      row.bind(++at, place++);
      row.step();
      row.reset();
    }
    file.run("COMMIT");
  } catch (const std::exception& failure) {
    return Error{Error::Kind::Io, database.string(), {}, std::string("cannot store the templates: ") + failure.what()};
  }
  return Done{};
}

Result<std::vector<TemplateFile>> stored_templates(const fs::path& database, const fs::path& root) {
  try {
    SqliteFile file(database, SqliteFile::Mode::Read);
    auto rows = file.prepare("SELECT path, library, text FROM template ORDER BY place");
    std::vector<TemplateFile> files;
    while (rows.step()) {
      const auto path = root / std::string(rows.text(0));
      files.push_back({path.string(), std::string(rows.text(2)), std::string(rows.text(1))});
    }
    return files;
  } catch (const std::exception& failure) {
    return Error{
        Error::Kind::Schema,
        database.string(),
        {},
        std::string("holds no templates (") + failure.what() + "); expected the output of 'unietp knowledge build'"};
  }
}

std::string digest_of(const std::vector<TemplateFile>& files, const fs::path& root) {
  std::string listing;
  for (const auto& file : files)
    listing += file.library + " " + below(root, file.path) + " " + sha256(file.text) + "\n";
  return sha256(listing);
}

}  // namespace unietp
