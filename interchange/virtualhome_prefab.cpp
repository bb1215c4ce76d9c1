#include "interchange/virtualhome_prefab.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace unietp {
namespace {

/// The prefabs of a class: the knowledge base's models, where it has any.
std::vector<Prefab> prefabs_of(const std::string& category, const Knowledge& knowledge, const FormatFacts& facts) {
  std::vector<Prefab> all;
  for (const Asset* const model : knowledge.asset_rows_of(category)) all.push_back({model->name, model->size});
  if (!all.empty()) return all;
  const auto more = facts.virtualhome_prefabs.find(category);
  return more == facts.virtualhome_prefabs.end() ? all : more->second;
}

/// The largest share by which a side of the prefab differs from the object's.
double misfit(const Prefab& prefab, const Vec3& size) {
  if (prefab.size.isZero()) return std::numeric_limits<double>::infinity();
  return (prefab.size.cwiseQuotient(size) - Vec3::Ones()).cwiseAbs().maxCoeff();
}

}  // namespace

Prefab virtualhome_prefab(const Node& node, const Knowledge& knowledge, const FormatFacts& facts) {
  if (!node.asset.empty())
    return {node.asset, size_of_prefab(node.asset, node.category, knowledge, facts).value_or(Vec3::Zero())};
  const std::vector<Prefab> all = prefabs_of(node.category, knowledge, facts);
  const auto nearest = std::min_element(all.begin(), all.end(), [&](const Prefab& a, const Prefab& b) {
    return misfit(a, node.size) < misfit(b, node.size);
  });
  return nearest == all.end() ? Prefab() : *nearest;
}

std::optional<Vec3> size_of_prefab(std::string_view name, std::string_view category, const Knowledge& knowledge,
                                   const FormatFacts& facts) {
  if (const Asset* const model = knowledge.asset(name)) return model->size;
  const auto known = facts.virtualhome_prefabs.find(category);
  if (known == facts.virtualhome_prefabs.end()) return std::nullopt;
  const auto prefab =
      std::find_if(known->second.begin(), known->second.end(), [&](const Prefab& one) { return one.name == name; });
  if (prefab == known->second.end() || prefab->size.isZero()) return std::nullopt;
  return prefab->size;
}

}  // namespace unietp
