#include "homes/given_scenes.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A folder with scene files, and a backend that knows mugs.
class GivenScenesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "unietp-scenes-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    Category mug;
    mug.name = "Mug";
    mug.movable = true;
    for (const auto simulator : kSimulators) {
      Knowledge knowledge(simulator, {mug}, {}, {}, {}, {});
      NounTable nouns(knowledge, {});
      backends_.push_back({std::move(knowledge), Profile{}, std::move(nouns)});
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static Scene scene(const std::string& id, const std::string& category) {
    Scene scene;
    scene.id = id;
    scene.simulator = Simulator::Habitat;
    scene.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}}};
    Node node;
    node.id = "mug_1";
    node.category = category;
    node.size = {0.1, 0.1, 0.1};
    scene.nodes = {node};
    return scene;
  }
  void write(const std::string& file, const Scene& scene) {
    const std::string text = scene_to_json(scene);
    ASSERT_TRUE(write_file(folder_ / file, file.ends_with(".gz") ? gzip(text) : text));
  }

  std::filesystem::path folder_;
  std::vector<Backend> backends_;
};

TEST_F(GivenScenesTest, AreReadFromFilesAndFoldersInOrderOfId) {
  write("b.scene.json.gz", scene("first", "Mug"));
  write("a.scene.json", scene("second", "Mug"));
  ASSERT_TRUE(write_file(folder_ / "notes.txt", "not a scene"));
  const auto given = read_given_scenes({folder_}, backends_);
  ASSERT_TRUE(given.errors.empty()) << format(given.errors.front());
  ASSERT_EQ(given.scenes.size(), 2U);
  EXPECT_EQ(given.scenes[0], scene("first", "Mug"));
  EXPECT_THAT(given.names, ElementsAre(StartsWith("first "), StartsWith("second ")));
}

TEST_F(GivenScenesTest, EveryProblemOfEveryFileIsTold) {
  write("a.scene.json", scene("home", "Mug"));
  write("b.scene.json", scene("home", "Mugg"));
  ASSERT_TRUE(write_file(folder_ / "c.scene.json", "{"));
  const auto given = read_given_scenes({folder_, folder_ / "none.scene.json"}, backends_);
  ASSERT_EQ(given.errors.size(), 4U);
  EXPECT_THAT(format(given.errors[0]), HasSubstr("no category \"Mugg\", did you mean \"Mug\""));
  EXPECT_THAT(format(given.errors[1]), HasSubstr("c.scene.json:1:2"));
  EXPECT_THAT(format(given.errors[2]), HasSubstr("none.scene.json"));
  EXPECT_THAT(format(given.errors[3]), HasSubstr("has the id \"home\""));
}

TEST_F(GivenScenesTest, AnIdThatCanNameNoFileIsRefused) {
  for (const auto& id : {std::string("../home"), std::string(201, 'h'), std::string("a\0b", 3)}) {
    write("a.scene.json", scene(id, "Mug"));
    const auto given = read_given_scenes({folder_}, backends_);
    ASSERT_EQ(given.errors.size(), 1U) << id;
    EXPECT_THAT(format(given.errors[0]), HasSubstr("letters, digits"));
  }
}

TEST_F(GivenScenesTest, AFolderWithoutScenesIsRefused) {
  const auto given = read_given_scenes({folder_}, backends_);
  ASSERT_EQ(given.errors.size(), 1U);
  EXPECT_THAT(format(given.errors[0]), HasSubstr("contains no scene"));
}

}  // namespace
}  // namespace unietp
