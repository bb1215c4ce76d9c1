#include "scene/node_json.h"

#include <initializer_list>
#include <utility>

#include "core/limits.h"
#include "core/text.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

void write(JsonText& json, std::initializer_list<double> numbers) {
  json.open_list();
  for (const double number : numbers) json.value(number);
  json.close_list();
}
void write(JsonText& json, const Vec3& v) { write(json, {v.x(), v.y(), v.z()}); }
void write(JsonText& json, const Quat& q) { write(json, {q.w(), q.x(), q.y(), q.z()}); }

template <class Value>
void field(JsonText& json, std::string_view name, const Value& value) {
  json.key(name);
  if constexpr (requires { json.value(value); }) {
    json.value(value);
  } else {
    write(json, value);
  }
}

std::vector<std::string> names_where(bool (*accepts)(Predicate)) {
  std::vector<std::string> names;
  for (const PredicateInfo& predicate : all_predicates()) {
    if (accepts(predicate.predicate)) names.emplace_back(predicate.name);
  }
  return names;
}

StateSet states_from_json(JsonReader& reader, const JsonAt& at) {
  StateSet states;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    const auto state = state_from_json(reader, item);
    if (!state) break;
    states.set(*state);
    if (states.all().size() != i + 1)
      reader.fail(item, in_quotes(state_name(*state)) + " repeats or excludes one before");
    if (!reader.error() && states.all().back() != *state)
      reader.fail(item, in_quotes(state_name(*state)) + " is out of order; expected the order of docs/vocabulary.md");
  }
  return states;
}

void write(JsonText& json, const Board& board) {
  json.open_object();
  field(json, "centre", board.center);
  field(json, "size", board.size);
  if (board.joint >= 0) field(json, "joint", board.joint);
  json.close_object();
}

Vec3 extents_from_json(JsonReader& reader, const JsonAt& at) {
  Vec3 size = reader.vec3_within(at, limits::kObject_m);
  if (!reader.error() && !(size.minCoeff() > 0)) reader.fail(at, "expected three lengths above 0");
  return size;
}

Board board_from_json(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Board board;
  if (const auto f = fields.required("centre")) board.center = reader.vec3_within(*f, limits::kObject_m);
  if (const auto f = fields.required("size")) board.size = extents_from_json(reader, *f);
  if (const auto f = fields.optional("joint")) {
    const double joint = reader.number(*f);
    if (joint != 0 && joint != 1) reader.fail(*f, "expected a joint, 0 or 1, not " + number_text(joint));
    board.joint = joint == 1 ? 1 : 0;
  }
  fields.finish();
  return board;
}

Archetype archetype_from_json(JsonReader& reader, const JsonAt& at) {
  const std::string name = reader.text(at);
  const auto archetype = archetype_named(name);
  if (!archetype && !reader.error()) {
    std::vector<std::string> names;
    for (const Archetype known : all_archetypes()) names.emplace_back(name_of(known));
    reader.unknown_name(at, "archetype", names);
  }
  return archetype.value_or(Archetype::Box);
}

}  // namespace

std::string state_name(const State& state) {
  std::string text(info(state.predicate).name);
  return state.symbol.empty() ? text : text + "(" + state.symbol + ")";
}

std::optional<State> state_from_json(JsonReader& reader, const JsonAt& at) {
  const std::string text = reader.label(at);
  if (reader.error()) return std::nullopt;
  const auto bracket = text.find('(');
  const auto predicate = predicate_named(std::string_view(text).substr(0, bracket));
  if (!predicate || !is_node_state(*predicate)) {
    reader.unknown_name(at, "state", names_where(is_node_state));
    return std::nullopt;
  }
  const bool written = bracket != std::string::npos;
  if (written != has_symbol(*predicate) || (written && (text.back() != ')' || text.size() - bracket < 3))) {
    const std::string name(info(*predicate).name);
    reader.fail(
        at, "expected " + in_quotes(has_symbol(*predicate) ? name + "(symbol)" : name) + ", not " + in_quotes(text));
    return std::nullopt;
  }
  return State{*predicate, written ? text.substr(bracket + 1, text.size() - bracket - 2) : std::string()};
}

void write(JsonText& json, const Vec2& v) { write(json, {v.x(), v.y()}); }

bool is_edge_relation(Predicate predicate) {
  const auto arguments = info(predicate).arguments;
  return arguments.size() == 2 && arguments[1] != ArgumentKind::Symbol && predicate != Predicate::Nearest;
}

bool has_symbol(Predicate predicate) {
  const auto arguments = info(predicate).arguments;
  return arguments.size() == 2 && arguments[1] == ArgumentKind::Symbol;
}

bool is_node_state(Predicate predicate) {
  // Color and material have fields of their own.
  if (has_symbol(predicate)) return predicate != Predicate::Color && predicate != Predicate::Material;
  return info(predicate).arguments.size() == 1 && predicate != Predicate::Held;
}

void write(JsonText& json, const Node& node) {
  json.open_object();
  field(json, "id", node.id);
  field(json, "category", node.category);
  field(json, "movable", node.movable);
  field(json, "archetype", name_of(node.archetype));
  field(json, "openable", node.openable);
  field(json, "size", node.size);
  field(json, "mass", node.mass);
  field(json, "position", node.pose.position);
  field(json, "rotation", node.pose.rotation);
  field(json, "opening", node.opening);
  if (!node.boards.empty()) {
    json.key("boards");
    json.open_list();
    for (const Board& board : node.boards) write(json, board);
    json.close_list();
  }
  json.key("states");
  json.open_list();
  for (const State& state : node.states.all()) json.value(state_name(state));
  json.close_list();
  if (!node.color.empty()) field(json, "colour", node.color);
  if (!node.material.empty()) field(json, "material", node.material);
  if (!node.asset.empty()) field(json, "asset", node.asset);
  if (!node.slice_of.empty()) field(json, "slice_of", node.slice_of);
  if (!node.whole_category.empty()) field(json, "whole_category", node.whole_category);
  json.close_object();
}

Node node_from_json(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Node node;
  if (const auto f = fields.required("id")) node.id = reader.label(*f);
  if (const auto f = fields.required("category")) node.category = reader.label(*f);
  if (const auto f = fields.required("movable")) node.movable = reader.boolean(*f);
  if (const auto f = fields.required("archetype")) node.archetype = archetype_from_json(reader, *f);
  if (const auto f = fields.required("openable")) node.openable = reader.boolean(*f);
  if (const auto f = fields.required("size")) {
    node.size = extents_from_json(reader, *f);
  }
  if (const auto f = fields.required("mass")) {
    node.mass = reader.number(*f);
    if (node.mass < 0) reader.fail(*f, "expected a mass of 0 or more, not " + number_text(node.mass));
  }
  if (const auto f = fields.required("position")) node.pose.position = reader.vec3_within(*f, limits::kPosition_m);
  if (const auto f = fields.required("rotation")) node.pose.rotation = reader.rotation(*f);
  if (const auto f = fields.required("opening")) {
    node.opening = reader.number(*f);
    if (!(node.opening >= 0 && node.opening <= 1)) {
      reader.fail(*f, "expected a number from 0 to 1, not " + number_text(node.opening));
    }
  }
  if (const auto f = fields.optional("boards")) {
    const std::size_t count = reader.items(*f, limits::kObjectBoards);
    for (std::size_t i = 0; i < count && !reader.error(); ++i) {
      node.boards.push_back(board_from_json(reader, reader.item(*f, i)));
    }
  }
  if (const auto f = fields.required("states")) node.states = states_from_json(reader, *f);
  if (const auto f = fields.optional("colour")) node.color = reader.label(*f);
  if (const auto f = fields.optional("material")) node.material = reader.label(*f);
  if (const auto f = fields.optional("asset")) node.asset = reader.label(*f);
  if (const auto f = fields.optional("slice_of")) node.slice_of = reader.label(*f);
  if (const auto f = fields.optional("whole_category")) node.whole_category = reader.label(*f);
  fields.finish();
  return node;
}

void write(JsonText& json, const Edge& edge) {
  json.open_object();
  field(json, "relation", info(edge.relation).name);
  field(json, "from", edge.from);
  field(json, "to", edge.to);
  json.close_object();
}

Edge edge_from_json(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Edge edge;
  if (const auto f = fields.required("relation")) {
    const std::string name = reader.text(*f);
    const auto relation = predicate_named(name);
    if (relation && is_edge_relation(*relation)) {
      edge.relation = *relation;
    } else {
      reader.unknown_name(*f, "relation", names_where(is_edge_relation));
    }
  }
  if (const auto f = fields.required("from")) edge.from = reader.label(*f);
  if (const auto f = fields.required("to")) edge.to = reader.label(*f);
  fields.finish();
  return edge;
}

void write(JsonText& json, const Agent& agent) {
  json.open_object();
  field(json, "position", agent.position);
  field(json, "yaw_rad", agent.yaw);
  field(json, "pitch_rad", agent.pitch);
  json.key("held");
  json.open_list();
  for (const std::string& id : agent.held) json.value(id);
  json.close_list();
  json.close_object();
}

Agent agent_from_json(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Agent agent;
  if (const auto f = fields.required("position")) agent.position = reader.vec2_within(*f, limits::kPosition_m);
  if (const auto f = fields.required("yaw_rad")) agent.yaw = reader.number(*f);
  if (const auto f = fields.required("pitch_rad")) agent.pitch = reader.number(*f);
  if (const auto f = fields.required("held")) agent.held = reader.texts(*f);
  fields.finish();
  return agent;
}

}  // namespace unietp
