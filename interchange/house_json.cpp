#include "interchange/house_json.h"

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "interchange/unity.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStanding_m = 0.95;   // height of the agent's middle in every house
constexpr double kReceptacle_m = 0.7;  // as in every house
constexpr double kFloor_m = 1.0;       // thickness of the floor's collider, as in every house
constexpr std::size_t kLayers = 4;

}  // namespace

double house_number(double value, double per_unit) {
  const double cut = std::round(value * per_unit) / per_unit;
  return cut == 0 ? 0.0 : cut;
}
Json house_xyz(const Vec3& unity, double per_unit) {
  return {{"x", house_number(unity.x(), per_unit)},
          {"y", house_number(unity.y(), per_unit)},
          {"z", house_number(unity.z(), per_unit)}};
}
Json house_point(const Vec2& w, double height) { return house_xyz(Vec3(w.x(), height, w.y())); }
Json house_material(std::string_view name) { return {{"name", name}}; }
Json house_paint(double red, double green, double blue) {
  return {{"color", {{"r", red}, {"g", green}, {"b", blue}}}, {"name", "PureWhite"}};
}

std::string house_layer(std::size_t room) { return "Procedural" + std::to_string(room % kLayers); }

Json house_parameters(const Scene& scene) {
  const Json shadow{{"type", "Soft"}, {"strength", 1},    {"normalBias", 0},
                    {"bias", 0.05},   {"nearPlane", 0.2}, {"resolution", "FromQualitySettings"}};
  Json lights = Json::array();
  lights.push_back({{"id", "DirectionalLight"},
                    {"position", house_xyz({0.84, 0.1855, -1.09})},
                    {"rotation", house_xyz({66, 75, 0})},
                    {"shadow", shadow},
                    {"type", "directional"},
                    {"intensity", 1},
                    {"indirectMultiplier", 1.0},
                    {"rgb", {{"r", 1.0}, {"g", 1.0}, {"b", 1.0}}}});
  for (std::size_t r = 0; r < scene.rooms.size(); ++r) {
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : scene.rooms[r].polygon) {
      middle += corner / static_cast<double>(scene.rooms[r].polygon.size());
    }
    Json others = Json::array();
    for (std::size_t k = 0; k < kLayers; ++k) {
      if (k != r % kLayers) others.push_back(house_layer(k));
    }
    lights.push_back({{"id", "light_" + std::to_string(r + 2)},
                      {"type", "point"},
                      {"position", house_point(middle, scene.wall_height - 0.2)},
                      {"intensity", 0.45},
                      {"range", 15},
                      {"rgb", {{"r", 1.0}, {"g", 0.855}, {"b", 0.722}}},
                      {"shadow", shadow},
                      {"layer", house_layer(r)},
                      {"cullingMaskOff", std::move(others)}});
  }
  return {{"floorColliderThickness", kFloor_m},
          {"receptacleHeight", kReceptacle_m},
          {"skyboxId", "SkyGarden"},
          {"lights", std::move(lights)},
          {"ceilingMaterial", house_paint(0.9, 0.9, 0.9)},
          {"reflections", Json::array()}};
}

Json house_metadata(const Scene& scene) {
  const Agent& agent = scene.agent;
  return {{"agent",
           {{"position", house_point(agent.position, kStanding_m)},
            {"rotation", house_xyz({0, agent_yaw_to_unity(agent), 0}, 1000)},
            {"standing", true},
            {"horizon", house_number(agent.pitch * 180 / std::numbers::pi, 1000)}}},
          {"roomSpecId", scene.id},
          {"schema", "1.0.0"},
          {"warnings", Json::object()}};
}

}  // namespace unietp
