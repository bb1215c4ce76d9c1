#include "exports/bddl.h"

#include <algorithm>
#include <set>

#include "exports/bddl_goal.h"

namespace unietp {
namespace {

constexpr const char* kFloor = "floor.n.01";

std::string numbered(const std::string& synset, std::size_t number) { return synset + "_" + std::to_string(number); }
std::string synset_of(const std::string& name) { return name.substr(0, name.rfind('_')); }

/// Names of all objects that have a synset: the synset and a running number. Halves of what can be cut come after them.
BddlNames names_of(const Scene& start, const std::map<std::string, Halves>& halves, const BddlSynsets& synsets) {
  std::map<std::string, std::size_t> counts;
  BddlNames names;
  const auto name = [&](const std::string& id, const std::string& category) {
    const auto synset = synsets.find(category);
    if (synset != synsets.end()) names[id] = numbered(synset->second, ++counts[synset->second]);
  };
  for (const Node& node : start.nodes) name(node.id, node.category);
  for (const Node& node : start.nodes) {
    const auto its = halves.find(node.id);
    if (its == halves.end()) continue;
    name(its->second.first, its->second.category);
    name(its->second.second, its->second.category);
  }
  return names;
}

BddlNames floors_of(const Scene& start) {
  BddlNames floors;
  for (const Room& room : start.rooms) floors[room.id] = numbered(kFloor, floors.size() + 1);
  return floors;
}

/// Each thing that an object rests on or in, and the floor that it stands on.
struct RestingPlace {
  std::vector<std::pair<std::string, std::string>> on;  // the relation in BDDL, the id
  std::string floor;                                    // a room's id
};
RestingPlace rest_of(const Scene& start, const std::string& id) {
  RestingPlace rest;
  for (const Edge& edge : start.edges) {
    if (edge.from != id) continue;
    if (edge.relation == Predicate::Inside || edge.relation == Predicate::On)
      rest.on.emplace_back(bddl_relation(edge.relation), edge.to);
    if (edge.relation == Predicate::OnFloor) rest.floor = edge.to;
  }
  return rest;
}

class ProblemWriter {
 public:
  ProblemWriter(const Scene& start, const BddlNames& names, const BddlNames& floors, const BddlWords& words,
                std::set<std::string> liquids)
      : start_(start), names_(names), floors_(floors), words_(words), liquids_(std::move(liquids)) {}

  /// An object with what it rests on or in. Errors: as bddl_problem.
  Result<Done> take(const std::string& id) {
    if (taken_.contains(id)) return Done{};
    const auto name = names_.find(id);
    if (name == names_.end()) return Error{Error::Kind::Unsatisfiable, "", {}, "the support " + id + " has no synset"};
    taken_[id] = name->second;
    const Node& node = *find_node(start_, id);
    for (const State& state : node.states.all()) {
      std::set<std::string> substances;
      const std::string literal = bddl_state(state, name->second, words_, liquids_, substances);
      if (literal.empty() || literal.starts_with("(not ") || literal.starts_with("(and ")) continue;
      facts_.insert(literal);
      substances_.insert(substances.begin(), substances.end());
    }
    if (!node.movable) {
      if (const Room* room = room_at(start_, node.pose.position.head<2>()))
        fact("inroom " + name->second + " " + room->type);
      return Done{};
    }
    const RestingPlace rest = rest_of(start_, id);
    for (const auto& [relation, place] : rest.on) {
      if (auto below = take(place); !below) return below;
      fact(relation + " " + name->second + " " + names_.at(place));
    }
    if (!rest.on.empty()) return Done{};
    if (!rest.floor.empty()) {
      fact("ontop " + name->second + " " + floor(rest.floor));
    } else {
      return Error{Error::Kind::Unsatisfiable, "", {}, id + " rests on nothing that BDDL can express"};
    }
    return Done{};
  }

  /// What the thing becomes when it is cut.
  void take_halves(const std::string& whole, const Halves& halves) {
    for (const auto& [number, half] : {std::pair{"/1", halves.first}, {"/2", halves.second}}) {
      taken_[whole + number] = names_.at(half);
      fact("future " + names_.at(half));
    }
  }
  void take_substances(const std::set<std::string>& synsets) { substances_.insert(synsets.begin(), synsets.end()); }
  std::string floor(const std::string& room) {
    if (used_floors_.emplace(room, floors_.at(room)).second)
      fact("inroom " + floors_.at(room) + " " + find_room(start_, room)->type);
    return floors_.at(room);
  }

  /// Objects, halves and floors that the problem has so far.
  BddlNames declared() const {
    BddlNames all = taken_;
    all.insert(used_floors_.begin(), used_floors_.end());
    return all;
  }

  /// Substances that the problem has so far.
  BddlNames substances() const {
    BddlNames named;
    for (const auto& [substance, synset] : words_.substances) {
      if (substances_.contains(synset)) named[substance] = numbered(synset, 1);
    }
    return named;
  }

  std::string text(const std::string& name, const std::string& goal) {
    const Room* room = room_at(start_, start_.agent.position);
    if (room != nullptr) fact(std::string("ontop ") + kBddlAgent + " " + floor(room->id));
    std::map<std::string, std::vector<std::string>> by_synset;
    std::string comments;
    for (const auto& [id, own] : declared()) {
      by_synset[synset_of(own)].push_back(own);
      comments += "; " + own + ": " + id + "\n";
    }
    for (const auto& synset : substances_) by_synset[synset].push_back(numbered(synset, 1));
    by_synset[synset_of(kBddlAgent)].emplace_back(kBddlAgent);
    std::string problem = comments + "(define (problem " + name + ")\n  (:domain omnigibson)\n  (:objects\n";
    for (const auto& [synset, objects] : by_synset) {
      problem += "   ";
      for (const auto& object : objects) problem += " " + object;
      problem += " - " + synset + "\n";
    }
    problem += "  )\n  (:init\n";
    for (const auto& fact : facts_) problem += "    " + fact + "\n";
    return problem + "  )\n  (:goal\n    " + goal + "\n  )\n)\n";
  }

 private:
  void fact(const std::string& text) { facts_.insert("(" + text + ")"); }

  const Scene& start_;
  const BddlNames& names_;
  const BddlNames& floors_;
  const BddlWords& words_;
  const std::set<std::string> liquids_;
  BddlNames taken_;
  std::set<std::string> facts_, substances_;
  BddlNames used_floors_;  // by room
};

}  // namespace

Result<BddlProblem> bddl_problem(const FinishedTask& task, const Knowledge& knowledge, const BddlWords& words) {
  const Scene& start = task.start;
  if (start.simulator != Simulator::Behavior)
    return Error{Error::Kind::Unsatisfiable, "", {}, "not a task of BEHAVIOR"};
  const auto halves = halved_trace(task, knowledge).halves;
  const BddlNames names = names_of(start, halves, words.categories), floors = floors_of(start);
  auto goal = behavior_goal(task, knowledge, words, names, floors);
  if (!goal) return goal.error();
  const auto quantified = bddl_goal(task.record.goal_tree, start, knowledge, words, names);
  ProblemWriter problem(start, names, floors, words, liquids_of(start, knowledge));
  for (const Node& node : start.nodes) {
    const bool ranged_over =
        quantified && std::binary_search(quantified->categories.begin(), quantified->categories.end(), node.category);
    if (!ranged_over && !goal->objects.contains(node.id)) continue;
    if (auto taken = problem.take(node.id); !taken) return taken.error();
    if (const auto its = halves.find(node.id); its != halves.end()) problem.take_halves(node.id, its->second);
  }
  for (const std::string& room : goal->floors) (void)problem.floor(room);
  problem.take_substances(goal->substances);
  if (quantified) problem.take_substances(quantified->substances);
  BddlProblem made;
  made.text = problem.text(task.record.id, quantified ? quantified->text : goal->last);
  made.names = problem.declared();
  made.substances = problem.substances();
  made.decides = quantified || goal->last_decides;
  made.goal = std::move(*goal);
  return made;
}

}  // namespace unietp
