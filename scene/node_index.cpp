#include "scene/node_index.h"

#include <algorithm>

namespace unietp {

NodeIndex::NodeIndex() : NodeIndex(SharedList<Node>()) {}

NodeIndex::NodeIndex(const SharedList<Node>& nodes) {
  auto common = std::make_shared<Common>();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    common->by_id.emplace(nodes[i].id, i);
    common->by_category[nodes[i].category].push_back(i);
  }
  for (const auto& [category, there] : common->by_category) common->categories.push_back(category);
  std::sort(common->categories.begin(), common->categories.end());
  common_ = std::move(common);
}

std::vector<std::string_view> NodeIndex::categories() const {
  std::vector<std::string_view> there;
  for (const std::string& category : common_->categories) {
    if (!of(category).empty()) there.push_back(category);
  }
  for (const auto& [category, places] : by_category_) {
    if (!places.empty() && !common_->by_category.contains(category)) there.push_back(category);
  }
  std::sort(there.begin(), there.end());
  return there;
}

std::optional<std::size_t> NodeIndex::find(std::string_view id) const {
  if (const auto own = by_id_.find(id); own != by_id_.end()) return own->second;
  const auto found = common_->by_id.find(id);
  return found == common_->by_id.end() ? std::nullopt : std::optional(found->second);
}

const NodeIndex::Places& NodeIndex::of(std::string_view category) const {
  static const Places kNone;
  if (const auto own = by_category_.find(category); own != by_category_.end()) return own->second;
  const auto found = common_->by_category.find(category);
  return found == common_->by_category.end() ? kNone : found->second;
}

NodeIndex::Places& NodeIndex::own(const std::string& category) {
  const auto [place, fresh] = by_category_.try_emplace(category);
  if (!fresh) return place->second;
  const auto common = common_->by_category.find(category);
  if (common != common_->by_category.end()) place->second = common->second;
  return place->second;
}

void NodeIndex::add(std::size_t place, const Node& node) {
  by_id_.insert_or_assign(node.id, place);
  Places& places = own(node.category);
  places.insert(std::lower_bound(places.begin(), places.end(), place), place);
}

void NodeIndex::remove(std::size_t place, const Node& node) {
  // A second node may have been added at this place, or the node at another, before this removal is reported.
  if (find(node.id) == place) by_id_.insert_or_assign(node.id, std::nullopt);
  Places& places = own(node.category);
  const auto at = std::lower_bound(places.begin(), places.end(), place);
  if (at != places.end() && *at == place) places.erase(at);
}

}  // namespace unietp
