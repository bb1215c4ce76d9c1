#include "grounding/polish.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grounding/likelihood.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

constexpr std::size_t kMostTried = 16;  // edits; nearly all starts have fewer
constexpr int kPlacesTried = 3;
constexpr double kContactDepth_m = 1e-3;  // resting contacts are no deeper

class Polish {
 public:
  Polish(SceneEditor& editor, const GoalPlaces& places, const std::function<bool()>& is_sound)
      : editor_(editor), places_(places), is_sound_(is_sound) {}

  void run() {
    for (const Node& node : changed()) {
      const auto place = workspace().places().find(node.id);
      const Node* before = in_home(node.id);
      if (place && before != nullptr && before->opening == node.opening && workspace().carried_by(*place).empty())
        put_back(*before, *place);
    }
    for (const Node& node : changed()) {
      if (node.movable && oddness_of(workspace(), node) != Oddness::None) find_likelier_place(node);
    }
    for (const auto& [category, places] : places_) {
      const auto* household = workspace().household();
      if (household == nullptr) break;
      const auto washes = [&](const std::string& place) { return household->washes(place); };
      if (std::any_of(places.begin(), places.end(), washes)) take_one_out(category, places);
      take_out_of_the_wash(category, places);
    }
    editor_.refresh();
  }

 private:
  Workspace& workspace() { return editor_.workspace(); }

  const Node* in_home(const std::string& id) {
    const auto place = workspace().home()->places.find(id);
    return place ? &workspace().home()->scene.nodes[*place] : nullptr;
  }

  std::vector<Node> changed() {
    editor_.refresh();
    std::vector<Node> nodes = workspace().changes().nodes;
    if (nodes.size() > kMostTried) nodes.resize(kMostTried);
    return nodes;
  }

  /// Whether everything that the thing rested on or in is where it was.
  bool has_its_support(const Node& before) {
    const auto& now = workspace().home()->now;
    const auto entity = workspace().home()->reader.find(before.id);
    const auto& relations = now.states.front().relations(*entity);
    return std::all_of(relations.begin(), relations.end(), [&](const auto& one) {
      const Node* host = in_home(now.entities[one.second].id);
      if (host == nullptr || (one.first != Predicate::On && one.first != Predicate::Inside)) return true;
      const auto place = workspace().places().find(host->id);
      return place && same_body(*host, workspace().scene().nodes[*place]);
    });
  }

  /// Whether a thing that stands there touches nothing but what it rests on.
  bool is_free(const Node& node, std::size_t index) {
    const std::array ignore{BodyId::node(index)};
    return !workspace().physics().overlap(shape_of(node), node.pose, node.opening, ignore, kContactDepth_m);
  }

  void put_back(const Node& before, std::size_t index) {
    const Node now = workspace().scene().nodes[index];
    if (!same_body(before, now) && !(has_its_support(before) && is_free(before, index))) return;
    editor_.replace(before);
    if (!is_sound_()) editor_.replace(now);
  }

  void find_likelier_place(const Node& node) {
    const auto place = workspace().places().find(node.id);
    if (!place || !workspace().carried_by(*place).empty()) return;
    const Oddness before = oddness_of(workspace(), node);
    for (int tried = 0; tried < kPlacesTried; ++tried) {
      if (!editor_.relocate(node.id, [&](const Node& host) { return !is_rare_at(workspace(), node, host); })) break;
      editor_.refresh();
      const Node& now = workspace().scene().nodes[*workspace().places().find(node.id)];
      if (oddness_of(workspace(), now) < before && is_sound_()) return;
    }
    editor_.replace(node);
    editor_.refresh();
  }

  bool is_put_away(const Node& node) {
    const auto entity = workspace().current_state().reader().find(node.id);
    const auto& trace = workspace().current_state().now();
    const auto& relations = trace.states.front().relations(*entity);
    return std::any_of(relations.begin(), relations.end(), [&](const auto& one) {
      if (one.first != Predicate::On && one.first != Predicate::Inside) return false;
      const auto host = workspace().places().find(trace.entities[one.second].id);
      return host && workspace().household()->puts_away(workspace().scene().nodes[*host].category);
    });
  }

  /// Moves one of the things from where it is put away, if all of them are, to where neither they are nor the goal puts
  /// them.
  void take_one_out(const std::string& category, const std::set<std::string>& goal) {
    editor_.refresh();
    std::vector<Node> things;
    for (const Node& node : workspace().scene().nodes) {
      if (node.category == category && node.movable) things.push_back(node);
    }
    if (things.empty() || !std::all_of(things.begin(), things.end(), [&](const Node& one) { return is_put_away(one); }))
      return;
    const Node& before = things.front();
    if (!workspace().carried_by(*workspace().places().find(before.id)).empty()) return;
    const bool moved = editor_.relocate(before.id, [&](const Node& host) {
      return !workspace().household()->puts_away(host.category) && !goal.contains(host.category);
    });
    if (moved) editor_.refresh();
    if (!moved || !is_sound_()) editor_.replace(before);
    editor_.refresh();
  }

  /// Whether the thing waits to be washed where the goal wants it nearly: dirty in a dishwasher though it is to go
  /// somewhere else, or in a dryer though it is to go into the washing machine.
  bool is_in_the_wash(const Node& node, const std::set<std::string>& goal) {
    const Household& household = *workspace().household();
    const auto entity = workspace().current_state().reader().find(node.id);
    const auto& trace = workspace().current_state().now();
    const auto& relations = trace.states.front().relations(*entity);
    return std::any_of(relations.begin(), relations.end(), [&](const auto& one) {
      const auto host = workspace().places().find(trace.entities[one.second].id);
      if (!host) return false;
      const std::string& there = workspace().scene().nodes[*host].category;
      if (one.first != Predicate::Inside || !household.washes(there)) return false;
      const bool to_be_washed =
          std::any_of(goal.begin(), goal.end(), [&](const std::string& place) { return household.washes(place); });
      if (!to_be_washed) return node.states.has(Predicate::Dirty);
      return std::any_of(goal.begin(), goal.end(), [&](const std::string& place) {
        return place != there && household.kind_of(place) == household.kind_of(there);
      });
    });
  }

  /// Moves such things to where neither they nor others are washed and the goal puts none.
  void take_out_of_the_wash(const std::string& category, const std::set<std::string>& goal) {
    editor_.refresh();
    std::vector<Node> things;
    for (const Node& node : workspace().scene().nodes) {
      if (node.category == category && node.movable && is_in_the_wash(node, goal)) things.push_back(node);
    }
    for (const Node& before : things) {
      if (!workspace().carried_by(*workspace().places().find(before.id)).empty()) continue;
      const bool moved = editor_.relocate(before.id, [&](const Node& host) {
        return !workspace().household()->washes(host.category) && !goal.contains(host.category) &&
               !is_rare_at(workspace(), before, host);
      });
      if (moved) editor_.refresh();
      if (!moved || !is_sound_()) editor_.replace(before);
      editor_.refresh();
    }
  }

  SceneEditor& editor_;
  const GoalPlaces& places_;
  const std::function<bool()>& is_sound_;
};

}  // namespace

void polish(SceneEditor& editor, const GoalPlaces& places, const std::function<bool()>& is_sound) {
  Polish(editor, places, is_sound).run();
}

}  // namespace unietp
