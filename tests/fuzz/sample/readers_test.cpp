#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <set>
#include <vector>

#include <gmock/gmock.h>

#include "akb/csv.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;

const fs::path kRoot = UNIETP_SOURCE_DIR;

/// Whether a function of this name, declared in this line with these arguments, reads a text or a file.
bool is_reader(std::string_view name, std::string_view line, std::string_view arguments) {
  const auto starts = [&](std::string_view prefix) { return name.starts_with(prefix); };
  const bool named = starts("read_") || starts("parse_") || starts("load_") || starts("stored_") ||
                     name.ends_with("_from_json") ||
                     ((name == "open" || name == "read") && line.find("static Result<") != std::string_view::npos);
  const auto takes = [&](std::string_view type) { return arguments.find(type) != std::string_view::npos; };
  return named && (takes("string_view") || takes("path&") || takes("std::string&") || takes("vector<std::string>&") ||
                   takes("File>&") || takes("Json"));
}

/// "header,function" of the readers that a header declares.
std::set<std::string> readers_in(const std::string& header, std::string_view text) {
  std::set<std::string> readers;
  for (const std::string& whole : split(text, '\n')) {
    const std::string_view line = std::string_view(whole).substr(0, whole.find("//"));
    for (auto open = line.find('('); open != std::string_view::npos; open = line.find('(', open + 1)) {
      auto start = open;
      while (start > 0 && (std::isalnum(static_cast<unsigned char>(line[start - 1])) != 0 || line[start - 1] == '_'))
        --start;
      const auto name = line.substr(start, open - start);
      if (is_reader(name, line, line.substr(open))) readers.insert(header + "," + std::string(name));
    }
  }
  return readers;
}

std::set<std::string> declared_readers() {
  std::set<std::string> readers;
  for (const auto& room : fs::directory_iterator(kRoot)) {
    if (!fs::exists(room.path() / "CMakeLists.txt") || room.path().filename() == "tests" ||
        room.path().filename() == "bench")
      continue;
    for (const auto& file : fs::recursive_directory_iterator(room.path())) {
      if (file.path().extension() != ".h") continue;
      const auto text = read_file(file.path());
      EXPECT_TRUE(text) << file.path();
      if (text) readers.merge(readers_in(file.path().lexically_relative(kRoot).generic_string(), *text));
    }
  }
  return readers;
}

/// readers.csv: header, function, fuzz targets, and why there are none.
CsvFile reader_table() {
  const auto text = read_file(kRoot / "tests/fuzz/readers.csv");
  EXPECT_TRUE(text);
  CsvFile table = read_csv("readers.csv", text ? *text : "");
  EXPECT_THAT(table.errors, IsEmpty());
  return table;
}

TEST(Readers, AreFoundByTheirNamesAndArguments) {
  EXPECT_EQ(readers_in("a.h",
                       "Result<A> read_a(const std::string& where,\n"
                       "  static Result<A> open(const std::filesystem::path& folder);\n"
                       "/// read_b(std::string_view text)\n"
                       "int read_count();\n"),
            (std::set<std::string>{"a.h,open", "a.h,read_a"}));
}

TEST(Readers, AreAllListedWithTheFuzzTargetsThatReachThem) {
  const auto declared = declared_readers();
  EXPECT_GT(declared.size(), 90U);
  std::set<std::string> listed, without;
  for (const CsvRow& row : reader_table().rows) {
    listed.insert(row[0].text + "," + row[1].text);
    EXPECT_NE(row[2].text.empty(), row[3].text.empty()) << row[1].text;
    for (const std::string& target : split(row[2].text, ' ')) {
      if (target.empty()) continue;
      EXPECT_TRUE(fs::is_directory(kRoot / "tests/fuzz/seeds" / target)) << row[1].text << " names " << target;
    }
  }
  std::vector<std::string> missing, gone;
  std::set_difference(declared.begin(), declared.end(), listed.begin(), listed.end(), std::back_inserter(missing));
  std::set_difference(listed.begin(), listed.end(), declared.begin(), declared.end(), std::back_inserter(gone));
  EXPECT_THAT(missing, IsEmpty()) << "declared by headers of the rooms, not listed in tests/fuzz/readers.csv";
  EXPECT_THAT(gone, IsEmpty()) << "listed in tests/fuzz/readers.csv, not declared";
}

}  // namespace
}  // namespace unietp
