#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "interchange/behavior_objects.h"
#include "interchange/behavior_rooms.h"
#include "interchange/foreign_json.h"
#include "interchange/formats.h"
#include "interchange/scene_models.h"

namespace unietp {
namespace {

constexpr double kUpright = 0.999;
constexpr double kOpen = 0.05;  // radians or meters from which a joint is open

/// Models' fronts look along x, ours along -y.
const Quat kFrontAlongX(std::sqrt(0.5), 0, 0, std::sqrt(0.5));

class BehaviorImporter {
 public:
  BehaviorImporter(const Knowledge& knowledge, const SceneModels& models) : knowledge_(knowledge), models_(models) {
    // A model keeps its six letters when a later release renames its category.
    for (const Asset& asset : knowledge.assets()) by_letters_.emplace(letters_of(asset.name), asset.name);
    for (const auto& [name, model] : models) by_letters_.emplace(letters_of(name), name);
  }

  SourceScene scene(const std::vector<BehaviorObject>& objects, const std::vector<std::string>& missing,
                    std::string id) {
    scene_.id = std::move(id);
    scene_.simulator = Simulator::Behavior;
    for (const BehaviorObject& object : objects) add(object);
    stand_up_by_the_floor();
    add_floor_rooms(scene_);
    if (!missing.empty()) {
      scene_.warnings.push_back(std::to_string(missing.size()) + " objects have no pose in the state, as " +
                                missing.front().substr(0, 60));
    }
    return std::move(scene_);
  }

 private:
  static std::string letters_of(std::string_view name) { return std::string(name.substr(name.rfind('-') + 1)); }

  void add(const BehaviorObject& from) {
    if (from.robot) return add_agent(from);
    SourceObject object;
    object.id = from.name;
    object.category = from.category;
    object.pose = {from.root.position, from.root.rotation * kFrontAlongX};
    if (!from.rooms.empty()) object.room = from.rooms.front();
    identify(from, object);
    if (from.joint > kOpen) {
      object.opening = std::min(1.0, from.joint / (M_PI / 2));
      object.states.push_back({Predicate::Open, ""});
    }
    if (from.has_switch_state) {
      object.states.push_back({from.switched_on ? Predicate::PowerOn : Predicate::PowerOff, ""});
    }
    scene_.objects.push_back(std::move(object));
  }

  void add_agent(const BehaviorObject& from) {
    if (scene_.has_agent) return scene_.warnings.push_back("another robot, " + from.name.substr(0, 60));
    scene_.has_agent = true;
    scene_.agent.position = from.root.position.head<2>();
    scene_.agent.yaw = yaw_of(from.root);
  }

  void identify(const BehaviorObject& from, SourceObject& object) {
    std::string name = from.category + "-" + from.model;
    if (knowledge_.asset(name) == nullptr && !models_.contains(name)) {
      if (const auto found = by_letters_.find(from.model); found != by_letters_.end()) name = found->second;
    }
    const Asset* asset = knowledge_.asset(name);
    const auto model = models_.find(name);
    Vec3 size = Vec3::Zero();
    if (asset != nullptr) {
      size = asset->size;
      object.asset = name;
    }
    if (model != models_.end()) {
      if (!model->second.size.isZero()) size = model->second.size;
      object.mass = model->second.mass;
    }
    const std::string renamed = asset != nullptr         ? asset->category
                                : model != models_.end() ? model->second.category
                                                         : "";
    if (knowledge_.find(from.category) == nullptr && !renamed.empty()) object.category = renamed;
    object.size = size.cwiseProduct(Vec3(from.scale.y(), from.scale.x(), from.scale.z()));
    if (!from.box.isZero()) object.size = Vec3(from.box.y(), from.box.x(), from.box.z());
  }

  /// The root link stands at a model's middle of mass, not in the middle of its box, and how far apart the two are is
  /// in no file. One that is near to the floor tells how high the middle of the box is: those of one model agree, and
  /// the others of that model (on a stage, on a shelf) follow. What is left keeps the root link's pose.
  void stand_up_by_the_floor() {
    using Model = std::tuple<std::string, int, int, int>;  // with its height and the axis that is up
    struct Stand {
      double gap = 0;  // from the box's lower side to the floor, were its middle the root link
      std::vector<std::size_t> objects;
    };
    std::map<Model, Stand> stands;
    const double floor = floor_height();
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      const SourceObject& object = scene_.objects[i];
      const Vec3 up = object.pose.rotation.conjugate() * Vec3::UnitZ();
      int axis = 0;
      if (up.cwiseAbs().maxCoeff(&axis) < kUpright || object.size.isZero() || object.category == "floors") continue;
      const double height = object.size[axis];
      const double gap = object.pose.position.z() - height / 2 - floor;
      const Model model{object.category + object.asset, static_cast<int>(std::lround(height * 1000)), axis,
                        up[axis] > 0 ? 1 : -1};
      auto [stand, fresh] = stands.try_emplace(model, Stand{gap, {}});
      if (std::abs(gap) < std::abs(stand->second.gap)) stand->second.gap = gap;
      stand->second.objects.push_back(i);
    }
    int shifted = 0;
    for (const auto& [model, stand] : stands) {
      if (std::abs(stand.gap) > 0.001 * std::get<1>(model) / 2) continue;
      for (const std::size_t i : stand.objects) {
        scene_.objects[i].pose.position.z() -= stand.gap;
        shifted += std::abs(stand.gap) > 0.02 ? 1 : 0;
      }
    }
    if (shifted == 0) return;
    scene_.warnings.push_back(std::to_string(shifted) +
                              " objects are more than 2 cm from the height that their root link suggests: the "
                              "center of their box follows from the part of their model that stands on the floor");
  }

  double floor_height() const {
    double top = 0;
    bool found = false;
    for (const SourceObject& object : scene_.objects) {
      if (object.category != "floors" || object.size.isZero()) continue;
      const double height = bounds_of(object.pose, object.size).high.z();
      top = found ? std::min(top, height) : height;
      found = true;
    }
    return top;
  }

  const Knowledge& knowledge_;
  const SceneModels& models_;
  std::map<std::string, std::string> by_letters_;
  SourceScene scene_;
};

}  // namespace

Result<std::vector<SourceScene>> read_behavior(const std::string& where, std::string_view text,
                                               const Knowledge& knowledge, const SceneModels& models) {
  return read_homes(where, text, {"objects", "objects_info", "state"},
                    [&](JsonReader& reader, const JsonAt& home, std::string id) {
                      std::vector<std::string> missing;
                      const auto objects = read_behavior_objects(reader, home, missing);
                      if (reader.error()) return SourceScene();
                      if (const auto name = given(home, "scene")) id = reader.text(*name);
                      return BehaviorImporter(knowledge, models).scene(objects, missing, std::move(id));
                    });
}

Result<std::vector<SourceScene>> read_behavior(const std::string& where, std::string_view text,
                                               const Knowledge& knowledge) {
  return read_behavior(where, text, knowledge, {});
}

}  // namespace unietp
