#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sqlite3.h>

namespace unietp::test {

/// A database as any client of SQLite reads it: with its views, which are for people and which a SqliteFile does not
/// read.
class SqliteClient {
 public:
  explicit SqliteClient(const std::filesystem::path& path) { sqlite3_open(path.c_str(), &database_); }
  ~SqliteClient() { sqlite3_close(database_); }
  SqliteClient(const SqliteClient&) = delete;
  SqliteClient& operator=(const SqliteClient&) = delete;

  /// The rows that a query gives, as texts; "" for NULL.
  std::vector<std::vector<std::string>> rows(const std::string& query) {
    std::vector<std::vector<std::string>> rows;
    const auto keep = [](void* into, int count, char** texts, char**) {
      auto& row = static_cast<decltype(&rows)>(into)->emplace_back();
      for (int i = 0; i < count; ++i) row.emplace_back(texts[i] == nullptr ? "" : texts[i]);
      return 0;
    };
    EXPECT_EQ(sqlite3_exec(database_, query.c_str(), keep, &rows, nullptr), SQLITE_OK) << sqlite3_errmsg(database_);
    return rows;
  }

 private:
  sqlite3* database_ = nullptr;
};

}  // namespace unietp::test
