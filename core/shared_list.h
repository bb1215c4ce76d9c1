#pragma once

#include <algorithm>
#include <atomic>
#include <compare>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace unietp {

/// A list whose copies have in common what none of them has changed since: a copy costs a pointer for every 32
/// elements, and so does comparing a list with what it became. Reading is as of a vector; whoever changes an element
/// says so, with `edit`, and gets a piece of 32 of his own. Copies may belong to different threads.
template <class T>
class SharedList {
  static constexpr std::size_t kPiece = 32;
  using Piece = std::shared_ptr<std::vector<T>>;  // changed only while one list has it

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
  const T& operator[](std::size_t i) const { return (*pieces_[i / kPiece])[i % kPiece]; }
  const T& front() const { return (*this)[0]; }
  const T& back() const { return (*this)[size_ - 1]; }
  Place begin() const { return {pieces_.data(), 0}; }
  Place end() const { return {pieces_.data(), static_cast<std::ptrdiff_t>(size_)}; }

  /// The element, to be changed. The reference is good until the list is copied or gets longer or shorter.
  T& edit(std::size_t i) { return own(i / kPiece)[i % kPiece]; }
  template <class... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    if (size_ % kPiece == 0) {
      T first(std::forward<Arguments>(arguments)...);  // which may be of this list
      pieces_.push_back(std::make_shared<std::vector<T>>());
      pieces_.back()->reserve(kPiece);
      ++size_;
      return pieces_.back()->emplace_back(std::move(first));
    }
    T& last = own(size_ / kPiece).emplace_back(std::forward<Arguments>(arguments)...);
    ++size_;
    return last;
  }
  void push_back(T element) { emplace_back(std::move(element)); }
  void pop_back() {
    --size_;
    if (size_ % kPiece == 0) {
      pieces_.pop_back();
    } else {
      own(size_ / kPiece).pop_back();
    }
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
    while (i < size_ && i < other.size_ && pieces_[i / kPiece] == other.pieces_[i / kPiece])
      i = (i / kPiece + 1) * kPiece;
    return std::min(i, std::max(size_, other.size_));
  }
  bool operator==(const SharedList& other) const {
    return size_ == other.size_ && std::equal(pieces_.begin(), pieces_.end(), other.pieces_.begin(),
                                              [](const Piece& a, const Piece& b) { return a == b || *a == *b; });
  }

 private:
  std::vector<T>& own(std::size_t piece) {
    Piece& here = pieces_[piece];
    if (here.use_count() > 1) {
      auto copy = std::make_shared<std::vector<T>>();
      copy->reserve(kPiece);
      copy->assign(here->begin(), here->end());
      here = std::move(copy);
    } else {
      std::atomic_thread_fence(std::memory_order_acquire);  // whoever had it in common has read it to the end
    }
    return *here;
  }

  std::vector<Piece> pieces_;  // all but the last are full
  std::size_t size_ = 0;
};

template <class T>
class SharedList<T>::Place {
 public:
  using iterator_category = std::random_access_iterator_tag;
  using value_type = T;
  using difference_type = std::ptrdiff_t;
  using pointer = const T*;
  using reference = const T&;

  Place() = default;
  Place(const Piece* pieces, difference_type at) : pieces_(pieces), at_(at) {}
  reference operator*() const {
    const auto at = static_cast<std::size_t>(at_);
    return (*pieces_[at / kPiece])[at % kPiece];
  }
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
  const Piece* pieces_ = nullptr;
  difference_type at_ = 0;
};

}  // namespace unietp
