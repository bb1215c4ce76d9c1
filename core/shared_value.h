#pragma once

#include <atomic>
#include <memory>
#include <utility>

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
    if (value_ == nullptr || value_.use_count() > 1) {
      value_ = std::make_shared<T>(**this);
    } else {
      std::atomic_thread_fence(std::memory_order_acquire);  // whoever had it in common has read it to the end
    }
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
