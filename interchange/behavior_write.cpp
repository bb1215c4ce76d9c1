#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "interchange/floor_tiles.h"
#include "interchange/formats.h"
#include "interchange/own_ids.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kReportedStretch = 0.5;  // of a side of a model's box
constexpr double kFloorThickness_m = 0.1;

Json list_of(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// An object's place at rest, as OmniGibson keeps it. `non_kin`: its states by OmniGibson's names.
Json resting(const Vec3& position, const Quat& q, Json non_kin) {
  const Json still = list_of(Vec3::Zero());
  Json root{{"pos", list_of(position)}, {"ori", {q.x(), q.y(), q.z(), q.w()}}, {"lin_vel", still}, {"ang_vel", still}};
  return {{"root_link", std::move(root)}, {"joints", Json::object()}, {"non_kin", std::move(non_kin)}};
}

/// The largest part by which a side of the object differs from the model's.
double stretch(const Asset& model, const Node& node) {
  return (node.size.cwiseQuotient(model.size) - Vec3::Ones()).cwiseAbs().maxCoeff();
}

/// The object's own model, else that of its category which is stretched least: OmniGibson scales each axis.
const Asset* model_of(const Node& node, const Knowledge& knowledge) {
  if (const Asset* own = knowledge.asset(node.asset)) return own;
  const auto models = knowledge.asset_rows_of(node.category);
  const auto least = std::min_element(models.begin(), models.end(), [&](const Asset* a, const Asset* b) {
    return stretch(*a, node) < stretch(*b, node);
  });
  return least == models.end() ? nullptr : *least;
}

class BehaviorWriter {
 public:
  BehaviorWriter(const Scene& scene, const Knowledge& knowledge) : scene_(scene), knowledge_(knowledge) {}

  ExportedScene write() {
    for (const Room& room : scene_.rooms) add_floor(room);
    for (const Node& node : scene_.nodes) own_names_.insert(node.id);
    for (const Node& node : scene_.nodes) add(node);
    left_out_.push_back("walls, doors and windows");
    Json scene{{"metadata", Json::object()},
               {"state", {{"system_registry", Json::object()}, {"object_registry", std::move(state_)}}},
               {"objects_info", {{"init_info", std::move(info_)}}}};
    return {scene.dump(1, ' ', false, Json::error_handler_t::replace) + "\n", std::move(left_out_), std::move(names_)};
  }

 private:
  /// Slabs of OmniGibson's own cubes, since generated rooms are of no scene of its.
  void add_floor(const Room& room) {
    std::vector<Tile> tiles = tiles_of(room.polygon);
    if (tiles.empty()) {
      Tile around{room.polygon.front(), room.polygon.front()};
      for (const Vec2& corner : room.polygon) {
        around.low = around.low.cwiseMin(corner);
        around.high = around.high.cwiseMax(corner);
      }
      tiles.push_back(around);
      left_out_.push_back(room.id + ": its walls are not along the axes, its floor is the box around it");
    }
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      const std::string name = "floors_" + room.id + "_" + std::to_string(i);
      if (i == 0) names_[room.id] = name;
      const Vec2 middle = (tiles[i].low + tiles[i].high) / 2, sides = tiles[i].high - tiles[i].low;
      info_[name] = {{"class_module", "omnigibson.objects.primitive_object"},
                     {"class_name", "PrimitiveObject"},
                     {"args",
                      {{"name", name},
                       {"primitive_type", "Cube"},
                       {"category", "floors"},
                       {"size", 1.0},
                       {"scale", list_of({sides.x(), sides.y(), kFloorThickness_m})},
                       {"fixed_base", true}}}};
      state_[name] = resting({middle.x(), middle.y(), -kFloorThickness_m / 2}, Quat::Identity(), Json::object());
    }
  }

  /// The name in the scene that the home was imported from; for others a new one, of the model with a number.
  std::string name_of_object(const Node& node, const std::string& stem) {
    if (auto own = own_id_of(node, Simulator::Behavior)) return *own;
    std::string name;
    do name = stem + std::to_string(count_[stem]++);
    while (own_names_.contains(name));
    return name;
  }

  void add(const Node& node) {
    const Asset* const asset = model_of(node, knowledge_);
    if (asset == nullptr) {
      left_out_.push_back(node.id + ": no model of " + node.category + " is known");
      return;
    }
    if (stretch(*asset, node) > kReportedStretch)
      left_out_.push_back(node.id + ": its model is stretched by more than half of a side");
    const auto dash = asset->name.rfind('-');
    const std::string category = asset->name.substr(0, dash), model = asset->name.substr(dash + 1);
    const std::string name = name_of_object(node, category + "_" + model + "_");
    names_[node.id] = name;
    Json rooms = Json::array();
    if (const Room* room = room_at(scene_, node.pose.position.head<2>())) rooms.push_back(room->id);
    info_[name] = {{"class_module", "omnigibson.objects.dataset_object"},
                   {"class_name", "DatasetObject"},
                   {"args",
                    {{"name", name},
                     {"category", category},
                     {"model", model},
                     {"bounding_box", list_of({node.size.y(), node.size.x(), node.size.z()})},
                     {"fixed_base", !node.movable},
                     {"in_rooms", std::move(rooms)}}}};
    Json non_kin = Json::object();
    if (node.states.has(Predicate::PowerOn)) non_kin["ToggledOn"] = {{"value", true}, {"hand_in_marker_steps", 0}};
    if (node.opening > 0) left_out_.push_back(node.id + ": how far it is open");
    const Quat along_x(std::sqrt(0.5), 0, 0, std::sqrt(0.5));  // models' fronts look along x, ours along -y
    state_[name] = resting(node.pose.position, node.pose.rotation * along_x.conjugate(), std::move(non_kin));
  }

  const Scene& scene_;
  const Knowledge& knowledge_;
  Json info_ = Json::object(), state_ = Json::object();
  std::map<std::string, std::size_t> count_;  // instances of each model so far
  std::set<std::string> own_names_;           // of all nodes, some of which are OmniGibson's own
  std::map<std::string, std::string> names_;
  std::vector<std::string> left_out_;
};

}  // namespace

bool has_behavior_model(const Node& node, const Knowledge& knowledge) { return model_of(node, knowledge) != nullptr; }

Result<ExportedScene> write_behavior(const Scene& scene, const Knowledge& knowledge) {
  if (scene.simulator != Simulator::Behavior)
    return Error{Error::Kind::Schema, scene.id, {}, "a BEHAVIOR scene needs objects of BEHAVIOR"};
  return BehaviorWriter(scene, knowledge).write();
}

}  // namespace unietp
