#include "includes.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const fs::path kSource = UNIETP_SOURCE_DIR;

RoomGraph declared() {
  const auto text = read_file(UNIETP_ROOM_GRAPH);
  EXPECT_TRUE(text) << "cmake/Room.cmake should have written room_graph.txt";
  return read_room_graph(text ? *text : "");
}

std::vector<std::string> sources_of(const std::string& room) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / room)) {
    const auto extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") files.push_back(fs::relative(entry.path(), kSource).generic_string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(House, NoDeclaredArrowRunsUpwards) {
  const auto graph = declared();
  EXPECT_THAT(graph_problems(graph), IsEmpty());
}

TEST(House, TheDeclaredArrowsAreExactlyThoseOfTheIncludes) {
  const auto graph = declared();
  int includes = 0;
  for (const auto& room : graph.rooms) {
    std::vector<std::string> texts;
    for (const auto& path : sources_of(room)) {
      auto text = read_file(kSource / path);
      ASSERT_TRUE(text) << path;
      EXPECT_THAT(include_problems(graph, path, *text), IsEmpty());
      includes += static_cast<int>(split(*text, '#').size()) - 1;
      texts.push_back(std::move(*text));
    }
    EXPECT_THAT(unused_arrows(graph, room, texts), IsEmpty());
  }
  EXPECT_GT(includes, 500);  // it did read the house
}

TEST(House, NoTwoRoomsDefineATypeOfOneName) {
  std::map<std::string, std::string> room_of_type;
  for (const auto& room : declared().rooms) {
    for (const auto& path : sources_of(room)) {
      const auto text = read_file(kSource / path);
      ASSERT_TRUE(text) << path;
      for (const auto& type : types_defined(*text)) {
        const auto [place, is_new] = room_of_type.emplace(type, room);
        EXPECT_TRUE(is_new || place->second == room)
            << path << " defines " << type << ", as " << place->second << " does";
      }
    }
  }
  EXPECT_GT(room_of_type.size(), 100U);  // it did read the house
}

TEST(House, NoFilesOfARoomIncludeOneAnotherInACircle) {
  for (const auto& room : declared().rooms) {
    std::map<std::string, std::string> texts;
    for (const auto& path : sources_of(room)) {
      const auto text = read_file(kSource / path);
      ASSERT_TRUE(text) << path;
      texts.emplace(path, *text);
    }
    EXPECT_THAT(file_circles(texts), IsEmpty()) << "in " << room;
  }
}

/// A library or mechanism that only the files named here may use, so that all others go through them.
TEST(House, OneFileOwnsSqliteAndOneOwnsThreads) {
  const std::map<std::string, std::string> owners{{"#include <sqlite3.h>", "core/sqlite_file.cpp"},
                                                  {"#include <thread>", "core/share_work.cpp"},
                                                  {"#include <future>", ""}};
  for (const auto& room : declared().rooms) {
    for (const auto& path : sources_of(room)) {
      const auto text = read_file(kSource / path);
      ASSERT_TRUE(text) << path;
      for (const auto& [use, owner] : owners) {
        EXPECT_EQ(text->find(use) != std::string::npos, path == owner) << use << " in " << path;
      }
    }
  }
}

/// A newcomer's map is the README's table: it must say what the build says.
TEST(House, TheReadmeTableNamesTheDeclaredArrows) {
  const auto readme = read_file(kSource / "README.md");
  ASSERT_TRUE(readme);
  const auto graph = declared();
  std::size_t found = 0;
  for (const auto& line : split(*readme, '\n')) {
    const auto cells = split(line, '|');
    if (cells.size() < 4) continue;
    for (const auto& room : graph.rooms) {
      if (trim(cells[1]) != "`" + room + "/`") continue;
      ++found;
      const auto depends = graph.depends.find(room);
      const auto told = depends == graph.depends.end() ? std::string("–") : join(depends->second, ", ");
      EXPECT_EQ(trim(cells[3]), told) << room;
    }
  }
  EXPECT_EQ(found, graph.rooms.size());
}

const RoomGraph kSmall = read_room_graph("core: \nlogic: core\nscene: logic\nakb: scene\n");

TEST(IncludeProblems, ASoundFileHasNone) {
  EXPECT_THAT(include_problems(kSmall, "scene/a.h",
                               "#include <vector>\n#include <sys/file.h>\n#include <Eigen/Core>\n"
                               "#include <nlohmann/json_fwd.hpp>\n#include \"logic/trace.h\"\n"),
              IsEmpty());
  EXPECT_THAT(include_problems(kSmall, "logic/a.cpp", "#include <nlohmann/json.hpp>\n#include \"logic/a.h\"\n"),
              IsEmpty());
}

TEST(IncludeProblems, AnUpwardOrUndeclaredArrowIsNamedWithItsLine) {
  EXPECT_THAT(include_problems(kSmall, "logic/a.cpp", "#include \"logic/a.h\"\n\n#include \"akb/knowledge.h\"\n"),
              ElementsAre(HasSubstr("logic/a.cpp:3: logic may not include akb")));
  EXPECT_THAT(include_problems(kSmall, "core/a.h", "#include \"logic/trace.h\"\n"),
              ElementsAre(HasSubstr("core may not include logic")));
  EXPECT_THAT(include_problems(kSmall, "core/a.h", "#include \"text.h\"\n"), ElementsAre(HasSubstr("in no room")));
}

TEST(IncludeProblems, AnArrowThatOnlyAnotherRoomDeclaresIsRefused) {
  EXPECT_THAT(include_problems(kSmall, "scene/a.h", "#include \"core/text.h\"\n"),
              ElementsAre(HasSubstr("scene/a.h:1: scene may not include core")));
}

TEST(UnusedArrows, AreThoseThatNoFileOfTheRoomIncludes) {
  EXPECT_THAT(unused_arrows(kSmall, "akb", {"#include <vector>\n", "#include \"scene/scene.h\"\n"}), IsEmpty());
  EXPECT_THAT(unused_arrows(kSmall, "akb", {"#include \"akb/facts.h\"\n"}),
              ElementsAre("akb declares scene, but none of its files includes it"));
}

TEST(IncludeProblems, AThirdPartysHeaderInAHeaderIsRefused) {
  EXPECT_THAT(include_problems(kSmall, "akb/a.h", "#include <sqlite3.h>\n"), ElementsAre(HasSubstr("third party")));
  EXPECT_THAT(include_problems(kSmall, "akb/a.h", "#include <Eigen/Core>\n"), ElementsAre(HasSubstr("third party")));
  EXPECT_THAT(include_problems(kSmall, "scene/a.h", "#include <nlohmann/json.hpp>\n"),
              ElementsAre(HasSubstr("third party")));
}

TEST(FileCircles, AreFoundThroughOthersAndThroughSourceFiles) {
  EXPECT_THAT(file_circles({{"akb/a.h", "#include \"akb/b.h\"\n"},
                            {"akb/b.cpp", "#include \"akb/b.h\"\n#include \"akb/c.h\"\n"},
                            {"akb/b.h", "#include <vector>\n"},
                            {"akb/c.h", "#include \"akb/a.h\"\n"},
                            {"akb/d.cpp", "#include \"akb/a.h\"\n"}}),
              ElementsAre(ElementsAre("akb/a", "akb/b", "akb/c")));
}

TEST(FileCircles, TwoThatDoNotMeetAreTwo) {
  EXPECT_THAT(file_circles({{"akb/a.h", "#include \"akb/b.h\"\n"},
                            {"akb/b.h", "#include \"akb/a.h\"\n#include \"akb/c.h\"\n"},
                            {"akb/c.h", "#include \"akb/d.h\"\n"},
                            {"akb/d.h", "#include \"akb/c.h\"\n"}}),
              ElementsAre(ElementsAre("akb/a", "akb/b"), ElementsAre("akb/c", "akb/d")));
}

TEST(FileCircles, AHeaderWithItsSourcesIsNone) {
  EXPECT_THAT(file_circles({{"akb/a.h", "#include \"akb/b.h\"\n"},
                            {"akb/a.cpp", "#include \"akb/a.h\"\n#include \"core/text.h\"\n"},
                            {"akb/a_more.cpp", "#include \"akb/a.h\"\n"},
                            {"akb/b.h", ""}}),
              IsEmpty());
}

TEST(TypesDefined, AreThoseOfTheProjectsNamespaceOnly) {
  EXPECT_THAT(types_defined("namespace unietp {\nnamespace {\nstruct Hidden {\n};\n}  // namespace\nstruct Seen {\n"
                            "enum class Kind : int {\nclass [[nodiscard]] Result {\nstruct Later;\n"
                            "struct Seen::Impl {\n}  // namespace unietp\n"),
              ElementsAre("Seen", "Kind", "Result"));
  EXPECT_THAT(types_defined("namespace unietp::monitoring {\nstruct Node {\n"), IsEmpty());
}

TEST(GraphProblems, ArrowsUpwardsAndToNowhereAreFound) {
  const auto graph = read_room_graph("core: logic\nlogic: core;attic\n");
  EXPECT_THAT(graph_problems(graph),
              ElementsAre("core declares logic, which stands above it", "logic declares attic, which is no room"));
}

}  // namespace
}  // namespace unietp
