// Files and folders are opened, made, renamed and removed in few places: core/file_place.h and core/file_writer.h for
// all that lies below a folder, and those listed here, each with its reason. A stranger's data set can lead nowhere
// else.
#include <cctype>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "code_pieces.h"
#include "core/files.h"
#include "source_files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path kSources = UNIETP_SOURCE_DIR;

/// Functions that open, make, rename or remove, where `::`, `fs::` or `std::filesystem::` stands before them.
const Names kFunctions{"open", "remove", "link", "copy", "creat", "truncate", "permissions", "chmod"};
/// The same of names that nothing else has, whatever stands before them.
const Names kOwnNames{"openat",
                      "rename",
                      "renameat",
                      "renameat2",
                      "unlink",
                      "unlinkat",
                      "remove_all",
                      "mkdir",
                      "mkdirat",
                      "rmdir",
                      "mkstemp",
                      "mkostemp",
                      "mkdtemp",
                      "linkat",
                      "symlink",
                      "symlinkat",
                      "copy_file",
                      "resize_file",
                      "create_directory",
                      "create_directories",
                      "create_hard_link",
                      "create_symlink",
                      "fopen",
                      "freopen",
                      "ifstream",
                      "ofstream",
                      "fstream",
                      "filebuf",
                      "sqlite3_open",
                      "sqlite3_open_v2",
                      "SqliteFile",
                      "create_directory_symlink"};

/// What opens, makes, renames or removes, by file; the reason why it is not one of the two files of core's.
const std::map<std::string, std::pair<Names, std::string>> kMay{
    {"core/file_place.cpp", {{"open", "openat", "mkdirat", "create_directories"}, "the one way below a folder"}},
    {"core/file_writer.cpp", {{"open", "openat", "renameat", "unlinkat"}, "the one way to write a file"}},
    {"core/files.cpp", {{"create_directories"}, "folders above a path of the user's"}},
    {"core/folder_lock.cpp", {{"open", "create_directories", "remove"}, "the lock beside a folder, and the folder"}},
    {"core/staged_folder.cpp",
     {{"renameat2", "rename", "remove_all", "create_directories", "create_hard_link", "copy_file"},
      "whole folders that get a name, and files that were listed there and are no links"}},
    // Data sets, runs and evaluations: fixed names in a folder that the user named
    {"dataset/dataset_database.cpp",
     {{"SqliteFile", "copy_file", "remove"},
      "dataset.sqlite in a folder aside; one to copy is no link, as ChangedCopy saw"}},
    {"dataset/dataset_database.h", {{"SqliteFile"}, "as above"}},
    {"dataset/dataset_writer.cpp", {{"create_directories"}, "the empty folders of a data set"}},
    {"evaluation/episode_log.cpp", {{"open"}, "episodes.log, to which is added; it follows no link"}},
    {"record/trait_table.cpp", {{"SqliteFile"}, "dataset.sqlite, from path_inside, to be read"}},
    {"record/trait_table.h", {{"SqliteFile"}, "as above"}},
    {"run/ledger.cpp", {{"SqliteFile"}, "ledger.sqlite of a run, and that of --ledger"}},
    {"run/ledger.h", {{"SqliteFile"}, "as above"}},
    {"run/run.cpp", {{"rename", "remove"}, "the ledger that --ledger names"}},
    {"run/run_folder.cpp", {{"create_directories", "remove_all", "rename"}, "a run's own folder, which gets a name"}},
    {"scores/watched_episodes.cpp", {{"open", "mkostemp", "unlink"}, "a file without a name"}},
    {"scores/write_results.cpp", {{"remove_all"}, "the pages of an evaluation, which are written anew"}},
    {"validator/database_check.cpp", {{"SqliteFile"}, "dataset.sqlite, from path_inside, to be read"}},
    {"validator/task_rows.cpp", {{"SqliteFile"}, "as above"}},
    {"validator/task_rows.h", {{"SqliteFile"}, "as above"}},
    // Outside of them
    {"akb/compile.cpp", {{"create_directories", "remove", "rename"}, "compiled knowledge of this program"}},
    {"akb/completed.cpp", {{"remove"}, "a table of the user's overrides that became empty"}},
    {"akb/load.cpp", {{"SqliteFile"}, "compiled knowledge"}},
    {"akb/write_database.cpp", {{"SqliteFile"}, "compiled knowledge"}},
    {"cli/evaluation_backend.cpp", {{"mkdtemp", "remove_all"}, "a scratch folder of this process"}},
    {"cli/output.cpp", {{"open"}, "/dev/null in the place of a closed output"}},
    {"core/sqlite_file.cpp", {{"SqliteFile", "sqlite3_open_v2"}, "SQLite opens by path"}},
    {"core/sqlite_file.h", {{"SqliteFile"}, "as above"}},
    {"exports/forms_files.cpp", {{"remove_all"}, "an export of this process that was only to be counted"}},
    {"homes/scene_folder.cpp", {{"remove"}, "a file of this process, to see that a folder can be written to"}},
    {"llm/cache.cpp", {{"SqliteFile", "create_directories"}, "the cache of answers"}},
    {"llm/cache.h", {{"SqliteFile"}, "as above"}},
    {"resources/resources.cpp", {{"create_directories", "rename"}, "compiled knowledge"}},
    {"rewording/batch_folder.cpp", {{"create_directory", "remove"}, "folders that this process made, if empty"}},
    {"templates/stored_templates.cpp", {{"SqliteFile"}, "compiled templates"}},
};

const Names kSpaces{"", "fs", "filesystem"};

bool is_part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The word that ends before `end`.
std::string word_before(std::string_view code, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && is_part_of_name(code[begin - 1])) --begin;
  return std::string(code.substr(begin, end - begin));
}

/// What of the above a code names, outside of comments and literals.
Names touched_by(std::string_view text) {
  std::string code;
  for (const CodePiece& piece : pieces_of(text)) code += piece.kind == CodePiece::Kind::Code ? piece.text : "\"\"";
  Names found;
  for (std::size_t i = 0; i < code.size();) {
    if (!is_part_of_name(code[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < code.size() && is_part_of_name(code[end])) ++end;
    const std::string word = code.substr(i, end - i);
    const bool in_space = i >= 2 && code.compare(i - 2, 2, "::") == 0 && (i == 2 || code[i - 3] != '>');
    const bool calls = in_space && end < code.size() && code[end] == '(' && kSpaces.contains(word_before(code, i - 2));
    if (kOwnNames.contains(word) || (calls && kFunctions.contains(word))) found.insert(word);
    i = end;
  }
  return found;
}

TEST(TouchedBy, SeesCallsOfTheSystemAndOfTheLibraryOnly) {
  EXPECT_THAT(touched_by("int f = ::open(path); fs::remove_all(x); std::filesystem::rename(a, b);"),
              ::testing::ElementsAre("open", "remove_all", "rename"));
  EXPECT_THAT(touched_by("std::ofstream out(p); // ::open(x)\n"), ::testing::ElementsAre("ofstream"));
  EXPECT_THAT(touched_by("LineFile::open(x); RecordFile<Task>::open(x); std::remove_if(a, b); file.open(y); "
                         "\"::open(\"; open_regular_file(z);"),
              ::testing::IsEmpty());
}

TEST(FileAccess, OnlyListedFilesOpenMakeRenameOrRemove) {
  std::map<std::string, Names> found;
  for (const auto& file : source_files({".cpp", ".h"})) {
    const auto name = fs::relative(file, kSources).generic_string();
    if (name.starts_with("tests/") || name.starts_with("bench/")) continue;
    const auto text = read_file(file);
    ASSERT_TRUE(text) << file;
    if (auto names = touched_by(*text); !names.empty()) found.emplace(name, std::move(names));
  }
  EXPECT_GT(found.size(), 10U);  // it did read them
  for (const auto& [file, names] : found) {
    const auto may = kMay.find(file);
    EXPECT_EQ(names, may == kMay.end() ? Names() : may->second.first)
        << file << ": use core/files.h, core/file_writer.h or core/file_place.h, or list it here with the reason";
  }
  for (const auto& [file, unused] : kMay) EXPECT_TRUE(found.contains(file)) << file << " does no such thing any more";
}

}  // namespace
}  // namespace unietp
