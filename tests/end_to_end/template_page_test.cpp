// docs/add-a-template.md, done as it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "program.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// The insides of all fenced blocks of one kind, in order.
std::vector<std::string> blocks(const std::string& page, const std::string& kind) {
  const std::string fence = "\n```" + kind + "\n";
  std::vector<std::string> found;
  for (auto at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
    const auto start = at + fence.size();
    found.push_back(page.substr(start, page.find("\n```", start) + 1 - start));
  }
  return found;
}

TEST(AddATemplatePage, FollowedFromTopToBottomItGivesProvenTasksOfItsTemplate) {
  const auto page = read_file(fs::path(UNIETP_SOURCE_DIR) / "docs" / "add-a-template.md");
  ASSERT_TRUE(page);
  const ScratchFolder folder;
  int templates = 0;
  for (const auto& block : blocks(*page, "lisp")) {
    if (!block.starts_with("(template ")) continue;
    const auto name = block.substr(10, block.find('\n') - 10);
    ASSERT_TRUE(write_file(folder.path() / "mine" / (name + ".template"), block));
    ++templates;
  }
  EXPECT_EQ(templates, 1);
  const auto commands = blocks(*page, "sh");
  ASSERT_GE(commands.size(), 5U);
  std::string last;
  for (const auto& command : commands) {
    const auto ended = run_script(command, folder.path());
    ASSERT_EQ(ended.code, 0) << command << ended.out << ended.err;
    last = ended.out;
  }
  EXPECT_THAT(last, HasSubstr("4 of 4"));
}

TEST(AddATemplatePage, TheMessageItShowsIsTheOneThatIsGiven) {
  const auto page = read_file(fs::path(UNIETP_SOURCE_DIR) / "docs" / "add-a-template.md");
  ASSERT_TRUE(page);
  const ScratchFolder folder;
  for (auto block : blocks(*page, "lisp")) {
    if (!block.starts_with("(template ")) continue;
    block.replace(block.rfind("closed"), 6, "closd");
    ASSERT_TRUE(write_file(folder.path() / "mine" / "two-on-and-close.template", block));
  }
  const auto ended = run_script("unietp template lint mine/two-on-and-close.template", folder.path());
  EXPECT_EQ(ended.code, 2);
  const auto shown = blocks(*page, "text");
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(ended.err, shown.front());
}

}  // namespace
}  // namespace unietp
