// Ids that objects of imported scenes keep, and what exports make of them.
#include "interchange/own_ids.h"

#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "import_rates.h"
#include "interchange/formats.h"
#include "small_home.h"

namespace unietp::testing {
namespace {

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
  const auto written = write_virtualhome(scene, knowledge, format_facts());
  ASSERT_TRUE(written);
  std::set<int> numbers;
  const Json graph = Json::parse(written->text);
  for (const auto& node : graph["nodes"]) EXPECT_TRUE(numbers.insert(node["id"].get<int>()).second);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(written->names.at(scene.nodes[i].id), scene.nodes[i].category + "_" + std::to_string(i + 1));
}

}  // namespace
}  // namespace unietp::testing
