#pragma once

#include <string_view>
#include <vector>

#include "serve/method_call.h"

namespace unietp {

/// A row of the protocol's table of methods.
struct Method {
  std::string_view name;
  MethodResult (*run)(const MethodCall& call);
};
/// In the order of docs/protocol.md.
const std::vector<Method>& all_methods();

}  // namespace unietp
