// How large a file and a function may be, so that each holds one idea.
#include <algorithm>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "function_sizes.h"
#include "includes.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::ptrdiff_t kFileLines = 480;
constexpr int kFunctionLines = 80;

std::vector<fs::path> source_files() {
  const fs::path source = UNIETP_SOURCE_DIR;
  std::vector<std::string> folders{"tests", "bench", "python"};
  for (const auto& room : read_room_graph(*read_file(UNIETP_ROOM_GRAPH)).rooms) folders.push_back(room);
  const std::set<fs::path> languages{".cpp", ".h", ".py"};
  std::vector<fs::path> files;
  for (const auto& folder : folders) {
    if (!fs::exists(source / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(source / folder))
      if (languages.contains(entry.path().extension())) files.push_back(entry.path());
  }
  return files;
}

TEST(Sizes, NoFileAndNoFunctionIsTooLong) {
  std::size_t functions = 0;
  for (const auto& file : source_files()) {
    const auto text = read_file(file);
    ASSERT_TRUE(text) << file;
    EXPECT_LE(std::count(text->begin(), text->end(), '\n'), kFileLines) << file;
    if (file.extension() == ".py") continue;
    for (const auto& function : functions_of(*text)) {
      ++functions;
      EXPECT_LE(function.lines, kFunctionLines) << file << ":" << function.line << ": " << function.signature;
    }
  }
  EXPECT_GT(functions, 10000U);  // it did read them
}

std::vector<std::string> sizes_in(std::string_view code) {
  std::vector<std::string> sizes;
  for (const auto& function : functions_of(code))
    sizes.push_back(std::to_string(function.line) + "+" + std::to_string(function.lines) + " " + function.signature);
  return sizes;
}

TEST(FunctionsOf, AreThoseWithABodyWithAllThatIsInside) {
  EXPECT_THAT(sizes_in("namespace a {\n"
                       "int one();\n"
                       "int two(int x) {\n"
                       "  const auto f = [&](int y) {\n"
                       "    return x + y;\n"
                       "  };\n"
                       "  return f(1);\n"
                       "}\n"
                       "int three() { return 3; }\n"
                       "}\n"),
              ElementsAre("3+4 int two(int x)", "9+0 int three()"));
  EXPECT_THAT(sizes_in("class List {\n"
                       " public:\n"
                       "  int size() const {\n"
                       "    return 1'000;\n"
                       "  }\n"
                       "};\n"),
              ElementsAre("3+1 public:   int size() const"));
}

TEST(FunctionsOf, AreNeitherTablesNorWhatStandsInTextAndComments) {
  EXPECT_THAT(sizes_in("const std::map<int, std::function<void()>> kTable = {\n"
                       "    {1, [] { go(); }},\n"
                       "};\n"
                       "#define F(x) \\\n"
                       "  void f(x) { \\\n"
                       "  }\n"
                       "// void g() {\n"
                       "const char* kText = R\"(void h() {)\";\n"
                       "const char* kOther = \"void i() {\\\"\";  // '\n"),
              IsEmpty());
}

}  // namespace
}  // namespace unietp
