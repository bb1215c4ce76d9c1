#include "grounding/edits_in_words.h"

#include <algorithm>
#include <optional>

#include "akb/default_states.h"

namespace unietp {
namespace {

std::string text_of(const State& state) {
  return std::string(info(state.predicate).name) + (state.symbol.empty() ? "" : " " + state.symbol);
}

/// States that the one has and the other has not.
std::vector<std::string> states_besides(const StateSet& states, const StateSet& others) {
  std::vector<std::string> more;
  for (const State& state : states.all()) {
    if (!others.has(state)) more.push_back(text_of(state));
  }
  return more;
}

/// What a thing lies on or in: of several, the one that is in or on another.
std::optional<Edge> support_of(const std::string& id, const EdgeSet& edges) {
  const auto from = [&](Predicate relation) { return Edge{relation, id, ""}; };
  std::optional<Edge> found;
  for (const Predicate relation : {Predicate::On, Predicate::Inside, Predicate::OnFloor}) {
    const Edge first = from(relation);
    for (auto at = edges.partition_point([&](const Edge& edge) { return edge < first; });
         at != edges.end() && at->relation == relation && at->from == id; ++at) {
      const bool nearer = !found || edges.contains(Edge{Predicate::Inside, at->to, found->to}) ||
                          edges.contains(Edge{Predicate::On, at->to, found->to});
      if (nearer) found = *at;
    }
    if (found) break;
  }
  return found;
}

std::string where(const std::optional<Edge>& support) {
  if (!support) return "to another place";
  if (support->relation == Predicate::OnFloor) return "on the floor of " + support->to;
  return std::string(info(support->relation).name) + " " + support->to;
}

class EditDescriber {
 public:
  EditDescriber(const Home& home, const Scene& start, const Delta& changes, const Knowledge& knowledge)
      : home_(home), start_(start), changes_(changes), knowledge_(knowledge) {}

  std::vector<std::string> all() {
    for (const std::string& id : changes_.removed) lines_.push_back("removed " + id);
    std::sort(lines_.begin(), lines_.end());
    for (const Node& node : changes_.nodes) {
      if (!before(node.id)) add(node);
    }
    for (const Node& node : changes_.nodes) {
      if (const Node* was = before(node.id)) move(*was, node);
    }
    for (const Node& node : changes_.nodes) {
      if (const Node* was = before(node.id)) make(*was, node);
    }
    if (changes_.agent) {
      const Room* room = room_at(start_, start_.agent.position);
      lines_.push_back("the agent starts in " + (room == nullptr ? "another place" : room->id));
    }
    return std::move(lines_);
  }

 private:
  const Node* before(const std::string& id) const {
    const auto place = home_.places.find(id);
    return place ? &home_.scene.nodes[*place] : nullptr;
  }

  void add(const Node& node) {
    Node plain = node;
    plain.states = {};
    set_default_states(plain, knowledge_);
    std::string text = "added " + node.category + " " + node.id + " " + where(support_of(node.id, start_.edges));
    for (const std::string& state : states_besides(node.states, plain.states)) text += ", " + state;
    lines_.push_back(std::move(text));
  }

  void move(const Node& was, const Node& now) {
    if (was.pose == now.pose) return;
    const auto support = support_of(now.id, start_.edges);
    const bool stays = support == support_of(now.id, home_.scene.edges);
    // A larger box stands a little higher; what lies in a drawer moves with it.
    if (stays && (was.size != now.size || (support && has_moved_its_door(support->to)))) return;
    lines_.push_back("moved " + now.id + " " + where(support));
  }

  bool has_moved_its_door(const std::string& id) const {
    const Node* was = before(id);
    const auto now =
        std::find_if(changes_.nodes.begin(), changes_.nodes.end(), [&](const Node& node) { return node.id == id; });
    return was != nullptr && now != changes_.nodes.end() && was->opening != now->opening;
  }

  void make(const Node& was, const Node& now) {
    const std::string made = "made " + now.id + " ";
    for (const std::string& state : states_besides(now.states, was.states)) lines_.push_back(made + state);
    if (was.states.has(Predicate::Covered) && !now.states.has(Predicate::Covered))
      lines_.push_back(made + "not covered");
    if (was.color != now.color) lines_.push_back(made + now.color);
    if (was.material != now.material) lines_.push_back(made + "of " + now.material);
    if (was.size != now.size) lines_.push_back(made + (now.size.prod() > was.size.prod() ? "larger" : "smaller"));
  }

  const Home& home_;
  const Scene& start_;
  const Delta& changes_;
  const Knowledge& knowledge_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> edits_in_words(const Home& home, const Scene& start, const Delta& changes,
                                        const Knowledge& knowledge) {
  return EditDescriber(home, start, changes, knowledge).all();
}

}  // namespace unietp
