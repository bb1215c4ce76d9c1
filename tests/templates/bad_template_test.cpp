#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "templates/template.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(UNIETP_SOURCE_DIR) / "tests/templates/data";

std::string slurp(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<fs::path> bad_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kData)) {
    if (entry.path().extension() == ".template" && entry.path().filename().string().starts_with("bad-")) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string messages(const std::vector<Error>& errors) {
  std::string text;
  for (const auto& error : errors) text += format(error) + "\n";
  return text;
}

/// UNIETP_UPDATE_GOLDEN=1 writes the files anew, to be read in a diff before they are committed.
TEST(BadTemplate, EveryMessageIsTheOneWrittenDown) {
  const auto files = bad_files();
  ASSERT_GE(files.size(), 20U);
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename().string());
    const auto reading = parse_template(file.filename().string(), slurp(file));
    EXPECT_TRUE(reading.templates.empty()) << "a template with an error must be refused";
    const auto golden = fs::path(file).replace_extension(".golden");
    if (std::getenv("UNIETP_UPDATE_GOLDEN") != nullptr) std::ofstream(golden) << messages(reading.errors);
    EXPECT_EQ(messages(reading.errors), slurp(golden));
  }
}

TEST(BadTemplate, EveryMessageSaysWhereInTheFile) {
  for (const auto& file : bad_files()) {
    SCOPED_TRACE(file.filename().string());
    const auto text = slurp(file);
    const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
    const auto reading = parse_template(file.filename().string(), text);
    ASSERT_FALSE(reading.errors.empty());
    SourcePos last;
    for (const auto& error : reading.errors) {
      EXPECT_EQ(error.where, file.filename().string());
      EXPECT_GE(error.pos.line, std::max(1, last.line)) << "in order of appearance";
      EXPECT_LE(error.pos.line, lines);
      EXPECT_GE(error.pos.column, 1);
      last = error.pos;
    }
  }
}

TEST(BadTemplate, OneFileMayHaveManyProblemsAndAllAreReported) {
  const auto reading = parse_template("bad-many-problems.template", slurp(kData / "bad-many-problems.template"));
  EXPECT_GE(reading.errors.size(), 6U);
}

TEST(BadTemplate, ARefusedFileDoesNotKeepOthersFromLoading) {
  const fs::path folder = fs::temp_directory_path() / ("unietp_templates_" + std::to_string(::getpid()));
  fs::create_directories(folder / "atomic");
  const auto good = fs::path(UNIETP_SOURCE_DIR) / "templates/library/atomic/open-one.template";
  fs::copy_file(good, folder / "atomic" / "open-one.template", fs::copy_options::overwrite_existing);
  std::ofstream(folder / "atomic" / "broken.template") << "(template broken";
  std::ofstream(folder / "atomic" / "notes.txt") << "not a template";
  const auto reading = load_templates(folder);
  ASSERT_EQ(reading.templates.size(), 1U);
  EXPECT_EQ(reading.templates[0].name, "open-one");
  ASSERT_EQ(reading.errors.size(), 1U);
  EXPECT_EQ(reading.errors[0].where, (folder / "atomic" / "broken.template").string());
  fs::remove_all(folder);
}

TEST(BadTemplate, TwoFilesOfOneNameAreRefused) {
  const fs::path folder = fs::temp_directory_path() / ("unietp_twice_" + std::to_string(::getpid()));
  const auto good = fs::path(UNIETP_SOURCE_DIR) / "templates/library/atomic/open-one.template";
  for (const auto* below : {"mine", "yours"}) {
    fs::create_directories(folder / below);
    fs::copy_file(good, folder / below / "open-one.template", fs::copy_options::overwrite_existing);
  }
  const auto reading = load_templates(folder);
  EXPECT_EQ(reading.templates.size(), 1U);
  ASSERT_EQ(reading.errors.size(), 1U);
  EXPECT_NE(reading.errors[0].message.find("already defined"), std::string::npos);
  fs::remove_all(folder);
}

TEST(BadTemplate, AFolderThatIsNotThereIsAnError) {
  const auto reading = load_templates("/nowhere/at/all");
  ASSERT_EQ(reading.errors.size(), 1U);
  EXPECT_EQ(reading.errors[0].kind, Error::Kind::Io);
}

/// Cutting a good file short or dropping one byte must never crash, and a cut file is never accepted.
TEST(BadTemplate, DamagedTextNeverGetsThroughACut) {
  const auto text = slurp(fs::path(UNIETP_SOURCE_DIR) / "templates/library/logical/share-evenly.template");
  const auto last = text.find_last_of(')');
  for (std::size_t length = 0; length < last; length += 3) {
    EXPECT_TRUE(parse_template("share-evenly.template", text.substr(0, length)).templates.empty()) << length;
  }
  for (std::size_t at = 0; at < text.size(); ++at) {
    auto damaged = text;
    damaged.erase(at, 1);
    const auto reading = parse_template("share-evenly.template", damaged);
    EXPECT_EQ(reading.templates.size() + (reading.errors.empty() ? 0U : 1U), 1U) << at;
  }
}

}  // namespace
}  // namespace unietp
