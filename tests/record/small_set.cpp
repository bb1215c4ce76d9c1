#include "small_set.h"

#include <gtest/gtest.h>

#include "core/files.h"

namespace unietp {

namespace fs = std::filesystem;

std::string task_line(const std::string& id, std::size_t padding) {
  return R"text({"format":"unietp-task/1","id":")text" + id +
         R"text(","template":"open-one","split":"atomic","simulator":"ai2thor","scene":"s","layout":"h","bindings":{"A":"Fridge"},"refinement":"","phenomena":[],"goal":{"text":"(at-end (exists (?a - Fridge) (open ?a)))","tree":{"op":"at-end","parts":[{"op":"exists","variable":"a","domain":{"categories":[{"category":"Fridge"}]},"body":{"op":"atom","predicate":"open","terms":[{"variable":"a"}]}}]}},"start":{"constraints":[],"edits":["e)text" +
         std::string(padding, 'x') +
         R"text("],"changes":{}},"instruction":{"text":"Open a fridge.","writer":"grammar","style":"direct","checks":[]},"sense":{"grade":"usual","parts":[{"part":"open fridge","grade":"usual","why":"written"}]},"forms":[],"expert":{"M1":{"steps":1,"failures":0}},"seed":{"run":1,"slot":0,"attempt":0}})text";
}

std::string shown_line(const std::string& id) {
  return R"({"format":"unietp-demonstration/1","task":")" + id +
         R"(","mode":"M1","steps":[{"action":"stop","args":[],"success":true,"failure":"none","feedback":"","search":false,"visible":[],"changes":{}}]})";
}

SmallSet::SmallSet()
    : folder_(fs::path(::testing::TempDir()) /
              (std::string("set_") + ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
  fs::remove_all(folder_);
  fs::create_directories(folder_ / "demonstrations");
}

void SmallSet::write(const std::vector<std::string>& tasks, const std::vector<std::string>& shown) const {
  const auto all = [](const std::vector<std::string>& lines) {
    std::string text;
    for (const auto& line : lines) text += line + "\n";
    return text;
  };
  write_bytes("tasks.jsonl", all(tasks));
  write_bytes("demonstrations/M1.jsonl", all(shown));
}

void SmallSet::write_bytes(const std::string& file, const std::string& bytes) const {
  EXPECT_TRUE(write_file(folder_ / file, bytes));
}

}  // namespace unietp
