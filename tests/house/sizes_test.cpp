// How large a file and a function may be, so that each holds one idea.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "function_sizes.h"
#include "source_files.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::ptrdiff_t kFileLines = 480;
constexpr int kFunctionLines = 80;

TEST(Sizes, NoFileAndNoFunctionIsTooLong) {
  std::size_t functions = 0;
  for (const auto& file : source_files({".cpp", ".h", ".py"})) {
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
