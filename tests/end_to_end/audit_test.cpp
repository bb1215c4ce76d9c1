// `unietp audit` of the real program: what it prints and its exit codes, and that a small fixed data set gives little
// away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "data_set.h"
#include "schema_checker.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

Ended audit(const std::filesystem::path& folder, std::vector<std::string> more) {
  more.insert(more.begin(), {"audit", folder.string()});
  return run_program(more);
}

TEST(AuditCommand, SaysTheSameOfASmallSetInAllForms) {
  const auto table = audit(small_data_set(), {});
  EXPECT_THAT(table.out, HasSubstr("last-listed"));
  EXPECT_THAT(table.out, HasSubstr("40 tasks in "));
  const auto whole = audit(small_data_set(), {"--whole", "--threads", "1"});
  EXPECT_GT(whole.out.size(), 2 * table.out.size());
  const auto ended = audit(small_data_set(), {"--json"});
  const auto json = Json::parse(ended.out);
  EXPECT_EQ(SchemaChecker().check(json, "audit.schema.json"), "");
  EXPECT_EQ(json["tasks"], kSmallCount);
  EXPECT_EQ(json["training_tasks"], 0);
  EXPECT_EQ(json["leaks"], 0) << table.out;
  EXPECT_EQ(table.code, 0) << table.err;
  EXPECT_EQ(ended.code, 0);
  EXPECT_GT(json["cells"].size(), 300U);
  EXPECT_THAT(table.out, HasSubstr(std::to_string(json["cells"].size()) + " cells, 0 better than chance"));
}

TEST(AuditCommand, LearnsFromAnotherSet) {
  const auto ended = audit(data_set_in_all_modes(), {"--training", small_data_set().string(), "--json"});
  EXPECT_EQ(Json::parse(ended.out)["training_tasks"], kSmallCount);
}

TEST(AuditCommand, RefusesWhatIsNoSoundDataSet) {
  EXPECT_EQ(audit("/nowhere", {}).code, 2);
  const DamagedCopy copy;
  auto tasks = copy.read("tasks.jsonl");
  copy.write("tasks.jsonl", "{" + tasks);
  const auto ended = audit(copy.folder(), {});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("tasks.jsonl:1:"));
}

}  // namespace
}  // namespace unietp
