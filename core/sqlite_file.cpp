#include "core/sqlite_file.h"

#include <sqlite3.h>

#include <stdexcept>

namespace unietp {
namespace {

[[noreturn]] void raise(sqlite3* database) { throw std::runtime_error(sqlite3_errmsg(database)); }

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
  const int flags =
      SQLITE_OPEN_NOMUTEX | (mode == Mode::Read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  const int code = sqlite3_open_v2(path.c_str(), &database, flags, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) raise(database);
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
