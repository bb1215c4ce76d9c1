#include "interchange/foreign_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "core/plain_name.h"
#include "core/text.h"
#include "interchange/json_fields.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

bool has_mark(const Json& json, const std::vector<std::string_view>& marks) {
  const auto* fields = json.get_ptr<const Json::object_t*>();
  return fields != nullptr && std::any_of(fields->begin(), fields->end(), [&](const auto& field) {
           return std::find(marks.begin(), marks.end(), field.first) != marks.end();
         });
}

/// Words that get into our scene as they are.
void keep_to_labels(JsonReader& reader, const JsonAt& home, const SourceScene& scene) {
  const auto check = [&](const std::string& word) {
    if (!word.empty() && !is_label(word)) reader.fail(home, in_quotes(word) + " is no label; " + label_expected());
  };
  for (const Room& room : scene.rooms) check(room.id), check(room.type);
  for (const Opening& opening : scene.openings) check(opening.id), check(opening.room_a), check(opening.room_b);
  for (const SourceObject& object : scene.objects) check(object.room), check(object.asset);
}

/// Rooms, walls, openings and agent of the size of a home; a room that is larger is an error, the rest is dropped with
/// a warning.
void keep_to_a_home(JsonReader& reader, const JsonAt& home, SourceScene& scene) {
  constexpr double kLowest_m = 1, kHighest_m = limits::kWallHeight_m, kUsual_m = 2.6;
  Vec2 low = Vec2::Constant(limits::kHomeOffset_m), high = -low;
  for (const Room& room : scene.rooms) {
    if (room.polygon.size() > limits::kRoomCorners)
      return reader.fail(home, "the room " + in_quotes(room.id) + " has " + std::to_string(room.polygon.size()) +
                                   " corners; expected at most " + std::to_string(limits::kRoomCorners));
    for (const Vec2& corner : room.polygon) {
      low = low.cwiseMin(corner), high = high.cwiseMax(corner);
      const bool near = corner.allFinite() && corner.cwiseAbs().maxCoeff() <= limits::kHomeOffset_m;
      if (near && (high - low).maxCoeff() <= limits::kHomeWidth_m) continue;
      return reader.fail(home, "the room " + in_quotes(room.id) +
                                   " is too far away; expected a home of at most 200 m within 1000 m of the origin");
    }
  }
  if (!(scene.wall_height >= kLowest_m && scene.wall_height <= kHighest_m)) {
    scene.warnings.push_back("walls of " + number_text(scene.wall_height) + " m: taken as 2.6 m");
    scene.wall_height = kUsual_m;
  }
  for (Opening& opening : scene.openings) opening.height = std::min(opening.height, scene.wall_height);
  const auto is_none = [](const Opening& opening) {
    return !opening.from.allFinite() || !opening.to.allFinite() || !((opening.to - opening.from).norm() > 0.001);
  };
  const auto dropped = std::erase_if(scene.openings, is_none);
  if (dropped > 0) scene.warnings.push_back(std::to_string(dropped) + " openings have no width");
  const Vec2& agent = scene.agent.position;
  if (scene.has_agent && !(agent.allFinite() && agent.cwiseAbs().maxCoeff() <= limits::kHomeOffset_m)) {
    scene.warnings.emplace_back("the agent stands too far away to be in a home");
    scene.has_agent = false;
  }
}

class Homes {
 public:
  Homes(const std::vector<std::string_view>& marks, const HomeReader& read) : marks_(marks), read_(read) {}

  /// The homes of one JSON value.
  void add(JsonReader& reader, const JsonAt& root, const std::string& name) {
    if (has_mark(root.json, marks_)) return one(reader, root, name);
    if (const auto scenes = given(root, "scenes")) return all(reader, *scenes, name);
    all(reader, root, name);
  }

  std::vector<SourceScene> take() { return std::move(scenes_); }

 private:
  void one(JsonReader& reader, const JsonAt& home, const std::string& id) {
    if (!has_mark(home.json, marks_)) {
      std::vector<std::string> names(marks_.begin(), marks_.end());
      return reader.fail(home, "expected a home, an object with the field " + join(names, " or "));
    }
    SourceScene scene = read_(reader, home, id);
    if (!reader.error()) keep_to_a_home(reader, home, scene);
    if (!reader.error()) keep_to_labels(reader, home, scene);
    scenes_.push_back(std::move(scene));
    keep_to_a_file(reader, home, scenes_);
  }

  void all(JsonReader& reader, const JsonAt& table, const std::string& name) {
    if (const auto* fields = table.json.get_ptr<const Json::object_t*>(); fields != nullptr && !fields->empty()) {
      for (const auto& [id, home] : *fields) {
        if (reader.error()) return;
        one(reader, JsonAt{home, &table, id, 0}, id);
      }
      return;
    }
    if (table.json.is_object()) return one(reader, table, name);
    const std::size_t count = reader.items(table);
    for (std::size_t i = 0; i < count && !reader.error(); ++i) {
      one(reader, reader.item(table, i), name + "_" + std::to_string(i));
    }
  }

  const std::vector<std::string_view>& marks_;
  const HomeReader& read_;
  std::vector<SourceScene> scenes_;
};

/// A whole object on the first line and something on a later one.
bool is_json_lines(std::string_view text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return false;
  const std::string_view first = trim(text.substr(0, end));
  return first.size() > 2 && first.front() == '{' && first.back() == '}' && !trim(text.substr(end)).empty();
}

}  // namespace

std::optional<JsonAt> given(const JsonAt& object, std::string_view name) {
  const auto* fields = object.json.get_ptr<const Json::object_t*>();
  if (fields == nullptr) return std::nullopt;
  for (const auto& [key, value] : *fields) {
    if (key == name && !value.is_null()) return JsonAt{value, &object, name, 0};
  }
  return std::nullopt;
}

std::size_t objects_in(JsonReader& reader, const JsonAt& list) {
  const std::size_t count = reader.items(list);
  if (count <= limits::kListedObjects) return count;
  reader.fail(
      list, std::to_string(count) + " objects in one home; expected at most " + std::to_string(limits::kListedObjects));
  return 0;
}

Quat rounded_rotation(JsonReader& reader, const JsonAt& at, QuatOrder order) {
  constexpr double kRounding = 0.01;
  if (reader.items(at) != 4) {
    reader.fail(at, std::string("expected ") + (order == QuatOrder::Wxyz ? "[w, x, y, z]" : "[x, y, z, w]"));
    return Quat::Identity();
  }
  double values[4];
  for (std::size_t i = 0; i < 4; ++i) values[i] = reader.number(reader.item(at, i));
  if (reader.error()) return Quat::Identity();
  const Quat quat = order == QuatOrder::Wxyz ? Quat(values[0], values[1], values[2], values[3])
                                             : Quat(values[3], values[0], values[1], values[2]);
  if (!(std::abs(quat.norm() - 1) <= kRounding)) {
    reader.fail(at, "expected a quaternion of length 1, not " + number_text(quat.norm()));
    return Quat::Identity();
  }
  return quat.normalized();
}

std::string home_named_by(std::string_view where) {
  if (const auto slash = where.find_last_of('/'); slash != std::string_view::npos) where.remove_prefix(slash + 1);
  const std::string_view stem = where.substr(0, where.find('.'));
  return stem.empty() ? "home" : std::string(stem);
}

Result<std::vector<SourceScene>> read_homes(std::string_view where, std::string_view text,
                                            const std::vector<std::string_view>& marks, const HomeReader& read) {
  const std::string name = home_named_by(where);
  Homes homes(marks, read);
  const auto add = [&](std::string_view at, std::string_view value, int line,
                       const std::string& id) -> std::optional<Error> {
    const auto json = parse_json(at, value, limits::kJsonHomeFields);
    if (!json) {
      Error error = json.error();
      if (line > 0 && error.pos.line > 0) error.pos.line = line, error.where = where;
      return error;
    }
    JsonReader reader(at);
    homes.add(reader, JsonAt{*json}, id);
    return reader.error();
  };
  if (!is_json_lines(text)) {
    if (auto error = add(where, text, 0, name)) return *std::move(error);
    return homes.take();
  }
  int line = 0;
  for (std::size_t start = 0; start < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view value = text.substr(start, end - start);
    start = end + 1;
    if (trim(value).empty()) continue;
    const std::string at = std::string(where) + ":" + std::to_string(line + 1);
    if (auto error = add(at, value, line + 1, name + "_" + std::to_string(line))) return *std::move(error);
  }
  return homes.take();
}

}  // namespace unietp
