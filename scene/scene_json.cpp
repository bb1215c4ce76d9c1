#include "scene/scene_json.h"

#include <algorithm>
#include <functional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "core/text.h"
#include "scene/json_parse.h"
#include "scene/json_reader.h"
#include "scene/json_text.h"
#include "scene/node_json.h"
#include "scene/scene_size.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "unietp-scene/1";

void write(JsonText& json, const Room& room) {
  json.open_object();
  json.key("id");
  json.value(room.id);
  json.key("type");
  json.value(room.type);
  json.key("polygon");
  json.open_list();
  for (const Vec2& corner : room.polygon) write(json, corner);
  json.close_list();
  json.close_object();
}

void write(JsonText& json, const Opening& opening) {
  json.open_object();
  json.key("id");
  json.value(opening.id);
  json.key("room_a");
  json.value(opening.room_a);
  json.key("room_b");
  json.value(opening.room_b);
  json.key("from");
  write(json, opening.from);
  json.key("to");
  write(json, opening.to);
  json.key("height");
  json.value(opening.height);
  json.close_object();
}

/// A field of the scene on a line of its own.
template <class Value>
void add_field(std::string& text, std::string_view name, const Value& value) {
  text += text.size() == 1 ? "\n\"" : ",\n\"";
  text += name;
  text += "\": ";
  JsonText json(text);
  if constexpr (requires { json.value(value); }) {
    json.value(value);
  } else {
    write(json, value);
  }
}

/// `"name": [`, one item a line, `]`: a change of one object is a change of one line.
template <class Items>
void add_list(std::string& text, std::string_view name, const Items& items) {
  text += ",\n\"";
  text += name;
  text += "\": [";
  const char* separator = "\n";
  for (const auto& item : items) {
    text += separator;
    JsonText json(text);
    write(json, item);
    separator = ",\n";
  }
  text += items.empty() ? "]" : "\n]";
}

/// A part of a delta, which is left out when it is empty.
template <class Items>
void add_part(JsonText& json, std::string_view name, const Items& items) {
  if (items.empty()) return;
  json.key(name);
  json.open_list();
  for (const auto& item : items) {
    if constexpr (requires { json.value(item); }) {
      json.value(item);
    } else {
      write(json, item);
    }
  }
  json.close_list();
}

Simulator simulator_from_json(JsonReader& reader, const JsonAt& at) {
  const std::string name = reader.text(at);
  const auto simulator = simulator_named(name);
  if (!simulator && !reader.error()) {
    std::vector<std::string> names;
    names.reserve(kSimulators.size());
    for (const Simulator known : kSimulators) names.emplace_back(name_of(known));
    reader.unknown_name(at, "simulator", names);
  }
  return simulator.value_or(Simulator::Ai2thor);
}

Room room_from_json(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Room room;
  if (const auto f = fields.required("id")) room.id = reader.label(*f);
  if (const auto f = fields.required("type")) room.type = reader.label(*f);
  if (const auto f = fields.required("polygon")) {
    const std::size_t corners = reader.items(*f, limits::kRoomCorners);
    if (corners < 3) reader.fail(*f, "expected three corners or more, not " + std::to_string(corners));
    for (std::size_t i = 0; i < corners && !reader.error(); ++i)
      room.polygon.push_back(reader.vec2_within(reader.item(*f, i), limits::kPosition_m));
  }
  fields.finish();
  return room;
}

Opening opening_from_json(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Opening opening;
  if (const auto f = fields.required("id")) opening.id = reader.label(*f);
  if (const auto f = fields.required("room_a")) opening.room_a = reader.label(*f);
  if (const auto f = fields.required("room_b")) opening.room_b = reader.label(*f);
  if (const auto f = fields.required("from")) opening.from = reader.vec2_within(*f, limits::kPosition_m);
  if (const auto f = fields.required("to")) opening.to = reader.vec2_within(*f, limits::kPosition_m);
  if (const auto f = fields.required("height")) opening.height = reader.positive(*f);
  fields.finish();
  return opening;
}

template <class T>
std::vector<T> list_from_json(JsonReader& reader, const JsonAt& at, T (*read)(JsonReader&, const JsonAt&),
                              std::size_t most) {
  std::vector<T> list;
  const std::size_t count = reader.items(at, most);
  list.reserve(count);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) list.push_back(read(reader, reader.item(at, i)));
  return list;
}

void check_format(JsonReader& reader, const JsonAt& at) {
  const std::string format = reader.text(at);
  if (format != kFormat) reader.fail(at, "expected the format " + in_quotes(kFormat) + ", not " + in_quotes(format));
}

enum class Kind { Agent, Room, Opening, Node };

/// What each id of a scene names; for look-up only. Views into the scene.
using Ids = std::unordered_map<std::string_view, Kind>;

Ids collect_ids(JsonReader& reader, const Scene& scene) {
  Ids ids;
  ids.reserve(1 + scene.rooms.size() + scene.openings.size() + scene.nodes.size());
  ids.emplace("agent", Kind::Agent);
  const auto collect = [&](std::string_view list, const auto& items, Kind kind) {
    for (std::size_t i = 0; i < items.size() && !reader.error(); ++i) {
      if (ids.emplace(items[i].id, kind).second) continue;
      reader.fail("/" + std::string(list) + "/" + std::to_string(i) + "/id",
                  "the id " + in_quotes(items[i].id) + " is taken");
    }
  };
  collect("rooms", scene.rooms, Kind::Room);
  collect("openings", scene.openings, Kind::Opening);
  collect("nodes", scene.nodes, Kind::Node);
  return ids;
}

/// Checks that every id that a part of the scene refers to exists.
void check_references(JsonReader& reader, const Scene& scene, const std::vector<Edge>& edges) {
  const Ids ids = collect_ids(reader, scene);
  const auto names = [&](const std::string& id, Kind kind) {
    const auto found = ids.find(id);
    return found != ids.end() && found->second == kind;
  };
  for (std::size_t i = 0; i < scene.openings.size() && !reader.error(); ++i) {
    const Opening& opening = scene.openings[i];
    const std::string pointer = "/openings/" + std::to_string(i);
    if (!names(opening.room_a, Kind::Room)) reader.fail(pointer + "/room_a", "no room " + in_quotes(opening.room_a));
    if (!names(opening.room_b, Kind::Room)) reader.fail(pointer + "/room_b", "no room " + in_quotes(opening.room_b));
  }
  for (std::size_t i = 0; i < edges.size() && !reader.error(); ++i) {
    const Edge& edge = edges[i];
    const bool to_room = info(edge.relation).arguments[1] == ArgumentKind::Room;
    if (!names(edge.from, Kind::Node) && !(edge.relation == Predicate::InRoom && edge.from == "agent")) {
      reader.fail("/edges/" + std::to_string(i) + "/from", "no object " + in_quotes(edge.from));
    }
    if (!names(edge.to, to_room ? Kind::Room : Kind::Node)) {
      reader.fail("/edges/" + std::to_string(i) + "/to", (to_room ? "no room " : "no object ") + in_quotes(edge.to));
    }
  }
  if (scene.nodes.size() > limits::kObjects && !reader.error())
    reader.fail("/nodes",
                std::to_string(scene.nodes.size()) + " objects; expected at most " + std::to_string(limits::kObjects));
  std::unordered_set<std::string_view> held;
  for (std::size_t i = 0; i < scene.agent.held.size() && !reader.error(); ++i) {
    const std::string& id = scene.agent.held[i];
    const std::string pointer = "/agent/held/" + std::to_string(i);
    if (!names(id, Kind::Node)) reader.fail(pointer, "no object " + in_quotes(id));
    if (!held.insert(id).second) reader.fail(pointer, in_quotes(id) + " is held twice");
  }
}

/// Sorts the edges. Reports a repeated one by its names, since sorting loses its position in the text.
void sort_edges(JsonReader& reader, std::vector<Edge>& edges, const std::string& pointer) {
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice == edges.end()) return;
  reader.fail(pointer, "the edge " + std::string(info(twice->relation).name) + " from " + in_quotes(twice->from) +
                           " to " + in_quotes(twice->to) + " occurs twice");
}

/// Changes have one form, in which their edges are sorted.
void check_order(JsonReader& reader, const std::vector<Edge>& edges, const std::string& pointer) {
  const auto wrong = std::adjacent_find(edges.begin(), edges.end(), std::greater_equal<>());
  if (wrong == edges.end()) return;
  reader.fail(pointer, "the edge " + std::string(info(wrong->relation).name) + " from " + in_quotes(wrong->from) +
                           " to " + in_quotes(wrong->to) +
                           (*wrong == *(wrong + 1) ? " occurs twice"
                                                   : " is out of order; expected them sorted by relation, from, to"));
}

}  // namespace

std::string scene_to_json(const Scene& scene) {
  std::string text;
  text.reserve(1024 + 420 * scene.nodes.size() + 80 * scene.edges.size());
  text += '{';
  add_field(text, "format", kFormat);
  add_field(text, "id", scene.id);
  add_field(text, "simulator", name_of(scene.simulator));
  add_field(text, "wall_height", scene.wall_height);
  if (scene.wall_thickness != Scene().wall_thickness) add_field(text, "wall_thickness", scene.wall_thickness);
  add_list(text, "rooms", scene.rooms);
  add_list(text, "openings", scene.openings);
  add_field(text, "agent", scene.agent);
  add_list(text, "nodes", scene.nodes);
  add_list(text, "edges", scene.edges);
  return text += "\n}\n";
}

Result<Scene> scene_from_json(std::string_view where, std::string_view text) {
  const auto json = parse_json(where, text);
  if (!json) return json.error();
  JsonReader reader(where);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  Scene scene;
  if (const auto f = fields.required("format")) check_format(reader, *f);
  if (const auto f = fields.required("id")) scene.id = reader.plain_name(*f);
  if (const auto f = fields.required("simulator")) scene.simulator = simulator_from_json(reader, *f);
  if (const auto f = fields.required("wall_height")) scene.wall_height = reader.positive(*f);
  if (const auto f = fields.optional("wall_thickness")) scene.wall_thickness = reader.positive(*f);
  if (const auto f = fields.required("rooms")) scene.rooms = list_from_json(reader, *f, room_from_json, limits::kRooms);
  if (const auto f = fields.required("openings"))
    scene.openings = list_from_json(reader, *f, opening_from_json, limits::kOpenings);
  if (const auto f = fields.required("agent")) scene.agent = agent_from_json(reader, *f);
  if (const auto f = fields.required("nodes"))
    scene.nodes = list_from_json(reader, *f, node_from_json, limits::kObjects);
  std::vector<Edge> edges;
  if (const auto f = fields.required("edges")) edges = list_from_json(reader, *f, edge_from_json, limits::kEdges);
  fields.finish();
  if (const auto excess = reader.error() ? "" : excess_of(scene); !excess.empty()) reader.fail("", excess);
  if (!reader.error()) check_references(reader, scene, edges);
  if (!reader.error()) sort_edges(reader, edges, "/edges");
  if (reader.error()) return *reader.error();
  scene.edges = std::move(edges);
  return scene;
}

Result<Scene> check_whole(std::string_view where, Scene scene) {
  JsonReader reader(where);
  check_references(reader, scene, {scene.edges.begin(), scene.edges.end()});
  if (reader.error()) return *reader.error();
  return scene;
}

std::string delta_to_json(const Delta& delta) {
  std::string text;
  JsonText json(text);
  json.open_object();
  add_part(json, "nodes", delta.nodes);
  add_part(json, "removed", delta.removed);
  add_part(json, "edges_added", delta.edges_added);
  add_part(json, "edges_removed", delta.edges_removed);
  if (delta.agent) {
    json.key("agent");
    write(json, *delta.agent);
  }
  json.close_object();
  return text;
}

Result<Delta> delta_from_json(std::string_view where, const Json& json) {
  JsonReader reader(where);
  const JsonAt root{json};
  JsonFields fields(reader, root);
  Delta delta;
  if (const auto f = fields.optional("nodes"))
    delta.nodes = list_from_json(reader, *f, node_from_json, limits::kObjects);
  if (const auto f = fields.optional("removed")) delta.removed = reader.texts(*f);
  if (const auto f = fields.optional("edges_added"))
    delta.edges_added = list_from_json(reader, *f, edge_from_json, limits::kEdges);
  if (const auto f = fields.optional("edges_removed"))
    delta.edges_removed = list_from_json(reader, *f, edge_from_json, limits::kEdges);
  if (const auto f = fields.optional("agent")) delta.agent = agent_from_json(reader, *f);
  fields.finish();
  std::unordered_set<std::string_view> ids;
  for (std::size_t i = 0; i < delta.nodes.size() && !reader.error(); ++i) {
    if (ids.insert(delta.nodes[i].id).second) continue;
    reader.fail("/nodes/" + std::to_string(i) + "/id", "the id " + in_quotes(delta.nodes[i].id) + " is taken");
  }
  for (std::size_t i = 0; i < delta.removed.size() && !reader.error(); ++i) {
    if (ids.insert(delta.removed[i]).second) continue;
    reader.fail("/removed/" + std::to_string(i), in_quotes(delta.removed[i]) + " is changed or removed already");
  }
  if (!reader.error()) check_order(reader, delta.edges_added, "/edges_added");
  if (!reader.error()) check_order(reader, delta.edges_removed, "/edges_removed");
  if (reader.error()) return *reader.error();
  return delta;
}

Json action_to_json(const Action& action) {
  return {{"action", std::string(info(action.type).name)}, {"args", action.args}};
}

Result<Action> action_from_json(std::string_view where, const Json& json) {
  JsonReader reader(where);
  const JsonAt root{json};
  JsonFields fields(reader, root);
  Action action;
  if (const auto f = fields.required("action")) {
    const std::string name = reader.text(*f);
    if (const auto type = action_named(name)) {
      action.type = *type;
    } else {
      std::vector<std::string> names;
      for (const auto list : {all_actions(), extension_actions()}) {
        for (const ActionInfo& known : list) names.emplace_back(known.name);
      }
      reader.unknown_name(*f, "action", names);
    }
  }
  if (const auto f = fields.required("args")) {
    action.args = reader.texts(*f);
    const std::size_t wanted = info(action.type).argument == ActionArgument::None ? 0 : 1;
    if (!reader.error() && action.args.size() != wanted) {
      reader.fail(*f, std::string(info(action.type).name) + " takes " + (wanted == 0 ? "no argument" : "one argument"));
    }
  }
  fields.finish();
  if (reader.error()) return *reader.error();
  return action;
}

}  // namespace unietp
