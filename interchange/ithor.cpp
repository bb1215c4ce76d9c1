#include <algorithm>
#include <charconv>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "interchange/foreign_json.h"
#include "interchange/formats.h"
#include "interchange/json_fields.h"
#include "interchange/unity.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// "FloorPlan203_physics" → "living_room": iTHOR numbers its scenes by the kind of room.
std::string room_type(std::string_view scene, const std::string& said) {
  if (!said.empty()) {
    std::string type = replace_all(lower(said), " ", "_");
    if (type.ends_with('s')) type.pop_back();
    return type == "livingroom" ? "living_room" : type;
  }
  const auto digits = scene.find_first_of("0123456789");
  int number = 0;
  if (digits != std::string_view::npos) std::from_chars(scene.data() + digits, scene.data() + scene.size(), number);
  if (number > 0 && number <= 30) return "kitchen";
  if (number > 300 && number <= 330) return "bedroom";
  if (number > 400 && number <= 430) return "bathroom";
  return "living_room";
}

class Reader {
 public:
  explicit Reader(std::string_view where) : reader_(where) {}

  /// Adds the scenes of one value, called `name` if it has one without a name. Returns the first error.
  std::optional<Error> read(const JsonAt& root, const std::string& name, std::vector<SourceScene>& scenes) {
    read_value(root, name, scenes);
    keep_to_a_file(reader_, root, scenes);
    return reader_.error();
  }

 private:
  void read_value(const JsonAt& at, const std::string& name, std::vector<SourceScene>& scenes) {
    if (at.json.is_array()) return scenes.push_back(scene(at, at, name, ""));
    const LooseFields fields(reader_, at);
    if (const auto metadata = fields.find("metadata")) return read_value(*metadata, name, scenes);
    if (const auto table = fields.find("scenes")) {
      if (!table->json.is_object()) return reader_.fail(*table, "expected an object with one scene per field");
      for (const auto& [id, value] : *table->json.get_ptr<const Json::object_t*>()) {
        const JsonAt one{value, &*table, id, 0};
        const LooseFields own(reader_, one);
        if (const auto objects = own.need("objects")) scenes.push_back(scene(one, *objects, id, own.text("room")));
        if (reader_.error()) return;
      }
      return;
    }
    const std::string said = fields.text("sceneName");
    if (const auto objects = fields.need("objects")) {
      scenes.push_back(scene(at, *objects, said.empty() ? name : said, fields.text("room")));
    }
  }

  SourceScene scene(const JsonAt& at, const JsonAt& objects, const std::string& id, const std::string& room) {
    SourceScene scene;
    scene.id = id;
    scene.simulator = Simulator::Ai2thor;
    const std::size_t count = objects_in(reader_, objects);
    for (std::size_t i = 0; i < count && !reader_.error(); ++i) {
      scene.objects.push_back(object(reader_.item(objects, i)));
    }
    draw_room(scene, room_type(id, room));
    if (at.json.is_object()) read_agent(at, scene);
    return scene;
  }

  SourceObject object(const JsonAt& at) {
    const LooseFields fields(reader_, at);
    SourceObject object;
    if (const auto f = fields.need("objectId")) object.id = reader_.text(*f);
    if (const auto f = fields.need("objectType")) object.category = reader_.text(*f);
    object.asset = fields.text("assetId");
    object.mass = fields.number("mass");
    object.opening = fields.flag("isOpen") ? fields.number("openness", 1) : 0;
    read_box(at, object);
    read_states(at, object);
    if (const auto states = fields.find("states")) {
      read_states(*states, object);
      if (LooseFields(reader_, *states).flag("isOpen")) object.opening = 1;
    }
    for (const std::string& holder : fields.texts("parentReceptacles")) {
      object.held_by.push_back({SourceRelation::Kind::OnOrInside, holder});
    }
    return object;
  }

  void read_box(const JsonAt& at, SourceObject& object) {
    const LooseFields fields(reader_, at);
    Vec3 position = Vec3::Zero(), angles = Vec3::Zero();
    if (const auto f = fields.need("position")) position = vector_at(reader_, *f);
    if (const auto f = fields.find("rotation")) angles = vector_at(reader_, *f);
    const Quat facing = rotation_from_unity(angles);
    object.pose = {from_unity(position), facing};
    Vec3 center = position, extents = Vec3::Zero();
    if (const auto f = fields.find("aabbCenter")) center = vector_at(reader_, *f);
    if (const auto f = fields.find("aabbSize")) extents = vector_at(reader_, *f);
    if (const auto f = fields.find("axisAlignedBoundingBox")) {
      const LooseFields box(reader_, *f);
      if (const auto c = box.need("center")) center = vector_at(reader_, *c);
      if (const auto s = box.need("size")) extents = vector_at(reader_, *s);
    }
    if (extents.maxCoeff() > 0) {
      const PosedBox box = box_within(from_unity(center), from_unity(extents), facing);
      object.pose = box.pose;
      object.size = box.size;
    }
    if (const auto corners = fields.find("obbCorners")) read_corners(*corners, facing, object);
    if (const auto f = fields.find("objectOrientedBoundingBox")) {
      const auto corners = LooseFields(reader_, *f).find("cornerPoints");
      if (corners) read_corners(*corners, facing, object);
    }
  }

  void read_corners(const JsonAt& at, const Quat& facing, SourceObject& object) {
    std::array<Vec3, 8> corners;
    if (reader_.items(at) != corners.size()) return reader_.fail(at, "expected eight corners");
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i] = from_unity(vector_at(reader_, reader_.item(at, i)));
    }
    const auto box = box_of_corners(corners, facing);
    if (!box) return;  // a flat or broken box: the axis-aligned one says more
    object.pose = box->pose;
    object.size = box->size;
  }

  void read_states(const JsonAt& at, SourceObject& object) {
    const LooseFields fields(reader_, at);
    const auto add = [&](const char* field, Predicate predicate) {
      if (fields.flag(field)) object.states.push_back({predicate, {}});
    };
    add("isToggled", Predicate::PowerOn);
    add("isDirty", Predicate::Dirty);
    add("isCooked", Predicate::Cooked);
    add("isBroken", Predicate::Broken);
    add("isSliced", Predicate::Sliced);
    add("isUsedUp", Predicate::UsedUp);
    if (fields.flag("isFilledWithLiquid")) {
      const std::string liquid = fields.text("fillLiquid");
      object.states.push_back({Predicate::Filled, liquid.empty() ? "water" : lower(liquid)});
    }
    const std::string temperature = fields.text("temperature");
    if (temperature == "Hot") object.states.push_back({Predicate::Hot, {}});
    if (temperature == "Cold") object.states.push_back({Predicate::Cool, {}});
  }

  /// iTHOR's scenes are one room each and have no walls: the room is what its floors cover and what stands on them.
  /// Heights count from the floor's upper face.
  static void draw_room(SourceScene& scene, const std::string& type) {
    std::optional<Bounds> floor;
    const auto add = [&](const Bounds& bounds) {
      if (!floor) floor = bounds;
      floor->low = floor->low.cwiseMin(bounds.low);
      floor->high.head<2>() = floor->high.head<2>().cwiseMax(bounds.high.head<2>());
    };
    for (const SourceObject& object : scene.objects) {
      if (object.category == "Floor" && object.size.maxCoeff() > 0) add(bounds_of(object.pose, object.size));
    }
    if (!floor) return;
    const double level = floor->high.z();
    const Bounds reach{floor->low - Vec3::Constant(0.5), floor->high + Vec3::Constant(0.5)};
    for (SourceObject& object : scene.objects) {
      object.pose.position.z() -= level;
      const Bounds box = bounds_of(object.pose, object.size);
      const Vec2 middle = object.pose.position.head<2>();
      const bool near = (middle - reach.low.head<2>()).minCoeff() > 0 && (reach.high.head<2>() - middle).minCoeff() > 0;
      if (near && object.size.head<2>().maxCoeff() < 1) add(box);
    }
    const double out = scene.wall_thickness / 2 + 0.005;
    const Vec2 low = floor->low.head<2>() - Vec2::Constant(out), high = floor->high.head<2>() + Vec2::Constant(out);
    scene.rooms.push_back({type + "_1", type, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}});
  }

  void read_agent(const JsonAt& at, SourceScene& scene) {
    const auto agent = LooseFields(reader_, at).find("agent");
    if (!agent) return;
    const LooseFields fields(reader_, *agent);
    const auto position = fields.find("position"), rotation = fields.find("rotation");
    if (!position || !rotation) return;
    scene.has_agent = true;
    scene.agent = agent_from_unity(vector_at(reader_, *position), vector_at(reader_, *rotation).y(),
                                   fields.number("cameraHorizon"));
  }

  JsonReader reader_;
};

}  // namespace

Result<std::vector<SourceScene>> read_ithor(const std::string& where, std::string_view text) {
  std::vector<SourceScene> scenes;
  Reader reader(where);
  const auto read = each_json_value(where, text, [&](const JsonAt& root, int line) {
    return reader.read(root, line == 0 ? "scene" : "scene_" + std::to_string(scenes.size() + 1), scenes);
  });
  if (!read) return read.error();
  return scenes;
}

}  // namespace unietp
