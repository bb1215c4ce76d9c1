#include "interchange/habitat_assets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/digest.h"
#include "interchange/gltf.h"
#include "interchange/habitat_frame.h"
#include "interchange/own_ids.h"
#include "interchange/solid_mesh.h"
#include "interchange/urdf.h"
#include "simulation/paint.h"
#include "simulation/room_paint.h"
#include "simulation/shape.h"
#include "simulation/solids.h"
#include "simulation/walls.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// An object's frame in Habitat's: x, y and z there are -x, z and y here, so that fronts are along -z.
Pose own_frame() { return {Vec3::Zero(), Quat(0, 0, std::sqrt(0.5), std::sqrt(0.5))}; }
/// W in Habitat's world: a quarter turn about x.
Pose world_frame() { return {Vec3::Zero(), Quat(std::sqrt(0.5), -std::sqrt(0.5), 0, 0)}; }

std::array<double, 3> linear(const Color& srgb) {
  std::array<double, 3> color{};
  for (int i = 0; i < 3; ++i) {
    const double part = std::clamp(srgb[i] / 255, 0.0, 1.0);  // the transfer function of sRGB, IEC 61966-2-1
    const double value = part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    color[static_cast<std::size_t>(i)] = std::round(value * 1e4) / 1e4;
  }
  return color;
}

/// The same for all nodes with one stand-in, though the camera shades each a little by its id.
std::array<double, 3> color_of(const Node& node) {
  Node any = node;
  any.id = node.category;
  return linear(paint_of(any));
}

GltfMaterial material_of(const std::array<double, 3>& color, Matter matter) {
  GltfMaterial look{color};
  switch (matter) {
    case Matter::Metal:
      look.metallic = 0.9, look.roughness = 0.35;
      break;
    case Matter::Glass:
      look.opacity = 0.45, look.roughness = 0.1;
      break;
    case Matter::Ceramic:
      look.roughness = 0.3;
      break;
    case Matter::Plastic:
    case Matter::Leather:
    case Matter::Wax:
      look.roughness = 0.5;
      break;
    default:
      look.roughness = 0.9;
      break;
  }
  return look;
}

Json numbers(const Vec3& v) {
  Json list = Json::array();
  for (const double value : v) list.push_back(std::round(value * 1e6) / 1e6 + 0.0);
  return list;
}

std::string link_of(int joint) { return joint < 0 ? "body" : "part_" + std::to_string(joint); }

/// In the words of habitat-lab: a flat box over each surface. `with_links`: of an articulated object.
Json receptacles(const Shape& shape, bool with_links) {
  constexpr double kHalfHeight_m = 0.01;
  Json all = Json::object();
  for (std::size_t i = 0; i < shape.surfaces.size(); ++i) {
    const Surface& surface = shape.surfaces[i];
    const std::string name = "receptacle_aabb_" + std::to_string(i);
    Vec3 center = surface.center + Vec3(0, 0, kHalfHeight_m);
    if (with_links && surface.joint >= 0) center -= shape.joints[static_cast<std::size_t>(surface.joint)].anchor;
    Json one = {{"name", name},
                {"position", numbers(own_frame() * center)},
                {"scale", numbers(lengths_to_habitat({surface.half.x(), surface.half.y(), kHalfHeight_m}))},
                {"up", {0, 1, 0}}};
    if (with_links) one["parent_link"] = link_of(surface.joint);
    all[name] = std::move(one);
  }
  return all;
}

/// What the camera shows of a node, the same for all nodes with one stand-in: a mesh for each material. Nothing for
/// those that look as physics has them.
std::vector<GltfMesh> look_of(const Node& node) {
  Node any = node;
  any.id = node.category;
  any.pose = Pose();
  any.opening = 0;
  any.states = {};
  const ShapeFamily* family = family_of(any, Simulator::Habitat);
  if (family == nullptr) return {};
  std::vector<Solid> solids;
  add_solids(any, 0, Simulator::Habitat, {}, solids);
  constexpr std::size_t kTriangles = 3000;
  const auto triangles = [&](std::uint32_t sides) {
    std::size_t all = 0;
    for (const Solid& solid : solids) all += triangles_of(solid, sides);
    return all;
  };
  std::uint32_t sides = 16;
  while (sides > 6 && triangles(sides) > kTriangles) sides -= 2;
  const Color color = paint_of(any, family);
  const Matter matter = matter_of(any, family);
  std::vector<GltfMesh> meshes;
  for (const Solid& solid : solids) {
    const Color own =
        solid.color ? Color((*solid.color)[0], (*solid.color)[1], (*solid.color)[2]) : Color(color * solid.shade);
    const GltfMaterial look = material_of(linear(own), solid.matter.value_or(matter));
    auto mesh = std::find_if(meshes.begin(), meshes.end(), [&](const GltfMesh& one) { return one.material == look; });
    if (mesh == meshes.end()) mesh = meshes.insert(mesh, {"look_" + std::to_string(meshes.size()), look, {}, {}, {}});
    add_surface(*mesh, solid, sides, own_frame());
  }
  return meshes;
}

std::string text_of(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::vector<AssetFile> rigid(const Node& node, const std::string& name) {
  const Shape shape = shape_of(node);
  const GltfMaterial look = material_of(color_of(node), matter_of(node));
  const std::vector<GltfMesh> seen = look_of(node);
  const std::string render = name + (seen.empty() ? ".glb" : ".render.glb");
  std::vector<GltfMesh> meshes;
  for (const Part& part : shape.parts) {
    meshes.push_back(mesh_of(part, own_frame() * part.pose, "part_" + std::to_string(meshes.size()), look));
  }
  Json own = receptacles(shape, false);
  own["category"] = node.category;
  // Each part of the mesh for collisions is convex, and a body of its own.
  const Json config = {{"render_asset", render},
                       {"collision_asset", name + ".glb"},
                       {"up", {0, 1, 0}},
                       {"front", {0, 0, -1}},
                       {"COM", {0, 0, 0}},
                       {"compute_COM_from_shape", false},
                       {"use_mesh_collision", true},
                       {"join_collision_meshes", false},
                       {"mass", node.mass},
                       {"user_defined", std::move(own)}};
  std::vector<AssetFile> files{{"objects/" + name + ".object_config.json", text_of(config)},
                               {"objects/" + name + ".glb", write_glb(meshes)}};
  if (!seen.empty()) files.push_back({"objects/" + render, write_glb(seen)});
  return files;
}

std::vector<AssetFile> articulated(const Node& node, const std::string& name) {
  const Shape shape = shape_of(node);
  Json own = receptacles(shape, true);
  own["category"] = node.category;
  const Json config = {
      {"urdf_filepath", name + ".urdf"}, {"render_mode", "link_visuals"}, {"user_defined", std::move(own)}};
  const std::string folder = "urdf/" + name + "/" + name;
  return {{folder + ".ao_config.json", text_of(config)},
          {folder + ".urdf", write_urdf(name, shape, node.size, node.mass, own_frame(), color_of(node))}};
}

Part box_part(const Pose& pose, const Vec3& size) { return {Part::Kind::Box, pose, size}; }

}  // namespace

std::string habitat_stand_in_name(const Node& node) {
  std::string name = node.category;
  for (const double side : {node.size.x(), node.size.y(), node.size.z()}) {
    name += "_" + std::to_string(std::lround(side * 1000));
  }
  for (const std::string& word : {node.color, node.material}) {
    if (!word.empty()) name += "_" + word;
  }
  if (!node.boards.empty()) {
    std::string boards;
    for (const Board& board : node.boards) {
      for (const Vec3& v : {board.center, board.size}) {
        for (const double value : v) boards += std::to_string(std::lround(value * 1000)) + " ";
      }
      boards += std::to_string(board.joint) + ";";
    }
    name += "_" + sha256(boards).substr(0, 8);
  }
  // Letters, digits and "_" only: names become names of files and links.
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (!plain) c = '_';
  }
  return name;
}

std::vector<AssetFile> habitat_stand_in(const Node& node) {
  const std::string name = habitat_stand_in_name(node);
  return node.openable ? articulated(node, name) : rigid(node, name);
}

std::vector<AssetFile> habitat_stage(const Scene& scene) {
  constexpr double kFloor_m = 0.1;
  std::vector<GltfMesh> meshes;
  const auto add = [&](const Part& part, std::string name, const Color& color) {
    meshes.push_back(mesh_of(part, world_frame() * part.pose, std::move(name), {linear(color)}));
  };
  for (const Room& room : scene.rooms) {
    const Bounds bounds = room_bounds(room, 0);
    const Vec3 size = bounds.high - bounds.low, middle = (bounds.low + bounds.high) / 2;
    add(box_part({{middle.x(), middle.y(), -kFloor_m / 2}, Quat::Identity()}, {size.x(), size.y(), kFloor_m}),
        "floor_" + room.id, room_paint(&room).floor_color);
  }
  for (const WallPiece& wall : walls_of(scene)) {
    add(box_part(wall.pose, wall.size), "wall_" + std::to_string(meshes.size() - scene.rooms.size()), kWallPaint);
  }
  const Json config = {{"render_asset", scene.id + ".glb"},
                       {"collision_asset", scene.id + ".glb"},
                       {"up", {0, 1, 0}},
                       {"front", {0, 0, -1}},
                       {"units_to_meters", 1.0},
                       {"is_collidable", true}};
  return {{"stages/" + scene.id + ".stage_config.json", text_of(config)},
          {"stages/" + scene.id + ".glb", write_glb(meshes)}};
}

AssetFile habitat_dataset_config(const std::string& scenes, bool with_own) {
  Json objects = {"objects"}, articulated = {{".json", {"urdf/*"}}};
  if (with_own) {
    for (const char* const folder : {"../replica_cad/configs/objects", "../scene_datasets/hssd-hab/objects/*"}) {
      objects.push_back(folder);
    }
    articulated[".json"].push_back("../scene_datasets/hssd-hab/urdf/*");
    articulated[".urdf"] = {"../replica_cad/urdf/*"};
  }
  const auto in = [](Json folders) { return Json{{"paths", {{".json", std::move(folders)}}}}; };
  const Json config = {{"stages", in({"stages"})},
                       {"objects", in(std::move(objects))},
                       {"articulated_objects", {{"paths", std::move(articulated)}}},
                       {"scene_instances", in({scenes})}};
  return {"unietp.scene_dataset_config.json", text_of(config)};
}

std::optional<std::string> habitat_own_template(const Node& node) {
  const auto handle = own_id_of(node, Simulator::Habitat);
  return handle ? std::optional(handle->substr(0, handle->rfind("_:"))) : std::nullopt;
}

std::string habitat_template_name(const Node& node) {
  const auto own = habitat_own_template(node);
  return own ? *own : habitat_stand_in_name(node);
}

}  // namespace unietp
