#pragma once

#include <initializer_list>
#include <string>

#include <nlohmann/json.hpp>

namespace unietp {

/// One task of a data set with all that belongs to it, to be damaged.
struct DamagedTask {
  nlohmann::ordered_json task, demonstration, home, scene;  // its line, its line in M1, its home and its start
  std::string task_line;                                    // written in place of `task` when not empty
  bool without_demonstration = false;

  std::string goal() const { return task["goal"]["text"]; }
  void set_goal(const std::string& text) { task["goal"]["text"] = text; }
  /// The steps, last first, whose action is one of these; nullptr when there is none.
  nlohmann::ordered_json* last_step(std::initializer_list<const char*> actions);
  /// The line with the changes that lead from the home to the start as it is now.
  nlohmann::ordered_json line() const;
  /// Category of an object of the start; "" when there is none.
  std::string category_of(const std::string& id) const;
};

}  // namespace unietp
