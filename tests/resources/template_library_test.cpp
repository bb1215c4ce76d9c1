#include "resources/template_library.h"
#include "resources/resources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/sqlite_file.h"
#include "core/text.h"
#include "templates/constraint_kinds.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

DataFolders library_folders() {
  return {UNIETP_SOURCE_DIR, fs::path(::testing::TempDir()) / "unietp-template-library-cache"};
}

std::string small_template(const std::string& name) {
  return "(template " + name + R"((name "open one <A>")
  (split atomic)
  (parameters (A - furniture openable))
  (init (forall (?a - A) (closed ?a)))
  (goal (exists (?a - A) (at-end (open ?a))))
  (instruction "Open {A:indefinite}." "Have {A:indefinite} open."))
)";
}

/// A folder of the user's with one template of that name.
fs::path folder_with(const std::string& folder, const std::string& name) {
  auto path = fs::path(::testing::TempDir()) / folder;
  EXPECT_TRUE(write_file(path / (name + ".template"), small_template(name)));
  return path;
}

/// All that a template says, as text.
std::string all_of(const Template& source) {
  std::string text = source.name + "\n" + source.title + "\n" + std::string(name_of(source.split)) + "\n" + source.file;
  for (const auto simulator : source.simulators) text += " " + std::string(name_of(simulator));
  for (const auto& parameter : source.parameters)
    text += "\n" + parameter.name + ": " + join(parameter.affordances, " ") + " " + std::to_string(parameter.pos.line);
  for (const auto& constraint : source.constraints) text += "\n" + to_text(constraint);
  for (const auto& formula : source.init) text += "\n" + to_text(formula);
  return text + "\n" + to_text(source.goal) + "\n" + join(source.instructions, "\n");
}

TEST(TemplateLibrary, TheKnowledgeFileCarriesExactlyWhatTheFilesSay) {
  const auto folders = library_folders();
  const auto compiled = compiled_knowledge(folders);
  ASSERT_TRUE(compiled.errors.empty()) << format(compiled.errors.front());
  const auto files = built_in_templates(folders);
  const auto stored = stored_templates(compiled.database, folders.root);
  ASSERT_TRUE(stored) << format(stored.error());
  EXPECT_EQ(*stored, files.files);

  const auto from_files = library_of(folders), from_database = library_in(compiled.database, folders);
  ASSERT_TRUE(from_files.errors.empty()) << format(from_files.errors.front());
  EXPECT_TRUE(from_database.errors.empty());
  ASSERT_EQ(from_files.templates.size(), from_database.templates.size());
  for (std::size_t i = 0; i < from_files.templates.size(); ++i)
    EXPECT_EQ(all_of(from_database.templates[i]), all_of(from_files.templates[i]));
}

TEST(TemplateLibrary, AReaderOfTheKnowledgeFileSeesClassSimulatorsAndParameters) {
  const auto compiled = compiled_knowledge(library_folders());
  ASSERT_TRUE(compiled.errors.empty());
  SqliteFile file(compiled.database, SqliteFile::Mode::Read);
  auto row = file.prepare("SELECT class, simulators, parameters, title FROM template WHERE name = 'open-one'");
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.text(0), "atomic");
  EXPECT_THAT(std::string(row.text(1)), HasSubstr("ai2thor|"));
  EXPECT_THAT(std::string(row.text(2)), HasSubstr("A: "));
  EXPECT_FALSE(row.text(3).empty());
}

TEST(TemplateLibrary, AnotherTemplateMakesAnotherKnowledgeFile) {
  const auto root = fs::path(::testing::TempDir()) / "unietp-root-with-templates";
  fs::remove_all(root);
  fs::create_directories(root / "templates");
  fs::copy(fs::path(UNIETP_SOURCE_DIR) / "templates" / "library", root / "templates" / "library",
           fs::copy_options::recursive);
  fs::create_directory_symlink(fs::path(UNIETP_SOURCE_DIR) / "data", root / "data");
  const DataFolders folders{root, library_folders().cache};
  const auto before = compiled_knowledge(folders);
  ASSERT_TRUE(write_file(folders.extended() / "open-again.template", small_template("open-again")));
  const auto after = compiled_knowledge(folders);
  ASSERT_TRUE(before.errors.empty() && after.errors.empty());
  EXPECT_NE(before.database, after.database);
  auto wide = folders;
  wide.extended_library = true;
  const auto without = library_in(after.database, folders), with = library_in(after.database, wide);
  EXPECT_EQ(with.templates.size(), without.templates.size() + 1);
  EXPECT_EQ(with.templates.back().name, "open-again");
  fs::remove_all(root);
}

TEST(TemplateLibrary, AUsersFolderLoadsBesideTheBuiltInOnesWithoutARebuild) {
  auto folders = library_folders();
  const auto before = compiled_knowledge(folders);
  const auto count = library_of(folders).templates.size();
  folders.templates = {folder_with("unietp-mine", "open-mine")};
  const auto library = library_in(before.database, folders);
  ASSERT_TRUE(library.errors.empty()) << format(library.errors.front());
  EXPECT_EQ(library.templates.size(), count + 1);
  EXPECT_EQ(library.templates.back().name, "open-mine");
  ASSERT_EQ(library.own.size(), 1U);
  EXPECT_THAT(library.own[0], ::testing::StartsWith("open-mine "));
  EXPECT_EQ(compiled_knowledge(folders).database, before.database);
}

TEST(TemplateLibrary, OneNameInTwoFoldersNamesBothFiles) {
  auto folders = library_folders();
  folders.templates = {folder_with("unietp-first", "open-twice"), folder_with("unietp-second", "open-twice"),
                       folder_with("unietp-third", "open-one")};
  const auto library = library_of(folders);
  ASSERT_EQ(library.errors.size(), 2U);
  EXPECT_THAT(library.errors[0].where, HasSubstr("unietp-second"));
  EXPECT_THAT(library.errors[0].message, HasSubstr("unietp-first"));
  EXPECT_THAT(library.errors[1].where, HasSubstr("unietp-third"));
  EXPECT_THAT(library.errors[1].message, HasSubstr("templates/library/atomic/open-one.template"));
}

TEST(TemplateLibrary, ANameInPlaceOfAFolderIsToldTheOptionForNames) {
  auto folders = library_folders();
  folders.templates = {"open-one"};
  const auto library = library_of(folders);
  ASSERT_EQ(library.errors.size(), 1U);
  EXPECT_THAT(library.errors[0].message, HasSubstr("`--template open-one`"));
}

}  // namespace
}  // namespace unietp
