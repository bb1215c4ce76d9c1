// Ids that objects of imported scenes keep, and what exports make of them.
#include "interchange/own_ids.h"

#include <filesystem>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "import_rates.h"
#include "interchange/formats.h"
#include "interchange/import_scene.h"
#include "simulation/profile.h"
#include "small_home.h"

namespace unietp::testing {
namespace {

using ::testing::ElementsAre;
using Json = nlohmann::json;

TEST(OwnIds, AreTheSimulatorsAndGiveItsIdBack) {
  for (const auto& [simulator, in_file, category, asset, id] :
       {std::tuple{Simulator::Ai2thor, "Mug|surface|2|3", "Mug", "Mug_1", "Mug|surface|2|3"},
        std::tuple{Simulator::Virtualhome, "193", "plate", "", "plate.193"},
        std::tuple{Simulator::Habitat, "frl_apartment_cup_3", "cup", "", "frl_apartment_cup_:0003"},
        std::tuple{Simulator::Behavior, "mug_ppzttc_0", "mug", "mug-ppzttc", "mug_ppzttc_0"}}) {
    SourceObject object;
    object.id = in_file, object.asset = asset;
    Node node;
    node.category = category, node.asset = asset;
    node.id = simulators_id(object, simulator, category);
    EXPECT_EQ(node.id, id);
    const std::string theirs = simulator == Simulator::Virtualhome ? in_file : id;
    EXPECT_EQ(own_id_of(node, simulator), theirs);
    node.id = node.category + "_3";
    EXPECT_EQ(own_id_of(node, simulator), std::nullopt) << node.id;
  }
  SourceObject box;
  box.id = "box_4";
  EXPECT_EQ(simulators_id(box, Simulator::Habitat, "chair"), "") << "a table of boxes names no models";
  EXPECT_EQ(simulators_id(box, Simulator::Virtualhome, "chair"), "");
}

/// Two mugs of VirtualHome's graph keep their numbers, and a third one of ours gets one that is free.
TEST(OwnIds, AreWhatVirtualhomesGraphHasAgain) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Virtualhome);
  Scene scene = small_home(knowledge, 3);
  ASSERT_GE(scene.nodes.size(), 3U);
  for (std::size_t i = 0; i < 2; ++i) {
    Node& node = scene.nodes.edit(i);
    node.id = node.category + "." + std::to_string(i + 1);  // numbers that rooms would get otherwise
  }
  scene.edges = {};
  scene.openings = {};  // which name the room
  scene.rooms.front().id = scene.rooms.front().type + ".20";
  const auto written = write_virtualhome(scene, knowledge, format_facts());
  ASSERT_TRUE(written);
  std::set<int> numbers;
  const Json graph = Json::parse(written->text);
  for (const auto& node : graph["nodes"]) EXPECT_TRUE(numbers.insert(node["id"].get<int>()).second);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(written->names.at(scene.nodes[i].id), scene.nodes[i].category + "_" + std::to_string(i + 1));
  EXPECT_EQ(graph["nodes"][0]["category"], "Rooms");
  EXPECT_EQ(graph["nodes"][0]["id"], 20) << "the room's own number";
}

/// Two rooms, of which the second is the fourth that ProcTHOR numbered, and a door between them.
const std::string kHouse = R"({"rooms": [
  {"id": "room|2", "roomType": "Kitchen", "floorPolygon": [[0, 0, 0], [0, 0, 4], [4, 0, 4], [4, 0, 0]]},
  {"id": "room|5", "roomType": "Bedroom", "floorPolygon": [[4, 0, 0], [4, 0, 4], [8, 0, 4], [8, 0, 0]]}],
 "walls": [{"id": "wall|2", "roomId": "room|2", "polygon": [[4, 0, 0], [4, 0, 4], [4, 3, 4], [4, 3, 0]]}],
 "doors": [{"id": "door|2|5", "room0": "room|2", "room1": "room|5", "wall0": "wall|2",
            "holePolygon": [[1, 0, 0], [2, 2, 0]]}],
 "objects": [{"id": "Bed|5|0", "objectType": "Bed", "assetId": "Bed_1", "position": [6, 0.4, 2]}]})";

std::vector<std::string> room_ids(const std::vector<Room>& rooms) {
  std::vector<std::string> ids;
  for (const Room& room : rooms) ids.push_back(room.id);
  return ids;
}

TEST(OwnIds, OfRoomsTellTheHousesAndAreInItAgain) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const auto read = read_procthor("house", kHouse, knowledge);
  ASSERT_TRUE(read) << format(read.error());
  const auto profile = load_profile(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/simulators", Simulator::Ai2thor);
  ASSERT_TRUE(profile) << format(profile.error());
  const auto imported = [&](bool own_ids) {
    ImportOptions how;
    how.own_ids = own_ids;
    auto made = assemble(read->front(), knowledge, *profile, format_facts(), how);
    EXPECT_TRUE(made) << format(made.error());
    return made->scene;
  };
  EXPECT_THAT(room_ids(imported(false).rooms), ElementsAre("kitchen_1", "bedroom_1"));
  const Scene own = imported(true);
  EXPECT_THAT(room_ids(own.rooms), ElementsAre("kitchen|2", "bedroom|5"));
  ASSERT_EQ(own.openings.size(), 1U);
  EXPECT_EQ(own.openings.front().room_a + " " + own.openings.front().room_b, "kitchen|2 bedroom|5");
  EXPECT_TRUE(has_edge(own, Predicate::InRoom, "Bed|5|0", "bedroom|5"));
  Scene scene;
  scene.simulator = Simulator::Ai2thor;
  scene.rooms = {own.rooms[1], own.rooms[0]};  // in whatever order
  scene.openings = own.openings;
  EXPECT_THAT(procthor_room_ids(scene), ElementsAre("room|5", "room|2"));
  const auto written = write_procthor(scene, knowledge, format_facts());
  ASSERT_TRUE(written) << format(written.error());
  const Json house = Json::parse(written->text);
  EXPECT_EQ(house["rooms"][0]["id"], "room|5");
  for (const auto& wall : house["walls"]) {
    const auto id = wall["id"].get<std::string>(), room = wall["roomId"].get<std::string>();
    EXPECT_TRUE(id.starts_with("wall|exterior|") || id.starts_with("wall|" + room.substr(5) + "|"))
        << id << " " << room;
  }
  scene.rooms.insert(scene.rooms.begin(), {{"hall_1", "hall", {}}, {"hall_2", "hall", {}}, {"hall_3", "hall", {}}});
  EXPECT_THAT(procthor_room_ids(scene), ElementsAre("room|3", "room|4", "room|6", "room|5", "room|2"))
      << "rooms of ours get numbers that are free";
}

TEST(OwnIds, OfRoomsGiveTheFilesBack) {
  for (const auto& [simulator, in_file, id] :
       {std::tuple{Simulator::Ai2thor, "room|12", "kitchen|12"}, std::tuple{Simulator::Virtualhome, "11", "kitchen.11"},
        std::tuple{Simulator::Ai2thor, "room|x", ""}, std::tuple{Simulator::Ai2thor, "12", ""},
        std::tuple{Simulator::Virtualhome, "room|12", ""}, std::tuple{Simulator::Behavior, "kitchen_0", ""}}) {
    const Room room{simulators_room_id("kitchen", in_file, simulator), "kitchen", {}};
    EXPECT_EQ(room.id, id);
    EXPECT_EQ(own_id_of(room, simulator).value_or(""), room.id.empty() ? "" : in_file);
    EXPECT_EQ(own_id_of(Room{"kitchen_1", "kitchen", {}}, simulator), std::nullopt);
  }
}

}  // namespace
}  // namespace unietp::testing
