#pragma once

#include <memory>
#include <utility>

#include "core/sole_owner.h"

namespace unietp {

/// A value whose copies are one object in memory until one of them is changed: a copy costs a pointer. Copies may
/// belong to different threads.
template <class T>
class SharedValue {
 public:
  SharedValue() = default;
  SharedValue(T value) : value_(std::make_shared<T>(std::move(value))) {}

  const T& operator*() const { return value_ == nullptr ? nothing() : *value_; }
  const T* operator->() const { return &**this; }
  /// Of one that was given a value: that, without a look whether it was.
  const T& given() const { return *value_; }
  /// Whether the two are one object in memory; two of which neither was ever given a value are.
  bool is(const SharedValue& other) const { return value_ == other.value_; }

  /// The value, to be changed. The reference is good until this is copied.
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
