#include "interchange/gltf.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <nlohmann/json.hpp>

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

// Constants of glTF 2.0: the file's magic word and version, the types of its chunks and of its numbers.
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kUnsignedInt = 5125, kFloat = 5126, kVertices = 34962, kIndices = 34963;

constexpr std::uint32_t kAround = 24, kRings = 12;  // sides of a cylinder; of a sphere, and its rings

void add_triangle(GltfMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.corners.insert(mesh.corners.end(), {a, b, c});
}

/// A flat polygon of points given counter-clockwise seen from outside.
void add_face(GltfMesh& mesh, const std::vector<Vec3>& points, const Vec3& normal) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const Vec3& point : points) {
    mesh.points.push_back(point);
    mesh.normals.push_back(normal);
  }
  for (std::uint32_t i = 1; i + 1 < points.size(); ++i) add_triangle(mesh, first, first + i, first + i + 1);
}

void add_box(GltfMesh& mesh, const Vec3& half) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const double side : {-1.0, 1.0}) {
      std::vector<Vec3> face;
      for (const auto& [a, b] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        Vec3 corner;
        corner[axis] = side * half[axis], corner[u] = side * a * half[u], corner[v] = b * half[v];
        face.push_back(corner);
      }
      Vec3 normal = Vec3::Zero();
      normal[axis] = side;
      add_face(mesh, face, normal);
    }
  }
}

Vec2 on_circle(std::uint32_t i) {
  const double angle = 2 * std::numbers::pi * i / kAround;
  return {std::cos(angle), std::sin(angle)};
}

/// The normal of an ellipsoid or an elliptic cylinder at the image of a point of the unit shape.
Vec3 normal_at(const Vec3& unit, const Vec3& half) { return unit.cwiseQuotient(half).normalized(); }

void add_cylinder(GltfMesh& mesh, const Vec3& half) {
  std::vector<Vec3> top, bottom;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const Vec2 at = on_circle(i), back = on_circle(kAround - i);
    top.emplace_back(at.x() * half.x(), at.y() * half.y(), half.z());
    bottom.emplace_back(back.x() * half.x(), back.y() * half.y(), -half.z());
  }
  add_face(mesh, top, Vec3::UnitZ());
  add_face(mesh, bottom, -Vec3::UnitZ());
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (std::uint32_t i = 0; i <= kAround; ++i) {
    const Vec2 at = on_circle(i % kAround);
    for (const double side : {-1.0, 1.0}) {
      mesh.points.emplace_back(at.x() * half.x(), at.y() * half.y(), side * half.z());
      mesh.normals.push_back(normal_at({at.x(), at.y(), 0}, half));
    }
  }
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t low = first + 2 * i;
    add_triangle(mesh, low, low + 2, low + 3);
    add_triangle(mesh, low, low + 3, low + 1);
  }
}

void add_sphere(GltfMesh& mesh, const Vec3& half) {
  for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
    const double angle = std::numbers::pi * ring / kRings;  // from the bottom up
    for (std::uint32_t i = 0; i <= kAround; ++i) {
      const Vec2 at = on_circle(i % kAround) * std::sin(angle);
      const Vec3 unit(at.x(), at.y(), -std::cos(angle));
      mesh.points.emplace_back(unit.cwiseProduct(half));
      mesh.normals.push_back(normal_at(unit, half));
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t low = ring * (kAround + 1) + i, high = low + kAround + 1;
      if (ring > 0) add_triangle(mesh, low, low + 1, high + 1);
      if (ring + 1 < kRings) add_triangle(mesh, low, high + 1, high);
    }
  }
}

void add_word(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFF);
}

void add_vector(std::string& bytes, const Vec3& v) {
  for (const double value : v) add_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

/// The parts of the JSON that list buffers, meshes and materials.
class GltfFile {
 public:
  void add(const GltfMesh& mesh) {
    const int points = add_vectors(mesh.points, true), normals = add_vectors(mesh.normals, false);
    const std::size_t begin = binary_.size();
    for (const std::uint32_t corner : mesh.corners) add_word(binary_, corner);
    const int corners = accessor(begin, mesh.corners.size(), kUnsignedInt, "SCALAR", kIndices);
    const auto number = static_cast<int>(meshes_.size());
    meshes_.push_back({{"name", mesh.name},
                       {"primitives",
                        {{{"attributes", {{"POSITION", points}, {"NORMAL", normals}}},
                          {"indices", corners},
                          {"material", material(mesh.material)}}}}});
    nodes_.push_back({{"name", mesh.name}, {"mesh", number}});
    roots_.push_back(number);
  }

  std::string text() const {
    Json json = {{"asset", {{"version", "2.0"}, {"generator", "unietp"}}},
                 {"scene", 0},
                 {"scenes", {{{"nodes", roots_}}}},
                 {"nodes", nodes_},
                 {"meshes", meshes_},
                 {"materials", materials_},
                 {"accessors", accessors_},
                 {"bufferViews", views_},
                 {"buffers", {{{"byteLength", binary_.size()}}}}};
    if (roots_.empty()) json = {{"asset", json["asset"]}, {"scene", 0}, {"scenes", {Json::object()}}};
    std::string header = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    header.resize((header.size() + 3) / 4 * 4, ' ');
    const std::size_t binary = binary_.empty() ? 0 : 8 + binary_.size();
    std::string file;
    add_word(file, kMagic);
    add_word(file, kVersion);
    add_word(file, static_cast<std::uint32_t>(12 + 8 + header.size() + binary));
    add_word(file, static_cast<std::uint32_t>(header.size()));
    add_word(file, kJsonChunk);
    file += header;
    if (binary > 0) {
      add_word(file, static_cast<std::uint32_t>(binary_.size()));
      add_word(file, kBinaryChunk);
      file += binary_;
    }
    return file;
  }

 private:
  int accessor(std::size_t begin, std::size_t count, int number_type, const char* shape, int target) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary_.size() - begin}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", number_type}, {"count", count}, {"type", shape}});
    return static_cast<int>(accessors_.size()) - 1;
  }

  int add_vectors(const std::vector<Vec3>& vectors, bool with_bounds) {
    const std::size_t begin = binary_.size();
    for (const Vec3& v : vectors) add_vector(binary_, v);
    const int number = accessor(begin, vectors.size(), kFloat, "VEC3", kVertices);
    if (!with_bounds) return number;
    Vec3 low = vectors.front(), high = vectors.front();
    for (const Vec3& v : vectors) low = low.cwiseMin(v), high = high.cwiseMax(v);
    // Of the numbers as they are stored, which readers compare.
    const auto stored = [](const Vec3& v) {
      return Json::array({static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())});
    };
    accessors_.back()["min"] = stored(low);
    accessors_.back()["max"] = stored(high);
    return number;
  }

  int material(const GltfMaterial& look) {
    Json json = {{"pbrMetallicRoughness",
                  {{"baseColorFactor", {look.color[0], look.color[1], look.color[2], look.opacity}},
                   {"metallicFactor", look.metallic},
                   {"roughnessFactor", look.roughness}}}};
    if (look.opacity < 1) json["alphaMode"] = "BLEND";
    for (std::size_t i = 0; i < materials_.size(); ++i) {
      if (materials_[i] == json) return static_cast<int>(i);
    }
    materials_.push_back(std::move(json));
    return static_cast<int>(materials_.size()) - 1;
  }

  std::string binary_;
  Json accessors_ = Json::array(), views_ = Json::array(), meshes_ = Json::array(), nodes_ = Json::array(),
       materials_ = Json::array(), roots_ = Json::array();
};

}  // namespace

GltfMesh mesh_of(const Part& part, const Pose& to_file, std::string name, const GltfMaterial& material) {
  GltfMesh mesh;
  mesh.name = std::move(name);
  mesh.material = material;
  const Vec3 half = part.size / 2;
  switch (part.kind) {
    case Part::Kind::Box:
      add_box(mesh, half);
      break;
    case Part::Kind::Cylinder:
      add_cylinder(mesh, half);
      break;
    case Part::Kind::Sphere:
      add_sphere(mesh, half);
      break;
  }
  for (Vec3& point : mesh.points) point = to_file * point;
  for (Vec3& normal : mesh.normals) normal = rotated(to_file.rotation, normal);
  return mesh;
}

std::string write_glb(const std::vector<GltfMesh>& meshes) {
  GltfFile file;
  for (const GltfMesh& mesh : meshes) file.add(mesh);
  return file.text();
}

}  // namespace unietp
