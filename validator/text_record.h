#pragma once

#include <string>
#include <vector>

namespace unietp {

/// How an instruction says that it was made.
struct TextOrigin {
  const std::string& writer;
  const std::vector<std::string>& checks;
  const std::string& why;  // the grammar wrote it instead of the requested writer; "" otherwise
};

/// What cannot be so: a writer that is none, checks that are not those of its writer, a reason for a stand-in where
/// nothing was replaced. `by_model`: whether a language model was asked for the instructions. "" when nothing is wrong.
std::string origin_fault(const TextOrigin& origin, bool by_model);

}  // namespace unietp
