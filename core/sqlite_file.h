#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace unietp {

/// One prepared statement. A failure (a file that is no database, a table that it lacks) throws std::runtime_error,
/// caught in the file of each room that uses it; only core's .cpp file sees SQLite.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql);
  void bind(int index, std::string_view text);
  void bind(int index, double value);
  void bind(int index, std::int64_t value);
  bool step();  // true while there is a row
  void reset();
  std::string_view text(int column);  // valid until the next step
  double number(int column);
  std::int64_t integer(int column);

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class SqliteFile {
 public:
  enum class Mode { Create, Read };
  /// Errors: std::runtime_error with SQLite's message.
  SqliteFile(const std::filesystem::path& path, Mode mode);
  void run(const char* sql);
  Statement prepare(std::string_view sql) { return {database_.get(), sql}; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace unietp
