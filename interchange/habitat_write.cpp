#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <nlohmann/json.hpp>

#include "interchange/formats.h"
#include "interchange/habitat_assets.h"
#include "interchange/habitat_frame.h"
#include "scene/node_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSamePart = 1e-3;  // a scale nearer to 1 is none

Json array_of(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }
Json array_of(const Quat& q) { return Json::array({q.w(), q.x(), q.y(), q.z()}); }
Json floor_point(const Vec2& point) { return array_of(to_habitat({point.x(), point.y(), 0})); }

class HabitatExporter {
 public:
  HabitatExporter(const Scene& scene, const Knowledge& knowledge, bool stand_ins)
      : scene_(scene), knowledge_(knowledge), stand_ins_(stand_ins) {}

  ExportedScene write() {
    for (const Node& node : scene_.nodes) add(node);
    Json own = {{"templates", Json::object()}, {"regions", Json::array()}, {"openings", Json::array()}};
    for (auto& [name, model] : templates_) own["templates"][name] = std::move(model);
    for (const Room& room : scene_.rooms) own["regions"].push_back(region(room));
    for (const Opening& opening : scene_.openings) own["openings"].push_back(json_of_opening(opening));
    own["agent"] = agent();
    const std::string text = "{\n\"stage_instance\": {\"template_name\": \"stages/" + scene_.id +
                             "\"},\n\"default_lighting\": \"\",\n\"translation_origin\": \"COM\"" +
                             lines("object_instances", objects_) + lines("articulated_object_instances", articulated_) +
                             ",\n\"user_defined\": " + text_of(own) + "\n}\n";
    return {text, std::move(left_out_), std::move(names_)};
  }

 private:
  static std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

  static std::string lines(const std::string& name, const std::vector<Json>& items) {
    std::string list = ",\n\"" + name + "\": [";
    const char* separator = "\n";
    for (const Json& item : items) {
      list += separator + text_of(item);
      separator = ",\n";
    }
    return list + "\n]";
  }

  /// The model whose box is nearest, by the largest part that one side differs by.
  const Asset* nearest_model(const Node& node) const {
    if (const Asset* own = knowledge_.asset(node.asset)) return own;
    constexpr double kMostStretched = 0.2;
    const Asset* best = nullptr;
    double least = kMostStretched;
    for (const Asset* asset : knowledge_.assets_of(node.category)) {
      const double differs = (asset->size.cwiseQuotient(node.size) - Vec3::Ones()).cwiseAbs().maxCoeff();
      if (differs < least) least = differs, best = asset;
    }
    return best;
  }

  /// Template and scale. What no model of the knowledge base fits gets a template of its own, named by its category and
  /// size in millimeters, which a user's data set has to provide.
  std::string template_of(const Node& node, Vec3& scale) {
    const Category& category = *knowledge_.find(node.category);
    const auto own = stand_ins_ ? habitat_own_template(node) : std::nullopt;
    const Asset* model = own ? knowledge_.asset(*own) : stand_ins_ ? nullptr : nearest_model(node);
    std::string name = stand_ins_ ? habitat_template_name(node) : model != nullptr ? model->name : node.asset;
    Vec3 size = model != nullptr ? model->size : node.size;
    if (name.empty()) {
      name = node.category;
      for (const double side : {node.size.x(), node.size.y(), node.size.z()}) {
        name += "_" + std::to_string(std::lround(side * 1000));
      }
      left_out_.push_back(node.id + ": no model of " + node.category + " fits its box, template " + name);
    }
    const Json entry = {{"category", category.name}, {"size", array_of(size)}, {"mass", node.mass}};
    if (const auto [at, fresh] = templates_.try_emplace(name, entry); !fresh && at->second != entry) {
      const Json& known = at->second.at("size");
      size = Vec3(known[0].get<double>(), known[1].get<double>(), known[2].get<double>());
    }
    scale = stand_ins_ && model == nullptr ? Vec3(1, 1, 1) : Vec3(node.size.cwiseQuotient(size));
    return name;
  }

  void add(const Node& node) {
    if (knowledge_.find(node.category) == nullptr) {
      left_out_.push_back(node.id + ": the knowledge base of Habitat has no category \"" + node.category + "\"");
      return;
    }
    Vec3 scale = Vec3::Ones();
    const std::string name = template_of(node, scale);
    const std::size_t before = count_[name]++;
    names_[node.id] = name + "_:" + std::string(4 - std::min<std::size_t>(4, std::to_string(before).size()), '0') +
                      std::to_string(before);
    Json instance = {{"template_name", name},
                     {"translation_origin", "COM"},
                     {"translation", array_of(to_habitat(node.pose.position))},
                     {"rotation", array_of(rotation_to_habitat(node.pose.rotation))},
                     {"motion_type", node.movable || node.openable ? "DYNAMIC" : "STATIC"}};
    if ((scale - Vec3::Ones()).cwiseAbs().maxCoeff() > kSamePart) {
      instance["non_uniform_scale"] = array_of(lengths_to_habitat(scale));
    }
    Json states = Json::array();
    for (const State& state : node.states.all()) states.push_back(state_name(state));
    Json own = {{"name", node.id}, {"category", node.category}, {"mass", node.mass}, {"states", std::move(states)}};
    if (node.openable) own["opening"] = node.opening;
    if (node.openable) {
      instance["fixed_base"] = !node.movable;
      instance["user_defined"] = std::move(own);
      articulated_.push_back(std::move(instance));
    } else {
      instance["user_defined"] = std::move(own);
      objects_.push_back(std::move(instance));
    }
  }

  /// In the words of HSSD's files of semantic regions.
  Json region(const Room& room) const {
    Json loop = Json::array();
    for (const Vec2& corner : room.polygon) loop.push_back(floor_point(corner));
    return {{"name", room.id},
            {"label", room.type},
            {"poly_loop", std::move(loop)},
            {"floor_height", 0.0},
            {"extrusion_height", scene_.wall_height}};
  }

  static Json json_of_opening(const Opening& opening) {
    return {{"name", opening.id},
            {"rooms", {opening.room_a, opening.room_b}},
            {"from", floor_point(opening.from)},
            {"to", floor_point(opening.to)},
            {"height", opening.height}};
  }

  Json agent() const {
    const Quat rotation = upright(Vec3::Zero(), scene_.agent.yaw + std::numbers::pi / 2).rotation;
    Json json = {{"translation", floor_point(scene_.agent.position)},
                 {"rotation", array_of(rotation_to_habitat(rotation))}};
    if (!scene_.agent.held.empty()) json["held"] = scene_.agent.held;
    return json;
  }

  const Scene& scene_;
  const Knowledge& knowledge_;
  bool stand_ins_;
  std::map<std::string, std::size_t> count_;  // instances of each template so far
  std::map<std::string, std::string> names_;
  std::vector<Json> objects_, articulated_;
  std::map<std::string, Json> templates_;
  std::vector<std::string> left_out_;
};

Result<ExportedScene> write(const Scene& scene, const Knowledge& knowledge, bool stand_ins) {
  if (scene.simulator != Simulator::Habitat || knowledge.simulator() != Simulator::Habitat) {
    return Error{Error::Kind::Schema,
                 scene.id,
                 {},
                 "expected a scene of habitat, not of " + std::string(name_of(scene.simulator))};
  }
  return HabitatExporter(scene, knowledge, stand_ins).write();
}

}  // namespace

Result<ExportedScene> write_habitat(const Scene& scene, const Knowledge& knowledge) {
  return write(scene, knowledge, false);
}

Result<ExportedScene> write_habitat_with_stand_ins(const Scene& scene, const Knowledge& knowledge) {
  return write(scene, knowledge, true);
}

}  // namespace unietp
