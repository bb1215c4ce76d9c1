#include "exports/bddl.h"

#include <algorithm>
#include <set>

namespace unietp {
namespace {

constexpr const char* kAgent = "agent.n.01";
constexpr const char* kFloor = "floor.n.01";

std::string numbered(const std::string& synset, std::size_t number) { return synset + "_" + std::to_string(number); }

/// Names of all objects that have a synset: the synset and a running number.
std::map<std::string, std::string> names_of(const Scene& start, const BddlSynsets& synsets) {
  std::map<std::string, std::size_t> counts;
  std::map<std::string, std::string> names;
  for (const Node& node : start.nodes) {
    const auto synset = synsets.find(node.category);
    if (synset != synsets.end()) names[node.id] = numbered(synset->second, ++counts[synset->second]);
  }
  return names;
}

/// What an object rests on or in, and the floor that it stands on.
struct RestingPlace {
  std::string relation, on;  // "" when it rests on nothing that has a name
  std::string floor;         // a room's id
};
RestingPlace rest_of(const Scene& start, const std::string& id) {
  RestingPlace rest;
  for (const Edge& edge : start.edges) {
    if (edge.from != id) continue;
    if (edge.relation == Predicate::Inside || (edge.relation == Predicate::On && rest.on.empty()))
      rest.relation = bddl_relation(edge.relation), rest.on = edge.to;
    if (edge.relation == Predicate::OnFloor) rest.floor = edge.to;
  }
  return rest;
}

class BddlProblem {
 public:
  BddlProblem(const Scene& start, const std::map<std::string, std::string>& names) : start_(start), names_(names) {}

  /// An object with what it rests on or in. Errors: as bddl_problem.
  Result<Done> take(const std::string& id) {
    if (taken_.contains(id)) return Done{};
    const auto name = names_.find(id);
    if (name == names_.end()) return Error{Error::Kind::Unsatisfiable, "", {}, "the support " + id + " has no synset"};
    taken_.insert(id);
    const Node& node = *find_node(start_, id);
    for (const State& state : node.states.all()) {
      const auto word = bddl_state(state.predicate);
      if (word && !word->negated) fact(std::string(word->name) + " " + name->second);
    }
    if (!node.movable) {
      if (const Room* room = room_at(start_, node.pose.position.head<2>()))
        fact("inroom " + name->second + " " + room->type);
      return Done{};
    }
    const RestingPlace rest = rest_of(start_, id);
    if (!rest.on.empty()) {
      if (auto below = take(rest.on); !below) return below;
      fact(rest.relation + " " + name->second + " " + names_.at(rest.on));
    } else if (!rest.floor.empty()) {
      fact("ontop " + name->second + " " + floor(rest.floor));
    } else {
      return Error{Error::Kind::Unsatisfiable, "", {}, id + " rests on nothing that BDDL can express"};
    }
    return Done{};
  }

  std::string text(const std::string& name, const std::string& goal) {
    const Room* room = room_at(start_, start_.agent.position);
    if (room != nullptr) fact("ontop " + numbered(kAgent, 1) + " " + floor(room->id));
    std::map<std::string, std::vector<std::string>> by_synset;
    std::string comments;
    for (const auto& id : taken_) {
      const std::string& own = names_.at(id);
      by_synset[own.substr(0, own.rfind('_'))].push_back(own);
      comments += "; " + own + ": " + id + "\n";
    }
    for (const auto& [id, own] : floors_) by_synset[kFloor].push_back(own);
    by_synset[kAgent].push_back(numbered(kAgent, 1));
    std::string problem = comments + "(define (problem " + name + ")\n  (:domain omnigibson)\n  (:objects\n";
    for (const auto& [synset, objects] : by_synset) {
      problem += "   ";
      for (const auto& object : objects) problem += " " + object;
      problem += " - " + synset + "\n";
    }
    problem += "  )\n  (:init\n";
    for (const auto& fact : facts_) problem += "    (" + fact + ")\n";
    return problem + "  )\n  (:goal\n    " + goal + "\n  )\n)\n";
  }

 private:
  void fact(const std::string& text) { facts_.insert(text); }
  std::string floor(const std::string& room) {
    const auto [place, is_new] = floors_.emplace(room, "");
    if (is_new) {
      place->second = numbered(kFloor, floors_.size());
      fact("inroom " + place->second + " " + find_room(start_, room)->type);
    }
    return place->second;
  }

  const Scene& start_;
  const std::map<std::string, std::string>& names_;
  std::set<std::string> taken_, facts_;
  std::map<std::string, std::string> floors_;  // by room
};

}  // namespace

Result<std::string> bddl_problem(const std::string& name, const Formula& goal, const Scene& start,
                                 const Knowledge& knowledge, const BddlSynsets& synsets) {
  if (start.simulator != Simulator::Behavior)
    return Error{Error::Kind::Unsatisfiable, "", {}, "BDDL problems are for BEHAVIOR only"};
  const auto names = names_of(start, synsets);
  const auto said = bddl_goal(goal, start, knowledge, synsets, names);
  if (!said) return said.error();
  BddlProblem problem(start, names);
  for (const Node& node : start.nodes) {
    if (!std::binary_search(said->categories.begin(), said->categories.end(), node.category)) continue;
    if (auto taken = problem.take(node.id); !taken) return taken.error();
  }
  return problem.text(name, said->text);
}

}  // namespace unietp
