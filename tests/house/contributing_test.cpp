#include <filesystem>

#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

TEST(Contributing, NamesOnlyFilesThatExist) {
  const fs::path source = UNIETP_SOURCE_DIR;
  const auto page = read_file(source / "CONTRIBUTING.md");
  ASSERT_TRUE(page);
  const auto parts = split(*page, '`');
  int files = 0;
  for (std::size_t i = 1; i < parts.size(); i += 2) {  // between backquotes
    const std::string& path = parts[i];
    const bool names_file =
        path.find('/') != std::string::npos && path.find_first_of(" <") == std::string::npos && !path.starts_with("./");
    if (!names_file) continue;
    ++files;
    EXPECT_TRUE(fs::exists(source / path)) << path;
  }
  EXPECT_GT(files, 15);
}

}  // namespace
}  // namespace unietp
