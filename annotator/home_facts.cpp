#include "annotator/home_facts.h"

#include <map>
#include <string_view>

#include "core/sort_unique.h"
#include "core/text.h"

namespace unietp {

std::string home_in_words(const Scene& scene, const NounTable& nouns) {
  std::map<std::string, std::string> room_of, category_of;
  for (const Node& node : scene.nodes) category_of[node.id] = node.category;
  for (const Edge& edge : scene.edges)
    if (edge.relation == Predicate::InRoom) room_of[edge.from] = edge.to;
  std::map<std::string, std::map<std::string, int>> counts;
  for (const Node& node : scene.nodes) ++counts[room_of[node.id]][node.category];
  std::string text;
  for (const Room& room : scene.rooms) {
    std::vector<std::string> things;
    for (const auto& [category, count] : counts[room.id]) {
      const auto* name = nouns.display(category);
      if (name == nullptr) continue;
      things.push_back(count == 1 ? name->singular : std::to_string(count) + " " + name->plural);
    }
    text += replace_all(room.type, "_", " ") + ": " + (things.empty() ? "nothing" : join(things, ", ")) + "\n";
  }
  return text;
}

std::vector<std::string> categories_in(const Scene& scene) { return categories_in(scene, NodeIndex(scene.nodes)); }

std::vector<std::string> categories_in(const Scene& scene, const NodeIndex& places) {
  std::vector<std::string> categories;
  for (const std::string_view category : places.categories()) categories.emplace_back(category);
  for (const Room& room : scene.rooms) categories.push_back(room.type);
  sort_unique(categories);
  return categories;
}

std::vector<std::string> alone_in(const Scene& scene) {
  std::map<std::string_view, int> counts;
  for (const Node& node : scene.nodes) ++counts[node.category];
  for (const Room& room : scene.rooms) ++counts[room.type];
  std::vector<std::string> alone;
  for (const auto& [category, count] : counts)
    if (count == 1) alone.emplace_back(category);
  return alone;
}

}  // namespace unietp
