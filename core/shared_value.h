#pragma once

#include <memory>
#include <utility>

#include "core/sole_owner.h"

namespace unietp {

/// A value whose copies share one object in memory until one of them is changed, so a copy costs a pointer. Copies may
/// belong to different threads.
template <class T>
class SharedValue {
 public:
  SharedValue() = default;
  SharedValue(T value) : value_(std::make_shared<T>(std::move(value))) {}

  const T& operator*() const { return value_ == nullptr ? nothing() : *value_; }
  const T* operator->() const { return &**this; }
  /// The value, without a check whether one was ever given; only after the constructor with a value or `edit`.
  const T& given() const { return *value_; }
  /// Whether the two share one object in memory. Two that were never given a value do.
  bool is(const SharedValue& other) const { return value_ == other.value_; }

  /// The value, to be changed. The reference is valid until this object is copied.
  T& edit() {
    if (!is_sole_owner(value_)) value_ = std::make_shared<T>(**this);
    return *value_;
  }

 private:
  static const T& nothing() {
    static const T kNothing{};
    return kNothing;
  }
  std::shared_ptr<T> value_;  // changed only while one has it; nullptr: as T{}
};

}  // namespace unietp
