#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

#include "core/shared_value.h"

namespace unietp {

/// A list whose copies have in common what none of them has changed since. It is a tree of two levels: leaves of 8
/// elements, 32 leaves to a branch. A copy costs a pointer for every 256 elements, a change copies the leaf and the
/// branch that it is in, and what a list became is found by the branches and leaves that the two do not share. Reading
/// is as of a vector; whoever changes an element says so, with `edit`. Copies may belong to different threads.
template <class T>
class SharedList {
  static constexpr std::size_t kLeaf = 8, kBranch = 32 * kLeaf;  // elements
  using Leaf = SharedValue<std::array<T, kLeaf>>;                // behind the last element: T{}
  using Branch = SharedValue<std::array<Leaf, kBranch / kLeaf>>;

 public:
  class Place;
  using value_type = T;
  using iterator = Place;
  using const_iterator = Place;

  SharedList() = default;
  SharedList(std::initializer_list<T> elements) : SharedList(elements.begin(), elements.end()) {}
  SharedList(std::vector<T> elements) {
    for (T& element : elements) push_back(std::move(element));
  }
  template <class Iterator>
  SharedList(Iterator first, Iterator last) {
    for (; first != last; ++first) push_back(*first);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return element(branches_.data(), i); }
  const T& front() const { return (*this)[0]; }  // of a list that is not empty
  const T& back() const { return (*this)[size_ - 1]; }
  Place begin() const { return {branches_.data(), 0}; }
  Place end() const { return {branches_.data(), static_cast<std::ptrdiff_t>(size_)}; }

  /// The element, to be changed. The reference is good until the list is copied or gets longer or shorter.
  T& edit(std::size_t i) { return branches_[i / kBranch].edit()[i % kBranch / kLeaf].edit()[i % kLeaf]; }
  template <class... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    T last(std::forward<Arguments>(arguments)...);  // which may be of this list
    if (size_ % kBranch == 0) branches_.emplace_back();
    return edit(size_++) = std::move(last);
  }
  void push_back(T element) { emplace_back(std::move(element)); }
  void pop_back() {
    edit(--size_) = T{};
    if (size_ % kBranch == 0) branches_.pop_back();
  }
  void clear() { *this = {}; }
  /// Takes out what `gone` is true of; the others stay in order.
  template <class Gone>
  friend void erase_if(SharedList& list, const Gone& gone) {
    if (std::none_of(list.begin(), list.end(), gone)) return;
    SharedList kept;
    std::copy_if(list.begin(), list.end(), std::back_inserter(kept), [&](const T& element) { return !gone(element); });
    list = std::move(kept);
  }

  /// The first place from i on where the two lists do not have one and the same object in common, or the size of the
  /// longer; what stands there may still be equal.
  std::size_t first_of_its_own(const SharedList& other, std::size_t i) const {
    while (i < size_ && i < other.size_) {
      const Branch &here = branches_[i / kBranch], &there = other.branches_[i / kBranch];
      if (here.is(there)) {
        i = (i / kBranch + 1) * kBranch;
      } else if (here.given()[i % kBranch / kLeaf].is(there.given()[i % kBranch / kLeaf])) {
        i = (i / kLeaf + 1) * kLeaf;
      } else {
        break;
      }
    }
    return std::min(i, std::max(size_, other.size_));
  }
  bool operator==(const SharedList& other) const {
    if (size_ != other.size_) return false;
    for (std::size_t i = 0; (i = first_of_its_own(other, i)) < size_; ++i) {
      if (!((*this)[i] == other[i])) return false;
    }
    return true;
  }

 private:
  static const T& element(const Branch* branches, std::size_t i) {
    return branches[i / kBranch].given()[i % kBranch / kLeaf].given()[i % kLeaf];
  }

  std::vector<Branch> branches_;
  std::size_t size_ = 0;
};

/// A random-access iterator; valid until the list changes.
template <class T>
class SharedList<T>::Place {
 public:
  using iterator_category = std::random_access_iterator_tag;
  using value_type = T;
  using difference_type = std::ptrdiff_t;
  using pointer = const T*;
  using reference = const T&;

  Place() = default;
  Place(const Branch* branches, difference_type at) : branches_(branches), at_(at) {}
  reference operator*() const { return element(branches_, static_cast<std::size_t>(at_)); }
  pointer operator->() const { return &**this; }
  reference operator[](difference_type n) const { return *(*this + n); }
  Place& operator+=(difference_type n) {
    at_ += n;
    return *this;
  }
  Place& operator-=(difference_type n) { return *this += -n; }
  Place& operator++() { return *this += 1; }
  Place& operator--() { return *this -= 1; }
  Place operator++(int) { return std::exchange(*this, *this + 1); }
  Place operator--(int) { return std::exchange(*this, *this - 1); }
  friend Place operator+(Place at, difference_type n) { return at += n; }
  friend Place operator+(difference_type n, Place at) { return at += n; }
  friend Place operator-(Place at, difference_type n) { return at -= n; }
  friend difference_type operator-(const Place& a, const Place& b) { return a.at_ - b.at_; }
  friend bool operator==(const Place& a, const Place& b) { return a.at_ == b.at_; }
  friend auto operator<=>(const Place& a, const Place& b) { return a.at_ <=> b.at_; }

 private:
  const Branch* branches_ = nullptr;
  difference_type at_ = 0;
};

}  // namespace unietp
