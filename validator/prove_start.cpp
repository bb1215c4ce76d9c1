#include "validator/prove_start.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/text.h"
#include "simulation/physics.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

std::string text_of(const Edge& edge) {
  return std::string(info(edge.relation).name) + "(" + edge.from + ", " + edge.to + ")";
}

std::string list_of(const std::vector<Edge>& edges) {
  constexpr std::size_t kShown = 4;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < edges.size() && i < kShown; ++i) texts.push_back(text_of(edges[i]));
  if (edges.size() > kShown) texts.push_back("and " + std::to_string(edges.size() - kShown) + " more");
  return join(texts, ", ");
}

bool is_held(const Scene& scene, const std::string& id) {
  return std::find(scene.agent.held.begin(), scene.agent.held.end(), id) != scene.agent.held.end();
}

}  // namespace

std::vector<Error> prove_start(const Scene& start, double rest_m, const std::string& file) {
  std::vector<Error> errors;
  const auto wrong = [&](std::string message) {
    errors.push_back({Error::Kind::Schema, file, {}, std::move(message)});
  };
  const auto physics = physics_of(start);
  const auto shown = read_relations(start, physics);
  std::vector<Edge> missing, extra;
  std::set_difference(start.edges.begin(), start.edges.end(), shown.begin(), shown.end(), std::back_inserter(missing));
  std::set_difference(shown.begin(), shown.end(), start.edges.begin(), start.edges.end(), std::back_inserter(extra));
  if (!missing.empty()) wrong("the scene says " + list_of(missing) + ", which physics does not show");
  if (!extra.empty()) wrong("physics shows " + list_of(extra) + ", which the scene does not say");

  std::vector<BodyId> loose;
  for (std::size_t i = 0; i < start.nodes.size(); ++i) {
    if (start.nodes[i].movable && !is_held(start, start.nodes[i].id)) loose.push_back(static_cast<BodyId>(i));
  }
  SettleOptions two_seconds;
  two_seconds.max_steps = two_seconds.calm_steps = static_cast<int>(std::lround(2.0 / two_seconds.step_s));
  for (const auto& settled : physics.settle(loose, two_seconds).bodies) {
    const auto& node = start.nodes[settled.body];
    const double moved = (settled.pose.position - node.pose.position).norm();
    if (!(moved <= rest_m))  // also when it is no number
      wrong(node.id + " is not at rest: it moves " + number_text(std::floor(moved * 1000)) +
            " mm in two seconds of physics");
  }
  return errors;
}

}  // namespace unietp
