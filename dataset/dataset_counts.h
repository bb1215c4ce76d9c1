#pragma once

#include <map>
#include <string>
#include <vector>

#include "dataset/balance.h"

namespace unietp {

/// How many tasks of each kind, and why candidates were given up. Maps, so that files are in order of name.
struct DatasetCounts {
  int tasks = 0;
  std::map<std::string, int> by_split, by_simulator, by_template, by_sense, by_form;
  std::map<std::string, int> not_usual;                          // by template
  std::map<std::string, std::map<std::string, int>> rejections;  // stage, reason
  std::vector<Spread> balance;                                   // of the tasks
};

}  // namespace unietp
