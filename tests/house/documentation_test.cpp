#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "declarations.h"
#include "includes.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> without_comment(std::string_view header) {
  std::vector<std::string> found;
  for (const auto& one : public_declarations(header)) {
    if (!one.commented && needs_comment(one)) found.push_back(std::to_string(one.line) + ": " + one.text);
  }
  return found;
}

TEST(Documentation, EveryPublicDeclarationHasAComment) {
  const fs::path source = UNIETP_SOURCE_DIR;
  const auto graph = read_file(UNIETP_ROOM_GRAPH);
  ASSERT_TRUE(graph);
  std::size_t declarations = 0;
  for (const auto& room : read_room_graph(*graph).rooms) {
    for (const auto& entry : fs::recursive_directory_iterator(source / room)) {
      if (entry.path().extension() != ".h") continue;
      const auto text = read_file(entry.path());
      ASSERT_TRUE(text) << entry.path();
      declarations += public_declarations(*text).size();
      EXPECT_THAT(without_comment(*text), IsEmpty()) << entry.path().lexically_relative(source);
    }
  }
  EXPECT_GT(declarations, 4000U);  // it did read the headers
}

TEST(PublicDeclarations, AreCommentedByTheCommentAboveThemOrTheirGroup) {
  EXPECT_THAT(without_comment("namespace unietp {\n"
                              "/// A number.\n"
                              "int one();\n"
                              "int another(std::string_view text = {});\n"
                              "\n"
                              "int alone();\n"
                              "inline constexpr int kMost = 3;  // of them\n"
                              "}\n"),
              ElementsAre("6: int alone()"));
  EXPECT_THAT(
      without_comment("// Of the file.\n\nusing Text = std::string;\nenum class Kind { A, B };\nclass Later;\n"),
      ElementsAre("3: using Text = std::string", "4: enum class Kind {}"));
  EXPECT_THAT(without_comment("template <class T>\nT made(int number = 1) {\n  return T(number);  // in the body\n}\n"
                              "/// Known.\nint known() {\n  return {of({1})};\n}\nint known_too();\n"),
              ElementsAre("1: template <class T> T made(int number = 1)"));
}

TEST(PublicDeclarations, OfAClassAreItsPublicFunctions) {
  EXPECT_THAT(without_comment("/// A list.\n"
                              "class List : public Base {\n"
                              " public:\n"
                              "  explicit List(int size) : size_{size} {}\n"
                              "  List(const List&) = delete;\n"
                              "  std::size_t size() const { return 1'000 + size_; }\n"
                              "  void run() override;\n"
                              "  bool operator==(const List&) const;\n"
                              "  struct Part {\n"
                              "    int number = 0;\n"
                              "    int twice() const { return 2 * number; }\n"
                              "  };\n"
                              "  int told(char quote = '\"') const;\n"
                              " private:\n"
                              "  int hidden() const { if (size_ > 0) { return 1; } return 2; }\n"
                              "  int size_ = 0;\n"
                              " public:\n"
                              "  int late();\n"
                              "};\n"
                              "int after();\n"),
              ElementsAre("11: int twice() const", "13: int told(char quote = '') const", "18: int late()"));
}

}  // namespace
}  // namespace unietp
