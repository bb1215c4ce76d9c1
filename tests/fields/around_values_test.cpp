// What a file says beside its values, where nobody who reads the values looks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/version.h"
#include "forged_set.h"

namespace unietp {
namespace {

using ::testing::Contains;

std::vector<std::string> kinds_of(const ValidationReport& report) {
  std::vector<std::string> kinds;
  for (const Problem& problem : report.problems) kinds.emplace_back(name_of(problem.kind));
  return kinds;
}

std::string bytes_of(const std::string& file) {
  const auto bytes = read_file(forged_set().folder() / file);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : "";
}

TEST(AroundValues, AHomeIsPackedAsTheProgramDoes) {
  for (const auto& file : forged_set().files()) {
    if (!file.ends_with(".gz")) continue;
    const std::string packed = bytes_of(file), nothing = gzip("");
    constexpr std::size_t kTime = 4;  // in the header, of four bytes
    std::string dated = packed;
    dated[kTime] = 'x';
    for (const auto& forged : {nothing + packed, packed + nothing, dated}) {
      ASSERT_EQ(*gunzip(file, forged), *gunzip(file, packed));
      EXPECT_THAT(kinds_of(forged_set().with_bytes(file, forged)), Contains("home"));
    }
    return;
  }
  FAIL() << "the set has no home";
}

TEST(AroundValues, TheDatabaseHasOnlyItsTables) {
  for (const char* sql : {"PRAGMA application_id=77", "PRAGMA user_version=77", "PRAGMA auto_vacuum=1; VACUUM",
                          "PRAGMA page_size=8192; VACUUM", "CREATE TABLE more(a); DROP TABLE more"})
    EXPECT_THAT(kinds_of(forged_set().with_database(sql)), Contains("database")) << sql;
}

TEST(AroundValues, NothingIsBehindTheDatabase) {
  const std::string file = "dataset.sqlite", bytes = bytes_of(file);
  constexpr std::size_t kPage = 4096, kPagesInHeader = 28, kChanges = 24, kSizeIsOfChange = 92;
  EXPECT_THAT(kinds_of(forged_set().with_bytes(file, bytes + "secret")), Contains("database"));
  EXPECT_THAT(kinds_of(forged_set().with_bytes(file, bytes + std::string(kPage, 's'))), Contains("database"));
  // A header that counts the page, which is of no table.
  std::string counted = bytes + std::string(kPage, 's');
  const auto pages = counted.size() / kPage;
  ASSERT_LT(pages, 256U * 256U);
  counted[kPagesInHeader + 2] = static_cast<char>(pages / 256);
  counted[kPagesInHeader + 3] = static_cast<char>(pages % 256);
  ASSERT_EQ(counted.substr(kChanges, 4), counted.substr(kSizeIsOfChange, 4));
  EXPECT_THAT(kinds_of(forged_set().with_bytes(file, counted)), Contains("database"));
}

/// The card says the same version in its turn, so that the two agree.
TEST(AroundValues, TheVersionIsThatOfTheProgram) {
  std::string manifest = forged_set().text("manifest.json");
  const std::string version = R"("version": ")" + std::string(program_version()) + '"';
  const auto at = manifest.find(version);
  ASSERT_NE(at, std::string::npos);
  manifest.replace(at, version.size(), R"("version": "9.9.0")");
  EXPECT_THAT(kinds_of(forged_set().with("manifest.json", manifest)), Contains("other-version"));
}

}  // namespace
}  // namespace unietp
