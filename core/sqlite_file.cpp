#include "core/sqlite_file.h"

#include <sqlite3.h>

#include <cctype>
#include <stdexcept>

#include "core/file_place.h"
#include "core/limits.h"

namespace unietp {
namespace {

[[noreturn]] void raise(sqlite3* database) { throw std::runtime_error(sqlite3_errmsg(database)); }

/// The schema is a part of the file, so a stranger's file could bring code: a view that never ends in place of a table,
/// a trigger, an expression with a side effect. None of it runs.
void distrust_schema(sqlite3* database) {
  for (const int part : {SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_TRIGGER, SQLITE_DBCONFIG_TRUSTED_SCHEMA})
    sqlite3_db_config(database, part, 0, nullptr);
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, limits::kDatabaseBytes);
  sqlite3_exec(database, "PRAGMA cell_size_check=ON; PRAGMA mmap_size=0", nullptr, nullptr, nullptr);
}

/// The name under which SQLite opens a file that nobody writes: without locks, and without a journal that lies beside
/// it and would be played back.
std::string unchanging(const std::filesystem::path& path) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const std::filesystem::path whole = std::filesystem::absolute(path);
  std::string name = "file:";
  for (const char c : whole.native()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || c == '/' || c == '.' || c == '-' || c == '_';
    name += plain ? std::string(1, c) : std::string{'%', kDigits[byte >> 4], kDigits[byte & 15]};
  }
  return name + "?immutable=1";
}

/// Refuses a FIFO, which would be waited for, and whatever else is no file.
void require_regular(const std::filesystem::path& path) {
  const auto file = open_regular_file(path);
  if (!file) throw std::runtime_error(file.error().message);
}

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::~Statement() {
  if (own_.empty()) return;  // moved from
  reset();
  idle_->insert(std::move(own_));
}

void Statement::bind(int index, std::string_view text) {
  sqlite3_bind_text(get(), index, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}
void Statement::bind(int index, double value) { sqlite3_bind_double(get(), index, value); }
void Statement::bind(int index, std::int64_t value) { sqlite3_bind_int64(get(), index, value); }

bool Statement::step() {
  const int code = sqlite3_step(get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) raise(sqlite3_db_handle(get()));
  return code == SQLITE_ROW;
}

void Statement::reset() {
  sqlite3_reset(get());
  sqlite3_clear_bindings(get());
}

std::string_view Statement::text(int column) {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(get(), column));
  return {bytes == nullptr ? "" : bytes, static_cast<std::size_t>(sqlite3_column_bytes(get(), column))};
}
double Statement::number(int column) { return sqlite3_column_double(get(), column); }
std::int64_t Statement::integer(int column) { return sqlite3_column_int64(get(), column); }

void SqliteFile::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

SqliteFile::SqliteFile(const std::filesystem::path& path, Mode mode) {
  sqlite3* database = nullptr;
  // One thread uses a file at a time, so SQLite need not lock a mutex for every value that it gives.
  const bool reads = mode == Mode::Read;
  std::error_code none;
  if (reads || std::filesystem::exists(path, none)) require_regular(path);
  const int flags = SQLITE_OPEN_NOMUTEX |
                    (reads ? SQLITE_OPEN_READONLY | SQLITE_OPEN_URI : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  const int code = sqlite3_open_v2(reads ? unchanging(path).c_str() : path.c_str(), &database, flags, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) raise(database);
  distrust_schema(database);
}

Statement SqliteFile::prepare(std::string_view sql) {
  if (const auto known = idle_->find(sql); known != idle_->end()) return {idle_->extract(known), idle_};
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  Statement::Idle fresh;
  fresh.emplace(sql, statement);
  if (code != SQLITE_OK) raise(database_.get());
  return {fresh.extract(fresh.begin()), idle_};
}

void SqliteFile::run(const char* sql) {
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) raise(database_.get());
}

}  // namespace unietp
