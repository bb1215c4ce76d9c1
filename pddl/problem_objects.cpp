#include "pddl/problem_objects.h"

#include <set>

#include "symbolic/from_scene.h"

namespace unietp::pddl {
namespace {

constexpr int kTools = 2;   // of a category
constexpr int kPlaces = 2;  // to put things of a category aside

class CastPicker {
 public:
  CastPicker(const Scene& scene, const Knowledge& knowledge) : scene_(scene), knowledge_(knowledge) {}

  void take(const Node& node) {
    for (const Node* step = &node; step != nullptr; step = symbolic::support_of(scene_, *step)) ids_.insert(step->id);
  }

  void take_category(const std::string& category) {
    for (const auto& node : scene_.nodes) {
      if (node.category == category) take(node);
    }
  }

  std::set<std::string> movable_categories() const {
    std::set<std::string> names;
    for (const auto& node : scene_.nodes) {
      if (node.movable && ids_.count(node.id) > 0) names.insert(node.category);
    }
    return names;
  }

  /// What does something to things of a category.
  void take_tools(const std::string& target) {
    for (const TreatmentInfo& row : all_treatments()) {
      if (row.treatment == Treatment::Attaches) continue;
      for (const auto* effect : knowledge_.effects_on(target, row.treatment)) take_few(effect->tool, kTools);
    }
  }

  void take_places(const std::string& category) {
    int found = 0;
    for (const auto* row : knowledge_.placements_of(category, Predicate::On)) {
      const auto* place = knowledge_.find(row->receptacle);
      if (place != nullptr && !place->movable && found < kPlaces) found += take_few(row->receptacle, 1);
    }
  }

  void take_content() {
    for (const auto& node : scene_.nodes) {
      const auto* support = node.movable ? symbolic::support_of(scene_, node) : nullptr;
      if (support != nullptr && support->movable && ids_.count(support->id) > 0) take(node);
    }
  }

  std::vector<const Node*> taken() const {
    std::vector<const Node*> nodes;
    for (const auto& node : scene_.nodes) {
      if (ids_.count(node.id) > 0 && knowledge_.find(node.category) != nullptr) nodes.push_back(&node);
    }
    return nodes;
  }

 private:
  int take_few(const std::string& category, int most) {
    int number = 0;
    for (const auto& node : scene_.nodes) {
      if (node.category == category && number < most) take(node), ++number;
    }
    return number;
  }

  const Scene& scene_;
  const Knowledge& knowledge_;
  std::set<std::string> ids_;
};

}  // namespace

std::vector<const Node*> problem_objects(const Scene& scene, const Knowledge& knowledge, const Formula& goal,
                                         const std::vector<std::string>& handled) {
  CastPicker picker(scene, knowledge);
  for (const auto& id : handled) {
    if (const auto* node = find_node(scene, id); node != nullptr) picker.take(*node);
  }
  for (const auto& category : categories_of(goal)) picker.take_category(category);
  for (const auto& category : picker.movable_categories()) {
    picker.take_tools(category);
    picker.take_places(category);
  }
  for (const auto& category : categories_of(goal)) picker.take_tools(category);
  for (const auto& category : picker.movable_categories()) picker.take_tools(category);  // what wets a cloth
  picker.take_content();
  return picker.taken();
}

}  // namespace unietp::pddl
