#include "logic/entity_list.h"

#include <algorithm>
#include <unordered_map>

#include "core/sort_unique.h"
#include "logic/membership.h"

namespace unietp {

struct EntityList::Block {
  using Numbers = std::vector<EntityIndex>;
  std::vector<Entity> entities;
  // Keys are texts of the entities; never iterated.
  std::unordered_map<std::string_view, EntityIndex> by_id;
  std::unordered_map<std::string_view, Numbers> by_category, by_whole;  // of those that are no agent
  std::vector<std::string_view> categories;

  explicit Block(std::vector<Entity> all) : entities(std::move(all)) {
    for (EntityIndex e; e.index() < entities.size(); ++e) {
      const Entity& entity = entities[e.index()];
      by_id.emplace(entity.id, e);
      if (entity.kind == Entity::Kind::Agent) continue;
      by_category[entity.category].push_back(e);
      if (!entity.slice_of.empty()) by_whole[entity.slice_of].push_back(e);
      categories.push_back(entity.category);
    }
    sort_unique(categories);
  }
};

void EntityList::follow(const EntityList& longer) {
  if (empty()) *this = longer;
  for (std::size_t e = size(); e < longer.size(); ++e) own_.push_back(longer[e]);
}

void EntityList::share() {
  // Shared by all copies, so that a candidate need not copy the names of a whole home.
  auto block = std::make_shared<const Block>(std::vector<Entity>(begin(), end()));
  own_.clear();
  first_ = &block->entities;
  shared_size_ = first_->size();
  shared_ = std::move(block);
}

std::optional<EntityIndex> EntityList::find_shared(std::string_view id) const {
  if (shared_ == nullptr) return std::nullopt;
  const auto found = shared_->by_id.find(id);
  return found == shared_->by_id.end() ? std::nullopt : std::optional(found->second);
}

std::vector<EntityIndex> EntityList::of(const Domain& domain) const {
  std::vector<EntityIndex> numbers;
  std::size_t looked_up = 0;
  if (shared_ != nullptr && domain.kind == Domain::Kind::Categories) {
    for (const Domain::Member& member : domain.members) {
      const auto& index = member.slice ? shared_->by_whole : shared_->by_category;
      const auto found = index.find(member.category);
      if (found != index.end()) numbers.insert(numbers.end(), found->second.begin(), found->second.end());
    }
    if (domain.members.size() > 1) sort_unique(numbers);
    looked_up = shared_size_;
  }
  for (std::size_t e = looked_up; e < size(); ++e) {
    if (is_of((*this)[e], domain)) numbers.push_back(EntityIndex(e));
  }
  return numbers;
}

std::vector<std::string_view> EntityList::categories() const {
  auto all = shared_ == nullptr ? std::vector<std::string_view>() : shared_->categories;
  for (const Entity& entity : own_) {
    if (entity.kind != Entity::Kind::Agent) all.push_back(entity.category);
  }
  if (!own_.empty()) sort_unique(all);
  return all;
}

bool EntityList::operator==(const EntityList& other) const {
  return size() == other.size() &&
         (shared_ == other.shared_ ? own_ == other.own_ : std::equal(begin(), end(), other.begin(), other.end()));
}

}  // namespace unietp
