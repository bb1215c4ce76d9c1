#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

#include "core/shared_value.h"
#include "core/sort_unique.h"

namespace unietp {

/// A sorted set without repeats whose copies share memory. Copying it, or comparing it with a changed copy, costs one
/// pointer for about 50 elements; a change copies about as many elements. Copies may belong to different threads.
template <class T>
class SharedSet {
  static constexpr std::size_t kPiece = 96;   // at most, then it is cut in two
  using Piece = SharedValue<std::vector<T>>;  // always given, never empty

 public:
  class Place;
  using value_type = T;
  using iterator = Place;
  using const_iterator = Place;

  SharedSet() = default;
  /// From elements in any order; repeats are dropped.
  SharedSet(std::vector<T> elements) {
    sort_unique(elements);
    size_ = elements.size();
    for (std::size_t from = 0; from < size_; from += kPiece / 2) {
      const auto first = elements.begin() + static_cast<std::ptrdiff_t>(from);
      const auto last = elements.begin() + static_cast<std::ptrdiff_t>(std::min(size_, from + kPiece / 2));
      pieces_.push_back(std::vector<T>(std::make_move_iterator(first), std::make_move_iterator(last)));
    }
  }
  SharedSet(std::initializer_list<T> elements) : SharedSet(std::vector<T>(elements)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Place begin() const { return {pieces_.data(), 0}; }
  Place end() const { return {pieces_.data() + pieces_.size(), 0}; }

  /// The first element for which `before` is false. `before` must be true for all elements before it and false for all
  /// after it.
  template <class Before>
  Place partition_point(const Before& before) const {
    const auto piece = std::partition_point(pieces_.begin(), pieces_.end(),
                                            [&](const Piece& one) { return before(one.given().back()); });
    if (piece == pieces_.end()) return end();
    const std::vector<T>& here = piece->given();
    const auto at = std::partition_point(here.begin(), here.end(), before);
    return {pieces_.data() + (piece - pieces_.begin()), static_cast<std::size_t>(at - here.begin())};
  }
  bool contains(const T& element) const {
    const Place at = partition_point([&](const T& one) { return one < element; });
    return at != end() && *at == element;
  }

  /// Returns whether the element is new.
  bool insert(T element) {
    auto piece = piece_for(element);
    if (piece == pieces_.end()) {
      if (pieces_.empty()) pieces_.push_back(std::vector<T>());
      piece = pieces_.end() - 1;
    }
    const auto at = place_in(*piece, element);
    if (at < std::ssize(piece->given()) && piece->given()[static_cast<std::size_t>(at)] == element) return false;
    std::vector<T>& here = piece->edit();
    here.insert(here.begin() + at, std::move(element));
    ++size_;
    if (here.size() > kPiece) {
      const auto half = here.begin() + static_cast<std::ptrdiff_t>(here.size() / 2);
      std::vector<T> later(std::make_move_iterator(half), std::make_move_iterator(here.end()));
      here.erase(half, here.end());
      pieces_.insert(piece + 1, std::move(later));
    }
    return true;
  }
  /// Returns whether the set had the element.
  bool erase(const T& element) {
    const auto piece = piece_for(element);
    if (piece == pieces_.end()) return false;
    const auto at = place_in(*piece, element);
    if (piece->given()[static_cast<std::size_t>(at)] != element) return false;
    --size_;
    if (piece->given().size() == 1) {
      pieces_.erase(piece);
      return true;
    }
    std::vector<T>& here = piece->edit();
    here.erase(here.begin() + at);
    return true;
  }
  void clear() { *this = {}; }
  template <class Gone>
  friend void erase_if(SharedSet& set, const Gone& gone) {
    std::vector<T> kept(set.begin(), set.end());
    std::erase_if(kept, gone);
    if (kept.size() < set.size()) set = std::move(kept);
  }

  bool operator==(const SharedSet& other) const {
    if (size_ != other.size_) return false;
    Place a = begin(), b = other.begin();
    while (a != end()) {
      if (a.at_ == 0 && b.at_ == 0 && a.piece_->is(*b.piece_)) {
        ++a.piece_;
        ++b.piece_;
      } else if (*a == *b) {
        ++a;
        ++b;
      } else {
        return false;
      }
    }
    return true;
  }

 private:
  auto piece_for(const T& element) {
    return std::partition_point(pieces_.begin(), pieces_.end(),
                                [&](const Piece& one) { return one.given().back() < element; });
  }
  static std::ptrdiff_t place_in(const Piece& piece, const T& element) {
    const std::vector<T>& here = piece.given();
    return std::lower_bound(here.begin(), here.end(), element) - here.begin();
  }

  std::vector<Piece> pieces_;
  std::size_t size_ = 0;
};

/// A bidirectional iterator; valid until the set changes.
template <class T>
class SharedSet<T>::Place {
 public:
  using iterator_category = std::bidirectional_iterator_tag;
  using value_type = T;
  using difference_type = std::ptrdiff_t;
  using pointer = const T*;
  using reference = const T&;

  Place() = default;
  Place(const Piece* piece, std::size_t at) : piece_(piece), at_(at) {}
  reference operator*() const { return piece_->given()[at_]; }
  pointer operator->() const { return &**this; }
  Place& operator++() {
    if (++at_ == piece_->given().size()) *this = {piece_ + 1, 0};
    return *this;
  }
  Place& operator--() {
    if (at_ == 0) *this = {piece_ - 1, (piece_ - 1)->given().size()};
    --at_;
    return *this;
  }
  Place operator++(int) {
    const Place before = *this;
    ++*this;
    return before;
  }
  Place operator--(int) {
    const Place before = *this;
    --*this;
    return before;
  }
  bool operator==(const Place&) const = default;

 private:
  friend class SharedSet;
  const Piece* piece_ = nullptr;
  std::size_t at_ = 0;
};

}  // namespace unietp
