#pragma once

#include <cassert>
#include <utility>
#include <variant>

#include "core/error.h"

namespace unietp {

/// A value or an Error; takes the member names of std::expected, which is C++23.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return content_.index() == 0; }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  /// Only when there is a value: asserted.
  T& value() {
    assert(*this);
    return *std::get_if<0>(&content_);
  }
  const T& value() const {
    assert(*this);
    return *std::get_if<0>(&content_);
  }
  /// Only when there is none: asserted.
  const Error& error() const {
    assert(!*this);
    return *std::get_if<1>(&content_);
  }

 private:
  std::variant<T, Error> content_;
};

/// For functions that return nothing but may fail.
struct Done {
  bool operator==(const Done&) const = default;
};

}  // namespace unietp
