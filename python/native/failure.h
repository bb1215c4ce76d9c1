#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"

namespace unietp::python {

/// An Error on its way to Python, where it is unietp.Error.
struct PythonError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value, or its error raised.
template <class T>
T value_of(Result<T> result) {
  if (!result) throw PythonError(format(result.error()));
  return std::move(*result);
}

/// Raises all of them, a line each; nothing happens when there are none.
inline void raise_any(const std::vector<Error>& errors) {
  if (errors.empty()) return;
  std::string text;
  for (const auto& error : errors) text += (text.empty() ? "" : "\n") + format(error);
  throw PythonError(text);
}

}  // namespace unietp::python
