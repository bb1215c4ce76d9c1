#pragma once

#include <functional>
#include <string>
#include <vector>

#include "forged_set.h"

namespace unietp {

/// One change of one file of a data set.
struct Forgery {
  std::string file;   // kind of file: "tasks.jsonl", "homes", "demonstrations/M3.jsonl"
  std::string field;  // "goal.text"
  std::string how;
  std::string where;  // which one, for people
  std::function<ValidationReport(ForgedSet&)> validate;
};

/// Changes of every field of every file: of each field and way at most `each`, in different lines as far as possible.
/// Deterministic.
std::vector<Forgery> forgeries(const ForgedSet& set, int each);

}  // namespace unietp
