// Stand-ins for Habitat's models: meshes, joints and names. That habitat-lab, trimesh and yourdfpy read them is shown
// by checks/judges.
#include "interchange/habitat_assets.h"

#include <cstring>
#include <numbers>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "interchange/formats.h"
#include "interchange/gltf.h"
#include "interchange/solid_mesh.h"
#include "interchange/urdf.h"
#include "tests/interchange/small_home.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::json;

/// The volume that a mesh encloses: positive when its triangles face outward.
double volume_of(const GltfMesh& mesh) {
  double six = 0;
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    six += mesh.points[mesh.corners[i]].dot(mesh.points[mesh.corners[i + 1]].cross(mesh.points[mesh.corners[i + 2]]));
  }
  return six / 6;
}

TEST(Gltf, MeshesEncloseWhatTheirPartsDo) {
  const Pose pose{{3, -1, 2}, Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
  const Vec3 size(0.2, 0.3, 0.5);
  const double box = size.prod(), circle = std::numbers::pi / 4, ball = std::numbers::pi / 6;
  for (const auto& [kind, volume, slack] : {std::tuple(Part::Kind::Box, box, 1e-9),
                                            {Part::Kind::Cylinder, box * circle, 0.02},
                                            {Part::Kind::Sphere, box * ball, 0.04}}) {
    const GltfMesh mesh = mesh_of({kind, Pose(), size}, pose, "part", {});
    EXPECT_NEAR(volume_of(mesh) / volume, 1, slack);
    ASSERT_EQ(mesh.points.size(), mesh.normals.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      EXPECT_NEAR(mesh.normals[i].norm(), 1, 1e-9);
      EXPECT_GT(mesh.normals[i].dot(mesh.points[i] - pose.position), 0) << "a normal points inward";
    }
  }
}

/// Every triangle's corners are counter-clockwise seen from where its normals point.
void expect_normals_of_triangles(const GltfMesh& mesh) {
  ASSERT_EQ(mesh.points.size(), mesh.normals.size());
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return mesh.points[mesh.corners[i + k]]; };
    const Vec3 across = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    ASSERT_GT(across.norm(), 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& normal = mesh.normals[mesh.corners[i + k]];
      EXPECT_NEAR(normal.norm(), 1, 1e-9);
      EXPECT_GT(normal.dot(across), 0) << "a normal points inward";
    }
  }
}

TEST(Gltf, SurfacesEncloseWhatSolidsDo) {
  Solid solid;
  solid.sheared = true;
  solid.pose.position = {1, 2, 3};
  solid.axes << 0.2, 0.05, 0, 0, 0.3, 0.1, 0, 0, 0.4;
  const Pose to_file{{3, -1, 2}, Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
  constexpr double kPi = std::numbers::pi;
  const double cup = kPi * 2 - kPi * 0.75 * 0.75 * 1.5;
  for (const bool mirrored : {false, true}) {
    if (mirrored) solid.axes.col(0) *= -1;
    const double cube = std::abs(solid.axes.determinant());
    const auto expect = [&](SolidKind kind, const Vec2& low, const Vec2& high, double volume) {
      solid.kind = kind, solid.low = low, solid.high = high, solid.wall = 0.25, solid.floor = 0.5;
      GltfMesh mesh;
      add_surface(mesh, solid, 48, to_file);
      EXPECT_NEAR(volume_of(mesh) / (cube * volume), 1, 0.01) << static_cast<int>(kind);
      EXPECT_LE(mesh.corners.size(), 3 * triangles_of(solid, 48));
      if (low.minCoeff() > 0 && high.minCoeff() > 0) {
        EXPECT_EQ(mesh.corners.size(), 3 * triangles_of(solid, 48));
      }
      expect_normals_of_triangles(mesh);
    };
    expect(SolidKind::Box, {1, 1}, {1, 1}, 8);
    expect(SolidKind::Wedge, {1, 1}, {0, 1}, 4);
    expect(SolidKind::Wedge, {0.5, 0.5}, {1, 1}, 8.0 / 3 * (1 + 0.5 + 0.25));
    expect(SolidKind::Cylinder, {1, 1}, {1, 1}, 2 * kPi);
    expect(SolidKind::Cone, {0, 0}, {1, 1}, 2 * kPi / 3);
    expect(SolidKind::Sphere, {1, 1}, {1, 1}, 4 * kPi / 3);
    expect(SolidKind::Cup, {1, 1}, {1, 1}, cup);
    expect(SolidKind::Crate, {1, 1}, {1, 1}, 8 - 4 * 0.75 * 0.75 * 1.5);
  }
}

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

TEST(Gltf, FilesHaveAHeaderChunksAndBoundsOfTheirPoints) {
  const Part part{Part::Kind::Box, Pose(), {0.1, 0.2, 0.4}};
  const std::string file = write_glb({mesh_of(part, {{1, 0, 0}, Quat::Identity()}, "a", {{1, 0, 0}, 0.5})});
  ASSERT_GE(file.size(), 20U);
  EXPECT_EQ(file.substr(0, 4), "glTF");
  EXPECT_EQ(word(file, 4), 2U);
  EXPECT_EQ(word(file, 8), file.size());
  const std::size_t header = word(file, 12);
  EXPECT_EQ(file.substr(16, 4), "JSON");
  const Json json = Json::parse(file.substr(20, header));
  EXPECT_EQ(word(file, 20 + header), json["buffers"][0]["byteLength"].get<std::size_t>());
  EXPECT_EQ(file.substr(24 + header, 4), std::string("BIN\0", 4));
  EXPECT_EQ(file.size(), 28 + header + word(file, 20 + header));
  const Json& points =
      json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(points["count"], 24);
  EXPECT_NEAR(points["min"][0].get<double>(), 0.95, 1e-6);
  EXPECT_NEAR(points["max"][2].get<double>(), 0.2, 1e-6);
  EXPECT_EQ(json["materials"][0]["alphaMode"], "BLEND");
  float first = 0;
  std::memcpy(&first, file.data() + 28 + header, 4);
  EXPECT_NEAR(std::abs(first - 1), 0.05, 1e-6);
}

TEST(Urdf, HasALinkAndAJointForEachDoor) {
  const Shape shape = make_shape(Archetype::Cabinet, {0.8, 0.5, 1.0}, true);
  ASSERT_FALSE(shape.joints.empty());
  const std::string text = write_urdf("cabinet", shape, {0.8, 0.5, 1.0}, 20, Pose(), {1, 1, 1});
  const auto count = [&](const std::string& what) {
    const std::regex pattern(what);
    return std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator());
  };
  EXPECT_EQ(count("<link name"), static_cast<long>(1 + shape.joints.size()));
  EXPECT_EQ(count("<joint name"), static_cast<long>(shape.joints.size()));
  EXPECT_EQ(count("<collision>"), static_cast<long>(shape.parts.size()));
  double mass = 0;
  const std::regex pattern("<mass value=\"([0-9.e-]+)\"");
  for (auto at = std::sregex_iterator(text.begin(), text.end(), pattern); at != std::sregex_iterator(); ++at) {
    mass += std::stod((*at)[1]);
  }
  EXPECT_NEAR(mass, 20, 0.01);
}

Node mug() {
  Node node;
  node.id = "mug_1", node.category = "mug", node.movable = true, node.archetype = Archetype::Cylinder;
  node.size = {0.08, 0.08, 0.1}, node.mass = 0.3, node.color = "red", node.material = "ceramic";
  return node;
}

TEST(HabitatAssets, EqualThingsShareAStandIn) {
  Node one = mug(), other = mug();
  other.id = "mug_2", other.pose.position = {1, 2, 3};
  EXPECT_EQ(habitat_stand_in_name(one), habitat_stand_in_name(other));
  const auto files = habitat_stand_in(one), again = habitat_stand_in(other);
  ASSERT_EQ(files.size(), 3U);
  for (std::size_t i = 0; i < files.size(); ++i) EXPECT_EQ(files[i].content, again[i].content) << files[i].path;
  other.color = "blue";
  EXPECT_NE(habitat_stand_in_name(one), habitat_stand_in_name(other));
  other = one;
  other.boards.push_back({{0, 0, 0}, {0.01, 0.01, 0.01}, -1});
  EXPECT_NE(habitat_stand_in_name(one), habitat_stand_in_name(other));
}

TEST(HabitatAssets, AConfigurationTellsTheMassAndKeepsThePartsOfHollowThingsApart) {
  const Json config = Json::parse(habitat_stand_in(mug())[0].content);
  EXPECT_EQ(config["mass"], 0.3);
  EXPECT_EQ(config["use_mesh_collision"], true);
  EXPECT_EQ(config["join_collision_meshes"], false) << "joined ones become one convex hull, which nothing goes into";
}

TEST(HabitatAssets, MeshesStandUprightWithTheirFrontsAlongMinusZ) {
  Node node = mug();
  node.archetype = Archetype::Box, node.size = {0.2, 0.4, 0.6};  // width, depth, height
  const std::string glb = habitat_stand_in(node)[1].content;
  const Json json = Json::parse(glb.substr(20, word(glb, 12)));
  Vec3 low(1, 1, 1), high(-1, -1, -1);
  for (const Json& one : json["accessors"]) {
    if (!one.contains("min")) continue;
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      low[i] = std::min(low[i], one["min"][axis].get<double>());
      high[i] = std::max(high[i], one["max"][axis].get<double>());
    }
  }
  EXPECT_THAT(std::vector<double>({high.x() - low.x(), high.y() - low.y(), high.z() - low.z()}),
              ::testing::ElementsAre(::testing::DoubleNear(0.2, 1e-6), ::testing::DoubleNear(0.6, 1e-6),
                                     ::testing::DoubleNear(0.4, 1e-6)));

  // What opens does so at its front: the doors of a cabinet are at the smallest z.
  const Shape shape = make_shape(Archetype::Cabinet, {0.8, 0.5, 1.0}, true);
  ASSERT_LT(shape.joints[0].anchor.y(), 0) << "fronts are along -y here";
  Node cabinet = mug();
  cabinet.archetype = Archetype::Cabinet, cabinet.openable = true, cabinet.size = {0.8, 0.5, 1.0};
  const std::string urdf = habitat_stand_in(cabinet)[1].content;
  std::smatch found;
  const std::regex pattern("<joint[^>]*>[^<]*<parent[^>]*>[^<]*<child[^>]*>[^<]*<origin xyz=\"\\S+ \\S+ (\\S+)\"");
  ASSERT_TRUE(std::regex_search(urdf, found, pattern)) << urdf;
  EXPECT_LT(std::stod(found[1]), 0);
}

/// The sizes of the box around all that a file shows.
Vec3 extents_of(const Json& gltf) {
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (const Json& one : gltf["accessors"]) {
    if (!one.contains("min")) continue;
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      low[i] = std::min(low[i], one["min"][axis].get<double>());
      high[i] = std::max(high[i], one["max"][axis].get<double>());
    }
  }
  return high - low;
}

Json gltf_in(const std::string& glb) { return Json::parse(glb.substr(20, word(glb, 12))); }

TEST(HabitatAssets, ThingsCollideAsPhysicsHasThemAndLookLikeTheirShapes) {
  const auto files = habitat_stand_in(mug());
  ASSERT_EQ(files.size(), 3U);
  const Json config = Json::parse(files[0].content);
  EXPECT_EQ("objects/" + config["collision_asset"].get<std::string>(), files[1].path);
  EXPECT_EQ("objects/" + config["render_asset"].get<std::string>(), files[2].path);
  const Json gltf = gltf_in(files[2].content);
  EXPECT_EQ(gltf["meshes"].size(), 1U) << "one color and material";
  EXPECT_GT(gltf["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][0].get<double>(), 0.3) << "it is red";
  EXPECT_LT(gltf["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][2].get<double>(), 0.1);

  Node plain = mug();
  plain.boards.push_back({{0, 0, 0}, {0.1, 0.1, 0.1}, -1});
  const auto board = habitat_stand_in(plain);
  ASSERT_EQ(board.size(), 2U);
  const Json same = Json::parse(board[0].content);
  EXPECT_EQ(same["render_asset"], same["collision_asset"]);
}

TEST(HabitatAssets, WhatIsSeenOfEveryCategoryFillsItsBoxWithFewTriangles) {
  std::size_t seen = 0, most = 0;
  for (const Category& category : committed_knowledge(Simulator::Habitat).categories()) {
    Node node;
    node.id = node.category = category.name, node.archetype = category.archetype, node.size = category.size;
    const auto files = habitat_stand_in(node);
    if (files.size() < 3) continue;
    ++seen;
    SCOPED_TRACE(category.name);
    const Json gltf = gltf_in(files[2].content);
    const Vec3 size(node.size.x(), node.size.z(), node.size.y());
    const Vec3 extents = extents_of(gltf);
    EXPECT_GT((extents - 0.85 * size).minCoeff(), 0) << extents.transpose() << " of " << size.transpose();
    EXPECT_LT((extents - 1.15 * size).maxCoeff(), 0) << extents.transpose() << " of " << size.transpose();
    std::size_t corners = 0;
    for (const Json& mesh : gltf["meshes"])
      corners += gltf["accessors"][mesh["primitives"][0]["indices"].get<std::size_t>()]["count"].get<std::size_t>();
    most = std::max(most, corners / 3);
  }
  EXPECT_GT(seen, 300U);
  EXPECT_LE(most, 3000U);
}

TEST(HabitatAssets, NamesAreNamesOfFilesWhateverTheCategory) {
  Node node = mug();
  node.category = "../../etc/pass wd", node.material = "steel/zinc";
  EXPECT_THAT(habitat_stand_in_name(node), Not(HasSubstr("/")));
  EXPECT_THAT(habitat_stand_in_name(node), Not(HasSubstr(".")));
  node.category = "TeaMug7";
  EXPECT_THAT(habitat_stand_in_name(node), HasSubstr("TeaMug7"));
}

TEST(HabitatAssets, AHomeHasAStageAndAModelForEveryNode) {
  const Scene home = testing::small_home(committed_knowledge(Simulator::Habitat), 3);
  const auto scene = write_habitat_with_stand_ins(home, committed_knowledge(Simulator::Habitat));
  ASSERT_TRUE(scene) << format(scene.error());
  EXPECT_THAT(scene->left_out, IsEmpty());
  const Json json = Json::parse(scene->text);
  std::set<std::string> stand_ins;
  for (const Node& node : home.nodes) {
    ASSERT_TRUE(scene->names.contains(node.id)) << node.id;
    EXPECT_THAT(scene->names.at(node.id), StartsWith(habitat_stand_in_name(node) + "_:00"));
    stand_ins.insert(habitat_stand_in_name(node));
  }
  for (const auto* list : {"object_instances", "articulated_object_instances"}) {
    for (const Json& instance : json[list]) {
      EXPECT_TRUE(stand_ins.contains(instance["template_name"].get<std::string>()));
      EXPECT_FALSE(instance.contains("non_uniform_scale"));
    }
  }
  const auto stage = habitat_stage(home);
  EXPECT_THAT(stage, Contains(Field(&AssetFile::path, "stages/" + home.id + ".stage_config.json")));
  EXPECT_EQ(json["stage_instance"]["template_name"], "stages/" + home.id);
}

}  // namespace
}  // namespace unietp
