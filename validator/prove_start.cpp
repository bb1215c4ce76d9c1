#include "validator/prove_start.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/text.h"
#include "logic/evaluate.h"
#include "validator/conjuncts.h"
#include "validator/replay.h"

namespace unietp {
namespace {

std::string list_of(const std::vector<Edge>& edges) {
  constexpr std::size_t kShown = 4;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < edges.size() && i < kShown; ++i) texts.push_back(text_of(edges[i]));
  if (edges.size() > kShown) texts.push_back("and " + std::to_string(edges.size() - kShown) + " more");
  return join(texts, ", ");
}

bool is_known(const std::string& category, const Scene& start, const Knowledge& knowledge) {
  return knowledge.find(category) != nullptr ||
         std::any_of(start.rooms.begin(), start.rooms.end(), [&](const Room& room) { return room.type == category; });
}

}  // namespace

std::vector<Problem> prove_start(const Scene& start, const PhysicsWorld& physics, const LinkTable& links,
                                 RestCheck& rest, const std::string& file) {
  std::vector<Problem> problems;
  std::vector<Edge> shown;
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const Link& link : links.of(i)) shown.push_back(edge_of(start, i, link));
  }
  if (const Room* room = room_at(start, start.agent.position)) shown.push_back({Predicate::InRoom, "agent", room->id});
  std::sort(shown.begin(), shown.end());
  std::vector<Edge> missing, extra;
  std::set_difference(start.edges.begin(), start.edges.end(), shown.begin(), shown.end(), std::back_inserter(missing));
  std::set_difference(shown.begin(), shown.end(), start.edges.begin(), start.edges.end(), std::back_inserter(extra));
  if (!missing.empty())
    problems.push_back(
        problem_in(ProblemKind::Relations, file, "the scene has " + list_of(missing) + ", but physics does not"));
  if (!extra.empty())
    problems.push_back(
        problem_in(ProblemKind::Relations, file, "physics has " + list_of(extra) + ", but the scene does not"));
  for (const auto& moved : rest.of(start, physics))
    problems.push_back(problem_in(ProblemKind::Unrest, file,
                                  start.nodes[moved.node].id + " is not at rest: it moves " +
                                      number_text(std::floor(moved.distance_m * 1000)) + " mm when physics continues"));
  return problems;
}

std::vector<Problem> prove_goal_at_start(const TaskRecord& task, const Formula& goal,
                                         const std::vector<Formula>& constraints, const Scene& start,
                                         const Trace& at_start, const Knowledge& knowledge, const std::string& where) {
  std::vector<Problem> problems;
  const auto found = [&](ProblemKind kind, std::string message) {
    problems.push_back(problem_in(kind, where, std::move(message)));
  };
  for (const auto& category : categories_of(goal)) {
    if (!is_known(category, start, knowledge))
      found(ProblemKind::BoundCategory, "its goal uses " + category + ", which " + task.simulator + " does not have");
  }
  std::string said = task.goal_text;
  for (const auto& text : task.start_constraints) said += text;
  for (const auto& [placeholder, value] : task.bindings) {
    if (said.find(value) == std::string::npos)
      found(ProblemKind::BoundCategory,
            "binds " + placeholder + " to " + value + ", which neither goal nor start uses");
  }
  for (const Formula& constraint : constraints) {
    if (!holds_in(constraint, at_start, 0))
      found(ProblemKind::StartConstraint, "does not satisfy the start constraint " + to_text(constraint));
  }
  if (holds(goal, at_start)) {
    found(ProblemKind::GoalAtStart, "its goal already holds at the start");
  } else {
    for (const Formula& part : conjuncts_of(goal)) {
      if (holds(part, at_start))
        found(ProblemKind::PartAtStart, "the part " + to_text(part) + " of its goal already holds at the start");
    }
  }
  for (const ReferringDomain& one : referring_domains(goal)) {
    if (one.certain && members_of(one.domain, one.variable, at_start).empty())
      found(ProblemKind::NoReferent, "no object at the start matches " + to_text(one.domain));
  }
  return problems;
}

}  // namespace unietp
