#include <algorithm>
#include <system_error>

#include "akb/completed.h"
#include "akb/database.h"
#include "akb/knowledge.h"
#include "akb/lay_kinds.h"
#include "akb/lay_phrases.h"
#include "akb/override.h"
#include "core/digest.h"
#include "core/files.h"

namespace unietp {
namespace {

Error io_error(const std::filesystem::path& path, std::string message) {
  return {Error::Kind::Io, path.string(), {}, std::move(message)};
}

std::vector<Tables> read_own(const std::filesystem::path& folder, std::vector<Error>& errors) {
  std::vector<Tables> all;
  for (const auto simulator : kSimulators) all.push_back(read_tables(folder / std::string(name_of(simulator)), errors));
  return all;
}

void lay_overrides(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& overrides,
                   std::vector<Tables>& all, std::vector<Error>& errors) {
  for (const auto& file : override_files(folder, overrides)) {
    const auto text = read_file(file);
    if (!text) {
      errors.push_back(text.error());
      continue;
    }
    apply_overrides(file.string(), read_overrides(file.string(), *text, errors), all, errors);
  }
}

void sort_all(std::vector<Tables>& all) {
  for (auto& tables : all) sort_tables(tables);
}

bool any_completed(const std::filesystem::path& folder) {
  return std::any_of(kSimulators.begin(), kSimulators.end(),
                     [&](Simulator simulator) { return !completed_files(folder, simulator).empty(); });
}

/// What overrides tell counts as stated, so completed facts yield to it; a fault of an override is reported where they
/// are laid over the whole.
void lay_all_completed(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& overrides,
                       std::vector<Tables>& all, std::vector<Error>& errors) {
  auto stated = all;
  std::vector<Error> later;
  lay_overrides(folder, overrides, stated, later);
  for (std::size_t i = 0; i < all.size(); ++i)
    lay_completed(folder, kSimulators[i], stated_by(stated[i]), all[i], errors);
}

}  // namespace

std::vector<Tables> read_all_tables(const std::filesystem::path& folder,
                                    const std::vector<std::filesystem::path>& overrides, std::vector<Error>& errors) {
  auto all = read_own(folder, errors);
  // A row that is left out for a fault of its own would make an override that names it look wrong too.
  if (errors.empty() && any_completed(folder)) lay_all_completed(folder, overrides, all, errors);
  if (errors.empty()) lay_overrides(folder, overrides, all, errors);
  if (errors.empty()) lay_kinds(folder, all, errors);
  if (errors.empty()) lay_phrases(folder, all, errors);
  sort_all(all);
  return all;
}

std::vector<Tables> read_stated_tables(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& overrides,
                                       std::vector<Error>& errors) {
  auto all = read_own(folder, errors);
  if (errors.empty()) lay_overrides(folder, overrides, all, errors);
  sort_all(all);
  return all;
}

std::vector<Error> compile_knowledge(const std::filesystem::path& tables, const std::filesystem::path& database,
                                     const std::vector<std::filesystem::path>& overrides) {
  std::vector<Error> errors;
  const auto all = read_all_tables(tables, overrides, errors);
  if (!errors.empty()) return errors;
  const auto digest = digest_of_tables(tables, overrides);
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

Result<std::string> digest_of_tables(const std::filesystem::path& tables,
                                     const std::vector<std::filesystem::path>& overrides) {
  std::string all;
  const auto add = [&](const std::filesystem::path& file, const std::string& name) -> Result<Done> {
    const auto text = read_file(file);
    if (!text) return text.error();
    all += name + "\n" + std::to_string(text->size()) + "\n" + *text;
    return Done{};
  };
  for (const auto simulator : kSimulators) {
    for (const auto& table : table_names()) {
      const auto name = std::string(name_of(simulator)) + "/" + table + ".csv";
      if (auto added = add(tables / name, name); !added) return added.error();
    }
    for (const auto& path : completed_files(tables, simulator)) {
      if (auto added = add(path, path.lexically_relative(tables).generic_string()); !added) return added.error();
    }
  }
  for (const auto& file : kind_files(tables)) {
    if (auto added = add(file, "sense/" + file.filename().string()); !added) return added.error();
  }
  // Of an override only the file's own name counts: it becomes the source of facts, its folder does not.
  for (const auto& file : override_files(tables, overrides)) {
    if (auto added = add(file, "override/" + file.filename().string()); !added) return added.error();
  }
  return sha256(all);
}

}  // namespace unietp
