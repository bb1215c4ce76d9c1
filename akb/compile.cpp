#include <system_error>

#include "akb/completed.h"
#include "akb/database.h"
#include "core/digest.h"
#include "core/files.h"

namespace unietp {
namespace {

Error io_error(const std::filesystem::path& path, std::string message) {
  return {Error::Kind::Io, path.string(), {}, std::move(message)};
}

}  // namespace

std::vector<Error> compile_knowledge(const std::filesystem::path& tables, const std::filesystem::path& database) {
  std::vector<Error> errors;
  std::vector<Tables> all;
  for (const auto simulator : kSimulators) {
    all.push_back(read_tables(tables / std::string(name_of(simulator)), errors));
    lay_completed(tables, simulator, all.back(), errors);
    sort_tables(all.back());
  }
  if (!errors.empty()) return errors;
  const auto digest = digest_of_tables(tables);
  if (!digest) return {digest.error()};

  std::error_code code;
  auto aside = database;
  aside += ".tmp";
  if (database.has_parent_path()) std::filesystem::create_directories(database.parent_path(), code);
  std::filesystem::remove(aside, code);
  errors = write_database(aside, *digest, all);
  if (errors.empty()) {
    std::filesystem::rename(aside, database, code);
    if (code) errors.push_back(io_error(database, "cannot rename the new knowledge base: " + code.message()));
  }
  if (!errors.empty()) std::filesystem::remove(aside, code);
  return errors;
}

Result<std::string> digest_of_tables(const std::filesystem::path& tables) {
  std::string all;
  for (const auto simulator : kSimulators) {
    for (const auto& table : table_names()) {
      const auto name = std::string(name_of(simulator)) + "/" + table + ".csv";
      const auto text = read_file(tables / name);
      if (!text) return text.error();
      all += name + "\n" + std::to_string(text->size()) + "\n" + *text;
    }
    for (const auto& path : completed_files(tables, simulator)) {
      const auto text = read_file(path);
      if (!text) return text.error();
      all += path.lexically_relative(tables).generic_string() + "\n" + std::to_string(text->size()) + "\n" + *text;
    }
  }
  return sha256(all);
}

}  // namespace unietp
