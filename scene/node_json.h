#pragma once

#include <optional>
#include <string>

#include "scene/json_reader.h"
#include "scene/json_text.h"
#include "scene/scene.h"

namespace unietp {

/// The parts that a scene and a delta have in common. Numbers must be finite. Readers report errors through `reader`;
/// what they return then means nothing.
void write(JsonText& json, const Vec2& v);
void write(JsonText& json, const Node& node);
void write(JsonText& json, const Edge& edge);
void write(JsonText& json, const Agent& agent);
/// A state as files have it: "clean", "filled(water)".
std::string state_name(const State& state);
/// The inverse of `state_name`; nullopt with an error.
std::optional<State> state_from_json(JsonReader& reader, const JsonAt& at);
/// The inverse of `write`.
Node node_from_json(JsonReader& reader, const JsonAt& at);
Edge edge_from_json(JsonReader& reader, const JsonAt& at);
Agent agent_from_json(JsonReader& reader, const JsonAt& at);

/// True for predicates that stand on edges: relations of two objects or of an object and a room, without `nearest`,
/// which follows from the poses.
bool is_edge_relation(Predicate predicate);
/// True for predicates that stand in a node's states; `held` does not, it follows from the agent.
bool is_node_state(Predicate predicate);
/// True for a node state that needs a symbol.
bool has_symbol(Predicate predicate);

}  // namespace unietp
