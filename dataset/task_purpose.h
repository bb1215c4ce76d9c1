#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "generator/specification.h"
#include "templates/template.h"

namespace unietp {

/// What a task is for in a home, and what in its start makes it needed. `name` is "" where its template does not say.
struct TaskPurpose {
  std::string name;                  // "cleaning": one of purpose_kinds() (templates/purposes.h)
  std::vector<std::string> because;  // "plate is dirty", "plate is not on counter"
  bool operator==(const TaskPurpose&) const = default;
};

/// The purpose of a template with its placeholders bound: categories are called as people call them. Pure.
TaskPurpose purpose_of(const Template& source, const Binding& binding, const Knowledge& knowledge);

}  // namespace unietp
