#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "interchange/formats.h"
#include "interchange/house_names.h"
#include "interchange/json_fields.h"
#include "interchange/own_ids.h"
#include "interchange/unity.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kWallThickness_m = 0.02;   // the walls of a house are sheets, and things stand right at them
constexpr double kWindowThickness_m = 0.1;  // of a window whose model the knowledge base lacks

/// The lower edge of a wall.
struct Wall {
  Vec2 start = Vec2::Zero(), along = Vec2::UnitX();  // `along` is a unit vector
};

class HouseReader {
 public:
  HouseReader(JsonReader& reader, const Knowledge& knowledge) : reader_(reader), knowledge_(knowledge) {}

  SourceScene read(const JsonAt& at, std::string id) {
    scene_.id = std::move(id);
    scene_.simulator = Simulator::Ai2thor;
    scene_.wall_thickness = kWallThickness_m;
    const LooseFields fields(reader_, at);
    each(fields.need("rooms"), limits::kRooms, [this](const JsonAt& room) { read_room(room); });
    each(fields.find("walls"), limits::kWalls, [this](const JsonAt& wall) { read_wall(wall); });
    if (highest_ > 0.5) scene_.wall_height = highest_;
    open_missing_walls();
    each(fields.find("doors"), limits::kOpenings, [this](const JsonAt& door) { read_door(door); });
    each(fields.need("objects"), limits::kListedObjects, [this](const JsonAt& object) { read_object(object, ""); });
    each(fields.find("windows"), limits::kOpenings, [this](const JsonAt& window) { read_window(window); });
    if (const auto metadata = fields.find("metadata")) {
      if (const auto agent = LooseFields(reader_, *metadata).find("agent")) read_agent(*agent);
    }
    return std::move(scene_);
  }

 private:
  template <class Read>
  void each(const std::optional<JsonAt>& list, std::size_t most, Read read) {
    if (!list) return;
    const std::size_t count = reader_.items(*list, most);
    for (std::size_t i = 0; i < count && !reader_.error(); ++i) read(reader_.item(*list, i));
  }

  std::vector<Vec3> points(const std::optional<JsonAt>& at) {
    std::vector<Vec3> all;
    each(at, limits::kRoomCorners, [&](const JsonAt& point) { all.push_back(vector_at(reader_, point)); });
    return all;
  }

  void read_room(const JsonAt& at) {
    const LooseFields fields(reader_, at);
    Room room;
    room.type = room_type_from_procthor(fields.text("roomType"));
    const auto outline = fields.need("floorPolygon");
    for (const Vec3& corner : points(outline)) room.polygon.push_back(from_unity(corner).head<2>());
    if (room.polygon.size() < 3 && outline) return reader_.fail(*outline, "expected three corners or more");
    const auto id = fields.need("id");
    const std::string theirs = id ? reader_.text(*id) : "", count = std::to_string(++rooms_of_type_[room.type]);
    room.id = simulators_room_id(room.type, theirs, Simulator::Ai2thor);
    if (room.id.empty() || room_names_.contains(theirs)) room.id = room.type + "_" + count;
    room_names_.try_emplace(theirs, room.id);
    scene_.rooms.push_back(std::move(room));
  }

  void read_wall(const JsonAt& at) {
    const LooseFields fields(reader_, at);
    const auto polygon = fields.need("polygon");
    const std::vector<Vec3> corners = points(polygon);
    if (corners.size() < 2) return reader_.fail(*polygon, "expected the corners of a wall");
    Wall wall;
    wall.start = from_unity(corners[0]).head<2>();
    const Vec2 end = from_unity(corners[1]).head<2>(), whole = end - wall.start;
    if (whole.norm() > 1e-6) wall.along = whole.normalized();
    if (fields.flag("empty")) missing_walls_.emplace_back(wall.start, end);
    for (const Vec3& corner : corners) highest_ = std::max(highest_, corner.y());
    if (const auto id = fields.need("id")) walls_.try_emplace(reader_.text(*id), wall);
  }

  /// Where a wall is `empty` two rooms are one space; each of them lists it.
  void open_missing_walls() {
    for (const auto& [start, end] : missing_walls_) {
      const Vec2 along = end - start, across = Vec2(-along.y(), along.x()).normalized() * 0.05;
      const Room *a = room_under((start + end) / 2 + across), *b = room_under((start + end) / 2 - across);
      const bool listed =
          std::any_of(scene_.openings.begin(), scene_.openings.end(), [&, s = start, e = end](const Opening& one) {
            return std::min((one.from - s).norm() + (one.to - e).norm(), (one.from - e).norm() + (one.to - s).norm()) <
                   0.01;
          });
      if (a == nullptr || b == nullptr || a == b || listed) continue;
      scene_.openings.push_back({opening_name(), a->id, b->id, start, end, scene_.wall_height});
    }
  }

  const Room* room_under(const Vec2& point) const {
    const auto found = std::find_if(scene_.rooms.begin(), scene_.rooms.end(),
                                    [&](const Room& room) { return contains(room.polygon, point); });
    return found == scene_.rooms.end() ? nullptr : &*found;
  }

  std::string opening_name() const { return "opening_" + std::to_string(scene_.openings.size() + 1); }

  /// A door's or window's wall, and the two corners of its hole: along the wall and up, meters.
  struct Hole {
    Wall wall;
    double from = 0, to = 0, low = 0, high = 0;
  };
  std::optional<Hole> hole_of(const JsonAt& at, const LooseFields& fields) {
    const auto wall = fields.need("wall0");
    const auto polygon = fields.need("holePolygon");
    if (!wall || !polygon) return std::nullopt;
    const std::string name = reader_.text(*wall);
    const auto found = walls_.find(name);
    if (found == walls_.end()) {
      reader_.fail(*wall, "no wall " + name);
      return std::nullopt;
    }
    const std::vector<Vec3> corners = points(polygon);
    if (corners.size() < 2) {
      reader_.fail(at, "expected two corners of the hole");
      return std::nullopt;
    }
    const auto [from, to] = std::minmax(corners[0].x(), corners[1].x());
    const auto [low, high] = std::minmax(corners[0].y(), corners[1].y());
    return Hole{found->second, from, to, low, high};
  }

  void read_door(const JsonAt& at) {
    const LooseFields fields(reader_, at);
    const auto hole = hole_of(at, fields);
    if (!hole) return;
    const auto a = room_names_.find(fields.text("room0")), b = room_names_.find(fields.text("room1"));
    if (a == room_names_.end() || b == room_names_.end() || a == b) {
      scene_.warnings.push_back("the door " + fields.text("id") + " leads out of the house");
      return;
    }
    scene_.openings.push_back({opening_name(), a->second, b->second, hole->wall.start + hole->from * hole->wall.along,
                               hole->wall.start + hole->to * hole->wall.along, hole->high});
  }

  void read_window(const JsonAt& at) {
    const LooseFields fields(reader_, at);
    const auto hole = hole_of(at, fields);
    if (!hole) return;
    SourceObject window;
    window.id = fields.text("id");
    window.category = "Window";
    window.asset = fields.text("assetId");
    window.size = Vec3(hole->to - hole->from, kWindowThickness_m, hole->high - hole->low);
    if (const Asset* asset = knowledge_.asset(window.asset)) window.size = asset->size;
    double along = (hole->from + hole->to) / 2, up = (hole->low + hole->high) / 2;
    if (const auto f = fields.find("assetPosition")) {
      const Vec3 position = vector_at(reader_, *f);
      along = position.x();
      up = position.y();
    }
    const Vec2 middle = hole->wall.start + along * hole->wall.along;
    const auto room = room_names_.find(fields.text("room0"));
    window.pose = upright(Vec3(middle.x(), middle.y(), up),
                          facing_into(room == room_names_.end() ? "" : room->second, middle, hole->wall.along));
    scene_.objects.push_back(std::move(window));
  }

  /// Yaw with which something on a wall faces the room.
  double facing_into(const std::string& room, const Vec2& middle, const Vec2& along) const {
    const Vec2 across(-along.y(), along.x());
    const double yaw = std::atan2(along.y(), along.x());  // faces -across
    const auto found =
        std::find_if(scene_.rooms.begin(), scene_.rooms.end(), [&](const Room& one) { return one.id == room; });
    const bool ahead = found == scene_.rooms.end() || contains(found->polygon, middle - 0.05 * across);
    return ahead ? yaw : std::remainder(yaw + std::numbers::pi, 2 * std::numbers::pi);
  }

  void read_object(const JsonAt& at, const std::string& holder) {
    const LooseFields fields(reader_, at);
    SourceObject object;
    if (const auto f = fields.need("id")) object.id = reader_.text(*f);
    object.asset = fields.text("assetId");
    const Asset* asset = knowledge_.asset(object.asset);
    object.category = fields.text("objectType");
    if (object.category.empty() && asset != nullptr) object.category = asset->category;
    if (object.category.empty()) object.category = object.id.substr(0, object.id.find('|'));
    if (asset != nullptr) object.size = asset->size;
    Vec3 position = Vec3::Zero();
    if (const auto f = fields.need("position")) position = vector_at(reader_, *f);
    object.pose.position = from_unity(position);
    if (const auto f = fields.find("rotation")) object.pose.rotation = rotation(*f);
    object.opening = std::clamp(fields.number("openness"), 0.0, 1.0);
    if (object.opening > 0) object.states.push_back({Predicate::Open, {}});
    if (fields.flag("isDirty")) object.states.push_back({Predicate::Dirty, {}});
    if (fields.flag("isOn")) object.states.push_back({Predicate::PowerOn, {}});
    if (!holder.empty()) object.held_by.push_back({SourceRelation::Kind::OnOrInside, holder});
    const std::string id = object.id;
    scene_.objects.push_back(std::move(object));
    each(fields.find("children"), limits::kListedObjects, [&](const JsonAt& child) { read_object(child, id); });
  }

  /// Euler angles, or an axis and an angle.
  Quat rotation(const JsonAt& at) {
    const LooseFields fields(reader_, at);
    const auto axis = at.json.is_object() ? fields.find("axis") : std::nullopt;
    if (!axis) return rotation_from_unity(vector_at(reader_, at));
    const Vec3 direction = vector_at(reader_, *axis);
    const double degrees = fields.number("degrees");
    if (direction.norm() < 1e-9) return rotation_from_unity(Vec3::Zero());
    // Swapping y and z mirrors the frame, so the same turn runs the other way.
    const double turn = -degrees * std::numbers::pi / 180;
    return Quat(Eigen::AngleAxisd(turn, from_unity(direction).normalized())) * rotation_from_unity(Vec3::Zero());
  }

  void read_agent(const JsonAt& at) {
    const LooseFields fields(reader_, at);
    const auto position = fields.need("position");
    if (!position) return;
    const auto turned = fields.find("rotation");
    scene_.has_agent = true;
    scene_.agent = agent_from_unity(vector_at(reader_, *position), turned ? vector_at(reader_, *turned).y() : 0,
                                    fields.number("horizon"));
  }

  JsonReader& reader_;
  const Knowledge& knowledge_;
  SourceScene scene_;
  std::map<std::string, int> rooms_of_type_;
  std::map<std::string, std::string> room_names_;  // theirs → ours
  std::map<std::string, Wall> walls_;
  std::vector<std::pair<Vec2, Vec2>> missing_walls_;
  double highest_ = 0;
};

}  // namespace

Result<std::vector<SourceScene>> read_procthor(const std::string& where, std::string_view text,
                                               const Knowledge& knowledge) {
  std::vector<SourceScene> scenes;
  const auto read = each_json_value(where, text, [&](const JsonAt& root, int) {
    JsonReader reader(where);
    const auto add = [&](const JsonAt& at) {
      scenes.push_back(HouseReader(reader, knowledge).read(at, "house_" + std::to_string(scenes.size() + 1)));
      keep_to_a_file(reader, at, scenes);
    };
    if (!root.json.is_array()) add(root);
    for (std::size_t k = 0; root.json.is_array() && k < root.json.size() && !reader.error(); ++k)
      add(reader.item(root, k));
    return reader.error();
  });
  if (!read) return read.error();
  return scenes;
}

}  // namespace unietp
