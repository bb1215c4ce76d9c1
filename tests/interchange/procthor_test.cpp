#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "import_rates.h"
#include "interchange/formats.h"
#include "interchange/model_choice.h"
#include "interchange/unity.h"
#include "small_home.h"
#include "tests/support/needs.h"

namespace unietp::testing {
namespace {

std::vector<SourceScene> real_houses() {
  std::vector<SourceScene> all;
  for (const char* set : {"train", "val", "2to3_rooms", "other"}) {
    const auto text = read_maybe_gzip(upstream() / ("ai2thor/procthor_houses_" + std::string(set) + ".jsonl.gz"));
    if (!text) continue;
    auto houses = read_procthor(set, *text, committed_knowledge(Simulator::Ai2thor));
    EXPECT_TRUE(houses) << format(houses.error());
    if (!houses) continue;
    for (auto& house : *houses) {
      house.id = std::string(set) + "_" + house.id;
      all.push_back(std::move(house));
    }
  }
  return all;
}

TEST(Procthor, RealHousesArriveAndHold) {
  const auto houses = real_houses();
  if (houses.empty()) GTEST_SKIP() << needs::kSimulatorFiles;
  const char* whole = std::getenv("UNIETP_WHOLE_IMPORT");
  const auto all = import_all(houses, whole ? 1 : 31);
  for (const auto& [scene, report, not_at_rest] : all) {
    SCOPED_TRACE(scene);
    EXPECT_GE(arrived_share(report), 0.95);
    EXPECT_GE(held_share(report), 0.9);
    EXPECT_LE(not_at_rest, 1u);
    if (!whole) continue;
    std::cout << scene << " objects " << report.objects << " known " << report.known << " arrived " << report.arrived
              << " stayed " << report.stayed << " relations " << report.relations << " held " << report.relations_held
              << " loose " << report.loose << " held " << report.loose_held << "\n";
    for (const auto& issue : report.issues) {
      std::cout << "  " << name_of(issue.reason) << ": " << issue.object << " " << issue.category << ": "
                << issue.detail << "\n";
    }
  }
  std::cout << table_row("procthor", all) << "\n";
}

/// The rotation of the one object of a house whose field `rotation` is this.
Quat rotation_read(const std::string& rotation) {
  const auto houses = read_procthor("house",
                                    R"({"rooms": [{"id": "room|2", "roomType": "Kitchen", "floorPolygon": )"
                                    R"([[0, 0, 0], [0, 0, 4], [4, 0, 4]]}], "objects": [{"id": "Mug|2|0", )"
                                    R"("assetId": "Mug_1", "position": [1, 0.05, 2], "rotation": )" +
                                        rotation + "}]}",
                                    committed_knowledge(Simulator::Ai2thor));
  EXPECT_TRUE(houses) << format(houses.error());
  return houses ? houses->front().objects.front().pose.rotation : Quat::Identity();
}

TEST(Procthor, AnAxisAndAnAngleTurnTheSameWayAsEulerAngles) {
  const auto same = [](const std::string& axis, double degrees, const std::string& euler) {
    const auto turn = std::to_string(degrees);
    const Quat read = rotation_read(R"({"axis": )" + axis + R"(, "degrees": )" + turn + "}");
    EXPECT_LT(read.angularDistance(rotation_read(euler)), 1e-6) << axis << " " << turn;
  };
  same("[0, 1, 0]", 30, "[0, 30, 0]");
  same("[0, -1, 0]", 30, "[0, -30, 0]");
  same("[0, 2, 0]", -75, "[0, -75, 0]");
  same("[1, 0, 0]", 40, "[40, 0, 0]");
  same("[0, 0, 1]", 50, "[0, 0, 50]");
  same("[0, 0, 0]", 50, "[0, 0, 0]");
  // Unity turns clockwise seen from above: a quarter turns what looks along its z, our y, to x.
  const Quat quarter = rotation_read(R"({"axis": [0, 1, 0], "degrees": 90})");
  EXPECT_LT((quarter * -Vec3::UnitY() - Vec3::UnitX()).norm(), 1e-6);
}

TEST(Procthor, WallsAreAsHighAsTheHouseSaysAndAnAgentLooksAheadUnlessItSaysOtherwise) {
  const auto read = [](const std::string& walls, const std::string& agent) {
    auto houses = read_procthor(
        "house",
        R"({"rooms": [{"id": "room|1", "roomType": "Kitchen", "floorPolygon": [{"x": 0, "y": 0, "z": 0}, )"
        R"({"x": 4, "y": 0, "z": 0}, {"x": 4, "y": 0, "z": 4}, {"x": 0, "y": 0, "z": 4}]}], "walls": [)" +
            walls + R"(], "objects": [], "metadata": {"agent": {"position": {"x": 1, "y": 0.9, "z": 2})" + agent +
            "}}}",
        committed_knowledge(Simulator::Ai2thor));
    EXPECT_TRUE(houses) << format(houses.error());
    return houses->front();
  };
  const std::string wall =
      R"({"id": "wall|1", "roomId": "room|1", "polygon": [{"x": 0, "y": 0, "z": 0}, {"x": 4, "y": 0, "z": 0}, )"
      R"({"x": 4, "y": 3.25, "z": 0}, {"x": 0, "y": 3.25, "z": 0}]})";
  const auto high = read(wall, R"(, "rotation": {"x": 0, "y": 90, "z": 0}, "horizon": 30)");
  EXPECT_NEAR(high.wall_height, 3.25, 1e-9);
  EXPECT_NEAR(high.agent.pitch, std::numbers::pi / 6, 1e-6);  // down
  const auto usual = read("", "");
  EXPECT_NEAR(usual.wall_height, SourceScene().wall_height, 1e-9);
  const auto turned = read("", R"(, "rotation": {"x": 0, "y": 0, "z": 0})");
  EXPECT_NEAR(usual.agent.yaw, turned.agent.yaw, 1e-9);
}

/// Nodes of one scene that the other has no equal of: same category, middle within 2 cm, extents within 1 cm.
std::vector<std::string> without_equal(const Scene& scene, const Scene& other, const std::vector<std::string>& except) {
  std::vector<std::string> missing;
  std::vector<bool> taken(other.nodes.size(), false);
  for (const Node& node : scene.nodes) {
    bool found = std::any_of(except.begin(), except.end(),
                             [&](const std::string& text) { return text.starts_with(node.id + ":"); });
    for (std::size_t k = 0; k < other.nodes.size() && !found; ++k) {
      const Node& twin = other.nodes[k];
      const Bounds a = bounds_of(node.pose, node.size), b = bounds_of(twin.pose, twin.size);
      found = !taken[k] && twin.category == node.category && (node.pose.position - twin.pose.position).norm() < 0.02 &&
              ((a.low - b.low).cwiseAbs().maxCoeff() < 0.03 && (a.high - b.high).cwiseAbs().maxCoeff() < 0.03);
      if (found) taken[k] = true;
    }
    if (!found) missing.push_back(node.id);
  }
  return missing;
}

void expect_same_plan(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.rooms.size(), b.rooms.size());
  for (std::size_t i = 0; i < a.rooms.size(); ++i) {
    ASSERT_EQ(a.rooms[i].polygon.size(), b.rooms[i].polygon.size());
    for (const Vec2& corner : a.rooms[i].polygon) {
      EXPECT_TRUE(std::any_of(b.rooms[i].polygon.begin(), b.rooms[i].polygon.end(),
                              [&](const Vec2& twin) { return (corner - twin).norm() < 0.001; }));
    }
  }
  ASSERT_EQ(a.openings.size(), b.openings.size());
  for (const Opening& one : a.openings) {
    EXPECT_TRUE(std::any_of(b.openings.begin(), b.openings.end(), [&](const Opening& two) {
      const bool same_way = (one.from - two.from).norm() + (one.to - two.to).norm() < 0.02;
      const bool other_way = (one.from - two.to).norm() + (one.to - two.from).norm() < 0.02;
      return std::abs(one.height - two.height) < 0.01 && (same_way || other_way);
    })) << one.id;
  }
  EXPECT_NEAR(a.wall_height, b.wall_height, 0.001);
  EXPECT_LT((a.agent.position - b.agent.position).norm(), 0.001);
  EXPECT_NEAR(std::cos(a.agent.yaw - b.agent.yaw), 1, 1e-6);
  EXPECT_NEAR(a.agent.pitch, b.agent.pitch, 1e-4);
}

TEST(Procthor, AWallIsNamedByItsRoomAndItsEndsInTwoDecimals) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const auto written = write_procthor(small_home(knowledge, 1), knowledge, format_facts());
  ASSERT_TRUE(written) << format(written.error());
  const auto house = nlohmann::json::parse(written->text);
  ASSERT_GE(house["walls"].size(), 8U);
  for (const auto& wall : house["walls"]) {
    const auto parts = split(wall["id"].get<std::string>(), '|');
    ASSERT_EQ(parts.size(), 6U) << wall["id"];
    double x[] = {1e9, -1e9}, z[] = {1e9, -1e9};
    for (const auto& corner : wall["polygon"]) {
      x[0] = std::min(x[0], corner["x"].get<double>());
      x[1] = std::max(x[1], corner["x"].get<double>());
      z[0] = std::min(z[0], corner["z"].get<double>());
      z[1] = std::max(z[1], corner["z"].get<double>());
    }
    EXPECT_NEAR(std::stod(parts[2]), x[0], 0.006) << wall["id"];
    EXPECT_NEAR(std::stod(parts[3]), z[0], 0.006) << wall["id"];
    EXPECT_NEAR(std::stod(parts[4]), x[1], 0.006) << wall["id"];
    EXPECT_NEAR(std::stod(parts[5]), z[1], 0.006) << wall["id"];
    EXPECT_EQ(wall["id"].get<std::string>().find("-0.00"), std::string::npos) << wall["id"];
  }
}

/// The models of knives stand on an edge, and those of laptops have their lids up.
TEST(Procthor, AKnifeLiesFlatAndALaptopIsShut) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  Scene scene = small_home(knowledge, 1);
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : scene.rooms[0].polygon)
    middle += corner / static_cast<double>(scene.rooms[0].polygon.size());
  for (const char* const category : {"Knife", "Laptop"}) {
    const Category& kind = *knowledge.find(category);
    Node node;
    node.id = category;
    node.category = category;
    node.movable = true;
    node.archetype = kind.archetype;
    node.openable = knowledge.has(category, "openable");
    node.size = kind.size;
    node.pose.position << middle, node.size.z() / 2;
    node.states.set({Predicate::Closed, ""});
    scene.nodes.push_back(node);
  }
  const auto written = write_procthor(scene, knowledge, format_facts());
  ASSERT_TRUE(written) << format(written.error());
  for (const char* const id : {"Knife", "Laptop"}) {
    ASSERT_TRUE(written->names.contains(id)) << ::testing::PrintToString(written->left_out);
  }
  const auto house = nlohmann::json::parse(written->text);
  const auto object = [&](const std::string& id) {
    for (const auto& one : house["objects"]) {
      if (one["id"] == written->names.at(id)) return one;
    }
    return nlohmann::json();
  };
  const auto knife = object("Knife"), laptop = object("Laptop");
  const auto turned = [&](const char* axis) { return knife["rotation"][axis].get<double>(); };
  const Vec3 lies = rotation_from_unity(Vec3(turned("x"), turned("y"), turned("z"))).toRotationMatrix().cwiseAbs() *
                    knowledge.asset(knife["assetId"].get<std::string>())->size;
  EXPECT_LT((lies - knowledge.find("Knife")->size).cwiseAbs().maxCoeff(), 0.01) << lies.transpose();
  EXPECT_NEAR(knife["position"]["y"], lies.z() / 2, 0.001);
  EXPECT_EQ(laptop["openness"], 0.0);
  EXPECT_GT(knowledge.asset(laptop["assetId"].get<std::string>())->size.z(), 0.1);
}

/// A home without objects.
Scene empty_home(const Knowledge& knowledge) {
  Scene scene = small_home(knowledge, 1);
  scene.nodes.clear();
  scene.edges.clear();
  return scene;
}

Vec2 middle_of(const Room& room) {
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : room.polygon) middle += corner / static_cast<double>(room.polygon.size());
  return middle;
}

/// In our physics a phone can lie on a plant, and a plant on a table.
TEST(Procthor, WhatLiesOnAPlantIsOfWhatThePlantStandsOn) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  Scene scene = empty_home(knowledge);
  const Vec2 middle = middle_of(scene.rooms[0]);
  double height = 0;
  for (const char* const category : {"DiningTable", "HousePlant", "CellPhone"}) {
    Node node;
    node.id = node.category = category;
    node.movable = category != std::string("DiningTable");
    node.size = knowledge.find(category)->size;
    node.pose.position << middle, height + node.size.z() / 2;
    height += node.size.z();
    scene.nodes.push_back(node);
  }
  scene.edges = {{Predicate::On, "HousePlant", "DiningTable"}, {Predicate::On, "CellPhone", "HousePlant"}};
  const auto written = write_procthor(scene, knowledge, format_facts());
  ASSERT_TRUE(written) << format(written.error());
  const auto house = nlohmann::json::parse(written->text);
  ASSERT_EQ(house["objects"].size(), 1U) << ::testing::PrintToString(written->left_out);
  std::set<std::string> on_table;
  for (const auto& child : house["objects"][0]["children"]) {
    on_table.insert(child["objectType"].get<std::string>());
    EXPECT_FALSE(child.contains("children"));
  }
  EXPECT_EQ(on_table, (std::set<std::string>{"CellPhone", "HousePlant"}));
}

TEST(Procthor, WhatMayNotLieWhereItLiesIsLeftOutWithWhatItHolds) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  Scene scene = empty_home(knowledge);
  const Vec2 middle = middle_of(scene.rooms[0]);
  for (const char* const category : {"DiningTable", "Bowl", "Egg", "CellPhone"}) {
    Node node;
    node.id = node.category = category;
    node.movable = category != std::string("DiningTable");
    node.size = knowledge.find(category)->size;
    node.pose.position << middle, node.size.z() / 2;
    scene.nodes.push_back(node);
  }
  scene.edges = {{Predicate::On, "Bowl", "DiningTable"},
                 {Predicate::Inside, "Egg", "Bowl"},
                 {Predicate::On, "CellPhone", "DiningTable"}};
  const auto names_with = [&](const MayHold& may_hold) {
    const auto written = write_procthor(scene, knowledge, format_facts(), may_hold);
    EXPECT_TRUE(written) << format(written.error());
    std::set<std::string> names;
    for (const auto& [id, name] : written->names) {
      names.insert(id);
      EXPECT_EQ(written->models.count(id), 1U);
      EXPECT_NE(written->text.find(name), std::string::npos);
    }
    for (const std::string id : {"Bowl", "Egg", "CellPhone"}) {
      const bool there = written->text.find("\"objectType\": \"" + id + "\"") != std::string::npos;
      EXPECT_EQ(there, names.contains(id)) << id;
    }
    return std::pair(names, written->left_out);
  };
  EXPECT_EQ(names_with({}).first, (std::set<std::string>{"Bowl", "CellPhone", "DiningTable", "Egg"}));
  const auto [names, left_out] =
      names_with([](const std::string& thing, const std::string&) { return thing != "Bowl"; });
  EXPECT_EQ(names, (std::set<std::string>{"CellPhone", "DiningTable"}));
  const std::string why = ": no table of AI2-THOR's has Bowl on or in DiningTable";
  EXPECT_EQ(left_out, (std::vector<std::string>{"Bowl" + why, "Egg" + why}));
}

TEST(Procthor, AHouseThatIsWrittenAndReadIsTheSameHome) {
  const auto houses = real_houses();
  if (houses.empty()) GTEST_SKIP() << needs::kSimulatorFiles;
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  for (std::size_t i = 0; i < houses.size(); i += 41) {
    SCOPED_TRACE(houses[i].id);
    const auto first = assemble(houses[i], knowledge, profile_of(Simulator::Ai2thor), format_facts());
    ASSERT_TRUE(first) << format(first.error());
    const auto written = write_procthor(first->scene, knowledge, format_facts());
    ASSERT_TRUE(written) << format(written.error());
    const auto read = read_procthor("written", written->text, knowledge);
    ASSERT_TRUE(read) << format(read.error());
    ASSERT_EQ(read->size(), 1u);
    const auto second = assemble(read->front(), knowledge, profile_of(Simulator::Ai2thor), format_facts());
    ASSERT_TRUE(second) << format(second.error());
    expect_same_plan(first->scene, second->scene);
    // What settles anew may roll, and what leaned was stood up: of a hundred things at most two.
    const std::size_t may_differ = std::max<std::size_t>(1, first->scene.nodes.size() / 50);
    EXPECT_THAT(without_equal(first->scene, second->scene, written->left_out),
                ::testing::SizeIs(::testing::Le(may_differ)));
    EXPECT_THAT(without_equal(second->scene, first->scene, {}), ::testing::SizeIs(::testing::Le(may_differ)));
    for (const std::string& text : written->left_out) std::cout << houses[i].id << " " << text << "\n";
    EXPECT_EQ(write_procthor(first->scene, knowledge, format_facts())->text, written->text);
  }
}

TEST(ModelChoice, TakesAModelThatCanDoWhatItsCategoryCanWhereOneFits) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const FormatFacts& facts = format_facts();
  ASSERT_THAT(facts.model_lacks.at("RoboTHOR_mug_ai2_2_v"), ::testing::Contains("pickupable"));
  Node mug;
  mug.id = "mug_1";
  mug.category = "Mug";
  mug.size = knowledge.asset("RoboTHOR_mug_ai2_2_v")->size;
  std::string why;
  const ChosenModel able = model_for(mug, knowledge, facts, why);
  ASSERT_NE(able.asset, nullptr) << why;
  EXPECT_FALSE(facts.model_lacks.contains(able.asset->name));
  FormatFacts all_lack = facts;
  for (const Asset* model : knowledge.asset_rows_of("Mug")) all_lack.model_lacks[model->name].insert("pickupable");
  EXPECT_EQ(model_for(mug, knowledge, all_lack, why).asset->name, "RoboTHOR_mug_ai2_2_v") << "where no other fits";
  mug.asset = "RoboTHOR_mug_ai2_2_v";
  EXPECT_EQ(model_for(mug, knowledge, facts, why).asset->name, mug.asset) << "its own";
}

}  // namespace
}  // namespace unietp::testing
