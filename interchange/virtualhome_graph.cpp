#include "interchange/virtualhome_graph.h"

#include <cmath>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "interchange/foreign_json.h"

namespace unietp {
namespace {

long long id_at(JsonReader& reader, const JsonAt& at) {
  if (at.json.is_number_integer() && !at.json.is_number_unsigned()) return at.json.get<long long>();
  const double id = reader.number(at);
  if (!reader.error() && (std::abs(id) > 1e15 || id != std::floor(id))) reader.fail(at, "expected a whole number");
  return reader.error() ? 0 : static_cast<long long>(id);
}

void read_box(JsonReader& reader, const JsonAt& node, VirtualhomeNode& into) {
  const auto box = given(node, "bounding_box");
  const JsonAt& holder = box ? *box : node;
  const auto center = given(holder, box ? "center" : "bbox_center");
  const auto size = given(holder, box ? "size" : "bbox_size");
  if (!center && !size && !box) return;
  if (!center || !size) return reader.fail(holder, "expected a box with centre and size");
  into.has_box = true;
  into.center = reader.vec3(*center);
  into.extents = reader.vec3(*size);
  if (!reader.error() && into.extents.minCoeff() < 0) reader.fail(*size, "expected three lengths >= 0");
}

void read_transform(JsonReader& reader, const JsonAt& node, VirtualhomeNode& into) {
  const auto transform = given(node, "obj_transform");
  if (!transform) return;
  const auto rotation = given(*transform, "rotation");
  if (!rotation) return;
  into.has_transform = true;
  into.rotation = rounded_rotation(reader, *rotation, QuatOrder::Xyzw);
  if (const auto scale = given(*transform, "scale")) into.scale = reader.vec3(*scale);
}

VirtualhomeNode read_node(JsonReader& reader, const JsonAt& at) {
  VirtualhomeNode node;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("id")) node.id = id_at(reader, *f);
  if (const auto f = fields.required("class_name")) node.class_name = reader.text(*f);
  const auto word = [&](std::string_view name) {
    const auto f = given(at, name);
    return f && !(f->json.is_string() && f->json.get_ref<const std::string&>().empty()) ? reader.text(*f) : "";
  };
  node.category = word("category");
  node.prefab = word("prefab_name");
  if (const auto f = given(at, "states")) node.states = reader.texts(*f);
  if (reader.error()) return node;
  read_box(reader, at, node);
  read_transform(reader, at, node);
  return node;
}

VirtualhomeEdge read_edge(JsonReader& reader, const JsonAt& at) {
  VirtualhomeEdge edge;
  if (at.json.is_array()) {
    if (reader.items(at) != 3) {
      reader.fail(at, "expected [from, relation, to]");
      return edge;
    }
    edge.from = id_at(reader, reader.item(at, 0));
    edge.relation = reader.text(reader.item(at, 1));
    edge.to = id_at(reader, reader.item(at, 2));
    return edge;
  }
  JsonFields fields(reader, at);
  if (const auto f = fields.required("from_id")) edge.from = id_at(reader, *f);
  if (const auto f = fields.required("relation_type")) edge.relation = reader.text(*f);
  if (const auto f = fields.required("to_id")) edge.to = id_at(reader, *f);
  return edge;
}

}  // namespace

VirtualhomeGraph read_virtualhome_graph(JsonReader& reader, const JsonAt& home) {
  VirtualhomeGraph graph;
  JsonFields fields(reader, home);
  std::set<long long> ids;
  if (const auto nodes = fields.required("nodes")) {
    const std::size_t count = objects_in(reader, *nodes);
    for (std::size_t i = 0; i < count && !reader.error(); ++i) {
      const JsonAt at = reader.item(*nodes, i);
      graph.nodes.push_back(read_node(reader, at));
      if (reader.error()) break;
      if (!ids.insert(graph.nodes.back().id).second) {
        reader.fail(at, "the id " + std::to_string(graph.nodes.back().id) + " is duplicated; expected one node per id");
      }
    }
  }
  if (const auto edges = fields.required("edges")) {
    const std::size_t count = reader.items(*edges);
    for (std::size_t i = 0; i < count && !reader.error(); ++i) {
      graph.edges.push_back(read_edge(reader, reader.item(*edges, i)));
    }
  }
  return graph;
}

}  // namespace unietp
