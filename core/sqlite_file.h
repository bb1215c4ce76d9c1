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

/// One prepared statement, which its file gives again to whoever asks for the same one later; it must not outlive the
/// file. A failure (a file that is no database, a table that it lacks) throws std::runtime_error, caught in the file of
/// each room that uses it; only core's .cpp file sees SQLite.
class Statement {
 public:
  Statement(Statement&&) = default;
  ~Statement();
  void bind(int index, std::string_view text);
  void bind(int index, double value);
  void bind(int index, std::int64_t value);
  bool step();  // true while there is a row
  void reset();
  std::string_view text(int column);  // valid until the next step
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
  void run(const char* sql);
  Statement prepare(std::string_view sql);

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
  std::shared_ptr<Statement::Idle> idle_ = std::make_shared<Statement::Idle>();  // gone before the database closes
};

}  // namespace unietp
