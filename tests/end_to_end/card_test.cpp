// The card of a data set: its metadata block names files that Hugging Face's `datasets` takes as tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Json = nlohmann::ordered_json;

/// Every field below a value with the kind of what it holds; a table's column has one kind.
void collect_kinds(const Json& value, const std::string& path, std::map<std::string, std::set<std::string>>& kinds) {
  if (value.is_null()) return;
  kinds[path].insert(value.is_number() ? "number" : value.type_name());
  if (value.is_object()) {
    for (const auto& [name, field] : value.items()) collect_kinds(field, path + "." + name, kinds);
  }
  if (value.is_array()) {
    for (const Json& item : value) collect_kinds(item, path + "[]", kinds);
  }
}

TEST(Card, NamesTablesWhoseColumnsHaveOneTypeEach) {
  const auto card = read_file(small_data_set() / "README.md");
  ASSERT_TRUE(card);
  const auto lines = split(*card, '\n');
  ASSERT_EQ(lines[0], "---");
  std::vector<std::string> files, fields;
  std::size_t end = 1;
  for (; lines.at(end) != "---"; ++end) {
    const auto line = std::string(trim(lines[end]));
    if (line.starts_with("path: ")) files.push_back(line.substr(6));
    if (lines[end].find(':') != std::string::npos && lines[end][0] != ' ' && lines[end][0] != '-')
      fields.push_back(line.substr(0, line.find(':')));
  }
  for (const char* field :
       {"license", "language", "task_categories", "tags", "pretty_name", "size_categories", "configs"})
    EXPECT_THAT(fields, Contains(field));
  EXPECT_THAT(*card, HasSubstr("- n<1K\n"));
  EXPECT_THAT(files, ::testing::ElementsAre("tasks.jsonl", "demonstrations/M1.jsonl"));
  for (const auto& file : files) {
    std::map<std::string, std::set<std::string>> kinds;
    for (const auto& line : json_lines(small_data_set() / file)) collect_kinds(line, "", kinds);
    for (const auto& [path, found] : kinds) EXPECT_THAT(found, SizeIs(1)) << file << path;
  }
  for (const char* title :
       {"## How it was made", "## How it was verified", "## Sources of the facts", "| split | tasks |"})
    EXPECT_THAT(*card, HasSubstr(title));
}

}  // namespace
}  // namespace unietp
