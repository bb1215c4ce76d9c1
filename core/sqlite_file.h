#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace unietp {

/// A prepared statement. When it is destroyed, the file keeps it for the next `prepare` of the same text. It must not
/// outlive the file. Failures (a file that is no database, a missing table) throw std::runtime_error, which each user
/// catches in the one file that calls this; only core's .cpp file includes SQLite.
class Statement {
 public:
  Statement(Statement&&) = default;
  ~Statement();
  /// The value of the parameter at `index`, counted from 1. Texts are copied.
  void bind(int index, std::string_view text);
  void bind(int index, double value);
  void bind(int index, std::int64_t value);
  bool step();  // true while there is a row
  /// Back to before the first row, to be bound and stepped again.
  void reset();
  std::string_view text(int column);  // valid until the next step
  /// Value of a column, counted from 0, in the row that `step` found.
  double number(int column);
  std::int64_t integer(int column);

 private:
  friend class SqliteFile;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  using Idle = std::multimap<std::string, std::unique_ptr<sqlite3_stmt, Finalize>, std::less<>>;  // by text
  Statement(Idle::node_type own, std::shared_ptr<Idle> idle) : own_(std::move(own)), idle_(std::move(idle)) {}
  sqlite3_stmt* get() { return own_.mapped().get(); }

  Idle::node_type own_;
  std::shared_ptr<Idle> idle_;
};

/// A database file, perhaps from a stranger: only its tables are used. Its views cannot be read, its triggers do not
/// fire, and no value of more than 64 MB is read or written.
class SqliteFile {
 public:
  /// Read: a file that nobody writes meanwhile; a journal beside it is not looked at.
  enum class Mode { Create, Read };
  /// Errors: std::runtime_error with SQLite's message.
  SqliteFile(const std::filesystem::path& path, Mode mode);
  /// Runs statements that give no rows. Errors: std::runtime_error.
  void run(const char* sql);
  /// One statement with parameters `?`. Errors: std::runtime_error.
  Statement prepare(std::string_view sql);

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
  std::shared_ptr<Statement::Idle> idle_ = std::make_shared<Statement::Idle>();  // gone before the database closes
};

}  // namespace unietp
