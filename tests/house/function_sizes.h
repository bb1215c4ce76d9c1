#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unietp {

/// A function with a body, of C++ code.
struct SizedFunction {
  int line = 0;           // where its body begins, from 1
  int lines = 0;          // of its body, without those of its outer braces
  std::string signature;  // what comes before its body
};

/// The functions of a file in order, members too. What is inside of a function, such as a lambda, is part of it. Tables
/// and types have no size.
std::vector<SizedFunction> functions_of(std::string_view code);

}  // namespace unietp
