#include "simulation/body_id.h"

namespace unietp {

std::vector<BodyId> bodies_of(std::span<const std::size_t> nodes) {
  std::vector<BodyId> bodies;
  bodies.reserve(nodes.size());
  for (const std::size_t node : nodes) bodies.push_back(BodyId::node(node));
  return bodies;
}

std::vector<std::size_t> nodes_of(std::span<const BodyId> bodies) {
  std::vector<std::size_t> nodes;
  nodes.reserve(bodies.size());
  for (const BodyId body : bodies) nodes.push_back(body.index());
  return nodes;
}

}  // namespace unietp
