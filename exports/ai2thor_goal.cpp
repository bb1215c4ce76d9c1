#include "exports/ai2thor_goal.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "exports/ai2thor_words.h"
#include "exports/ltlf_formula.h"
#include "interchange/formats.h"
#include "logic/evaluate.h"
#include "scene/trace.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// A proposition about AI2-THOR's metadata.
class TestWriter {
 public:
  TestWriter(const Scene& start, const ThorNames& names, const Knowledge& knowledge)
      : start_(start), names_(names), knowledge_(knowledge) {}

  Result<Json> test_of(const LtlfProposition& one, const Facts& at_start) const {
    const std::string& first = one.arguments.front();
    if (one.meaning == Predicate::InRoom) return in_room(first, one.arguments[1]);
    const auto name = names_.find(first);
    if (name == names_.end()) return thor_lacks(first + " is not in the house");
    const Json there{{"objectId", name->second}, {"key", "objectId"}, {"equals", name->second}};
    if (one.presence) return there;
    switch (one.meaning) {
      case Predicate::SliceOf: {
        const Node* const piece = find_node(start_, first);
        return piece != nullptr && piece->slice_of == one.arguments[1] ? there : Json{{"always", false}};
      }
      case Predicate::Color:
      case Predicate::Material:
      case Predicate::Size:
        return Json{{"always", one.holds_in(at_start)}};
      case Predicate::On:
      case Predicate::Inside:
        return on_or_inside(name->second, one);
      case Predicate::OnFloor: {
        auto room = in_room(first, one.arguments[1]);
        if (!room) return room;
        return Json{{"all",
                     {Json{{"objectId", name->second}, {"key", "parentReceptacles"}, {"containsType", "Floor"}},
                      std::move(*room)}}};
      }
      default:
        break;
    }
    const Node* const node = find_node(start_, first);
    const bool of_switch = one.meaning == Predicate::PowerOn || one.meaning == Predicate::PowerOff;
    const auto test = thor_test({one.meaning, one.arguments.size() > 1 ? one.arguments[1] : ""}, name->second);
    if (!test || (of_switch && node != nullptr && !thor_holding_part(node->category).empty()))
      return thor_lacks("AI2-THOR's metadata does not tell " + one.predicate +
                        (node == nullptr ? std::string() : " of " + node->category));
    return *test;
  }

 private:
  Result<Json> in_room(const std::string& what, const std::string& room) const {
    const auto place =
        std::find_if(start_.rooms.begin(), start_.rooms.end(), [&](const Room& one) { return one.id == room; });
    if (place == start_.rooms.end()) return thor_lacks("there is no room " + room);
    const std::string id = procthor_room_ids(start_)[static_cast<std::size_t>(place - start_.rooms.begin())];
    if (what == "agent") return Json{{"agent", true}, {"room", id}};
    const auto name = names_.find(what);
    if (name == names_.end()) return thor_lacks(what + " is not in the house");
    return Json{{"objectId", name->second}, {"room", id}};
  }

  Result<Json> on_or_inside(const std::string& object, const LtlfProposition& one) const {
    const auto place = names_.find(one.arguments[1]);
    if (place == names_.end()) return thor_lacks(one.arguments[1] + " is not in the house");
    Json test{{"objectId", object}, {"key", "parentReceptacles"}, {"contains", place->second}};
    // The metadata does not tell on from inside; where things go both ways, heights do.
    const Node* const node = find_node(start_, one.arguments[1]);
    const bool both =
        node != nullptr && knowledge_.has(node->category, "container") && knowledge_.has(node->category, "receptacle");
    if (both) test["above"] = one.meaning == Predicate::On;
    return test;
  }

  const Scene& start_;
  const ThorNames& names_;
  const Knowledge& knowledge_;
};

std::optional<EntityIndex> entity_of(const std::string& id, const Trace& trace) {
  for (std::size_t i = 0; i < trace.entities.size(); ++i) {
    if (trace.entities[EntityIndex(i)].id == id) return EntityIndex(i);
  }
  return std::nullopt;
}

/// A copy of a piece that lies where it does.
template <class Edges>
void add_beside(const Node& piece, std::string id, std::vector<Node>& nodes, const Edges& edges,
                std::vector<Edge>& added) {
  std::vector<Edge> copies;
  for (const Edge& edge : edges) {
    if (edge.from == piece.id) copies.push_back({edge.relation, id, edge.to});
  }
  added.insert(added.end(), copies.begin(), copies.end());
  nodes.push_back(piece);
  nodes.back().id = std::move(id);
}

/// The states of the demonstration with all pieces that AI2-THOR cuts, which are more than ours: the others lie where
/// the first does. Pieces of what is never cut are entities that never exist.
Trace trace_with(const std::vector<ThorPiece>& pieces, Scene start, std::vector<Delta> changes, bool with_comparisons) {
  Delta at_start;
  std::vector<std::string> never;
  for (const ThorPiece& piece : pieces) {
    if (piece.beside.empty()) continue;  // the demonstration itself cuts it
    if (const Node* const first = find_node(start, piece.beside);
        first != nullptr && first->category == piece.node.category) {
      add_beside(*first, piece.node.id, at_start.nodes, start.edges, at_start.edges_added);
      continue;
    }
    bool cut = false;
    for (Delta& change : changes) {
      const auto first = std::find_if(change.nodes.begin(), change.nodes.end(), [&](const Node& node) {
        return node.slice_of == piece.beside && find_node(start, node.id) == nullptr;
      });
      if (first == change.nodes.end()) continue;
      const Node copied = *first;
      add_beside(copied, piece.node.id, change.nodes, std::vector<Edge>(change.edges_added), change.edges_added);
      cut = true;
      break;
    }
    if (cut) continue;
    at_start.nodes.push_back(piece.node);
    never.push_back(piece.node.id);
  }
  Trace trace = to_logic(apply(std::move(start), at_start), changes, with_comparisons);
  for (const std::string& id : never) {
    const auto entity = entity_of(id, trace);
    if (!entity) continue;
    for (Facts& facts : trace.states) facts.forget(*entity);
  }
  return trace;
}

}  // namespace

std::vector<ThorPiece> thor_pieces(const FinishedTask& task, const ThorNames& names,
                                   const std::map<std::string, std::string>& wholes, const Knowledge& knowledge) {
  constexpr int kPieces = 10;  // a loaf of bread has this many, others fewer
  std::vector<ThorPiece> pieces;
  std::set<std::string> known;
  for (const auto& [id, name] : names) known.insert(name);
  for (const auto& step : task.shown.at(Mode::M1).steps) {
    for (const Node& node : step.changes.nodes) {
      const bool is_new =
          find_node(task.start, node.id) == nullptr &&
          std::none_of(pieces.begin(), pieces.end(), [&](const ThorPiece& one) { return one.node.id == node.id; });
      const auto name = names.find(node.id);
      if (is_new && !node.slice_of.empty() && name != names.end()) pieces.push_back({node, name->second, ""});
    }
  }
  const auto add = [&](const Node& whole, const std::string& piece_category, const std::string& object) {
    for (int n = 0; n < kPieces; ++n) {
      ThorPiece piece;
      piece.objectId = object + "|" + piece_category + "_" + std::to_string(n);
      if (known.contains(piece.objectId)) continue;
      piece.node.id = whole.id + "_piece_" + std::to_string(n);
      piece.node.category = piece_category;
      piece.node.movable = true;
      piece.node.size = Vec3::Constant(0.01);
      piece.beside = whole.id;
      const bool cut_at_start = whole.category == piece_category;
      piece.node.slice_of = cut_at_start ? whole.slice_of : whole.id;
      piece.node.whole_category = cut_at_start ? whole.whole_category : whole.category;
      pieces.push_back(std::move(piece));
    }
  };
  for (const Node& node : task.start.nodes) {
    if (const auto cut = wholes.find(node.id); cut != wholes.end()) add(node, node.category, cut->second);
    const auto cuts = knowledge.effects_on(node.category, Treatment::Slices);
    const auto name = names.find(node.id);
    if (!cuts.empty() && name != names.end()) add(node, cuts.front()->gives, name->second);
  }
  return pieces;
}

Result<ThorGoal> thor_goal(const FinishedTask& task, ThorNames names, const std::vector<ThorPiece>& pieces,
                           const Knowledge& knowledge) {
  const Formula& goal = task.record.goal_tree;
  const std::vector<Delta> changes = changes_by_moment(task.shown.at(Mode::M1));
  const bool with_comparisons = reads_comparisons(goal);
  if (holds(goal, to_logic(task.start, {}, with_comparisons)))
    return thor_lacks("among what is in the house its goal holds at the start");
  if (!holds(goal, to_logic(task.start, changes, with_comparisons)))
    return thor_lacks("among what is in the house the demonstration does not reach its goal");
  Scene with_pieces = task.start;
  for (const ThorPiece& piece : pieces) {
    with_pieces.nodes.push_back(piece.node);
    names[piece.node.id] = piece.objectId;
  }
  const Trace trace = trace_with(pieces, task.start, changes, with_comparisons);
  if (!holds(goal, trace)) return thor_lacks("AI2-THOR cuts a thing into more pieces than its goal allows");
  // AI2-THOR may cut fewer: of those that our scene does not have, the goal asks nothing unless they are there.
  Facts front = trace.states.front(), later = front;
  for (const ThorPiece& piece : pieces) {
    const auto entity = entity_of(piece.node.id, trace);
    if (!entity) return thor_lacks(piece.node.id + " is in no moment of the demonstration");
    if (!piece.beside.empty()) front.forget(*entity);
    later.set_exists(*entity);
  }
  auto ltlf = ltlf_goal(goal, Trace{trace.entities, {std::move(front), std::move(later)}});
  if (!ltlf) return ltlf.error();
  ThorGoal made;
  made.formula = std::move(ltlf->formula);
  Json propositions = Json::array();
  const TestWriter tests(with_pieces, names, knowledge);
  for (const auto& one : ltlf->propositions) {
    const auto test = tests.test_of(one, trace.states.front());
    if (!test) return test.error();
    propositions.push_back(
        {{"name", one.name}, {"predicate", one.predicate}, {"arguments", one.arguments}, {"test", *test}});
    for (const auto& argument : one.arguments) {
      if (names.contains(argument)) made.objects.insert(argument);
    }
  }
  for (const Facts& facts : trace.states) {
    made.holding.emplace_back();
    for (const auto& one : ltlf->propositions) {
      if (one.holds_in(facts)) made.holding.back().push_back(one.name);
    }
  }
  made.propositions = propositions.dump(-1, ' ', false, Json::error_handler_t::replace);
  return made;
}

}  // namespace unietp
