#include "record/trait_table.h"

#include <exception>

namespace unietp {
namespace {

Error trait_error(const std::filesystem::path& file, const std::exception& reason) {
  return {Error::Kind::Io, file.string(), {}, std::string("cannot read the table trait: ") + reason.what()};
}

}  // namespace

Result<TraitTable> TraitTable::open(const std::filesystem::path& file) {
  try {
    SqliteFile database(file, SqliteFile::Mode::Read);
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
    SqliteFile database(file, SqliteFile::Mode::Read);
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
