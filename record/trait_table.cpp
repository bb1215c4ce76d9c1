#include "record/trait_table.h"

#include <exception>
#include <stdexcept>

#include "core/file_place.h"

namespace unietp {
namespace {

Error trait_error(const std::filesystem::path& file, const std::exception& reason) {
  return {Error::Kind::Io, file.string(), {}, std::string("cannot read the table trait: ") + reason.what()};
}

/// The database, which no symbolic link stands for. Errors: std::runtime_error.
SqliteFile database_in(const std::filesystem::path& file) {
  const auto path = path_inside(file.parent_path(), file.filename().string(), MissingFolders::Refused);
  if (!path) throw std::runtime_error(path.error().message);
  return {*path, SqliteFile::Mode::Read};
}

}  // namespace

Result<TraitTable> TraitTable::open(const std::filesystem::path& file) {
  try {
    SqliteFile database = database_in(file);
    auto rows = database.prepare(
        "SELECT task.rowid, trait.task, trait.dimension, trait.value FROM trait JOIN task ON task.id = trait.task "
        "ORDER BY task.rowid, trait.rowid");
    return TraitTable(file, std::move(database), std::move(rows));
  } catch (const std::exception& reason) {
    return trait_error(file, reason);
  }
}

Result<TraitTable::Traits> TraitTable::of(std::int64_t row, const std::string& task) {
  try {
    if (!begun_) more_ = rows_.step();
    begun_ = true;
    Traits traits;
    for (; more_ && rows_.integer(0) <= row; more_ = rows_.step()) {
      if (rows_.integer(0) == row && rows_.text(1) == task) traits.emplace_back(rows_.text(2), rows_.text(3));
    }
    return traits;
  } catch (const std::exception& reason) {
    return trait_error(path_, reason);
  }
}

Result<TraitCounts> trait_counts(const std::filesystem::path& file) {
  try {
    SqliteFile database = database_in(file);
    auto rows = database.prepare("SELECT dimension, value, count(*) FROM trait GROUP BY 1, 2");
    TraitCounts counts;
    while (rows.step())
      counts[std::string(rows.text(0))][std::string(rows.text(1))] = static_cast<int>(rows.integer(2));
    return counts;
  } catch (const std::exception& reason) {
    return trait_error(file, reason);
  }
}

}  // namespace unietp
