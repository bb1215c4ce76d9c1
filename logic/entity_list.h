#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "logic/entity.h"

namespace unietp {

struct Domain;

/// A list of entities that can grow. The entities up to the last call of `share` are one block in memory for all
/// copies, indexed by id and category; each copy stores those added since by itself and searches them one by one.
class EntityList {
 public:
  class Iterator;

  EntityList() = default;
  EntityList(std::initializer_list<Entity> entities) : own_(entities) {}

  std::size_t size() const { return shared_size_ + own_.size(); }
  bool empty() const { return size() == 0; }
  const Entity& operator[](std::size_t i) const { return i < shared_size_ ? (*first_)[i] : own_[i - shared_size_]; }
  const Entity& operator[](EntityIndex entity) const { return (*this)[entity.index()]; }
  Iterator begin() const;
  Iterator end() const;

  void push_back(Entity entity) { own_.push_back(std::move(entity)); }  // an entity of its own
  /// Appends what `longer`, a list that starts with the same entities, has in addition.
  void follow(const EntityList& longer);
  /// Moves all entities into a block that copies made from now on share.
  void share();

  /// The first shared entity with that id.
  std::optional<EntityIndex> find_shared(std::string_view id) const;
  /// The entities of a domain's kind and category (is_of in logic/membership.h), ascending.
  std::vector<EntityIndex> of(const Domain& domain) const;

  /// The categories of all entities but the agent, sorted, without repeats.
  std::vector<std::string_view> categories() const;

  bool operator==(const EntityList& other) const;

 private:
  struct Block;
  std::shared_ptr<const Block> shared_;         // never changed, so that threads may share a home's
  const std::vector<Entity>* first_ = nullptr;  // the entities of `shared_`
  std::size_t shared_size_ = 0;
  std::vector<Entity> own_;
};

/// A forward iterator; valid until the list changes.
class EntityList::Iterator {
 public:
  using iterator_category = std::random_access_iterator_tag;
  using value_type = Entity;
  using difference_type = std::ptrdiff_t;
  using pointer = const Entity*;
  using reference = const Entity&;

  Iterator() = default;
  Iterator(const EntityList& list, std::size_t at) : list_(&list), at_(static_cast<difference_type>(at)) {}
  reference operator*() const { return (*list_)[static_cast<std::size_t>(at_)]; }
  pointer operator->() const { return &**this; }
  reference operator[](difference_type n) const { return *(*this + n); }
  Iterator& operator+=(difference_type n) {
    at_ += n;
    return *this;
  }
  Iterator& operator-=(difference_type n) { return *this += -n; }
  Iterator& operator++() { return *this += 1; }
  Iterator& operator--() { return *this -= 1; }
  Iterator operator++(int) {
    Iterator before = *this;
    ++*this;
    return before;
  }
  Iterator operator--(int) {
    Iterator before = *this;
    --*this;
    return before;
  }
  friend Iterator operator+(Iterator at, difference_type n) { return at += n; }
  friend Iterator operator+(difference_type n, Iterator at) { return at += n; }
  friend Iterator operator-(Iterator at, difference_type n) { return at -= n; }
  friend difference_type operator-(const Iterator& a, const Iterator& b) { return a.at_ - b.at_; }
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }
  friend auto operator<=>(const Iterator& a, const Iterator& b) { return a.at_ <=> b.at_; }

 private:
  const EntityList* list_ = nullptr;
  difference_type at_ = 0;
};

inline EntityList::Iterator EntityList::begin() const { return {*this, 0}; }
inline EntityList::Iterator EntityList::end() const { return {*this, size()}; }

}  // namespace unietp
