#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "core/text.h"
#include "templates/constraint_kinds.h"
#include "templates/template.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

const TemplateReading& folder(const std::string& name) {
  static std::map<std::string, TemplateReading> read;
  const auto found = read.find(name);
  if (found != read.end()) return found->second;
  return read.emplace(name, load_templates(fs::path(UNIETP_SOURCE_DIR) / "templates" / name)).first->second;
}

TEST(ExtendedLibrary, EveryTemplateLoads) {
  std::string errors;
  for (const auto& error : folder("extended").errors) errors += format(error) + "\n";
  EXPECT_EQ(errors, "");
  EXPECT_GE(folder("extended").templates.size(), 9U);
}

TEST(ExtendedLibrary, SharesNoNameAndNoPhrasingWithTheDefaultLibrary) {
  std::set<std::string> names;
  std::map<std::string, std::string> library_of;  // by phrasing
  for (const auto* library : {"library", "extended"}) {
    for (const auto& t : folder(library).templates) {
      EXPECT_TRUE(names.insert(t.name).second) << t.name;
      EXPECT_GE(t.instructions.size(), 1U) << t.name;
      EXPECT_EQ(std::set<std::string>(t.instructions.begin(), t.instructions.end()).size(), t.instructions.size())
          << t.name;
      for (const auto& text : t.instructions)
        EXPECT_EQ(library_of.emplace(text, library).first->second, library) << t.name << ": " << text;
    }
  }
}

/// Two may ask for the same end where another action brings it about: washing and wiping.
TEST(ExtendedLibrary, NoTwoTemplatesAskForTheSameByTheSameMeans) {
  std::map<std::string, std::string> name_of;
  for (const auto* library : {"library", "extended"}) {
    for (const auto& t : folder(library).templates) {
      std::string key = to_text(normal_form(t.goal)) + " " + t.refinement;
      for (const auto& constraint : t.constraints) key += " " + to_text(constraint);
      for (const auto& start : t.init) key += " " + to_text(start);
      const auto [first, added] = name_of.emplace(key, t.name);
      EXPECT_TRUE(added) << t.name << " asks for what " << first->second << " asks for";
    }
  }
}

/// Each comparison of a count with a number, and of two counts in either direction, is that of some task.
TEST(ExtendedLibrary, CountsAreComparedInEachWay) {
  std::string goals;
  for (const auto* library : {"library", "extended"}) {
    for (const auto& t : folder(library).templates) goals += to_text(t.goal);
  }
  for (const char* sign : {"= ", ">= ", "<= ", "> ", "< "})
    EXPECT_NE(goals.find(std::string("(count ") + sign), std::string::npos) << sign;
  EXPECT_NE(goals.find("(count = (number "), std::string::npos);
  EXPECT_NE(goals.find("(count > (number "), std::string::npos);
}

struct Row {
  std::string split, name, library, source, note;
};

/// data/release_templates.csv: split,name,library,template,note; no field has a comma in it.
std::vector<Row> release_map() {
  std::ifstream file(fs::path(UNIETP_SOURCE_DIR) / "data/release_templates.csv");
  std::vector<Row> rows;
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "split,name,library,template,note");
  while (std::getline(file, line)) {
    const auto fields = split(line, ',');
    EXPECT_EQ(fields.size(), 5U) << line;
    if (fields.size() == 5) rows.push_back({fields[0], fields[1], fields[2], fields[3], fields[4]});
  }
  return rows;
}

/// The counts are those of the paper's released data set.
TEST(ReleaseMap, NamesEachOfTheHundredAndFortySixOnce) {
  std::map<std::string, int> count;
  std::set<std::string> names;
  for (const auto& row : release_map()) {
    ++count[row.split];
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " stands twice";
  }
  EXPECT_EQ(names.size(), 146U);
  EXPECT_EQ(count["atomic"], 20);
  EXPECT_EQ(count["compositional"], 64);
  EXPECT_EQ(count["logical"], 62);
}

TEST(ReleaseMap, EveryNameHasATemplateInTheLibraryThatItNames) {
  for (const auto& row : release_map()) {
    ASSERT_TRUE(row.library == "default" || row.library == "extended") << row.name << ": " << row.library;
    const auto& templates = folder(row.library == "default" ? "library" : "extended").templates;
    const auto found =
        std::find_if(templates.begin(), templates.end(), [&](const Template& t) { return t.name == row.source; });
    ASSERT_NE(found, templates.end()) << row.name << " -> " << row.source;
    EXPECT_TRUE(name_of(found->split) == row.split || !row.note.empty())
        << row.name << " -> " << row.source << " is of another class, and no note says so";
  }
}

}  // namespace
}  // namespace unietp
