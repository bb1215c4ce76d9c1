#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "interchange/foreign_json.h"
#include "interchange/formats.h"
#include "interchange/habitat_boxes.h"
#include "interchange/habitat_frame.h"
#include "interchange/scene_models.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

constexpr double kOriginIsBase_m = 0.15;  // an articulated piece whose root is lower than this stands on its root

/// One instance as the file has it.
struct Instance {
  std::string name;
  Vec3 translation = Vec3::Zero();
  Quat rotation = Quat::Identity();
  Vec3 scale = Vec3::Ones();
  bool asset_origin = false;  // `translation` is that of the asset's own origin, not of its middle
  bool articulated = false;
  bool ours = false;  // our own exports give the pose of the middle
};

bool is_asset_local(const JsonAt& holder, bool otherwise) {
  const auto origin = given(holder, "translation_origin");
  if (!origin || !origin->json.is_string()) return otherwise;
  std::string name = origin->json.get<std::string>();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name == "asset_local";
}

Vec3 scale_of(JsonReader& reader, const JsonAt& at) {
  Vec3 scale = Vec3::Ones();
  if (const auto f = given(at, "uniform_scale")) scale *= reader.number(*f);
  if (const auto f = given(at, "non_uniform_scale")) scale = scale.cwiseProduct(reader.vec3(*f));
  if (!reader.error() && scale.cwiseAbs().minCoeff() <= 0) reader.fail(at, "expected a scale that is not zero");
  return scale.cwiseAbs();
}

class HabitatImporter {
 public:
  HabitatImporter(JsonReader& reader, const Knowledge& knowledge, const FormatFacts& facts, const SceneModels& models)
      : reader_(reader), knowledge_(knowledge), facts_(facts), models_(models) {}

  SourceScene scene(const JsonAt& home, std::string id) {
    scene_.id = std::move(id);
    scene_.simulator = Simulator::Habitat;
    asset_origin_ = is_asset_local(home, false);
    if (const auto own = given(home, "user_defined")) read_own(*own);
    for (const char* list : {"object_instances", "articulated_object_instances"}) {
      const auto instances = given(home, list);
      if (!instances) continue;
      const std::size_t count = objects_in(reader_, *instances);
      for (std::size_t i = 0; i < count && !reader_.error(); ++i) {
        const JsonAt at = reader_.item(*instances, i);
        read_instance(at, list != std::string_view("object_instances"));
      }
    }
    warn("objects have the typical size of their category, since a scene instance says none", typical_);
    warn("of these stand on the floor, and the height of their middle says how tall they are", fitted_);
    return std::move(scene_);
  }

 private:
  void warn(const char* what, int count) {
    if (count > 0) scene_.warnings.push_back(std::to_string(count) + " " + what);
  }

  void read_instance(const JsonAt& at, bool articulated) {
    JsonFields fields(reader_, at);
    Instance instance;
    instance.articulated = articulated;
    if (const auto f = fields.required("template_name")) instance.name = bare_template(reader_.text(*f));
    if (const auto f = given(at, "translation")) instance.translation = reader_.vec3(*f);
    if (const auto f = given(at, "rotation")) instance.rotation = rounded_rotation(reader_, *f, QuatOrder::Wxyz);
    instance.scale = scale_of(reader_, at);
    instance.asset_origin = is_asset_local(at, asset_origin_);
    const auto own = given(at, "user_defined");
    instance.ours = own && given(*own, "category");
    if (reader_.error()) return;
    SourceObject object;
    object.id = instance.name + "_" + std::to_string(counts_[instance.name]++);
    identify(instance, object);
    place(instance, object);
    if (const auto joints = given(at, "initial_joint_pose")) object.opening = opening_of(*joints);
    if (own) read_own_object(*own, object);
    scene_.objects.push_back(std::move(object));
  }

  /// Category, size, mass and model, as far as anything knows them.
  void identify(const Instance& instance, SourceObject& object) {
    const Asset* asset = knowledge_.asset(instance.name);
    if (asset != nullptr) {
      object.category = asset->category;
      object.asset = asset->name;
      object.size = asset->size.cwiseProduct(lengths_from_habitat(instance.scale));
    } else {
      object.category = habitat_category(instance.name, knowledge_, facts_);
    }
    for (const SceneModels* table : {&models_, &std::as_const(own_models_)}) {
      const auto found = table->find(instance.name);
      if (found == table->end()) continue;
      const SceneModel& model = found->second;
      if (!model.category.empty()) object.category = model.category;
      if (!model.size.isZero()) object.size = model.size.cwiseProduct(lengths_from_habitat(instance.scale));
      if (model.mass > 0) object.mass = model.mass;
    }
  }

  void place(const Instance& instance, SourceObject& object) {
    Quat rotation = instance.rotation;
    // Models of robots' description files are z up in their own frame and stand upright by a quarter turn.
    if (instance.articulated && (rotation * Vec3::UnitZ()).y() > 0.9) {
      rotation = rotation * Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()));
    }
    object.pose = {from_habitat(instance.translation), rotation_from_habitat(rotation)};
    const bool sized = !object.size.isZero();
    if (!sized) take_typical_size(instance, object);
    const bool stands_on_origin =
        instance.asset_origin || (instance.articulated && !instance.ours && object.pose.position.z() < kOriginIsBase_m);
    if (stands_on_origin) object.pose.position += object.pose.rotation * Vec3(0, 0, object.size.z() / 2);
  }

  /// Furniture on the floor is as tall as twice the height of its middle, where the file gives that.
  void take_typical_size(const Instance& instance, SourceObject& object) {
    const Category* category = knowledge_.find(object.category);
    if (category == nullptr) return;
    ++typical_;
    object.size = category->size;
    const double tall = 2 * object.pose.position.z(), upright = (object.pose.rotation * Vec3::UnitZ()).z();
    const bool on_floor = !category->movable && category->archetype != Archetype::Panel &&
                          category->archetype != Archetype::Fixture && upright > 0.99 && !instance.asset_origin;
    if (!on_floor || tall < object.size.z() / 2 || tall > object.size.z() * 2) return;
    object.size.z() = tall;
    ++fitted_;
  }

  /// Joint positions in radians or meters: how far of a quarter turn.
  double opening_of(const JsonAt& joints) {
    double most = 0;
    const auto add = [&](const JsonAt& value) { most = std::max(most, std::abs(reader_.number(value))); };
    if (joints.json.is_object()) {
      for (const auto& [name, value] : joints.json.items()) add(JsonAt{value, &joints, name, 0});
    } else {
      const std::size_t count = reader_.items(joints);
      for (std::size_t i = 0; i < count && !reader_.error(); ++i) add(reader_.item(joints, i));
    }
    return most < 0.01 ? 0 : std::min(1.0, most / (M_PI / 2));
  }

  // What our own exports add, where Habitat lets a user add something.
  void read_own(const JsonAt& own) {
    if (const auto f = given(own, "templates")) own_models_ = scene_models_from_json(reader_, *f);
    if (const auto f = given(own, "regions")) read_regions(*f);
    if (const auto f = given(own, "openings")) read_openings(*f);
    if (const auto f = given(own, "agent")) read_agent(*f);
  }

  void read_regions(const JsonAt& list) {
    const std::size_t count = objects_in(reader_, list);
    for (std::size_t i = 0; i < count && !reader_.error(); ++i) {
      const JsonAt at = reader_.item(list, i);
      JsonFields fields(reader_, at);
      Room room;
      if (const auto f = fields.required("name")) room.id = reader_.text(*f);
      if (const auto f = fields.required("label")) room.type = reader_.text(*f);
      if (const auto f = fields.required("poly_loop")) {
        const std::size_t corners = objects_in(reader_, *f);
        for (std::size_t k = 0; k < corners && !reader_.error(); ++k) {
          room.polygon.push_back(from_habitat(reader_.vec3(reader_.item(*f, k))).head<2>());
        }
        if (!reader_.error() && corners < 3) reader_.fail(*f, "expected at least three corners");
      }
      if (const auto f = given(at, "extrusion_height")) scene_.wall_height = reader_.positive(*f);
      scene_.rooms.push_back(std::move(room));
    }
  }

  void read_openings(const JsonAt& list) {
    const std::size_t count = objects_in(reader_, list);
    for (std::size_t i = 0; i < count && !reader_.error(); ++i) {
      const JsonAt at = reader_.item(list, i);
      JsonFields fields(reader_, at);
      Opening opening;
      if (const auto f = fields.required("name")) opening.id = reader_.text(*f);
      if (const auto f = fields.required("rooms")) {
        const auto rooms = reader_.texts(*f);
        if (!reader_.error() && rooms.size() != 2) reader_.fail(*f, "expected two rooms");
        if (rooms.size() == 2) opening.room_a = rooms[0], opening.room_b = rooms[1];
      }
      if (const auto f = fields.required("from")) opening.from = from_habitat(reader_.vec3(*f)).head<2>();
      if (const auto f = fields.required("to")) opening.to = from_habitat(reader_.vec3(*f)).head<2>();
      if (const auto f = fields.required("height")) opening.height = reader_.positive(*f);
      scene_.openings.push_back(std::move(opening));
    }
  }

  void read_agent(const JsonAt& at) {
    JsonFields fields(reader_, at);
    scene_.has_agent = true;
    if (const auto f = fields.required("translation")) {
      scene_.agent.position = from_habitat(reader_.vec3(*f)).head<2>();
    }
    if (const auto f = fields.required("rotation")) {
      const Vec3 forward = rotation_from_habitat(rounded_rotation(reader_, *f, QuatOrder::Wxyz)) * -Vec3::UnitY();
      scene_.agent.yaw = std::atan2(forward.y(), forward.x());
    }
    if (const auto f = given(at, "held")) scene_.agent.held = reader_.texts(*f);
  }

  void read_own_object(const JsonAt& own, SourceObject& object) {
    if (const auto f = given(own, "name")) object.id = reader_.text(*f);
    if (const auto f = given(own, "category")) object.category = reader_.text(*f);
    if (const auto f = given(own, "mass")) object.mass = reader_.number(*f);
    if (const auto f = given(own, "opening")) object.opening = reader_.number(*f);
    if (const auto f = given(own, "states")) {
      for (const std::string& text : reader_.texts(*f)) read_state(*f, text, object);
    }
  }

  /// "dirty", "filled(water)"
  void read_state(const JsonAt& at, const std::string& text, SourceObject& object) {
    const std::size_t bracket = std::min(text.find('('), text.size());
    const auto predicate = predicate_named(std::string_view(text).substr(0, bracket));
    if (!predicate) return reader_.fail(at, "unknown state " + in_quotes(text));
    const bool symbol = bracket < text.size() && text.back() == ')';
    object.states.push_back({*predicate, symbol ? text.substr(bracket + 1, text.size() - bracket - 2) : ""});
  }

  JsonReader& reader_;
  const Knowledge& knowledge_;
  const FormatFacts& facts_;
  const SceneModels& models_;
  SceneModels own_models_;  // of the file itself
  bool asset_origin_ = false;
  std::map<std::string, int> counts_;
  int typical_ = 0, fitted_ = 0;
  SourceScene scene_;
};

}  // namespace

Result<std::vector<SourceScene>> read_habitat(const std::string& where, std::string_view text,
                                              const Knowledge& knowledge, const FormatFacts& facts,
                                              const SceneModels& models) {
  return read_homes(where, text, {"object_instances", "articulated_object_instances", "stage_instance", "objects"},
                    [&](JsonReader& reader, const JsonAt& home, std::string id) {
                      if (given(home, "objects")) return read_labeled_boxes(reader, home, std::move(id), knowledge);
                      return HabitatImporter(reader, knowledge, facts, models).scene(home, std::move(id));
                    });
}

Result<std::vector<SourceScene>> read_habitat(const std::string& where, std::string_view text,
                                              const Knowledge& knowledge, const FormatFacts& facts) {
  return read_habitat(where, text, knowledge, facts, {});
}

}  // namespace unietp
